/* The reason behind the circles, against the definitions. */
#include "why.h"

#include "fixture.h"
#include "judge.h"
#include "scene.h"

#include <math.h>
#include <string.h>

/* The sign of a power is that of integers of any size. */
static void
check_signs (const Fixture *fixture)
{
  Judge *judge = judge_new (fixture->set);
  uint32_t facet, site;

  for (facet = 0; facet < fixture->trace->n_facets; facet++) {
    const FacetRow *row = &fixture->trace->facets[facet];

    if (row->facing == FACING_VERTICAL)
      continue;
    for (site = 0; site < fixture->set->n_sites; site++) {
      const Power power = why_power (fixture->set, row->site, site);

      g_assert_cmpint (power.sign, ==, judge_circle (judge, row->site, site));
      g_assert_true (power.sign == (power.value > 0) - (power.value < 0));
    }
  }
  judge_free (judge);
}

static void
test_signs (void)
{
  fixture_for_each (2, 14, ORDER_FURTHEST, check_signs);
}

/* Around (3, 4) with radius 5: the power is the squared distance to the
 * centre less 25, also where the set is scaled. */
static void
test_values (void)
{
  static const double scales[] = { 1, 0x1p-300, 0x1p400 };
  static const struct {
    Site site;
    double power;
  } rows[] = {
    { { 3, 4 }, -25 }, { { 3, 10 }, 11 }, { { 8, 4 }, 0 }, { { 3, 8.5 }, -4.75 }
  };
  size_t i, k;

  for (i = 0; i < G_N_ELEMENTS (scales); i++)
    for (k = 0; k < G_N_ELEMENTS (rows); k++) {
      const double s = scales[i];
      const Site sites[] = { { 0, 0 },
                             { 6 * s, 0 },
                             { 6 * s, 8 * s },
                             { rows[k].site.x * s, rows[k].site.y * s } };
      SiteSet *set = site_set_new (sites, 4);
      const Power power = why_power (set, (uint32_t[]){ 0, 1, 2 }, 3);

      g_assert_cmpfloat (power.value / s / s, ==, rows[k].power);
      site_set_free (set);
    }
}

static void
test_numbers (void)
{
  static const struct {
    Power power;
    const char *text;
  } rows[] = {
    { { 1, 0.03 }, "0.03" },        { { 1, 0.031249 }, "0.0312" },
    { { -1, -2.5 }, "−2.5" },       { { 0, 0 }, "0" },
    { { 1, 1234567 }, "1.23e+06" }, { { 1, 999.9 }, "1000" },
  };
  char text[WHY_NUMBER_ROOM];
  size_t i;

  for (i = 0; i < G_N_ELEMENTS (rows); i++) {
    why_write_number (rows[i].power, text);
    if (i != 4)
      g_assert_cmpstr (text, ==, rows[i].text);
  }
}

typedef struct Stage {
  Fixture *fixture;
  Frame frame;
  SceneLook look;
  Scene plane, space;
} Stage;

static void
stage_init (Stage *stage, const char *name)
{
  memset (stage, 0, sizeof *stage);
  stage->fixture = fixture_load (name, ORDER_FURTHEST);
  frame_init (&stage->frame, stage->fixture->trace,
              stage->fixture->trace->n_events);
  scene_look_init (&stage->look, &stage->frame);
  stage->look.layers |= LAYER_WHY;
}

static void
stage_clear (Stage *stage)
{
  scene_clear (&stage->plane);
  scene_clear (&stage->space);
  frame_clear (&stage->frame);
  fixture_free (stage->fixture);
}

static const SceneItem *
find_role (const Scene *scene, Role role)
{
  uint32_t i;

  for (i = 0; i < scene->n_items; i++)
    if (scene->items[i].role == role)
      return &scene->items[i];
  return NULL;
}

/* How far above the plane through the lifts of @facet a point is, by solving
 * for the plane anew. */
static double
gap_above (const Stage *stage, uint32_t facet, Point3 at)
{
  const FacetRow *row = &stage->fixture->trace->facets[facet];
  const Site *sites = stage->fixture->set->sites;
  const Point3 a = scene_point (&stage->look, &sites[row->site[0]], true);
  const Point3 b = scene_point (&stage->look, &sites[row->site[1]], true);
  const Point3 c = scene_point (&stage->look, &sites[row->site[2]], true);
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  const double s
      = ((at.x - a.x) * (c.y - a.y) - (at.y - a.y) * (c.x - a.x)) / area;
  const double t
      = ((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / area;

  return at.z - (a.z + s * (b.z - a.z) + t * (c.z - a.z));
}

/* The ellipse lies on the paraboloid, as far as it is shown, and in the plane;
 * the patch of plane in the plane; the gap is vertical, from the lift to the
 * plane, and as long as the power; the segment in the plane has the power as
 * its square. */
static void
check_facet (Stage *stage, uint32_t facet, uint32_t site)
{
  const FacetRow *row = &stage->fixture->trace->facets[facet];
  const double radius = stage->look.extent.radius;
  const SceneItem *gap, *short_cut;
  const Point3 *ends;
  Power power;
  Point3 rim;
  uint32_t i, k;

  stage->look.selection = (Object){ OBJECT_FACET, facet };
  stage->look.measured = (Object){ OBJECT_SITE, site };
  scene_space (&stage->space, &stage->frame, &stage->look);
  rim = stage->space.points[find_role (&stage->space, ROLE_RIM)->first];
  scene_plane (&stage->plane, &stage->frame, &stage->look);
  for (i = 0; i < stage->space.n_items; i++) {
    const SceneItem *item = &stage->space.items[i];

    if (item->role != ROLE_ELLIPSE && item->role != ROLE_PLANE)
      continue;
    for (k = 0; k < item->n; k++) {
      const Point3 at = stage->space.points[item->first + k];
      const double sheet = stage->look.raise + at.x * at.x + at.y * at.y;

      /* Chords end a little inside the circle where they are cut off. */
      g_assert_cmpfloat (fabs (gap_above (stage, facet, at)), <, 1e-3);
      if (item->role != ROLE_ELLIPSE)
        continue;
      g_assert_cmpfloat (fabs (at.z - sheet), <, 1e-9);
      g_assert_cmpfloat (at.z, <, rim.z + 1e-9);
    }
  }
  g_assert_nonnull (find_role (&stage->space, ROLE_ELLIPSE));
  gap = find_role (&stage->space, ROLE_GAP);
  if (site == row->site[0] || site == row->site[1] || site == row->site[2]) {
    g_assert_null (gap);
    return;
  }
  power = why_power (stage->fixture->set, row->site, site);
  ends = &stage->space.points[gap->first];
  g_assert_cmpfloat (ends[0].x, ==, ends[1].x);
  g_assert_cmpfloat (fabs (gap_above (stage, facet, ends[1])), <, 1e-9);
  g_assert_cmpfloat (
      fabs ((ends[0].z - ends[1].z) * radius * radius - power.value), <, 1e-9);
  short_cut = find_role (&stage->plane, ROLE_GAP);
  ends = &stage->plane.points[short_cut->first];
  g_assert_cmpfloat (
      fabs (
          pow (hypot (ends[1].x - ends[0].x, ends[1].y - ends[0].y) * radius, 2)
          - fabs (power.value)),
      <, 1e-9);
}

/* Whether a convex polygon, seen from above, has a point in it. */
static bool
holds (const Scene *scene, const SceneItem *item, Point3 at)
{
  uint32_t k, n_left = 0;

  for (k = 0; k < item->n; k++) {
    const Point3 a = scene->points[item->first + k];
    const Point3 b = scene->points[item->first + (k + 1) % item->n];

    n_left += (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x) > 0;
  }
  return n_left == 0 || n_left == item->n;
}

/* However far a site is from the circle, also below the plane z = 0. */
static void
check_foot (Stage *stage, uint32_t facet, uint32_t site)
{
  const SceneItem *gap, *patch;
  Point3 foot;

  stage->look.selection = (Object){ OBJECT_FACET, facet };
  stage->look.measured = (Object){ OBJECT_SITE, site };
  scene_space (&stage->space, &stage->frame, &stage->look);
  gap = find_role (&stage->space, ROLE_GAP);
  patch = find_role (&stage->space, ROLE_PLANE);
  if (gap == NULL)
    return;
  foot = stage->space.points[gap->first + 1];
  g_assert_nonnull (patch);
  g_assert_true (holds (&stage->space, patch, foot));
}

static void
check_pairs (void (*check) (Stage *stage, uint32_t facet, uint32_t site))
{
  static const char *const names[] = { "lecture8", "mixed8", "furthest8" };
  size_t i;

  for (i = 0; i < G_N_ELEMENTS (names); i++) {
    uint32_t k, site;
    Stage stage;

    stage_init (&stage, names[i]);
    for (k = 0; k < stage.frame.n_facets; k++)
      for (site = 0; site < stage.frame.n_sites; site++)
        check (&stage, stage.frame.facets[k].facet, site);
    stage_clear (&stage);
  }
}

static void
test_foot (void)
{
  check_pairs (check_foot);
}

static void
test_pictures (void)
{
  check_pairs (check_facet);
}

/* The sentence has the words of the law, and its sign. */
static void
test_sentences (void)
{
  static const struct {
    const char *name;
    uint32_t round;
    Phase phase;
  } rows[] = { { "lecture8", 4, PHASE_SEE }, { "mixed8", 2, PHASE_SEE } };
  size_t i;

  for (i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autoptr (Fixture) fixture = fixture_load (rows[i].name, ORDER_FURTHEST);
    uint32_t step, k;
    Frame frame;

    g_assert_true (timeline_find (
        fixture->trace, (Place){ rows[i].round, rows[i].phase }, false, &step));
    frame_init (&frame, fixture->trace, step);
    for (k = 0; k < frame.n_facets; k++) {
      const Object facet = { OBJECT_FACET, frame.facets[k].facet };
      const Object none = { OBJECT_NONE, 0 };
      const Why why = why_find (&frame, facet, none, none);
      const bool is_seen = (frame.facets[k].roles & FACET_VISIBLE) != 0;
      char text[NARRATION_ROOM];

      g_assert_cmpuint (why.site, ==,
                        fixture->trace->rounds[rows[i].round - 1].site);
      why_write (&frame, why, NULL, text);
      g_assert_true ((strstr (text, " sees ") != NULL) == is_seen);
      g_assert_true (strchr (text, '{') == NULL);
    }
    frame_clear (&frame);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/why/the-sign-of-a-power-is-exact", test_signs);
  g_test_add_func ("/why/a-power-is-in-coordinates-as-given", test_values);
  g_test_add_func ("/why/numbers-have-three-digits", test_numbers);
  g_test_add_func ("/why/the-gap-in-space-is-the-power-in-the-plane",
                   test_pictures);
  g_test_add_func ("/why/the-gap-ends-on-the-patch-of-plane", test_foot);
  g_test_add_func ("/why/the-sentence-says-what-sees", test_sentences);
  return g_test_run ();
}
