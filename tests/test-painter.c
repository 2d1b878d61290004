/* The painter against pictures that were looked at.
 * HULL2VD_RENEW_IMAGES=1 writes the reference pictures anew. */
#include "drawing.h"
#include "look-case.h"

#include <string.h>

static const unsigned char *
row_of (cairo_surface_t *surface, int y)
{
  return cairo_image_surface_get_data (surface)
         + (gsize)y * (gsize)cairo_image_surface_get_stride (surface);
}

static void
check_all (PictureView view)
{
  guint i;

  for (i = 0; i < look_n_cases; i++) {
    cairo_surface_t *out = look_paint (&look_cases[i], view);
    g_autofree char *path = look_path (&look_cases[i], view);

    if (g_getenv ("HULL2VD_RENEW_IMAGES") != NULL)
      g_assert_cmpint (cairo_surface_write_to_png (out, path), ==,
                       CAIRO_STATUS_SUCCESS);
    look_check_case (&look_cases[i], view, "", out, LOOK_SAME);
    cairo_surface_destroy (out);
  }
}

static void
test_plane (void)
{
  check_all (PICTURE_PLANE);
}

static void
test_space (void)
{
  check_all (PICTURE_SPACE);
}

/* The reference pictures are apart enough for the comparison to tell them:
 * it would see a horizon that is missing. */
static void
test_compare (void)
{
  cairo_surface_t *see = look_paint (&look_cases[2], PICTURE_PLANE);
  cairo_surface_t *cone = look_paint (&look_cases[4], PICTURE_PLANE);
  cairo_surface_t *diff
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, LOOK_SIDE, LOOK_SIDE);

  g_assert_cmpuint (look_compare (see, cone, 1, diff), >,
                    LOOK_SIDE * LOOK_SIDE * LOOK_PER_THOUSAND / 1000);
  g_assert_cmpuint (look_compare (see, see, 0, diff), ==, 0);
  cairo_surface_destroy (diff);
  cairo_surface_destroy (cone);
  cairo_surface_destroy (see);
}

/* Whether a pixel, in the order of RGB24, is one of those that are counted. */
typedef bool (*PixelCheck) (const unsigned char *pixel);

/* Greener than red and than blue by far. */
static bool
is_green (const unsigned char *pixel)
{
  return pixel[1] > pixel[0] + 30 && pixel[1] > pixel[2] + 30;
}

static bool
is_white (const unsigned char *pixel)
{
  return pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
}

static guint
count_pixels (cairo_surface_t *surface, PixelCheck is_counted)
{
  guint n = 0;
  int x, y;

  for (y = 0; y < cairo_image_surface_get_height (surface); y++)
    for (x = 0; x < cairo_image_surface_get_width (surface); x++)
      n += is_counted (row_of (surface, y) + 4 * x);
  return n;
}

static guint
count_green_at (uint32_t step, CameraPreset preset, const Theme *theme)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 300, 300);
  cairo_t *cr = cairo_create (surface);
  Picture picture;
  Frame frame;
  guint n;

  frame_init (&frame, fixture->trace, step);
  picture_init (&picture, PICTURE_SPACE, &frame);
  picture.width = picture.height = 300;
  picture.theme = theme;
  picture.look.layers = LAYER_HULL | LAYER_PARABOLOID;
  camera_init (&picture.camera, preset);
  picture_paint (&picture, &frame, cr);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  n = count_pixels (surface, is_green);
  cairo_surface_destroy (surface);
  frame_clear (&frame);
  return n;
}

static guint
count_white (uint32_t layers)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 300, 300);
  cairo_t *cr = cairo_create (surface);
  Picture picture;
  Frame frame;
  guint n;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  picture_init (&picture, PICTURE_SPACE, &frame);
  picture.width = picture.height = 300;
  picture.theme = theme_get (THEME_PAPER);
  picture.look.layers = layers;
  picture.look.lift = 0;
  picture_paint (&picture, &frame, cr);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  n = count_pixels (surface, is_white);
  cairo_surface_destroy (surface);
  frame_clear (&frame);
  return n;
}

/* What keeps the sheet from shining through facets is gone where they are. */
static void
test_paper_lies_flat (void)
{
  const guint without = count_white (LAYER_VORONOI);
  const guint with = count_white (LAYER_VORONOI | LAYER_HULL);

  g_assert_cmpuint (without, <, 300 * 300 - 5000);
  g_assert_cmpuint (with, <=, without);
}

/* With upper facets in grey and without lines nothing may be green: neither
 * cyan facets before the yellow sheet, nor pale ones, nor those far behind. */
static void
test_paper_has_no_clash (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const uint32_t end = fixture->trace->n_events;
  Theme theme = *theme_get (THEME_PAPER);
  guint n = count_green_at (end, CAMERA_LOOK_DOWN, &theme);
  uint32_t step;
  int role;

  g_assert_cmpuint (n, >, 3000);
  theme.styles[ROLE_UPPER].fill = (Colour){ 0.5, 0.5, 0.5, 1 };
  for (role = 0; role < N_ROLES; role++)
    theme.styles[role].line.alpha = theme.pale_lines[role].alpha = 0;
  for (step = 0; step <= end; step++) {
    n = count_green_at (step, CAMERA_LOOK_UP, &theme);
    g_assert_cmpuint (n, <, 30);
    n = count_green_at (step, CAMERA_HOME, &theme);
    g_assert_cmpuint (n, <, 30);
  }
}

/* Whether a facet's corners run round clockwise in pixels, whose y runs down:
 * then one looks at its outside. */
static gboolean
is_turned_here (const LookScene *look, const SceneItem *facet)
{
  double area = 0;
  uint32_t i;

  for (i = 0; i < facet->n; i++) {
    const Point3 *points = &look->scene.points[facet->first];
    Pixel a, b;

    g_assert_true (clip_point (&look->projection, points[i], &a));
    g_assert_true (
        clip_point (&look->projection, points[(i + 1) % facet->n], &b));
    area += a.x * b.y - a.y * b.x;
  }
  return area < 0;
}

static gboolean
has_corner (const LookScene *look, const SceneItem *facet, Point3 at)
{
  uint32_t i;

  for (i = 0; i < facet->n; i++) {
    const Point3 *corner = &look->scene.points[facet->first + i];

    if (corner->x == at.x && corner->y == at.y && corner->z == at.z)
      return TRUE;
  }
  return FALSE;
}

/* Horizon, cone edges and facet f are drawn over the hull. */
static gboolean
is_drawn_over (const SceneItem *item)
{
  return item->pass == PASS_LINES && item->shape == SHAPE_PATH
         && item->object.kind != OBJECT_SITE && item->role != ROLE_DROP;
}

/* Whether a lift is hidden by its own facets, and the current round is not
 * about it. */
static gboolean
is_behind_hull (const LookScene *look, Point3 lift)
{
  gboolean has_facet = FALSE;
  uint32_t i;

  for (i = 0; i < look->scene.stock.n_items; i++) {
    const SceneItem *item = &look->scene.items[i];

    if (is_drawn_over (item) && has_corner (look, item, lift))
      return FALSE;
    if (item->pass != PASS_HULL || item->shape != SHAPE_POLYGON
        || !has_corner (look, item, lift))
      continue;
    if (item->is_two_sided || item->role >= ROLE_VISIBLE || item->fade >= 0.5
        || is_turned_here (look, item))
      return FALSE;
    has_facet = TRUE;
  }
  return has_facet;
}

/* Returns: the number of sites that are hidden. */
static guint
check_behind (const LookCase *what)
{
  Names *names = names_new ();
  Drawing *drawing = drawing_new (names);
  LookScene look;
  double least;
  guint n = 0;
  uint32_t i;

  look_scene_init (&look, what, PICTURE_SPACE);
  least = 0.9 * look.theme->styles[ROLE_SITE].radius * look.theme->mark_factor;
  drawing_set_stock (drawing, &look.scene, &look.projection, look.theme);
  for (i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const SceneItem *item = look.scene.items;
    gboolean is_small;

    if (stroke->kind != STROKE_MARK || stroke->place.item == INDEX_NONE
        || item[stroke->place.item].role != ROLE_SITE)
      continue;
    item += stroke->place.item;
    is_small = drawing->styles[stroke->style].radius < least;
    if (is_small != is_behind_hull (&look, look.scene.points[item->first]))
      g_error ("%s: %s looks wrong", what->name, item->label);
    n += is_small;
  }
  look_scene_clear (&look);
  drawing_free (drawing);
  names_free (names);
  return n;
}

/* A site that only far facets have lies behind the near ones: its mark must
 * not look as if it lay on them. */
static void
test_behind (void)
{
  guint i, n = 0;

  for (i = 0; i < look_n_cases; i++)
    n += check_behind (&look_cases[i]);
  g_assert_cmpuint (n, >, 10);
}

/* The plane of mixed8 when the cone of round 4 stands, with @answer over it. */
static cairo_surface_t *
paint_answer (const Fixture *fixture,
              ThemeKind theme,
              const SceneAnswer *answer)
{
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, LOOK_SIDE, LOOK_SIDE);
  cairo_t *cr = cairo_create (surface);
  Picture picture;
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->rounds[3].last_cone);
  picture_init (&picture, PICTURE_PLANE, &frame);
  picture.width = picture.height = LOOK_SIDE;
  picture.theme = theme_get (theme);
  picture.look.layers &= ~(uint32_t)LAYER_LABELS;
  picture.look.answers = answer;
  picture.look.n_answers = answer == NULL ? 0 : 1;
  picture_paint (&picture, &frame, cr);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  frame_clear (&frame);
  return surface;
}

/* The row of the ridge that an event tells. */
static uint32_t
ridge_of (const Trace *trace, const Event *event)
{
  for (uint32_t i = 0; i < trace->n_ridges; i++) {
    const RidgeRow row = trace_ridge (trace, i);

    if ((row.site[0] == event->ridge[0] && row.site[1] == event->ridge[1])
        || (row.site[0] == event->ridge[1] && row.site[1] == event->ridge[0]))
      return i;
  }
  g_assert_not_reached ();
}

/* Whoever missed a ridge of the horizon finds it there. */
static void
test_missed_on_the_horizon (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  const RoundRow *round = &fixture->trace->rounds[3];
  cairo_surface_t *diff
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, LOOK_SIDE, LOOK_SIDE);

  for (int theme = 0; theme < N_THEMES; theme++) {
    cairo_surface_t *without = paint_answer (fixture, theme, NULL);

    for (uint32_t i = round->first_horizon; i <= round->last_horizon; i++) {
      const Event event = trace_event (fixture->trace, i - 1);
      const SceneAnswer missed = {
        { OBJECT_RIDGE, ridge_of (fixture->trace, &event) }, ANSWER_MISSED, 0
      };
      cairo_surface_t *out = paint_answer (fixture, theme, &missed);

      g_assert_cmpuint (look_compare (out, without, 0, diff), >, 100);
      cairo_surface_destroy (out);
    }
    cairo_surface_destroy (without);
  }
  cairo_surface_destroy (diff);
}

/* Returns: how much of the ring round a site is in the colour of its role, 0 …
 *          1, where it is @at and has this radius. */
static double
measure_ring (cairo_surface_t *surface, const double at[2], const Style *style)
{
  const Colour ink = style->line;
  const int n = 90;
  int k, n_inked = 0;

  for (k = 0; k < n; k++) {
    const double angle = 2 * G_PI * k / n;
    const int x = (int)(at[0] + style->radius * cos (angle));
    const int y = (int)(at[1] + style->radius * sin (angle));
    const guchar *pixel = row_of (surface, y) + 4 * x;

    n_inked += fabs (pixel[2] - 255 * ink.red) < 60
               && fabs (pixel[1] - 255 * ink.green) < 60
               && fabs (pixel[0] - 255 * ink.blue) < 60;
  }
  return (double)n_inked / n;
}

/* The middle of what differs. */
static void
find_change (cairo_surface_t *a, cairo_surface_t *b, double middle[2])
{
  double low[2] = { LOOK_SIDE, LOOK_SIDE }, high[2] = { 0, 0 };
  int x, y;

  for (y = 0; y < LOOK_SIDE; y++)
    for (x = 0; x < LOOK_SIDE; x++)
      if (memcmp (row_of (a, y) + 4 * x, row_of (b, y) + 4 * x, 3) != 0) {
        low[0] = MIN (low[0], x), high[0] = MAX (high[0], x);
        low[1] = MIN (low[1], y), high[1] = MAX (high[1], y);
      }
  middle[0] = (low[0] + high[0] + 1) / 2;
  middle[1] = (low[1] + high[1] + 1) / 2;
}

static double
ring_of (const Fixture *fixture,
         ThemeKind theme,
         AnswerKind kind,
         Role role,
         const double middle[2])
{
  const SceneAnswer answer = { { OBJECT_SITE, 0 }, kind, 0 };
  const SceneItem item = { .role = role, .emphasis = EMPHASIS_NORMAL };
  const Style style = theme_style (theme_get (theme), &item);
  cairo_surface_t *out = paint_answer (fixture, theme, &answer);
  const double part = measure_ring (out, middle, &style);

  cairo_surface_destroy (out);
  return part;
}

/* As the legend shows it, and the words say. */
static void
test_missed_site (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  const SceneAnswer missed = { { OBJECT_SITE, 0 }, ANSWER_MISSED, 0 };

  for (int theme = 0; theme < N_THEMES; theme++) {
    cairo_surface_t *without = paint_answer (fixture, theme, NULL);
    cairo_surface_t *with = paint_answer (fixture, theme, &missed);
    double middle[2], dots, dashes;

    find_change (without, with, middle);
    dots = ring_of (fixture, theme, ANSWER_MISSED, ROLE_ANSWER_MISSED, middle);
    dashes = ring_of (fixture, theme, ANSWER_WRONG, ROLE_ANSWER_WRONG, middle);
    g_assert_cmpfloat (
        ring_of (fixture, theme, ANSWER_RIGHT, ROLE_ANSWER_RIGHT, middle), >,
        0.8);
    g_assert_cmpfloat (dots, >, 0.2);
    g_assert_cmpfloat (dots, <, 0.7);
    g_assert_cmpfloat (dashes, >, 0.3);
    g_assert_cmpfloat (dashes, <, 0.8);
    cairo_surface_destroy (with);
    cairo_surface_destroy (without);
  }
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
    const SceneItem item = { .role = (Role)role, .emphasis = EMPHASIS_NORMAL };
    guint n = 0;
    int x, y;

    painter_swatch (cr, &item, theme_get (THEME_LIGHT), 36, 18);
    cairo_destroy (cr);
    cairo_surface_flush (surface);
    for (y = 0; y < 18; y++)
      for (x = 0; x < 36; x++)
        n += row_of (surface, y)[4 * x + 3] > 40;
    if (role != ROLE_FACET_NAME && role != ROLE_ANSWER_NAME
        && role != ROLE_POWER && n < 10)
      g_error ("role %d: its sample has %u pixels", role, n);
    cairo_surface_destroy (surface);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/painter/a-missed-site-has-a-ring-of-dots-a-wrong-one-of-"
                   "dashes",
                   test_missed_site);
  g_test_add_func ("/painter/the-plane-looks-as-it-was-seen", test_plane);
  g_test_add_func ("/painter/space-looks-as-it-was-seen", test_space);
  g_test_add_func ("/painter/the-comparison-tells-phases-apart", test_compare);
  g_test_add_func ("/painter/every-role-has-a-sample", test_swatches);
  g_test_add_func ("/painter/what-was-missed-is-seen-on-the-horizon",
                   test_missed_on_the_horizon);
  g_test_add_func ("/painter/sites-behind-the-hull-do-not-look-as-if-before-it",
                   test_behind);
  g_test_add_func ("/painter/the-flat-hull-of-the-paper-hides-no-cell",
                   test_paper_lies_flat);
  g_test_add_func ("/painter/no-facet-of-the-paper-is-green-by-mixture",
                   test_paper_has_no_clash);
  return g_test_run ();
}
