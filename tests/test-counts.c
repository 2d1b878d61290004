/* The teaching numbers: what an order costs a site, at 10 000 uniform sites.
 * QuickHull, the oldest facet first, makes fewer facets than a random order.
 */
#include "batch.h"
#include "trace.h"

#include <glib.h>
#include <math.h>

enum { N_SITES = 10000, N_SEEDS = 4 };

/* Facets made a site. */
#define QUICKHULL 5.56
#define RANDOM 6.00

static Site *
uniform_sites (guint32 seed)
{
  Site *sites = g_new (Site, N_SITES);
  GRand *random = g_rand_new_with_seed (seed);

  for (guint i = 0; i < N_SITES; i++) {
    sites[i].x = g_rand_double (random);
    sites[i].y = g_rand_double (random);
  }
  g_rand_free (random);
  return sites;
}

static void
assert_within_2_percent (double count, double expected)
{
  g_test_message ("%.3f", count);
  g_assert_cmpfloat (fabs (count - expected), <=, 0.02 * expected);
}

static HullCounts
counts_of (guint32 seed, OrderKind kind)
{
  g_autofree Site *sites = uniform_sites (seed);
  Batch *batch
      = batch_build (sites, N_SITES, &(Order){ kind, seed }, BATCH_OLDEST);
  const HullCounts counts = batch->counts;

  batch_free (batch);
  return counts;
}

static void
test_quickhull_makes_few_facets (void)
{
  for (guint32 seed = 1; seed <= N_SEEDS; seed++)
    assert_within_2_percent (
        (double)counts_of (seed, ORDER_FURTHEST).facets_created / N_SITES,
        QUICKHULL);
}

static void
test_random_order_makes_six_facets (void)
{
  for (guint32 seed = 1; seed <= N_SEEDS; seed++) {
    assert_within_2_percent (
        (double)counts_of (seed, ORDER_RANDOM).facets_created / N_SITES,
        RANDOM);
    assert_within_2_percent (
        (double)counts_of (seed, ORDER_INPUT).facets_created / N_SITES, RANDOM);
  }
}

/* Each visible facet but the first was tested, and each beyond the horizon:
 * visible - 1 + visible + 2 tests a round are the least, met when none is
 * tested twice. */
static void
test_tests_follow_from_facets (void)
{
  for (guint32 seed = 1; seed <= N_SEEDS; seed++) {
    const HullCounts counts = counts_of (seed, ORDER_FURTHEST);
    const uint64_t n_rounds = N_SITES - 4;
    const uint64_t n_visible = counts.facets_created - 4 - 2 * n_rounds;
    const uint64_t least = 2 * n_visible + n_rounds;

    g_assert_cmpuint (counts.visibility_tests, >=, least);
    g_assert_cmpfloat ((double)counts.visibility_tests, <=,
                       1.02 * (double)least);
  }
}

/* As engines count that build the lower hull alone: with a facet to infinity
 * over each edge of the hull in the plane. A site outside makes two of those.
 */
static double
lower_and_ghost_facets (const Trace *trace)
{
  uint32_t n_made = 0;

  for (uint32_t i = 0; i < trace->n_rounds; i++) {
    const RoundRow *row = &trace->rounds[i];
    bool is_outside = false;

    for (uint32_t step = row->first_cone; step <= row->last_cone; step++) {
      const uint32_t facet = trace_event (trace, step - 1).facet;
      const bool is_lower = trace->facets[facet].facing == FACING_LOWER;

      n_made += is_lower ? 1 : 0;
      is_outside = is_outside || !is_lower;
    }
    n_made += is_outside ? 2 : 0;
  }
  return (double)n_made / trace->set->n_sites;
}

static void
test_lower_hull_and_ghosts_count_the_same (void)
{
  static const struct {
    OrderKind kind;
    double expected;
  } rows[] = { { ORDER_FURTHEST, QUICKHULL }, { ORDER_RANDOM, RANDOM } };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autofree Site *sites = uniform_sites (9);
    SiteSet *set = site_set_new (sites, N_SITES);
    Trace *trace = trace_record (set, &(Order){ rows[i].kind, 9 });

    assert_within_2_percent (lower_and_ghost_facets (trace), rows[i].expected);
    trace_free (trace);
    site_set_free (set);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/counts/quickhull-makes-5.56-facets-a-site",
                   test_quickhull_makes_few_facets);
  g_test_add_func ("/counts/a-random-order-makes-6-facets-a-site",
                   test_random_order_makes_six_facets);
  g_test_add_func ("/counts/hardly-a-facet-is-tested-twice",
                   test_tests_follow_from_facets);
  g_test_add_func ("/counts/lower-facets-and-ghosts-are-as-many",
                   test_lower_hull_and_ghosts_count_the_same);
  return g_test_run ();
}
