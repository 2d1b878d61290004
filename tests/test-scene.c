#include "stage.h"

#include <math.h>

static Role
role_of_point (const Scene *scene, guint point)
{
  guint i = 0;

  while (scene->items[i].first + scene->items[i].n <= point)
    i++;
  return scene->items[i].role;
}

static void
assert_finite (const Scene *scene, const char *name, uint32_t step)
{
  guint i;

  for (i = 0; i < scene->n_points; i++)
    if (!isfinite (scene->points[i].x) || !isfinite (scene->points[i].y)
        || !isfinite (scene->points[i].z))
      g_error ("%s, step %u: point %u of a %d is not finite", name, step, i,
               role_of_point (scene, i));
}

/* No line comes after that round the plane: its casing would cut it. */
static void
assert_whole_frame (const Scene *scene)
{
  bool has_frame = false;
  guint i;

  for (i = 0; i < scene->stock.n_items; i++)
    if (scene->items[i].role == ROLE_GROUND)
      has_frame = true;
    else if (has_frame && scene->items[i].pass == PASS_GROUND)
      g_assert_cmpint (scene->items[i].shape, !=, SHAPE_PATH);
  g_assert_true (has_frame);
}

/* Every scene of a trace, of few steps where it is long. */
static void
check_scenes (const Fixture *fixture)
{
  const uint32_t n = fixture->trace->n_events;
  const uint32_t stride = MAX (n / 12, 1);
  Scene scene = { 0 };
  uint32_t step;

  for (step = 0; step <= n; step += stride) {
    SceneLook look;
    Frame frame;
    uint64_t hash;

    frame_init (&frame, fixture->trace, step);
    hash = frame_hash (&frame);
    scene_look_init (&look, &frame);
    look.layers = (1U << N_LAYERS) - 1;
    scene_plane (&scene, &frame, &look);
    assert_finite (&scene, fixture->name, step);
    assert_whole_frame (&scene);
    scene_space (&scene, &frame, &look);
    assert_finite (&scene, fixture->name, step);
    g_assert_true (frame_hash (&frame) == hash);
    frame_clear (&frame);
  }
  scene_clear (&scene);
}

static void
test_finite (void)
{
  const char *const *name;

  for (name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    check_scenes (fixture);
  }
  fixture_for_each (2, 24, ORDER_FURTHEST, check_scenes);
}

static void
test_names (void)
{
  int i;

  for (i = 0; i < N_LAYERS; i++) {
    Layer layer;

    g_assert_true (layer_parse (layer_name ((Layer)(1 << i)), &layer));
    g_assert_cmpint (layer, ==, 1 << i);
  }
  for (i = 0; i <= FOCUS_CONE; i++) {
    Focus focus;

    g_assert_true (focus_parse (focus_name ((Focus)i), &focus));
    g_assert_cmpint (focus, ==, i);
  }
  g_assert_cmpstr (layer_name (LAYER_CIRCLES), ==, "circumcircles");
}

static void
test_active_set (void)
{
  g_autoptr (Stage) see = stage_new ("lecture8", 4, PHASE_SEE);
  g_autoptr (Stage) horizon = stage_new ("lecture8", 4, PHASE_HORIZON);
  g_autoptr (Stage) cone = stage_new ("lecture8", 4, PHASE_CONE);
  g_autoptr (Stage) over = stage_new ("lecture8", 4, PHASE_HAND_OVER);

  /* Round 4 of this set: 4 visible facets, all lower; a cone of 6. */
  g_assert_cmpuint (stage_count (&see->plane, ROLE_VISIBLE), ==, 4);
  g_assert_cmpuint (stage_count (&see->space, ROLE_VISIBLE), ==, 8);
  g_assert_cmpuint (stage_count (&see->plane, ROLE_VORONOI_VERTEX_DYING), ==,
                    4);
  g_assert_cmpuint (stage_count (&see->plane, ROLE_HORIZON), ==, 0);
  g_assert_cmpuint (stage_count (&horizon->plane, ROLE_HORIZON), ==, 6);
  g_assert_cmpuint (stage_count (&horizon->space, ROLE_HORIZON), ==, 12);
  g_assert_cmpuint (stage_count (&cone->plane, ROLE_CONE), ==, 6);
  g_assert_cmpuint (stage_count (&cone->plane, ROLE_CONE_EDGE), ==, 6);
  g_assert_cmpuint (stage_count (&over->plane, ROLE_CONE), ==, 6);
  g_assert_cmpuint (stage_count (&over->plane, ROLE_VISIBLE), ==, 0);
  g_assert_cmpuint (stage_count (&over->plane, ROLE_SITE_APEX), ==, 1);
}

/* mixed8: round 1 sees two lower facets from outside, round 2 three upper
 * ones, round 4 one of each. */
static void
test_upper (void)
{
  g_autoptr (Stage) upper = stage_new ("mixed8", 2, PHASE_SEE);
  g_autoptr (Stage) both = stage_new ("mixed8", 4, PHASE_CONE);
  g_autoptr (Stage) ring = stage_new ("mixed8", 4, PHASE_HORIZON);

  g_assert_cmpuint (stage_count (&upper->plane, ROLE_VISIBLE), ==, 0);
  g_assert_cmpuint (stage_count (&upper->space, ROLE_VISIBLE_UPPER), ==, 3);
  g_assert_cmpuint (stage_count (&upper->plane, ROLE_VORONOI_VERTEX_DYING), ==,
                    0);
  g_assert_cmpuint (stage_count (&both->plane, ROLE_CONE), ==, 3);
  g_assert_cmpuint (stage_count (&both->space, ROLE_CONE_UPPER), ==, 1);
  g_assert_cmpuint (stage_count (&ring->plane, ROLE_HORIZON)
                        + stage_count (&ring->plane, ROLE_HORIZON_UPPER),
                    ==, 4);
  g_assert_cmpuint (stage_count (&ring->plane, ROLE_HORIZON_UPPER), ==, 1);
}

static void
test_emphasis (void)
{
  g_autoptr (Stage) stage = stage_new ("lecture8", 4, PHASE_SEE);
  guint i, n_pale = 0;

  for (i = 0; i < stage->plane.n_items; i++) {
    const SceneItem *item = &stage->plane.items[i];

    if (item->role == ROLE_VISIBLE || item->role == ROLE_CIRCLE_VISIBLE
        || item->role == ROLE_SITE_APEX)
      g_assert_cmpint (item->emphasis, ==, EMPHASIS_LOUD);
    if (item->role == ROLE_SITE)
      g_assert_cmpint (item->emphasis, ==, EMPHASIS_NORMAL);
    n_pale += item->emphasis == EMPHASIS_PALE;
  }
  g_assert_cmpuint (n_pale, >, 10);
  stage->look.focus = FOCUS_NONE;
  stage_draw (stage);
  for (i = 0; i < stage->plane.n_items; i++)
    g_assert_cmpint (stage->plane.items[i].emphasis, !=, EMPHASIS_PALE);
}

/* All points of a circle are equally far from its three sites' centre: from
 * the point where the bisectors meet, by the Voronoi vertex that the frame
 * has. */
static void
test_circles (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  guint i, k, n_circles = 0;

  stage->look.layers = LAYERS_DEFAULT | LAYER_CIRCLES;
  stage_draw (stage);
  for (i = 0; i < stage->plane.n_items; i++) {
    const SceneItem *item = &stage->plane.items[i];
    const FacetRow *row;
    Point3 site[3];
    uint32_t group;

    if (item->role != ROLE_CIRCLE)
      continue;
    n_circles++;
    row = &stage->fixture->trace->facets[item->object.number];
    for (group = 0;; group++) {
      const uint32_t triangle = stage->frame.voronoi.vertices[group].triangle;

      if (stage->frame.delaunay.triangles[triangle].facet
          == item->object.number)
        break;
    }
    for (k = 0; k < 3; k++)
      site[k]
          = scene_point (&stage->look, stage_site (stage, row->site[k]), false);
    for (k = 0; k < item->n; k++) {
      const Point3 at = stage->plane.points[item->first + k];
      const Point3 centre = scene_point (
          &stage->look, &stage->frame.voronoi.vertices[group].at, false);
      const double radius = hypot (site[0].x - centre.x, site[0].y - centre.y);

      g_assert_cmpfloat (
          fabs (hypot (at.x - centre.x, at.y - centre.y) - radius), <,
          1e-3 * radius);
    }
  }
  g_assert_cmpuint (n_circles, >=, 10);
}

/* A vertical facet that is seen shows in the plane as its hull edge. */
static void
test_seen_edges (void)
{
  g_autoptr (Stage) stage = stage_new ("square5", 1, PHASE_SEE);
  g_autoptr (Stage) vertical = stage_new ("vertical5", 1, PHASE_SEE);
  guint i, n = 0;

  g_assert_cmpuint (stage_count (&stage->plane, ROLE_SEEN_EDGE), ==, 1);
  for (i = 0; i < vertical->plane.n_items; i++) {
    const SceneItem *item = &vertical->plane.items[i];
    const Point3 *p = &vertical->plane.points[item->first];

    if (item->role != ROLE_SEEN_EDGE)
      continue;
    n++;
    g_assert_cmpfloat (p[0].y, ==, p[1].y);
    g_assert_cmpfloat (fabs (p[0].x - p[1].x), ==, 2);
  }
  g_assert_cmpuint (n, ==, 1);
}

/* Flat input has pictures too: triangles and their lifts, or a line. */
static void
test_flat (void)
{
  g_autoptr (Stage) square = stage_at_end ("square4");
  g_autoptr (Stage) start = stage_new ("lecture8", 0, PHASE_START);

  g_assert_cmpuint (stage_count (&square->plane, ROLE_TRIANGLE), ==, 2);
  g_assert_cmpuint (stage_count (&square->plane, ROLE_FREE_EDGE), ==, 1);
  g_assert_cmpuint (stage_count (&square->plane, ROLE_VORONOI_EDGE), ==, 4);
  g_assert_cmpuint (stage_count (&square->plane, ROLE_VORONOI_VERTEX_TIED), ==,
                    1);
  g_assert_cmpuint (stage_count (&square->plane, ROLE_CELL), ==, 4);
  g_assert_cmpuint (stage_count (&square->space, ROLE_LOWER), ==, 2);
  g_assert_cmpuint (stage_count (&start->plane, ROLE_SITE_WAITING), ==, 8);
  g_assert_cmpuint (stage_count (&start->plane, ROLE_CELL), ==, 0);
  g_assert_cmpuint (stage_count (&start->space, ROLE_SITE_WAITING), ==, 8);
}

/* The same set at another scale and place makes the same scenes. */
static void
test_scale (void)
{
  g_autoptr (Stage) near = stage_at_end ("lecture8");
  const SiteSet *set = near->fixture->set;
  g_autofree Site *sites = g_new (Site, set->n_sites);
  const Order order = { ORDER_FURTHEST, 0 };
  Stage *far;
  uint32_t i;

  for (i = 0; i < set->n_sites; i++)
    sites[i] = (Site){ 4096 + set->sites[i].x / 1024,
                       -8192 + set->sites[i].y / 1024 };
  far = stage_take (fixture_take (g_strdup ("far"),
                                  site_set_new (sites, set->n_sites), &order),
                    near->fixture->trace->n_events);
  g_assert_cmpuint (far->plane.n_items, ==, near->plane.n_items);
  g_assert_cmpuint (far->plane.n_points, ==, near->plane.n_points);
  for (i = 0; i < near->plane.n_points; i++) {
    g_assert_cmpfloat (fabs (far->plane.points[i].x - near->plane.points[i].x),
                       <, 1e-6);
    g_assert_cmpfloat (fabs (far->plane.points[i].y - near->plane.points[i].y),
                       <, 1e-6);
  }
  stage_free (far);
}

/* Sites a few last bits apart: their Voronoi vertex lies between doubles, but
 * not in the picture. */
static void
test_last_bits (void)
{
  const double bit = 0x1p-52;
  const Site sites[] = { { 1, 1 }, { 1 + 3 * bit, 1 }, { 1, 1 + bit } };
  const Order order = { ORDER_FURTHEST, 0 };
  g_autoptr (Stage) stage = stage_take (
      fixture_take (g_strdup ("bits"), site_set_new (sites, 3), &order), 2);
  const Point3 a = scene_point (&stage->look, stage_site (stage, 1), false);
  const Point3 b = scene_point (&stage->look, stage_site (stage, 2), false);
  guint i = 0;

  while (i < stage->plane.n_items
         && stage->plane.items[i].role != ROLE_VORONOI_VERTEX)
    i++;
  g_assert_cmpuint (i, <, stage->plane.n_items);
  {
    const Point3 at = stage->plane.points[stage->plane.items[i].first];

    /* A right angle: the centre is the middle of the long side. */
    g_assert_cmpfloat (fabs (at.x - (a.x + b.x) / 2), <, 1e-9);
    g_assert_cmpfloat (fabs (at.y - (a.y + b.y) / 2), <, 1e-9);
  }
}

/* The highest of all tangent planes over a point; a plane touches the
 * paraboloid at its site's lift. */
static double
highest_tangent (const Stage *stage, Point3 at)
{
  double highest = -INFINITY;
  uint32_t i;

  for (i = 0; i < stage->frame.n_sites; i++) {
    const Point3 p = scene_point (&stage->look, stage_site (stage, i), true);

    highest
        = fmax (highest, p.z + 2 * p.x * (at.x - p.x) + 2 * p.y * (at.y - p.y));
  }
  return highest;
}

/* What is seen from above of the tangent planes is their upper envelope, cell
 * by cell, and never below the ground. */
static void
test_tangents (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  guint i, k, n_cells = 0;

  stage->look.layers = LAYER_TANGENTS;
  stage_draw (stage);
  for (i = 0; i < stage->space.n_items; i++) {
    const SceneItem *item = &stage->space.items[i];

    if (item->role != ROLE_TANGENT && item->role != ROLE_TANGENT_EDGE)
      continue;
    n_cells += item->role == ROLE_TANGENT;
    for (k = 0; k < item->n; k++) {
      const Point3 at = stage->space.points[item->first + k];

      g_assert_cmpfloat (fabs (at.z - highest_tangent (stage, at)), <, 1e-9);
      g_assert_cmpfloat (at.z, >=, -1e-12);
    }
  }
  g_assert_cmpuint (n_cells, ==, 8);
  g_assert_cmpuint (stage_count (&stage->plane, ROLE_TANGENT), ==, 8);
}

/* Halfway up, a lift is halfway; at 0 lower facets lie on their triangles and
 * what is not lower is not to be seen. */
static void
test_lift (void)
{
  g_autoptr (Stage) stage = stage_at_end ("mixed8");
  guint i, k;

  for (i = 0; i < stage->frame.n_sites; i++) {
    const Point3 up = scene_point (&stage->look, stage_site (stage, i), true);
    SceneLook half = stage->look;

    half.lift = 0.5;
    g_assert_cmpfloat (scene_point (&half, stage_site (stage, i), true).z, ==,
                       up.z / 2);
  }
  stage->look.lift = 0;
  stage_draw (stage);
  for (i = 0; i < stage->space.n_items; i++) {
    const SceneItem *item = &stage->space.items[i];

    if (item->role == ROLE_UPPER || item->role == ROLE_VERTICAL)
      g_assert_cmpfloat (item->fade, ==, 1);
    if (item->role != ROLE_LOWER)
      continue;
    g_assert_cmpfloat (item->fade, ==, 0);
    for (k = 0; k < item->n; k++)
      g_assert_cmpfloat (stage->space.points[item->first + k].z, ==, 0);
  }
}

static double
length_of (const Scene *scene, Role role)
{
  double length = 0;
  guint i;

  for (i = 0; i < scene->n_items; i++) {
    const Point3 *p = &scene->points[scene->items[i].first];

    if (scene->items[i].role == role)
      length += hypot (p[1].x - p[0].x, p[1].y - p[0].y);
  }
  return length;
}

/* A step that is on its way draws ever more of the horizon and of the cone,
 * nothing of what stood before moves, and at its end all is there. */
static void
test_moving (void)
{
  static const struct {
    Phase phase;
    Role role;
  } rows[]
      = { { PHASE_HORIZON, ROLE_HORIZON }, { PHASE_CONE, ROLE_CONE_EDGE } };
  size_t r;

  for (r = 0; r < G_N_ELEMENTS (rows); r++) {
    g_autoptr (Stage) stage = stage_new ("lecture8", 4, rows[r].phase);
    const double whole = length_of (&stage->plane, rows[r].role);
    double last = -1;
    int i;

    stage->look.since = stage->frame.step - 6;
    for (i = 0; i <= 10; i++) {
      double length;

      stage->look.moving = 1 - i / 10.0;
      stage_draw (stage);
      length = length_of (&stage->plane, rows[r].role);
      g_assert_cmpfloat (length, >, last);
      last = length;
    }
    g_assert_cmpfloat (fabs (last - whole), <, 1e-12);
    stage->look.moving = 1;
    stage->look.since = stage->frame.step;
    stage_draw (stage);
    g_assert_cmpfloat (length_of (&stage->plane, rows[r].role), ==, whole);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/scene/all-points-are-finite-and-the-frame-is-untouched",
                   test_finite);
  g_test_add_func ("/scene/every-layer-and-focus-has-a-name", test_names);
  g_test_add_func ("/scene/the-active-set-has-its-roles", test_active_set);
  g_test_add_func ("/scene/what-is-not-lower-has-roles-of-its-own", test_upper);
  g_test_add_func ("/scene/the-active-set-is-loud-and-the-rest-pale",
                   test_emphasis);
  g_test_add_func ("/scene/a-circle-keeps-its-distance", test_circles);
  g_test_add_func ("/scene/a-vertical-facet-that-is-seen-is-a-hull-edge",
                   test_seen_edges);
  g_test_add_func ("/scene/flat-input-has-pictures", test_flat);
  g_test_add_func ("/scene/scale-and-place-do-not-matter", test_scale);
  g_test_add_func ("/scene/the-last-bits-are-drawn-right", test_last_bits);
  g_test_add_func ("/scene/tangent-planes-are-seen-where-they-are-highest",
                   test_tangents);
  g_test_add_func ("/scene/lifts-glide-down-to-the-triangulation", test_lift);
  g_test_add_func ("/scene/what-is-new-grows-and-what-stood-stays",
                   test_moving);
  return g_test_run ();
}
