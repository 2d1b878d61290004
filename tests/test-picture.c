#include "picture.h"

#include "fixture.h"

#include <glib/gstdio.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const sets[]
    = { "lecture8", "mixed8", "grid9", "square4", "cross5" };

#define N_SETS (sizeof sets / sizeof sets[0])

/* What the pictures of a test look like. */
static ThemeKind theme = THEME_LIGHT;
static double scale = 1;
static gboolean is_transparent = FALSE;

/* The bytes of a picture of a set at its last cone, or at its end. */
static GString *
write_zoomed (const Fixture *fixture,
              PictureView view,
              PictureFormat format,
              double zoom)
{
  const Trace *trace = fixture->trace;
  const uint32_t step = trace->n_rounds == 0
                            ? trace->n_events
                            : trace->rounds[trace->n_rounds - 1].last_cone;
  GString *bytes = g_string_new (NULL);
  FILE *file = tmpfile ();
  Picture picture;
  Frame frame;
  int byte;

  frame_init (&frame, trace, step);
  picture_init (&picture, view, &frame);
  picture.look.layers |= LAYER_CIRCLES;
  picture.plane_camera.zoom = picture.camera.zoom = zoom;
  picture.theme = theme_get (theme);
  picture.scale = scale;
  picture.is_transparent = is_transparent;
  picture.title = "Sites & <lifts>";
  picture.description = "s7 sees f9 > f8";
  g_assert_true (picture_write (&picture, &frame, format, file));
  rewind (file);
  while ((byte = fgetc (file)) != EOF)
    g_string_append_c (bytes, (char)byte);
  fclose (file);
  frame_clear (&frame);
  return bytes;
}

static GString *
write_picture (const Fixture *fixture, PictureView view, PictureFormat format)
{
  return write_zoomed (fixture, view, format, 1);
}

static void
free_string (GString *string)
{
  g_string_free (string, TRUE);
}

static void
test_same_bytes (void)
{
  size_t i;
  int format;

  for (format = PICTURE_SVG; format <= PICTURE_PNG; format++)
    for (i = 0; i < N_SETS; i++) {
      g_autoptr (Fixture) fixture = fixture_load (sets[i], ORDER_FURTHEST);
      GString *first
          = write_picture (fixture, PICTURE_BOTH, (PictureFormat)format);
      GString *other
          = write_picture (fixture, PICTURE_PLANE, (PictureFormat)format);
      GString *second
          = write_picture (fixture, PICTURE_BOTH, (PictureFormat)format);

      g_assert_cmpmem (first->str, first->len, second->str, second->len);
      g_assert_cmpuint (first->len, !=, other->len);
      free_string (first);
      free_string (other);
      free_string (second);
    }
}

/* What the SVG says of itself. */
typedef struct Svg {
  double width, height;
  guint n_paths;
  GString *title, *description;
  char *element;
} Svg;

/* All numbers of a path lie on the page or within a page of it. */
static void
check_path (const Svg *svg, const char *data, const double matrix[6])
{
  double at[2];
  int n = 0;

  while (*data != '\0') {
    char *end;
    const double number = g_ascii_strtod (data, &end);

    if (end == data) {
      g_assert_false (g_str_has_prefix (data, "nan")
                      || g_str_has_prefix (data, "inf"));
      data++;
      continue;
    }
    g_assert_true (isfinite (number));
    at[n++ % 2] = number;
    data = end;
    if (n % 2 == 0) {
      const double x = matrix[0] * at[0] + matrix[2] * at[1] + matrix[4];
      const double y = matrix[1] * at[0] + matrix[3] * at[1] + matrix[5];

      g_assert_cmpfloat (x, >=, -svg->width);
      g_assert_cmpfloat (x, <=, 2 * svg->width);
      g_assert_cmpfloat (y, >=, -svg->height);
      g_assert_cmpfloat (y, <=, 2 * svg->height);
    }
  }
}

static void
on_start (GMarkupParseContext *context,
          const char *element,
          const char **names,
          const char **values,
          gpointer user,
          GError **error)
{
  Svg *svg = user;
  double matrix[6] = { 1, 0, 0, 1, 0, 0 };
  const char *path = NULL;
  int i;

  (void)context;
  (void)error;
  g_free (svg->element);
  svg->element = g_strdup (element);
  for (i = 0; names[i] != NULL; i++) {
    if (strcmp (element, "svg") == 0 && strcmp (names[i], "width") == 0)
      svg->width = g_ascii_strtod (values[i], NULL);
    if (strcmp (element, "svg") == 0 && strcmp (names[i], "height") == 0)
      svg->height = g_ascii_strtod (values[i], NULL);
    if (strcmp (names[i], "d") == 0)
      path = values[i];
    if (strcmp (names[i], "transform") == 0)
      g_assert_cmpint (sscanf (values[i], "matrix(%lf,%lf,%lf,%lf,%lf,%lf)",
                               &matrix[0], &matrix[1], &matrix[2], &matrix[3],
                               &matrix[4], &matrix[5]),
                       ==, 6);
  }
  if (path == NULL)
    return;
  svg->n_paths += 1;
  check_path (svg, path, matrix);
}

static void
on_end (GMarkupParseContext *context,
        const char *element,
        gpointer user,
        GError **error)
{
  Svg *svg = user;

  (void)context;
  (void)element;
  (void)error;
  g_clear_pointer (&svg->element, g_free);
}

static void
on_text (GMarkupParseContext *context,
         const char *text,
         gsize length,
         gpointer user,
         GError **error)
{
  Svg *svg = user;

  (void)context;
  (void)error;
  if (g_strcmp0 (svg->element, "title") == 0)
    g_string_append_len (svg->title, text, (gssize)length);
  if (g_strcmp0 (svg->element, "desc") == 0)
    g_string_append_len (svg->description, text, (gssize)length);
}

static void
check_svg (const Fixture *fixture, PictureView view, double zoom)
{
  static const GMarkupParser parser = { on_start, on_end, on_text, NULL, NULL };
  GString *bytes = write_zoomed (fixture, view, PICTURE_SVG, zoom);
  Svg svg
      = { .title = g_string_new (NULL), .description = g_string_new (NULL) };
  g_autoptr (GMarkupParseContext) context
      = g_markup_parse_context_new (&parser, 0, &svg, NULL);
  g_autoptr (GError) error = NULL;

  if (!g_markup_parse_context_parse (context, bytes->str, (gssize)bytes->len,
                                     &error)
      || !g_markup_parse_context_end_parse (context, &error))
    g_error ("%s: %s", fixture->name, error->message);
  g_assert_cmpuint (svg.n_paths, >, zoom > 1 ? 0 : 10);
  g_assert_cmpstr (svg.title->str, ==, "Sites & <lifts>");
  g_assert_cmpstr (svg.description->str, ==, "s7 sees f9 > f8");
  g_assert_null (strstr (bytes->str, "<pattern"));
  g_assert_null (strstr (bytes->str, "<image"));
  free_string (svg.title);
  free_string (svg.description);
  free_string (bytes);
}

static void
check_both_svg (const Fixture *fixture)
{
  check_svg (fixture, PICTURE_PLANE, 1);
  check_svg (fixture, PICTURE_SPACE, 1);
  check_svg (fixture, PICTURE_PLANE, 300);
  check_svg (fixture, PICTURE_SPACE, 300);
}

static void
test_svg (void)
{
  size_t i;

  for (i = 0; i < N_SETS; i++) {
    g_autoptr (Fixture) fixture = fixture_load (sets[i], ORDER_FURTHEST);

    check_both_svg (fixture);
  }
  fixture_for_each (1, 20, ORDER_FURTHEST, check_both_svg);
}

/* Large, small, and without a background. */
static void
test_themes (void)
{
  static const double scales[] = { 0.3, 1, 4 };
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);

  for (theme = 0; theme < N_THEMES; theme++) {
    scale = scales[theme % G_N_ELEMENTS (scales)];
    is_transparent = theme % 2 == 1;
    check_both_svg (fixture);
  }
  theme = THEME_LIGHT;
  scale = 1;
  is_transparent = FALSE;
}

static gboolean
contains (const GString *bytes, const char *words)
{
  const gsize length = strlen (words);
  gsize i;

  for (i = 0; i + length <= bytes->len; i++)
    if (memcmp (bytes->str + i, words, length) == 0)
      return TRUE;
  return FALSE;
}

static void
test_pdf (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  GString *bytes = write_picture (fixture, PICTURE_SPACE, PICTURE_PDF);

  g_assert_true (g_str_has_prefix (bytes->str, "%PDF-"));
  g_assert_true (contains (bytes, "/CreationDate (20040101000000"));
  g_assert_true (contains (bytes, "/Title (Sites & <lifts>)"));
  free_string (bytes);
}

static void
test_png (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  GString *bytes = write_picture (fixture, PICTURE_BOTH, PICTURE_PNG);
  const guint8 *header = (const guint8 *)bytes->str;

  g_assert_cmpmem (header, 8, "\x89PNG\r\n\x1a\n", 8);
  g_assert_cmpuint (header[18] * 256U + header[19], ==, 960);
  g_assert_cmpuint (header[22] * 256U + header[23], ==, 480);
  free_string (bytes);
}

static guint
to_number (const guint8 *bytes)
{
  return ((bytes[0] * 256U + bytes[1]) * 256U + bytes[2]) * 256U + bytes[3];
}

static void
test_scale (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  GString *bytes, *svg;
  const guint8 *header;

  scale = 2.5;
  bytes = write_picture (fixture, PICTURE_BOTH, PICTURE_PNG);
  svg = write_picture (fixture, PICTURE_PLANE, PICTURE_SVG);
  scale = 1;
  header = (const guint8 *)bytes->str;
  g_assert_cmpuint (to_number (header + 16), ==, 2400);
  g_assert_cmpuint (to_number (header + 20), ==, 1200);
  g_assert_nonnull (strstr (svg->str, "width=\"1200pt\" height=\"1200pt\""));
  free_string (bytes);
  free_string (svg);
}

static cairo_status_t
read_bytes (void *closure, unsigned char *data, unsigned length)
{
  GString *bytes = closure;

  if (bytes->len < length)
    return CAIRO_STATUS_READ_ERROR;
  memcpy (data, bytes->str, length);
  g_string_erase (bytes, 0, (gssize)length);
  return CAIRO_STATUS_SUCCESS;
}

/* Returns: the alpha of the pixel in the upper left corner of space. */
static guint
corner_alpha (const Fixture *fixture)
{
  GString *bytes = write_picture (fixture, PICTURE_SPACE, PICTURE_PNG);
  cairo_surface_t *surface
      = cairo_image_surface_create_from_png_stream (read_bytes, bytes);
  guint alpha = 255;

  g_assert_cmpint (cairo_surface_status (surface), ==, CAIRO_STATUS_SUCCESS);
  if (cairo_image_surface_get_format (surface) == CAIRO_FORMAT_ARGB32)
    alpha = *(guint32 *)(void *)cairo_image_surface_get_data (surface) >> 24;
  cairo_surface_destroy (surface);
  free_string (bytes);
  return alpha;
}

static void
test_transparent (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);

  g_assert_cmpuint (corner_alpha (fixture), ==, 255);
  is_transparent = TRUE;
  g_assert_cmpuint (corner_alpha (fixture), ==, 0);
  is_transparent = FALSE;
}

/* An independent reader finds the names of the sites in the order of words. */
static void
test_pdf_has_text (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  GString *bytes = write_picture (fixture, PICTURE_PLANE, PICTURE_PDF);
  g_autofree char *path
      = g_build_filename (g_get_tmp_dir (), "hull2vd-XXXXXX", NULL);
  g_autofree char *line = NULL, *text = NULL;
  g_autoptr (GError) error = NULL;
  const int file = g_mkstemp (path);
  guint i;

  g_assert_cmpint (write (file, bytes->str, bytes->len), ==,
                   (gssize)bytes->len);
  close (file);
  line = g_strdup_printf ("pdftotext %s -", path);
  g_assert_true (g_spawn_command_line_sync (line, &text, NULL, NULL, &error));
  g_assert_no_error (error);
  for (i = 0; i < 8; i++) {
    g_autofree char *name = g_strdup_printf ("s%u", i);

    g_assert_nonnull (strstr (text, name));
  }
  g_remove (path);
  free_string (bytes);
}

static void
test_sizes (void)
{
  static const struct {
    double width, height, scale;
    bool is_good;
  } rows[] = {
    { 1, 1, 1, true },           { 0, 0, 1, false },
    { 1e6, 1e6, 1, false },      { -5, 5, 1, false },
    { 16384, 16384, 1, true },   { 16384, 16384, 1.001, false },
    { 20000, 20000, 0.5, true }, { 1, 1, 0.5, false },
    { NAN, 5, 1, false },        { 5, 5, INFINITY, false },
  };
  guint i;

  for (i = 0; i < G_N_ELEMENTS (rows); i++) {
    const Picture picture = { .width = rows[i].width,
                              .height = rows[i].height,
                              .scale = rows[i].scale };

    g_assert_cmpint (picture_has_good_size (&picture), ==, rows[i].is_good);
  }
}

static void
test_full_disk (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  FILE *file = fopen ("/dev/full", "wb");
  Picture picture;
  Frame frame;

  g_assert_nonnull (file);
  frame_init (&frame, fixture->trace, 0);
  picture_init (&picture, PICTURE_PLANE, &frame);
  g_assert_false (picture_write (&picture, &frame, PICTURE_SVG, file));
  fclose (file);
  frame_clear (&frame);
}

static void
test_format (void)
{
  PictureFormat format;

  g_assert_true (picture_format_of ("a/b.SVG", &format));
  g_assert_cmpint (format, ==, PICTURE_SVG);
  g_assert_true (picture_format_of ("x.pdf", &format));
  g_assert_cmpint (format, ==, PICTURE_PDF);
  g_assert_true (picture_format_of ("x.y.png", &format));
  g_assert_cmpint (format, ==, PICTURE_PNG);
  g_assert_false (picture_format_of ("x.jpeg", &format));
  g_assert_false (picture_format_of ("png", &format));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/picture/the-same-frame-gives-the-same-bytes",
                   test_same_bytes);
  g_test_add_func ("/picture/an-svg-is-well-formed-and-stays-near-its-page",
                   test_svg);
  g_test_add_func ("/picture/a-pdf-has-a-title-and-a-fixed-date", test_pdf);
  g_test_add_func ("/picture/a-png-has-the-size-asked-for", test_png);
  g_test_add_func ("/picture/every-theme-stays-near-its-page", test_themes);
  g_test_add_func ("/picture/the-names-in-a-pdf-are-text", test_pdf_has_text);
  g_test_add_func ("/picture/a-scaled-picture-is-larger", test_scale);
  g_test_add_func ("/picture/a-transparent-one-has-no-background",
                   test_transparent);
  g_test_add_func ("/picture/sizes-that-cannot-be-drawn-are-known", test_sizes);
  g_test_add_func ("/picture/a-full-disk-is-a-failure", test_full_disk);
  g_test_add_func ("/picture/the-ending-names-the-format", test_format);
  return g_test_run ();
}
