/* What lies over what in a picture, and that both are still seen. */
#include "brush.h"
#include "drawing.h"
#include "sight.h"
#include "stage.h"

#include <string.h>

#define NONE G_MAXUINT

/* Places of items in a scene */

static guint
first_of (const Scene *scene, Role role)
{
  for (guint i = 0; i < scene->n_items; i++)
    if (scene->items[i].role == role)
      return i;
  return NONE;
}

static guint
last_in_plane (const Scene *scene, Role role)
{
  guint last = NONE;

  for (guint i = 0; i < scene->n_items; i++)
    if (scene->items[i].role == role && scene->items[i].pass == PASS_GROUND)
      last = i;
  return last;
}

/* Returns: how many circles of the round lie over the cone's shadow. */
static guint
count_circles_over_cone (const Scene *scene)
{
  const guint cone = last_in_plane (scene, ROLE_CONE);
  guint i, n = 0;

  for (i = 0; i < scene->n_items && cone != NONE; i++) {
    const SceneItem *item = &scene->items[i];

    if (item->role != ROLE_CIRCLE_VISIBLE && item->role != ROLE_CIRCLE_UPPER)
      continue;
    g_assert_cmpuint (i, >, cone);
    if (item->role == ROLE_CIRCLE_UPPER)
      g_assert_cmpint (item->emphasis, !=, EMPHASIS_PALE);
    n++;
  }
  return n;
}

static void
test_circles (void)
{
  guint n = 0;

  for (guint round = 1; round <= 4; round++) {
    g_autoptr (Stage) stage = stage_new ("mixed8", round, PHASE_CONE);

    n += count_circles_over_cone (&stage->plane);
    n += count_circles_over_cone (&stage->space);
  }
  g_assert_cmpuint (n, >=, 10);
}

/* A circle of an upper facet is dots: there is little ink to see it by. */
static void
check_dots (const Theme *theme)
{
  const Style cone = sight_style (theme, ROLE_CONE);
  const Style dots = sight_style (theme, ROLE_CIRCLE_UPPER);

  for (guint hue = 0; hue < 24; hue++) {
    const SceneItem cell = { .role = ROLE_CELL, .hue = hue };
    const Colour beneath
        = sight_over (cone.fill, theme_style (theme, &cell).fill);
    const double value = sight_contrast (dots.line, beneath);

    if (value < 3)
      sight_fault (theme, "dots", ROLE_CIRCLE_UPPER, "cone", value);
  }
}

static void
test_dots (void)
{
  sight_for_each_theme (check_dots);
}

static void
test_dying (void)
{
  g_autoptr (Stage) stage = stage_new ("lecture8", 4, PHASE_SEE);
  const Scene *const scenes[] = { &stage->plane, &stage->space };
  const Role sites[] = { ROLE_SITE, ROLE_SITE_APEX, ROLE_FOOT, ROLE_FOOT_APEX };

  for (guint i = 0; i < G_N_ELEMENTS (scenes); i++) {
    const guint dying = first_of (scenes[i], ROLE_VORONOI_VERTEX_DYING);

    g_assert_cmpuint (dying, !=, NONE);
    for (guint k = 0; k < G_N_ELEMENTS (sites); k++) {
      const guint last = scenes[i]->is_space
                             ? last_in_plane (scenes[i], sites[k])
                             : first_of (scenes[i], sites[k]);

      g_assert_true (last == NONE || last < dying);
    }
  }
}

/* Pixels of marks and lines */

#define SIDE 60
#define MIDDLE 30.0

/* Paints two roles, one over the other; N_ROLES: nothing. */
typedef void (*Paint) (cairo_t *cr, const Theme *theme, Role role);

static cairo_surface_t *
paint_both (Paint paint, const Theme *theme, Role below, Role above)
{
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, SIDE, SIDE);
  cairo_t *cr = cairo_create (surface);

  brush_colour (cr, theme->background);
  cairo_paint (cr);
  if (below != N_ROLES)
    paint (cr, theme, below);
  if (above != N_ROLES)
    paint (cr, theme, above);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

static Colour
colour_at (cairo_surface_t *surface, int x, int y)
{
  const unsigned char *at = cairo_image_surface_get_data (surface)
                            + y * cairo_image_surface_get_stride (surface)
                            + 4 * x;

  return (Colour){ at[2] / 255.0, at[1] / 255.0, at[0] / 255.0, 1 };
}

/* Returns: how many pixels are clearly others. */
static guint
count_differences (cairo_surface_t *a, cairo_surface_t *b)
{
  guint n = 0;

  for (int y = 0; y < SIDE; y++)
    for (int x = 0; x < SIDE; x++)
      n += sight_distance (colour_at (a, x, y), colour_at (b, x, y),
                           sight_visions[0])
           > 0.1;
  cairo_surface_destroy (a);
  cairo_surface_destroy (b);
  return n;
}

static void
check_both (const Theme *theme, Paint paint, Role below, Role above)
{
  const guint above_seen
      = count_differences (paint_both (paint, theme, below, above),
                           paint_both (paint, theme, below, N_ROLES));
  const guint below_seen
      = count_differences (paint_both (paint, theme, below, above),
                           paint_both (paint, theme, N_ROLES, above));

  if (above_seen < 20)
    sight_fault (theme, "upper mark", (int)above, "pixels", above_seen);
  if (below_seen < 20)
    sight_fault (theme, "lower mark", (int)below, "pixels", below_seen);
}

static void
paint_mark (cairo_t *cr, const Theme *theme, Role role)
{
  const Style style = sight_style (theme, role);

  brush_mark (cr, &style, theme, (Pixel){ MIDDLE, MIDDLE });
}

/* Also where the vertex is right on the site. */
static void
check_diamond (const Theme *theme)
{
  check_both (theme, paint_mark, ROLE_SITE, ROLE_VORONOI_VERTEX_DYING);
  check_both (theme, paint_mark, ROLE_SITE_APEX, ROLE_VORONOI_VERTEX_DYING);
  check_both (theme, paint_mark, ROLE_SITE_OUTSIDE, ROLE_VORONOI_VERTEX_DYING);
}

static void
test_diamond (void)
{
  sight_for_each_theme (check_diamond);
}

static void
paint_line (cairo_t *cr, const Theme *theme, Role role)
{
  const Style style = sight_style (theme, role);

  cairo_move_to (cr, 0, MIDDLE);
  cairo_line_to (cr, SIDE, MIDDLE);
  brush_line (cr, &style);
}

/* The upper line is lighter or darker by so much, or wider. */
#define INKS_RATIO 2.0
#define WIDTHS_RATIO 1.3

/* The edges of the hull are edges of both triangulations. */
static void
check_furthest (const Theme *theme)
{
  const Style below = sight_style (theme, ROLE_DELAUNAY_EDGE);
  const Style above = sight_style (theme, ROLE_FURTHEST_EDGE);
  const double ratio = sight_contrast (below.line, above.line);
  const gboolean is_wider = above.dash > 0 && above.gap > 0
                            && above.width >= WIDTHS_RATIO * below.width;

  check_both (theme, paint_line, ROLE_DELAUNAY_EDGE, ROLE_FURTHEST_EDGE);
  if (ratio < INKS_RATIO && !is_wider)
    sight_fault (theme, "furthest edge", ROLE_FURTHEST_EDGE, "edge", ratio);
}

static void
test_furthest (void)
{
  sight_for_each_theme (check_furthest);
}

/* Strokes of a drawing */

static Drawing *
draw (const Scene *scene,
      const Projection *projection,
      ThemeKind theme,
      Names *names)
{
  Drawing *drawing = drawing_new (names);

  drawing_set (drawing, scene, projection, theme_get (theme));
  return drawing;
}

static Role
role_of (const Scene *scene, const Stroke *stroke)
{
  return stroke->place.item == INDEX_NONE
             ? N_ROLES
             : scene->items[stroke->place.item].role;
}

/* An edge that leaves the horizon, or a site on a circle, at a small angle has
 * no gap beside it. */
static void
check_casings (Phase phase, Role line)
{
  g_autoptr (Stage) stage = stage_new ("lecture8", 3, phase);
  const Scene *scene = &stage->plane;
  Names *names = names_new ();
  Drawing *drawing = draw (scene, &stage->on_plane, THEME_PROJECTOR, names);
  guint n_casings = 0, n_edges = 0;

  for (guint i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Role role = role_of (scene, stroke);

    n_edges += role == ROLE_DELAUNAY_EDGE && stroke->kind == STROKE_LINE;
    if (role != line || stroke->kind != STROKE_CASING)
      continue;
    g_assert_cmpuint (n_edges, ==, 0);
    n_casings++;
  }
  g_assert_cmpuint (n_casings, ==, stage_count (scene, line));
  g_assert_cmpuint (n_casings, >, 0);
  g_assert_cmpuint (n_edges, >, 3);
  drawing_free (drawing);
  names_free (names);
}

static void
test_horizon (void)
{
  check_casings (PHASE_HORIZON, ROLE_HORIZON);
}

static void
test_circle_casings (void)
{
  check_casings (PHASE_HORIZON, ROLE_CIRCLE_VISIBLE);
  check_casings (PHASE_CONE, ROLE_CIRCLE_VISIBLE);
}

/* As the legend says, also in a small crowd. */
static void
test_lifts (void)
{
  Fixture *fixture = fixture_new (FAMILY_RANDOM, 3, 60, ORDER_FURTHEST);
  g_autoptr (Stage) stage = stage_take (fixture, fixture->trace->n_events);
  Names *names = names_new ();
  Drawing *drawing;
  guint n = 0;

  stage_project (stage, 360, 600);
  drawing = draw (&stage->space, &stage->on_space, THEME_PROJECTOR, names);
  for (guint i = 0; i < drawing->n_strokes; i++)
    if (role_of (&stage->space, &drawing->strokes[i]) == ROLE_LIFT) {
      g_assert_cmpfloat (drawing->styles[drawing->strokes[i].style].dash, >, 1);
      n++;
    }
  g_assert_cmpuint (n, >, 30);
  drawing_free (drawing);
  names_free (names);
}

/* In space a Voronoi vertex is tiny, but never when it is selected. */
static guint
count_lit_vertices (const Stage *stage, ThemeKind theme)
{
  Names *names = names_new ();
  Drawing *drawing = draw (&stage->space, &stage->on_space, theme, names);
  guint n = 0;

  for (guint i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];

    n += stroke->kind == STROKE_MARK
         && role_of (&stage->space, stroke) == ROLE_VORONOI_VERTEX
         && drawing->styles[stroke->style].halo.alpha > 0;
  }
  drawing_free (drawing);
  names_free (names);
  return n;
}

/* Vertices may lie beyond the ground that is shown. */
static void
test_lit_vertex (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  guint n[N_THEMES] = { 0 };

  for (guint i = 0; i < stage->frame.delaunay.n_triangles; i++) {
    stage->look.selection
        = (Object){ OBJECT_VERTEX, stage->frame.delaunay.triangles[i].facet };
    stage_draw (stage);
    for (int theme = 0; theme < N_THEMES; theme++)
      n[theme] += count_lit_vertices (stage, (ThemeKind)theme);
  }
  g_assert_cmpuint (n[THEME_LIGHT], >=, 4);
  for (int theme = 0; theme < N_THEMES; theme++)
    g_assert_cmpuint (n[theme], ==, n[THEME_LIGHT]);
}

/* Answers */

static guint
count_names (const Scene *scene, const char *name)
{
  guint n = 0;

  for (guint i = 0; i < scene->n_items; i++)
    n += g_strcmp0 (scene->items[i].label, name) == 0;
  return n;
}

/* What is said of an answer names its facet: so do the pictures, once, in one
 * word with the sign. The facet of the step is one of them. */
static void
test_answers (void)
{
  g_autoptr (Stage) stage = stage_new ("lecture8", 4, PHASE_SEE);
  const uint32_t named
      = trace_event (stage->fixture->trace, stage->frame.step - 1).facet;
  const uint32_t other = stage->frame.delaunay.triangles[0].facet;
  const SceneAnswer answers[] = {
    { { OBJECT_VERTEX, named }, ANSWER_RIGHT, 0 },
    { { OBJECT_FACET, other }, ANSWER_MISSED, 0 },
  };
  const Scene *const scenes[] = { &stage->plane, &stage->space };
  g_autofree char *right = g_strdup_printf ("f%u ✓", named);
  g_autofree char *missed = g_strdup_printf ("f%u", other);
  g_autofree char *bare = g_strdup_printf ("f%u", named);

  g_assert_cmpuint (named, !=, other);
  for (guint i = 0; i < G_N_ELEMENTS (scenes); i++)
    g_assert_cmpuint (count_names (scenes[i], bare), ==, 1);
  stage->look.answers = answers;
  stage->look.n_answers = G_N_ELEMENTS (answers);
  stage_draw (stage);
  for (guint i = 0; i < G_N_ELEMENTS (scenes); i++) {
    g_assert_cmpuint (count_names (scenes[i], right), ==, 1);
    g_assert_cmpuint (count_names (scenes[i], missed), ==, 1);
    g_assert_cmpuint (count_names (scenes[i], bare), ==, 0);
    g_assert_cmpuint (count_names (scenes[i], "✓"), ==, 0);
  }
}

/* Facets of which two are seen edge-on lie one on the other. */
static void
test_missed (void)
{
  g_autoptr (Stage) stage = stage_new ("lecture8", 4, PHASE_SEE);
  const Delaunay *delaunay = &stage->frame.delaunay;
  const SceneAnswer answers[] = {
    { { OBJECT_FACET, delaunay->triangles[0].facet }, ANSWER_RIGHT, 0 },
    { { OBJECT_FACET, delaunay->triangles[1].facet }, ANSWER_MISSED, 0 },
  };
  const Scene *const scenes[] = { &stage->plane, &stage->space };

  stage->look.answers = answers;
  stage->look.n_answers = G_N_ELEMENTS (answers);
  stage_draw (stage);
  for (guint i = 0; i < G_N_ELEMENTS (scenes); i++) {
    const guint missed = first_of (scenes[i], ROLE_ANSWER_MISSED);
    const guint right = first_of (scenes[i], ROLE_ANSWER_RIGHT);

    g_assert_cmpuint (missed, !=, NONE);
    g_assert_cmpuint (right, !=, NONE);
    g_assert_cmpuint (missed, <, right);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/overlay/circles-of-the-round-lie-over-the-cones-shadow",
                   test_circles);
  g_test_add_func ("/overlay/dots-stand-out-from-the-cones-shadow", test_dots);
  g_test_add_func ("/overlay/what-dies-lies-over-all-sites", test_dying);
  g_test_add_func ("/overlay/a-site-and-a-vertex-in-one-place-are-both-seen",
                   test_diamond);
  g_test_add_func ("/overlay/both-triangulations-are-seen-on-the-hull",
                   test_furthest);
  g_test_add_func ("/overlay/edges-reach-the-horizon", test_horizon);
  g_test_add_func ("/overlay/circles-do-not-cut-edges", test_circle_casings);
  g_test_add_func ("/overlay/lifts-in-a-small-crowd-are-dashed", test_lifts);
  g_test_add_func ("/overlay/a-selected-vertex-is-seen-in-space",
                   test_lit_vertex);
  g_test_add_func ("/overlay/answers-have-the-names-of-their-facets",
                   test_answers);
  g_test_add_func ("/overlay/what-was-missed-covers-no-other-answer",
                   test_missed);
  return g_test_run ();
}
