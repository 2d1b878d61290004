/* Pictures as bytes. The same frame gives the same bytes: dates are fixed and
 * numbers that cairo counts through the life of the process are put back. */
#include "picture.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <glib.h>
#include <math.h>

static cairo_status_t
append_bytes (void *closure, const unsigned char *data, unsigned length)
{
  g_byte_array_append (closure, data, length);
  return CAIRO_STATUS_SUCCESS;
}

static void
describe_pdf (const Picture *picture, cairo_surface_t *surface)
{
  cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                  "2004-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_CREATOR,
                                  "Hull2VD");
  if (picture->title != NULL)
    cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_TITLE,
                                    picture->title);
  if (picture->description != NULL)
    cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_SUBJECT,
                                    picture->description);
}

static cairo_surface_t *
surface_new (const Picture *picture, PictureFormat format, GByteArray *bytes)
{
  const double width = picture->width * picture->scale;
  const double height = picture->height * picture->scale;

  switch (format) {
  case PICTURE_SVG:
    return cairo_svg_surface_create_for_stream (append_bytes, bytes, width,
                                                height);
  case PICTURE_PDF:
    return cairo_pdf_surface_create_for_stream (append_bytes, bytes, width,
                                                height);
  case PICTURE_PNG:
    break;
  }
  return cairo_image_surface_create (
      picture->is_transparent ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
      (int)lround (width), (int)lround (height));
}

/* Returns: the picture in @format, or NULL when cairo refuses its size. */
static GByteArray *
encode (const Picture *picture, const Frame *frame, PictureFormat format)
{
  g_autoptr (GByteArray) bytes = g_byte_array_new ();
  cairo_surface_t *surface = surface_new (picture, format, bytes);
  cairo_t *cr = cairo_create (surface);
  cairo_status_t status;

  if (format == PICTURE_PDF)
    describe_pdf (picture, surface);
  cairo_scale (cr, picture->scale, picture->scale);
  picture_paint (picture, frame, cr);
  cairo_show_page (cr);
  status = cairo_status (cr);
  cairo_destroy (cr);
  if (status == CAIRO_STATUS_SUCCESS && format == PICTURE_PNG)
    status = cairo_surface_write_to_png_stream (surface, append_bytes, bytes);
  cairo_surface_finish (surface);
  if (status == CAIRO_STATUS_SUCCESS)
    status = cairo_surface_status (surface);
  cairo_surface_destroy (surface);
  return status == CAIRO_STATUS_SUCCESS ? g_steal_pointer (&bytes) : NULL;
}

/* Numbers the surfaces and clips of an SVG from 1, in the order in which they
 * come: cairo goes on counting from the last picture. */
static gboolean
renumber (const GMatchInfo *match, GString *result, gpointer user)
{
  GHashTable *numbers = user;
  g_autofree char *kind = g_match_info_fetch (match, 1);
  char *name = g_match_info_fetch (match, 0);
  gpointer number = g_hash_table_lookup (numbers, name);

  if (number == NULL) {
    number = GUINT_TO_POINTER (g_hash_table_size (numbers) + 1);
    g_hash_table_insert (numbers, g_strdup (name), number);
  }
  g_string_append_printf (result, "%s%u", kind, GPOINTER_TO_UINT (number));
  g_free (name);
  return FALSE;
}

/* The words of a picture, for readers that do not see it. */
static char *
words_of (const Picture *picture)
{
  g_autoptr (GString) words = g_string_new (NULL);
  g_autofree char *title = NULL, *description = NULL;

  if (picture->title != NULL) {
    title = g_markup_escape_text (picture->title, -1);
    g_string_append_printf (words, "<title>%s</title>\n", title);
  }
  if (picture->description != NULL) {
    description = g_markup_escape_text (picture->description, -1);
    g_string_append_printf (words, "<desc>%s</desc>\n", description);
  }
  return g_string_free (g_steal_pointer (&words), FALSE);
}

/* Returns: the SVG with its words, right after the start tag of <svg>, and
 *          with numbers of its own. */
static char *
finish_svg (const Picture *picture, const GByteArray *bytes)
{
  g_autoptr (GHashTable) numbers
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  g_autoptr (GRegex) names = g_regex_new (
      "\\b(surface|clip|image|mask|pattern)[0-9]+\\b", 0, 0, NULL);
  g_autoptr (GString) text
      = g_string_new_len ((const char *)bytes->data, (gssize)bytes->len);
  g_autofree char *words = words_of (picture);
  const char *svg = strstr (text->str, "<svg");
  const char *end = svg != NULL ? strchr (svg, '\n') : NULL;
  g_autofree char *renumbered = g_regex_replace_eval (
      names, text->str, -1, 0, 0, renumber, numbers, NULL);

  if (end == NULL)
    return g_steal_pointer (&renumbered);
  /* Nothing before the end of the start tag has a number. */
  return g_strdup_printf ("%.*s%s%s", (int)(end + 1 - text->str), renumbered,
                          words, renumbered + (end + 1 - text->str));
}

bool
picture_write (const Picture *picture,
               const Frame *frame,
               PictureFormat format,
               FILE *file)
{
  g_autoptr (GByteArray) bytes = encode (picture, frame, format);
  g_autofree char *svg = NULL;
  gsize length;

  if (bytes == NULL)
    return false;
  if (format != PICTURE_SVG) {
    length = bytes->len;
    return fwrite (bytes->data, 1, length, file) == length
           && fflush (file) == 0;
  }
  svg = finish_svg (picture, bytes);
  length = strlen (svg);
  return fwrite (svg, 1, length, file) == length && fflush (file) == 0;
}
