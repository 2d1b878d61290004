/* The raster of the screen against cairo's pictures, and a part of a picture
 * painted alone against the whole. */
#include "easel.h"
#include "look-case.h"
#include "raster.h"

#include <string.h>

static guint
n_different (cairo_surface_t *a, cairo_surface_t *b)
{
  const int stride = cairo_image_surface_get_stride (a);
  const int height = cairo_image_surface_get_height (a);
  const int width = cairo_image_surface_get_width (a);
  guint n = 0;

  cairo_surface_flush (a);
  cairo_surface_flush (b);
  g_assert_cmpint (cairo_image_surface_get_stride (b), ==, stride);
  g_assert_cmpint (cairo_image_surface_get_height (b), ==, height);
  for (int y = 0; y < height; y++)
    for (int x = 0; x < width; x++)
      n += memcmp (cairo_image_surface_get_data (a) + y * stride + 4 * x,
                   cairo_image_surface_get_data (b) + y * stride + 4 * x, 3)
           != 0;
  return n;
}

static void
check_case (const LookCase *what, PictureView view)
{
  Raster *raster = raster_new (LOOK_SIDE, LOOK_SIDE, 1);
  Names *names = names_new ();
  Drawing *drawing = drawing_new (names);
  LookScene look;

  look_scene_init (&look, what, view);
  drawing_set (drawing, &look.scene, &look.projection, look.theme);
  raster_paint (raster, drawing, NULL);
  look_check_case (what, view, "-raster", raster_get_surface (raster),
                   LOOK_ALIKE);
  look_scene_clear (&look);
  drawing_free (drawing);
  names_free (names);
  raster_free (raster);
}

static void
test_pictures (void)
{
  for (guint i = 0; i < look_n_cases; i++) {
    check_case (&look_cases[i], PICTURE_PLANE);
    check_case (&look_cases[i], PICTURE_SPACE);
  }
}

/* Every theme has the same strokes under both. */
static void
test_themes (void)
{
  for (int kind = 0; kind < N_THEMES; kind++) {
    cairo_surface_t *ref
        = cairo_image_surface_create (CAIRO_FORMAT_RGB24, LOOK_SIDE, LOOK_SIDE);
    cairo_t *cr = cairo_create (ref);
    const Theme *theme = theme_get ((ThemeKind)kind);
    g_autofree char *name = g_strconcat (theme->name, "-raster", NULL);
    Easel *easel = easel_new ();
    LookScene look;

    look_scene_init (&look, &look_cases[8], PICTURE_SPACE);
    painter_paint (cr, &look.scene, &look.projection, theme, 0);
    cairo_destroy (cr);
    cairo_surface_flush (ref);
    cairo_region_destroy (
        easel_paint (easel, &look.scene, &look.projection, theme, 1));
    look_check (name, easel_get_surface (easel), ref, LOOK_ALIKE);
    look_scene_clear (&look);
    easel_free (easel);
    cairo_surface_destroy (ref);
  }
}

/* Two device pixels to a px: the same picture as cairo's on such a surface.
 */
static void
test_scale (void)
{
  cairo_surface_t *ref = cairo_image_surface_create (
      CAIRO_FORMAT_RGB24, 2 * LOOK_SIDE, 2 * LOOK_SIDE);
  cairo_t *cr = cairo_create (ref);
  Easel *easel = easel_new ();
  LookScene look;

  look_scene_init (&look, &look_cases[6], PICTURE_SPACE);
  cairo_scale (cr, 2, 2);
  painter_paint (cr, &look.scene, &look.projection, look.theme, 0);
  cairo_destroy (cr);
  cairo_surface_flush (ref);
  cairo_region_destroy (
      easel_paint (easel, &look.scene, &look.projection, look.theme, 2));
  look_check ("scale-2-raster", easel_get_surface (easel), ref, LOOK_ALIKE);
  look_scene_clear (&look);
  easel_free (easel);
  cairo_surface_destroy (ref);
}

/* Random walks */

typedef struct Walk {
  GRand *rand;
  const Fixture *fixture;
  Scene scene; /* relit, when only the light has changed */
  Scene whole; /* filled anew */
  SceneLook look;
  uint32_t selected[2];
  guint step; /* that the scene is of */
  gboolean is_space;
  guint n_partly; /* pictures of which only a part was painted */
  guint n_relit;
} Walk;

static void
fill (const Walk *walk, Scene *scene, const Frame *frame)
{
  if (walk->is_space)
    scene_space (scene, frame, &walk->look);
  else
    scene_plane (scene, frame, &walk->look);
}

static Projection
build (Walk *walk, guint step)
{
  Projection projection;
  PlaneCamera plane_camera;
  Camera camera;
  Frame frame;

  plane_camera_init (&plane_camera);
  camera_init (&camera, CAMERA_HOME);
  frame_init (&frame, walk->fixture->trace, step);
  projection = walk->is_space
                   ? camera_projection (&camera, 300, 300)
                   : plane_camera_projection (&plane_camera, 300, 300);
  if (!walk->is_space)
    scene_look_fit (&walk->look, &projection, 6);
  if (walk->step == step && scene_relight (&walk->scene, &frame, &walk->look))
    walk->n_relit++;
  else
    fill (walk, &walk->scene, &frame);
  fill (walk, &walk->whole, &frame);
  walk->step = step;
  frame_clear (&frame);
  return projection;
}

static guint
area_of (const cairo_region_t *region)
{
  guint area = 0;

  for (int i = 0; i < cairo_region_num_rectangles (region); i++) {
    cairo_rectangle_int_t part;

    cairo_region_get_rectangle (region, i, &part);
    area += (guint)(part.width * part.height);
  }
  return area;
}

/* Any event after any other, with anything lit. */
static guint
choose (Walk *walk)
{
  const Trace *trace = walk->fixture->trace;

  walk->look.hover = (Object){
    OBJECT_SITE,
    (uint32_t)g_rand_int_range (walk->rand, 0, (int)walk->fixture->set->n_sites)
  };
  if (trace->n_facets > 0)
    walk->look.selection
        = (Object){ g_rand_boolean (walk->rand) ? OBJECT_FACET : OBJECT_NONE,
                    (uint32_t)g_rand_int_range (walk->rand, 0,
                                                (int)trace->n_facets) };
  return (guint)g_rand_int_range (walk->rand, 0, (int)trace->n_events + 1);
}

/* An object of any kind that the trace has rows of. */
static Object
choose_object (Walk *walk)
{
  const Trace *trace = walk->fixture->trace;
  const uint32_t n_rows[] = { [OBJECT_NONE] = 1,
                              [OBJECT_SITE] = walk->fixture->set->n_sites,
                              [OBJECT_FACET] = trace->n_facets,
                              [OBJECT_VERTEX] = trace->n_facets,
                              [OBJECT_RIDGE] = trace->n_ridges };
  const int kind = g_rand_int_range (walk->rand, 0, G_N_ELEMENTS (n_rows));

  if (kind == OBJECT_NONE || n_rows[kind] == 0)
    return (Object){ OBJECT_NONE, 0 };
  return (Object){ (ObjectKind)kind, (uint32_t)g_rand_int_range (
                                         walk->rand, 0, (int)n_rows[kind]) };
}

/* Two sites of those that are selected beside the selection; or none. */
static void
choose_sites (Walk *walk)
{
  const uint32_t n = walk->fixture->set->n_sites;

  walk->selected[0] = (uint32_t)g_rand_int_range (walk->rand, 0, (int)n / 2);
  walk->selected[1]
      = (uint32_t)g_rand_int_range (walk->rand, (int)n / 2, (int)n);
  walk->look.selected = walk->selected;
  walk->look.n_selected = g_rand_boolean (walk->rand) ? 2 : 0;
}

static void
choose_preview (Walk *walk)
{
  const Point3 at = { g_rand_double_range (walk->rand, -1, 1),
                      g_rand_double_range (walk->rand, -1, 1), 0 };

  walk->look.has_preview = g_rand_boolean (walk->rand);
  walk->look.preview = scene_site (&walk->look, at);
}

/* The next event; or the same one with other objects lit; or any one. */
static guint
go_on (Walk *walk, guint step, guint turn)
{
  switch (turn % 6) {
  case 1:
    walk->look.hover = choose_object (walk);
    return step;
  case 2:
    walk->look.selection = choose_object (walk);
    return step;
  case 3:
    choose_sites (walk);
    return step;
  case 4:
    choose_preview (walk);
    return step;
  case 5:
    return choose (walk);
  default:
    return MIN (step + 1, walk->fixture->trace->n_events);
  }
}

static void
take_steps (Walk *walk, Easel *easel, guint n)
{
  const Theme *theme = theme_get (THEME_LIGHT);
  guint step = choose (walk);

  for (guint i = 0; i < n; i++) {
    Easel *fresh = easel_new ();
    Projection projection;
    cairo_region_t *region;

    step = go_on (walk, step, i);
    projection = build (walk, step);
    region = easel_paint (easel, &walk->scene, &projection, theme, 1);
    walk->n_partly += area_of (region) < 300 * 300 / 2;
    cairo_region_destroy (region);
    cairo_region_destroy (
        easel_paint (fresh, &walk->whole, &projection, theme, 1));
    if (n_different (easel_get_surface (easel), easel_get_surface (fresh)) > 0)
      g_error (
          "%s, step %u: %u pixels are old", walk->fixture->name, step,
          n_different (easel_get_surface (easel), easel_get_surface (fresh)));
    easel_free (fresh);
  }
}

static void
walk_through (const Fixture *fixture, guint n_steps)
{
  for (int is_space = 0; is_space < 2; is_space++) {
    Walk walk = { .rand = g_rand_new_with_seed (7),
                  .fixture = fixture,
                  .step = G_MAXUINT,
                  .is_space = is_space };
    Easel *easel = easel_new ();
    Frame frame;

    frame_init (&frame, fixture->trace, 0);
    scene_look_init (&walk.look, &frame);
    frame_clear (&frame);
    walk.look.layers |= LAYER_WHY | LAYER_CIRCLES;
    take_steps (&walk, easel, n_steps);
    g_assert_cmpuint (walk.n_partly, >, n_steps / 6);
    g_assert_cmpuint (walk.n_relit, >, n_steps / 3);
    scene_clear (&walk.scene);
    scene_clear (&walk.whole);
    easel_free (easel);
    g_rand_free (walk.rand);
  }
}

/* Where sites crowd, marks are small and only what is lit has a name. */
static void
test_crowd (void)
{
  g_autoptr (Fixture) crowd
      = fixture_new (FAMILY_RANDOM, 3, 300, ORDER_FURTHEST);

  walk_through (crowd, 18);
}

static void
test_parts (void)
{
  for (guint seed = 1; seed <= fixture_n_seeds (2); seed++) {
    g_autoptr (Fixture) random
        = fixture_new (FAMILY_RANDOM, seed, 40, ORDER_FURTHEST);
    g_autoptr (Fixture) ties
        = fixture_new (FAMILY_TIES, seed, 30, ORDER_FURTHEST);

    walk_through (random, 48);
    walk_through (ties, 48);
  }
}

/* Facets and ridges have other numbers when a site has moved, and yet most of
 * the picture stays. */
static cairo_region_t *
paint_sites (Easel *easel, const Site *sites, guint n, gboolean is_space)
{
  static const Order order = { ORDER_FURTHEST, 0 };
  SiteSet *set = site_set_new (sites, n);
  Walk walk = { .is_space = is_space, .step = G_MAXUINT };
  Fixture *fixture = fixture_take (g_strdup ("moved"), set, &order);
  cairo_region_t *region;
  Projection projection;
  Frame frame;

  walk.fixture = fixture;
  frame_init (&frame, fixture->trace, 0);
  scene_look_init (&walk.look, &frame);
  frame_clear (&frame);
  walk.look.extent = (Extent){ { 0, 0 }, 1 };
  projection = build (&walk, fixture->trace->n_events);
  region = easel_paint (easel, &walk.scene, &projection,
                        theme_get (THEME_LIGHT), 1);
  scene_clear (&walk.scene);
  scene_clear (&walk.whole);
  fixture_free (fixture);
  return region;
}

static void
test_move (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (2);
  Site sites[300];

  for (guint i = 0; i < G_N_ELEMENTS (sites); i++)
    sites[i] = (Site){ g_rand_double_range (rand, -1, 1),
                       g_rand_double_range (rand, -1, 1) };
  for (int is_space = 0; is_space < 2; is_space++) {
    Easel *easel = easel_new ();
    cairo_region_t *region;

    sites[7] = (Site){ 0.1, 0.1 };
    cairo_region_destroy (
        paint_sites (easel, sites, G_N_ELEMENTS (sites), is_space));
    sites[7] = (Site){ 0.15, 0.12 };
    region = paint_sites (easel, sites, G_N_ELEMENTS (sites), is_space);
    g_assert_cmpuint (area_of (region), >, 0);
    g_assert_cmpuint (area_of (region), <, 300 * 300 / 8);
    cairo_region_destroy (region);
    easel_free (easel);
  }
}

/* What did not change is not painted. */
static void
test_nothing (void)
{
  Easel *easel = easel_new ();
  cairo_region_t *region;
  LookScene look;

  look_scene_init (&look, &look_cases[4], PICTURE_SPACE);
  cairo_region_destroy (
      easel_paint (easel, &look.scene, &look.projection, look.theme, 1));
  region = easel_paint (easel, &look.scene, &look.projection, look.theme, 1);
  g_assert_true (cairo_region_is_empty (region));
  cairo_region_destroy (region);
  look_scene_clear (&look);
  easel_free (easel);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/raster/its-pictures-are-those-of-cairo", test_pictures);
  g_test_add_func ("/raster/every-theme-looks-as-in-cairo", test_themes);
  g_test_add_func ("/raster/fine-screens-show-the-same-picture", test_scale);
  g_test_add_func ("/easel/a-part-painted-alone-has-the-same-pixels",
                   test_parts);
  g_test_add_func ("/easel/in-a-crowd-as-well", test_crowd);
  g_test_add_func ("/easel/a-site-that-moves-changes-what-is-near", test_move);
  g_test_add_func ("/easel/what-did-not-change-is-not-painted", test_nothing);
  return g_test_run ();
}
