/* The painter against pictures that were looked at. A picture that differs
 * leaves NAME-out.png and NAME-diff.png in the working directory.
 * HULL2VD_RENEW_IMAGES=1 writes the reference pictures anew. */
#include "picture.h"

#include "fixture.h"
#include "label.h"

#include <math.h>
#include <string.h>

/* A channel may differ by so much (of 255), and so many pixels in a thousand
 * by more: room for another version of the font or of cairo's edges. */
#define CHANNEL_TOLERANCE 40
#define PER_THOUSAND 4

typedef struct Case {
  const char *name; /* of the reference: NAME-plane-ref.png, NAME-space… */
  const char *sites;
  Place place;
  uint32_t layers; /* more than the default ones */
  Object selection;
} Case;

static const Case cases[] = {
  { .name = "lecture8-start", .sites = "lecture8" },
  { "lecture8-choose", "lecture8", { 1, PHASE_CHOOSE }, 0, { 0 } },
  { "lecture8-see", "lecture8", { 4, PHASE_SEE }, 0, { 0 } },
  { "lecture8-horizon", "lecture8", { 3, PHASE_HORIZON }, 0, { 0 } },
  { "lecture8-cone", "lecture8", { 4, PHASE_CONE }, 0, { 0 } },
  { "lecture8-hand-over", "lecture8", { 4, PHASE_HAND_OVER }, 0, { 0 } },
  { "lecture8-selected",
    "lecture8",
    { 0, PHASE_COMPLETE },
    LAYER_CIRCLES,
    { OBJECT_FACET, 17 } },
  { "mixed8-see-upper", "mixed8", { 2, PHASE_SEE }, 0, { 0 } },
  { "mixed8-cone-both", "mixed8", { 4, PHASE_CONE }, 0, { 0 } },
  { "grid9-end", "grid9", { 0, PHASE_COMPLETE }, 0, { OBJECT_SITE, 4 } },
  { "square4-end", "square4", { 0, PHASE_COMPLETE }, 0, { 0 } },
};

#define N_CASES (sizeof cases / sizeof cases[0])

static const unsigned char *
row_of (cairo_surface_t *surface, int y)
{
  return cairo_image_surface_get_data (surface)
         + (gsize)y * (gsize)cairo_image_surface_get_stride (surface);
}

static int
channel_difference (const unsigned char *a, const unsigned char *b)
{
  int k, most = 0;

  for (k = 0; k < 3; k++)
    most = MAX (most, ABS (a[k] - b[k]));
  return most;
}

/* Returns: the number of pixels that differ; they are black in @diff, the
 *          others a paler picture. */
static int
compare (cairo_surface_t *out, cairo_surface_t *ref, cairo_surface_t *diff)
{
  const int width = cairo_image_surface_get_width (out);
  const int height = cairo_image_surface_get_height (out);
  int x, y, n = 0;

  cairo_surface_flush (diff);
  for (y = 0; y < height; y++)
    for (x = 0; x < width; x++) {
      const unsigned char *a = row_of (out, y) + 4 * x;
      const unsigned char *b = row_of (ref, y) + 4 * x;
      unsigned char *to = (unsigned char *)row_of (diff, y) + 4 * x;
      const gboolean differs = channel_difference (a, b) > CHANNEL_TOLERANCE;
      int k;

      n += differs;
      for (k = 0; k < 3; k++)
        to[k] = differs ? 0 : (unsigned char)(192 + a[k] / 4);
    }
  cairo_surface_mark_dirty (diff);
  return n;
}

static cairo_surface_t *
paint_case (const Case *what, PictureView view)
{
  g_autoptr (Fixture) fixture = fixture_load (what->sites, ORDER_FURTHEST);
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 420, 420);
  cairo_t *cr = cairo_create (surface);
  Picture picture;
  uint32_t step;
  Frame frame;

  g_assert_true (timeline_find (fixture->trace, what->place, false, &step));
  frame_init (&frame, fixture->trace, step);
  picture_init (&picture, view, &frame);
  picture.width = picture.height = 420;
  picture.look.layers |= what->layers;
  picture.look.selection = what->selection;
  picture_paint (&picture, &frame, cr);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  frame_clear (&frame);
  return surface;
}

static void
check_picture (const Case *what, PictureView view, const char *suffix)
{
  g_autofree char *name = g_strconcat (what->name, suffix, NULL);
  g_autofree char *path = fixture_path ("images", name, "-ref.png");
  cairo_surface_t *out = paint_case (what, view);
  cairo_surface_t *ref, *diff;
  int n, n_allowed;

  if (g_getenv ("HULL2VD_RENEW_IMAGES") != NULL) {
    g_assert_cmpint (cairo_surface_write_to_png (out, path), ==,
                     CAIRO_STATUS_SUCCESS);
    cairo_surface_destroy (out);
    return;
  }
  ref = cairo_image_surface_create_from_png (path);
  if (cairo_surface_status (ref) != CAIRO_STATUS_SUCCESS)
    g_error ("%s cannot be read", path);
  g_assert_cmpint (cairo_image_surface_get_width (ref), ==, 420);
  g_assert_cmpint (cairo_image_surface_get_height (ref), ==, 420);
  diff = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 420, 420);
  n = compare (out, ref, diff);
  n_allowed = 420 * 420 * PER_THOUSAND / 1000;
  if (n > n_allowed) {
    g_autofree char *out_name = g_strconcat (name, "-out.png", NULL);
    g_autofree char *diff_name = g_strconcat (name, "-diff.png", NULL);

    cairo_surface_write_to_png (out, out_name);
    cairo_surface_write_to_png (diff, diff_name);
    g_error ("%s: %d pixels differ, %d may; see %s", name, n, n_allowed,
             diff_name);
  }
  cairo_surface_destroy (diff);
  cairo_surface_destroy (ref);
  cairo_surface_destroy (out);
}

static void
test_plane (void)
{
  size_t i;

  for (i = 0; i < N_CASES; i++)
    check_picture (&cases[i], PICTURE_PLANE, "-plane");
}

static void
test_space (void)
{
  size_t i;

  for (i = 0; i < N_CASES; i++)
    check_picture (&cases[i], PICTURE_SPACE, "-space");
}

/* The reference pictures are apart enough for the comparison to tell them:
 * it would see a horizon that is missing. */
static void
test_compare (void)
{
  cairo_surface_t *see = paint_case (&cases[2], PICTURE_PLANE);
  cairo_surface_t *cone = paint_case (&cases[4], PICTURE_PLANE);
  cairo_surface_t *diff
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 420, 420);

  g_assert_cmpint (compare (see, cone, diff), >,
                   420 * 420 * PER_THOUSAND / 1000);
  g_assert_cmpint (compare (see, see, diff), ==, 0);
  cairo_surface_destroy (diff);
  cairo_surface_destroy (cone);
  cairo_surface_destroy (see);
}

/* WCAG asks 3:1 of graphics. Areas and the fine lines of the paraboloid are
 * grounds, not marks. */
static void
test_contrast (void)
{
  int kind, role;

  for (kind = 0; kind < N_THEMES; kind++) {
    const Theme *theme = theme_get ((ThemeKind)kind);

    for (role = 0; role < N_ROLES; role++) {
      const SceneItem item
          = { .role = (Role)role, .emphasis = EMPHASIS_NORMAL };
      const Style style = theme_style (theme, &item);
      guint32 hue;

      if (role == ROLE_SHEET || role == ROLE_VERTICAL || style.line.alpha == 0)
        continue;
      for (hue = 0; hue < 24; hue++) {
        const SceneItem cell
            = { .role = ROLE_CELL, .hue = hue, .emphasis = EMPHASIS_NORMAL };
        const Colour ground = theme_style (theme, &cell).fill;
        const Colour line = colour_over (style.line, ground);

        if (colour_contrast (line, ground) < 3)
          g_error ("%s: role %d has contrast %g on cell %u", theme->name, role,
                   colour_contrast (line, ground), hue);
      }
    }
  }
}

static void
test_text_contrast (void)
{
  int kind;

  for (kind = 0; kind < N_THEMES; kind++) {
    const Theme *theme = theme_get ((ThemeKind)kind);

    g_assert_cmpfloat (colour_contrast (theme->text, theme->background), >=,
                       4.5);
    g_assert_cmpfloat (colour_contrast (theme->apex_text, theme->background),
                       >=, 4.5);
  }
  g_assert_cmpfloat (
      fabs (colour_contrast ((Colour){ 0, 0, 0, 1 }, (Colour){ 1, 1, 1, 1 })
            - 21),
      <, 1e-9);
  /* #777777 on white: a known value. */
  g_assert_cmpfloat (
      fabs (colour_contrast (
                (Colour){ 0x77 / 255.0, 0x77 / 255.0, 0x77 / 255.0, 1 },
                (Colour){ 1, 1, 1, 1 })
            - 4.48),
      <, 0.01);
}

/* The hue of a cell stays with its site, whatever else changes, and differs
 * from that of the next sites. */
static void
test_hues (void)
{
  const Theme *theme = theme_get (THEME_LIGHT);
  guint32 i;

  for (i = 0; i < 40; i++) {
    const SceneItem a = { .role = ROLE_CELL, .hue = i };
    const SceneItem b = { .role = ROLE_CELL, .hue = i + 1 };
    const Colour p = theme_style (theme, &a).fill;
    const Colour q = theme_style (theme, &b).fill;

    g_assert_cmpfloat (fabs (p.red - q.red) + fabs (p.green - q.green)
                           + fabs (p.blue - q.blue),
                       >, 0.02);
  }
}

static gboolean
overlap (const Label *a, const Label *b)
{
  return a->low.x < b->low.x + b->width && b->low.x < a->low.x + a->width
         && a->low.y < b->low.y + b->height && b->low.y < a->low.y + a->height;
}

static gboolean
covers_mark (const Label *label, Pixel at, double reach)
{
  const double x = CLAMP (at.x, label->low.x, label->low.x + label->width);
  const double y = CLAMP (at.y, label->low.y, label->low.y + label->height);

  return hypot (at.x - x, at.y - y) < reach - 2;
}

/* Where there is room, names sit on no mark, on no other name, within the
 * view. */
static void
test_labels (void)
{
  enum { N = 30 };
  g_autoptr (GRand) rand = g_rand_new_with_seed (5);
  LabelSheet *sheet = label_sheet_new (600, 600);
  Label labels[N] = { 0 };
  int i, k;

  for (i = 0; i < N; i++) {
    labels[i] = (Label){ .text = "s1",
                         .at = { 10 + g_rand_double (rand) * 580,
                                 10 + g_rand_double (rand) * 580 },
                         .reach = 7,
                         .width = 24,
                         .height = 14 };
    label_sheet_mark (sheet, labels[i].at, 7);
  }
  label_sheet_place (sheet, labels, N);
  for (i = 0; i < N; i++) {
    g_assert_true (labels[i].is_placed);
    g_assert_true (labels[i].low.x >= 0 && labels[i].low.x + 24 <= 600
                   && labels[i].low.y >= 0 && labels[i].low.y + 14 <= 600);
    for (k = 0; k < N; k++) {
      g_assert_false (covers_mark (&labels[i], labels[k].at, 7));
      g_assert_false (i != k && overlap (&labels[i], &labels[k]));
    }
  }
  label_sheet_free (sheet);
}

/* A name keeps off a line that runs through its favourite place. */
static void
test_labels_avoid_lines (void)
{
  LabelSheet *sheet = label_sheet_new (200, 200);
  Label label = {
    .text = "s1", .at = { 100, 100 }, .reach = 7, .width = 24, .height = 14
  };
  const Pixel right_up[2] = { { 100, 100 }, { 200, 0 } };
  int i;

  label_sheet_line (sheet, right_up, 3);
  label_sheet_place (sheet, &label, 1);
  g_assert_true (label.is_placed);
  for (i = 0; i <= 100; i++) {
    const double x = 100 + i, y = 100 - i;

    g_assert_false (x > label.low.x && x < label.low.x + 24 && y > label.low.y
                    && y < label.low.y + 14);
  }
  label_sheet_free (sheet);
}

/* The important are never left out, the others are where there is no room. */
static void
test_labels_are_left_out (void)
{
  enum { N = 60 };
  LabelSheet *sheet = label_sheet_new (80, 80);
  Label labels[N];
  int i, n_placed = 0;

  for (i = 0; i < N; i++) {
    const int row = i / 8;

    labels[i] = (Label){ .text = "s1",
                         .at = { 40 + i % 8, 40 + row },
                         .reach = 5,
                         .width = 24,
                         .height = 14,
                         .is_important = i == N - 1 };
    label_sheet_mark (sheet, labels[i].at, 5);
  }
  label_sheet_place (sheet, labels, N);
  for (i = 0; i < N; i++)
    n_placed += labels[i].is_placed;
  g_assert_true (labels[N - 1].is_placed);
  g_assert_cmpint (n_placed, <, N);
  label_sheet_free (sheet);
}

/* Every role leaves ink in its legend's sample. */
static void
test_swatches (void)
{
  int role;

  for (role = 0; role < N_ROLES; role++) {
    cairo_surface_t *surface
        = cairo_image_surface_create (CAIRO_FORMAT_ARGB32, 36, 18);
    cairo_t *cr = cairo_create (surface);
    guint n = 0;
    int x, y;

    painter_swatch (cr, (Role)role, theme_get (THEME_LIGHT), 36, 18);
    cairo_destroy (cr);
    cairo_surface_flush (surface);
    for (y = 0; y < 18; y++)
      for (x = 0; x < 36; x++)
        n += row_of (surface, y)[4 * x + 3] > 40;
    if (role != ROLE_FACET_NAME && role != ROLE_POWER && n < 10)
      g_error ("role %d: its sample has %u pixels", role, n);
    cairo_surface_destroy (surface);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/painter/the-plane-looks-as-it-was-seen", test_plane);
  g_test_add_func ("/painter/space-looks-as-it-was-seen", test_space);
  g_test_add_func ("/painter/the-comparison-tells-phases-apart", test_compare);
  g_test_add_func ("/painter/every-role-has-a-sample", test_swatches);
  g_test_add_func ("/theme/every-mark-stands-out-from-every-cell",
                   test_contrast);
  g_test_add_func ("/theme/names-can-be-read", test_text_contrast);
  g_test_add_func ("/theme/the-next-site-has-another-hue", test_hues);
  g_test_add_func ("/label/names-sit-on-no-mark-and-no-name", test_labels);
  g_test_add_func ("/label/names-keep-off-lines", test_labels_avoid_lines);
  g_test_add_func ("/label/only-the-unimportant-are-left-out",
                   test_labels_are_left_out);
  return g_test_run ();
}
