/* What a click means, and what is lit with it. */
#include "stage.h"

#include <math.h>

/* A site takes the click on its mark, in both views. */
static void
test_pick_sites (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  uint32_t i;

  for (i = 0; i < stage->frame.n_sites; i++) {
    const Pixel plane = stage_pixel (
        &stage->on_plane,
        scene_point (&stage->look, stage_site (stage, i), false));
    const Pixel space
        = stage_pixel (&stage->on_space,
                       scene_point (&stage->look, stage_site (stage, i), true));
    const Object on_plane
        = scene_pick (&stage->plane, &stage->on_plane,
                      (double[2]){ plane.x + 3, plane.y - 2 }, 8);
    const Object on_space = scene_pick (&stage->space, &stage->on_space,
                                        (double[2]){ space.x + 1, space.y }, 8);

    g_assert_cmpint (on_plane.kind, ==, OBJECT_SITE);
    g_assert_cmpuint (on_plane.number, ==, i);
    g_assert_cmpint (on_space.kind, ==, OBJECT_SITE);
    g_assert_cmpuint (on_space.number, ==, i);
  }
}

static double
squared (double x, double y)
{
  return x * x + y * y;
}

/* Without triangles, a click in the plane is in the cell of the nearest
 * site. */
static void
check_cells (const Fixture *fixture)
{
  Stage *stage = g_new0 (Stage, 1);
  g_autoptr (GRand) rand = g_rand_new_with_seed (3);
  int i;

  stage->fixture = (Fixture *)fixture;
  frame_init (&stage->frame, fixture->trace, fixture->trace->n_events);
  scene_look_init (&stage->look, &stage->frame);
  stage_project (stage, 500, 500);
  stage->look.layers = LAYER_VORONOI;
  scene_plane (&stage->plane, &stage->frame, &stage->look);
  for (i = 0; i < 40; i++) {
    const double at[2] = { g_rand_double_range (rand, 8, 492),
                           g_rand_double_range (rand, 8, 492) };
    const Object picked = scene_pick (&stage->plane, &stage->on_plane, at, 0);
    const Point3 point = projection_unapply (&stage->on_plane, at[0], at[1]);
    double least = INFINITY;
    uint32_t k;

    for (k = 0; k < stage->frame.n_sites; k++) {
      const Point3 site
          = scene_point (&stage->look, stage_site (stage, k), false);

      least = fmin (least, squared (site.x - point.x, site.y - point.y));
    }
    if (picked.kind == OBJECT_SITE) {
      const Point3 site = scene_point (
          &stage->look, stage_site (stage, picked.number), false);

      if (squared (site.x - point.x, site.y - point.y) > least + 1e-6)
        g_error ("%s: s%u is not nearest to %g, %g", fixture->name,
                 picked.number, at[0], at[1]);
    } else if (picked.kind != OBJECT_RIDGE && picked.kind != OBJECT_VERTEX) {
      g_error ("%s: nothing at %g, %g", fixture->name, at[0], at[1]);
    }
  }
  scene_clear (&stage->plane);
  frame_clear (&stage->frame);
  g_free (stage);
}

static void
test_cells (void)
{
  fixture_for_each (3, 20, ORDER_FURTHEST, check_cells);
}

/* Where the line of sight through @corners' plane meets the pixel, or
 * infinity: smaller is nearer. By solving for barycentric coordinates in the
 * view. */
static double
depth_at (const Stage *stage, const SceneItem *item, Pixel at)
{
  const Point3 *points = &stage->space.points[item->first];
  Point3 p[3];
  double area, b[3];
  int k;

  for (k = 0; k < 3; k++)
    p[k] = projection_apply (&stage->on_space, points[k]);
  area = (p[1].x - p[0].x) * (p[2].y - p[0].y)
         - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  for (k = 0; k < 3; k++) {
    const Point3 q = p[(k + 1) % 3], r = p[(k + 2) % 3];

    b[k] = ((r.x - q.x) * (at.y - q.y) - (r.y - q.y) * (at.x - q.x)) / area;
    if (!(b[k] > 1e-6))
      return INFINITY;
  }
  return b[0] * p[0].z + b[1] * p[1].z + b[2] * p[2].z;
}

/* The facet picked is the nearest to the eye of all that the line of sight
 * meets, whatever the camera. */
static void
test_pick_nearest (void)
{
  g_autoptr (Stage) stage = stage_at_end ("mixed8");
  g_autoptr (GRand) rand = g_rand_new_with_seed (11);
  int i, n_facets = 0;

  stage->look.layers = LAYER_HULL;
  stage_draw (stage);
  for (i = 0; i < 300; i++) {
    const double at[2] = { g_rand_double_range (rand, 100, 400),
                           g_rand_double_range (rand, 100, 400) };
    Camera camera;
    Object picked;
    double least = INFINITY, depth = INFINITY;
    guint k;

    camera_init (&camera, (CameraPreset)(i % N_CAMERA_PRESETS));
    camera_roll (&camera, (double[2]){ 250, 250 }, at, (double[2]){ 500, 500 });
    stage->on_space = camera_projection (&camera, 500, 500);
    picked = scene_pick (&stage->space, &stage->on_space, at, 0);
    for (k = 0; k < stage->space.n_items; k++) {
      const SceneItem *item = &stage->space.items[k];
      double here;

      if (item->pass != PASS_HULL || item->shape != SHAPE_POLYGON)
        continue;
      here = depth_at (stage, item, (Pixel){ at[0], at[1] });
      least = fmin (least, here);
      if (object_equal (item->object, picked))
        depth = here;
    }
    if (!isfinite (least))
      continue;
    n_facets++;
    g_assert_cmpint (picked.kind, ==, OBJECT_FACET);
    g_assert_cmpfloat (depth, <=, least + 1e-9);
  }
  g_assert_cmpint (n_facets, >, 60);
}

/* Selecting a facet lights its triangle, circle and Voronoi vertex, and
 * nothing else; a site its lift and cell; a ridge its three edges. */
static void
test_counterparts (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  const uint32_t facet = stage->frame.delaunay.triangles[2].facet;
  const Object object = { OBJECT_FACET, facet };
  const uint32_t ridge = stage->frame.ridges[5].ridge;
  guint i, n_ridges = 0;

  stage->look.selection = object;
  stage->look.hover = (Object){ OBJECT_SITE, 3 };
  stage_draw (stage);
  g_assert_cmpint (stage_find (&stage->plane, ROLE_TRIANGLE, object)->lit, ==,
                   LIT_SELECTED);
  g_assert_cmpint (stage_find (&stage->space, ROLE_LOWER, object)->lit, ==,
                   LIT_SELECTED);
  g_assert_cmpuint (stage_count (&stage->plane, ROLE_CIRCLE_SELECTED), >=, 1);
  g_assert_cmpuint (stage_count (&stage->plane, ROLE_CIRCLE), ==, 0);
  for (i = 0; i < stage->plane.n_items; i++) {
    const SceneItem *item = &stage->plane.items[i];

    if (item->object.kind == OBJECT_VERTEX && item->shape == SHAPE_MARK)
      g_assert_cmpint (item->lit == LIT_SELECTED, ==,
                       item->object.number == facet);
    if (item->role == ROLE_CELL || item->role == ROLE_SITE)
      g_assert_cmpint (item->lit == LIT_HOVER, ==, item->object.number == 3);
  }
  stage->look.selection = (Object){ OBJECT_RIDGE, ridge };
  stage_draw (stage);
  for (i = 0; i < stage->space.n_items; i++)
    n_ridges += stage->space.items[i].lit == LIT_SELECTED;
  g_assert_cmpuint (n_ridges, >=, 2);
  g_assert_cmpuint (n_ridges, <=, 3);
}

/* A Delaunay edge and a Voronoi edge that are lit together are dual: they
 * stand at a right angle, and belong to the same two sites as the ridge. */
static void
test_dual_edges (void)
{
  g_autoptr (Stage) stage = stage_at_end ("mixed8");
  guint i, n_pairs = 0;

  for (i = 0; i < stage->plane.n_items; i++) {
    const SceneItem *edge = &stage->plane.items[i];
    const SceneItem *dual;
    RidgeRow row;
    Point3 a, b, c, d, tail;

    if (edge->role != ROLE_DELAUNAY_EDGE)
      continue;
    dual = stage_find (&stage->plane, ROLE_VORONOI_EDGE, edge->object);
    row = trace_ridge (stage->fixture->trace, edge->object.number);
    a = stage->plane.points[edge->first];
    b = stage->plane.points[edge->first + 1];
    tail = scene_point (&stage->look, stage_site (stage, row.site[0]), false);
    g_assert_true ((tail.x == a.x && tail.y == a.y)
                   || (tail.x == b.x && tail.y == b.y));
    if (dual == NULL)
      continue;
    n_pairs++;
    c = stage->plane.points[dual->first];
    d = stage->plane.points[dual->first + 1];
    g_assert_cmpfloat (
        fabs ((b.x - a.x) * (d.x - c.x) + (b.y - a.y) * (d.y - c.y)), <, 1e-9);
  }
  g_assert_cmpuint (n_pairs, >=, 8);
}

/* What is transparent is there for no one: not for the pointer either. */
static void
test_opacity (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  const Pixel middle = stage_pixel (&stage->on_space, (Point3){ 0.1, 0, 1.2 });
  const double at[2] = { middle.x, middle.y };
  Role role;

  stage->look.layers = LAYER_HULL;
  stage_draw (stage);
  g_assert_cmpint (scene_pick (&stage->space, &stage->on_space, at, 0).kind, ==,
                   OBJECT_FACET);
  stage->look.body_fade[BODY_HULL] = 1;
  stage_draw (stage);
  g_assert_cmpint (scene_pick (&stage->space, &stage->on_space, at, 0).kind, ==,
                   OBJECT_NONE);
  stage->look.body_fade[BODY_HULL] = 0.5;
  stage->look.role_fade[ROLE_LOWER] = 0.5;
  stage_draw (stage);
  g_assert_cmpfloat (
      stage_find (
          &stage->space, ROLE_LOWER,
          (Object){ OBJECT_FACET, stage->frame.delaunay.triangles[0].facet })
          ->fade,
      ==, 0.75);
  for (role = 0; role < N_ROLES; role++) {
    Role again;

    g_assert_true (role_parse (role_name (role), &again));
    g_assert_cmpint (again, ==, role);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/pick/a-cell-holds-what-is-nearest-to-its-site",
                   test_cells);
  g_test_add_func ("/pick/counterparts-are-lit-together", test_counterparts);
  g_test_add_func ("/pick/dual-edges-have-one-name", test_dual_edges);
  g_test_add_func ("/pick/what-is-transparent-cannot-be-picked", test_opacity);
  g_test_add_func ("/pick/a-site-takes-the-click-on-its-mark", test_pick_sites);
  g_test_add_func ("/pick/a-facet-is-the-nearest-to-the-eye",
                   test_pick_nearest);
  return g_test_run ();
}
