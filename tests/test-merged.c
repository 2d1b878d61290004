#include "merged.h"

#include "certify.h"
#include "fixture.h"
#include "judge.h"

#include <string.h>

/* What merged facets are, in the words of the plane. */
typedef struct Case {
  const Fixture *fixture;
  const Judge *judge;
  const Result *result;
  Merged merged;
} Case;

#define case_assert(test, condition)                                           \
  G_STMT_START                                                                 \
  {                                                                            \
    if (!(condition))                                                          \
      g_error ("%s: not true: %s", (test)->fixture->name, #condition);         \
  }                                                                            \
  G_STMT_END

static uint32_t
site_at (const Case *test, const Polygon *polygon, uint32_t i)
{
  return test->merged.sites[polygon->first + i % polygon->n_sites];
}

/* All sites on the circle are corners, and none is on its wrong side. */
static void
check_circle (const Case *test, const Polygon *polygon, int wrong)
{
  const Delaunay *delaunay = &test->result->delaunay;
  const uint32_t *corner = test->merged.sites + polygon->first;
  uint32_t n_on = 0;

  for (uint32_t i = 0; i < delaunay->n_active; i++) {
    const int side = judge_circle (test->judge, corner, delaunay->active[i]);

    case_assert (test, side != wrong);
    n_on += side == 0;
  }
  case_assert (test, n_on == polygon->n_sites);
}

/* Every corner turns the same way, and the border goes round once. */
static void
check_turns (const Case *test, const Polygon *polygon, int turn)
{
  const Site *sites = test->fixture->set->sites;
  uint32_t n_changes = 0;

  for (uint32_t i = 0; i < polygon->n_sites; i++) {
    const uint32_t a = site_at (test, polygon, i);
    const uint32_t b = site_at (test, polygon, i + 1);
    const uint32_t c = site_at (test, polygon, i + 2);

    case_assert (test, judge_orient (test->judge, a, b, c) == turn);
    n_changes += site_compare (&sites[a], &sites[b])
                 != site_compare (&sites[b], &sites[c]);
  }
  case_assert (test, n_changes == 2);
}

/* Seen from outside, the sites over a hull edge go from its tail to its head
 * below, and back above in one ridge. */
static void
check_vertical (const Case *test, const Polygon *polygon)
{
  const Delaunay *delaunay = &test->result->delaunay;
  const Site *sites = test->fixture->set->sites;
  const uint32_t n = polygon->n_sites;
  uint32_t tail = 0, n_on = 0, a, b;

  while (tail < n
         && site_compare (&sites[site_at (test, polygon, tail)],
                          &sites[site_at (test, polygon, tail + 1)])
                == site_compare (&sites[site_at (test, polygon, tail + n - 1)],
                                 &sites[site_at (test, polygon, tail)]))
    tail++;
  /* The two ends of the line: the tail is the one after the long ridge. */
  if (site_compare (&sites[site_at (test, polygon, tail)],
                    &sites[site_at (test, polygon, tail + 1)])
      != site_compare (&sites[site_at (test, polygon, tail + 1)],
                       &sites[site_at (test, polygon, tail + 2)]))
    tail++;
  a = site_at (test, polygon, tail);
  b = site_at (test, polygon, tail + n - 1);
  for (uint32_t i = 0; i + 1 < n; i++)
    case_assert (test,
                 site_compare (&sites[site_at (test, polygon, tail + i)],
                               &sites[site_at (test, polygon, tail + i + 1)])
                     == site_compare (&sites[a], &sites[b]));
  for (uint32_t i = 0; i < delaunay->n_active; i++) {
    const int turn = judge_orient (test->judge, a, b, delaunay->active[i]);

    case_assert (test, turn >= 0);
    n_on += turn == 0;
  }
  case_assert (test, n_on == n);
}

static uint32_t
count (const Merged *merged, Facing facing)
{
  uint32_t n = 0;

  for (uint32_t i = 0; i < merged->n_polygons; i++)
    n += merged->polygons[i].facing == facing;
  return n;
}

static void
check_polygons (const Case *test)
{
  for (uint32_t i = 0; i < test->merged.n_polygons; i++) {
    const Polygon *polygon = &test->merged.polygons[i];

    switch (polygon->facing) {
    case FACING_LOWER:
      check_circle (test, polygon, -1);
      check_turns (test, polygon, -1);
      break;
    case FACING_UPPER:
      check_circle (test, polygon, 1);
      check_turns (test, polygon, 1);
      break;
    case FACING_VERTICAL:
      check_vertical (test, polygon);
      break;
    }
    for (uint32_t k = 1; k < polygon->n_sites; k++)
      case_assert (test,
                   site_at (test, polygon, k) > site_at (test, polygon, 0));
  }
  case_assert (test, count (&test->merged, FACING_LOWER)
                         == test->result->delaunay.n_groups);
}

static void
check_step (const Fixture *fixture, const Judge *judge, uint32_t step)
{
  char why[CERTIFY_ROOM] = "";
  Result result;
  Case test = { .fixture = fixture, .judge = judge, .result = &result };

  result_init (&result, fixture->trace, step);
  merged_init (&test.merged, &result);
  check_polygons (&test);
  if (!certify_merged (&test.merged, &result, why))
    g_error ("%s, step %u: %s", fixture->name, step, why);
  merged_clear (&test.merged);
  result_clear (&result);
}

static void
check_rounds (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  Judge *judge = judge_new (fixture->set);

  check_step (fixture, judge, trace->start_end);
  for (uint32_t i = 0; i < trace->n_rounds; i++)
    check_step (fixture, judge, trace->rounds[i].end);
  judge_free (judge);
}

static void
test_polygons_of_every_family_are_whole_circles_and_lines (void)
{
  fixture_for_each (4, 30, ORDER_FURTHEST, check_rounds);
}

static void
test_polygons_of_curated_sets_are_whole_circles_and_lines (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    check_rounds (fixture);
  }
}

/* A three by three grid: four squares below, one above, a polygon on each
 * side. */
static void
test_grid_is_four_squares (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("grid9", ORDER_FURTHEST);
  Result result;
  Merged merged;

  result_init (&result, fixture->trace, fixture->trace->n_events);
  merged_init (&merged, &result);
  g_assert_cmpuint (count (&merged, FACING_LOWER), ==, 4);
  g_assert_cmpuint (count (&merged, FACING_UPPER), ==, 1);
  g_assert_cmpuint (count (&merged, FACING_VERTICAL), ==, 4);
  g_assert_cmpuint (merged.n_sites, ==, 4 * 4 + 4 + 4 * 3);
  merged_clear (&merged);
  result_clear (&result);
}

/* Ways to spoil polygons, each of which certify must find. */
typedef struct Spoiling {
  const char *name, *sites, *words;
  void (*spoil) (Merged *merged);
} Spoiling;

static void
forget_polygon (Merged *merged)
{
  merged->n_polygons -= 1;
}

static void
forget_site (Merged *merged)
{
  merged->polygons[0].n_sites -= 1;
}

static void
swap_sites (Merged *merged)
{
  uint32_t *site = merged->sites + merged->polygons[0].first;
  const uint32_t first = site[0];

  site[0] = site[1];
  site[1] = first;
}

static void
turn_over (Merged *merged)
{
  const Polygon *polygon = &merged->polygons[0];
  uint32_t *site = merged->sites + polygon->first;

  for (uint32_t i = 0; i < polygon->n_sites / 2; i++) {
    const uint32_t low = site[i];

    site[i] = site[polygon->n_sites - 1 - i];
    site[polygon->n_sites - 1 - i] = low;
  }
}

static void
name_wrong_facing (Merged *merged)
{
  Polygon *polygon = &merged->polygons[0];

  polygon->facing
      = polygon->facing == FACING_LOWER ? FACING_UPPER : FACING_LOWER;
}

static void
put_beyond_sites (Merged *merged)
{
  merged->polygons[0].first = merged->n_sites - 1;
}

static void
repeat_polygon (Merged *merged)
{
  merged->polygons[0] = merged->polygons[1];
}

/* Two triangles instead of the first quadrilateral. */
static void
cut_square (Merged *merged)
{
  uint32_t i = 0, last = merged->n_polygons - 1, n = merged->n_sites;
  Polygon *polygon;
  uint32_t *site;

  while (merged->polygons[i].n_sites != 4)
    i++;
  polygon = &merged->polygons[i];
  site = merged->sites + polygon->first;
  merged->sites = g_renew (uint32_t, merged->sites, n + 3);
  site = merged->sites + polygon->first;
  merged->polygons = g_renew (Polygon, merged->polygons, last + 2);
  polygon = &merged->polygons[i];
  merged->sites[n] = site[0];
  merged->sites[n + 1] = site[2];
  merged->sites[n + 2] = site[3];
  polygon->n_sites = 3;
  merged->polygons[last + 1] = (Polygon){ n, 3, polygon->facing };
  merged->n_polygons += 1;
  merged->n_sites += 3;
}

/* One pentagon or more of what were two polygons that are not flat. */
static void
join_triangles (Merged *merged)
{
  Polygon *polygon = &merged->polygons[0];

  while (polygon->n_sites != 3 || polygon[1].n_sites != 3)
    polygon++;
  polygon->n_sites = 4;
}

static const Spoiling spoilings[] = {
  { "polygon-missing", "grid9", "facets", forget_polygon },
  { "site-missing", "grid9", "", forget_site },
  { "sites-swapped", "grid9", "", swap_sites },
  { "polygon-turned-over", "grid9", "", turn_over },
  { "polygon-facing-elsewhere", "grid9", "elsewhere", name_wrong_facing },
  { "polygon-beyond-sites", "grid9", "three sites", put_beyond_sites },
  { "polygon-twice", "mixed8", "", repeat_polygon },
  { "polygon-cut", "grid9", "one plane", cut_square },
  { "polygons-joined", "mixed8", "", join_triangles },
  { "side-missing", "square4", "two sides", forget_polygon },
  { "side-short", "square4", "all sites", forget_site },
  { "side-disordered", "square4", "disordered", swap_sites },
  { "side-turned-over", "square4", "disordered", turn_over },
  { "side-facing-elsewhere", "square4", "elsewhere", name_wrong_facing },
};

static void
test_spoiling_is_found (gconstpointer data)
{
  const Spoiling *spoiling = data;
  g_autoptr (Fixture) fixture = fixture_load (spoiling->sites, ORDER_FURTHEST);
  char why[CERTIFY_ROOM] = "";
  Result result;
  Merged merged;

  result_init (&result, fixture->trace, fixture->trace->n_events);
  merged_init (&merged, &result);
  g_assert_true (certify_merged (&merged, &result, why));
  spoiling->spoil (&merged);
  g_assert_false (certify_merged (&merged, &result, why));
  g_test_message ("%s", why);
  g_assert_nonnull (strstr (why, spoiling->words));
  merged_clear (&merged);
  result_clear (&result);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/merged/a-grid-is-four-squares", test_grid_is_four_squares);
  g_test_add_func (
      "/merged/polygons-of-curated-sets-are-whole-circles-and-lines",
      test_polygons_of_curated_sets_are_whole_circles_and_lines);
  g_test_add_func ("/merged/polygons-of-families-are-whole-circles-and-lines",
                   test_polygons_of_every_family_are_whole_circles_and_lines);
  for (guint i = 0; i < G_N_ELEMENTS (spoilings); i++) {
    g_autofree char *path
        = g_strdup_printf ("/certify/finds/%s", spoilings[i].name);

    g_test_add_data_func (path, &spoilings[i], test_spoiling_is_found);
  }
  return g_test_run ();
}
