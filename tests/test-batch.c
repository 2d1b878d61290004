/* The engine without events against the one with them, and the orders. */
#include "batch.h"
#include "certify.h"
#include "fixture.h"
#include "hilbert.h"
#include "rbox.h"

#include <math.h>
#include <string.h>

/* Whether the facet's circle or plane has company: then another cut of the
 * same polygon is as good. */
static gboolean
is_tied (const Trace *trace, uint32_t facet)
{
  const Site *sites = trace->set->sites;
  const uint32_t *s = trace->facets[facet].site;

  for (uint32_t i = 0; i < trace->set->n_sites; i++)
    if (trace->set->first[i] == i && i != s[0] && i != s[1] && i != s[2]
        && lift_orient (&sites[s[0]], &sites[s[1]], &sites[s[2]], &sites[i])
               == 0)
      return TRUE;
  return FALSE;
}

/* The facet's sites, the lowest first; duplicates by their first. */
static char *
facet_key (const SiteSet *set, const uint32_t site[3])
{
  uint32_t k = 0;
  uint32_t s[3];

  for (uint32_t i = 0; i < 3; i++)
    s[i] = set->first[site[i]];
  while (s[k] > s[(k + 1) % 3] || s[k] > s[(k + 2) % 3])
    k++;
  return g_strdup_printf ("%u %u %u", s[k], s[(k + 1) % 3], s[(k + 2) % 3]);
}

static GHashTable *
facet_keys (const SiteSet *set, const Batch *batch)
{
  GHashTable *keys
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);

  for (uint32_t i = 0; i < batch->n_facets; i++)
    g_hash_table_add (keys, facet_key (set, batch->facets[i].site));
  return keys;
}

static void
assert_same_hull (const Fixture *fixture, OrderKind kind)
{
  const Trace *trace = fixture->trace;
  const SiteSet *set = fixture->set;
  Batch *batch = batch_build (set->sites, set->n_sites, &(Order){ kind, 5 },
                              BATCH_LOCAL);
  g_autoptr (GHashTable) keys = NULL;
  uint32_t n_standing = 0;

  batch_close (batch, set->sites, set->n_sites);
  keys = facet_keys (set, batch);
  for (uint32_t i = 0; i < trace->n_facets; i++) {
    g_autofree char *key = facet_key (set, trace->facets[i].site);

    if (trace->facets[i].span.death != STEP_NEVER)
      continue;
    n_standing++;
    if (!is_tied (trace, i) && !g_hash_table_contains (keys, key))
      g_error ("%s, order %s: facet %s is missing", fixture->name,
               order_kind_name (kind), key);
  }
  if (batch->n_facets != n_standing || g_hash_table_size (keys) != n_standing)
    g_error ("%s, order %s: %u facets, not %u", fixture->name,
             order_kind_name (kind), batch->n_facets, n_standing);
  batch_free (batch);
}

static void
check_every_order (const Fixture *fixture)
{
  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++)
    assert_same_hull (fixture, kind);
}

static void
test_every_order_builds_the_same_hull (void)
{
  fixture_for_each (2, 60, ORDER_FURTHEST, check_every_order);
  fixture_for_each (1, 400, ORDER_FURTHEST, check_every_order);
}

/* What certify finds in the sites' triangulation, diagram and hull. */
static void
assert_certified (const SiteSet *set, OrderKind kind, const char *name)
{
  char why[CERTIFY_ROOM];
  Result result;

  result_init_batch (&result, set, &(Order){ kind, 1 });
  if (!certify_result (&result, why))
    g_error ("%s, order %s: %s", name, order_kind_name (kind), why);
  result_clear (&result);
}

static void
certify_every_order (const SiteSet *set, const char *name)
{
  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++)
    assert_certified (set, kind, name);
}

static void
test_results_of_every_family_are_certified (void)
{
  for (Rbox kind = 0; kind < N_RBOXES; kind++) {
    SiteSet *set = rbox_new (kind, 7, 3000);

    certify_every_order (set, rbox_name (kind));
    site_set_free (set);
  }
}

/* The bit patterns of both builds' results. */
static void
assert_same_without_avx2 (const SiteSet *set, const char *name)
{
  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++) {
    const Order order = { kind, 3 };
    Batch *with = batch_build (set->sites, set->n_sites, &order, BATCH_LOCAL);
    Batch *without;

    batch_use_avx2 (false);
    without = batch_build (set->sites, set->n_sites, &order, BATCH_LOCAL);
    batch_use_avx2 (true);
    if (with->n_facets != without->n_facets
        || memcmp (with->facets, without->facets,
                   with->n_facets * sizeof *with->facets)
               != 0)
      g_error ("%s, order %s: AVX2 makes a difference", name,
               order_kind_name (kind));
    batch_free (with);
    batch_free (without);
  }
}

static void
test_avx2_makes_no_difference (void)
{
  rbox_for_each (2, 300, assert_same_without_avx2);
}

/* Neighbours agree: the same edge the other way, and back again. */
static void
assert_neighbours_agree (const Batch *batch)
{
  for (uint32_t edge = 0; edge < batch->n_facets * 4; edge++) {
    const HullFacet *row = &batch->facets[edge / 4];
    const HullFacet *other;
    HullEdge across;

    if (edge % 4 == 3)
      continue;
    across = row->across[edge % 4];
    other = &batch->facets[across / 4];
    g_assert_cmpuint (other->across[across % 4], ==, edge);
    g_assert_cmpuint (other->site[across % 4], ==,
                      row->site[(edge % 4 + 1) % 3]);
    g_assert_cmpuint (other->site[(across % 4 + 1) % 3], ==,
                      row->site[edge % 4]);
  }
}

static void
check_neighbours (const Fixture *fixture)
{
  Batch *batch = batch_build (fixture->set->sites, fixture->set->n_sites,
                              &(Order){ ORDER_HILBERT, 0 }, BATCH_LOCAL);

  assert_neighbours_agree (batch);
  batch_close (batch, fixture->set->sites, fixture->set->n_sites);
  assert_neighbours_agree (batch);
  batch_free (batch);
}

static void
test_neighbours_agree (void)
{
  fixture_for_each (2, 60, ORDER_FURTHEST, check_neighbours);
}

/* Sites on a circle but for rounding, where hardly a sign in space is beyond
 * doubt; and two whose upper hull is flat: one facet, and several on one
 * circle.
 */
static void
test_doubtful_and_flat_upper_hulls_are_certified (void)
{
  enum { N = 2000 };
  const Site triangle[] = { { 0, 0 }, { 8, 0 }, { 0, 8 }, { 1, 2 }, { 3, 2 } };
  const Site square[]
      = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 2 }, { 2, 1 } };
  Site circle[N];
  SiteSet *sets[3];

  for (uint32_t i = 0; i < N; i++) {
    const double angle = 2 * G_PI * i / N;

    circle[i] = (Site){ cos (angle), sin (angle) };
  }
  sets[0] = site_set_new (circle, N);
  sets[1] = site_set_new (triangle, G_N_ELEMENTS (triangle));
  sets[2] = site_set_new (square, G_N_ELEMENTS (square));
  for (uint32_t i = 0; i < G_N_ELEMENTS (sets); i++) {
    certify_every_order (sets[i],
                         (const char *[]){ "circle", "triangle", "square" }[i]);
    site_set_free (sets[i]);
  }
}

static uint32_t
count_unbounded (const Batch *batch)
{
  uint32_t n = 0;

  for (uint32_t i = 0; i < batch->n_facets; i++)
    for (uint32_t k = 0; k < 3; k++)
      n += batch->facets[i].site[k] == INDEX_NONE;
  return n;
}

static void
test_the_lower_hull_is_closed_by_infinity (void)
{
  const Site sites[] = { { 0, 0 }, { 8, 1 }, { 9, 7 }, { 4, 10 }, { -1, 6 },
                         { 2, 3 }, { 5, 4 }, { 3, 7 }, { 6, 6 },  { 2, 3 } };
  enum { N = G_N_ELEMENTS (sites), N_DISTINCT = N - 1 };

  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++) {
    Batch *batch = batch_build (sites, N, &(Order){ kind, 1 }, BATCH_LOCAL);

    g_assert_false (batch->is_whole);
    g_assert_cmpuint (batch->n_facets, ==, 2 * (N_DISTINCT + 1) - 4);
    g_assert_cmpuint (count_unbounded (batch), ==, 5);
    batch_close (batch, sites, N);
    g_assert_true (batch->is_whole);
    g_assert_cmpuint (batch->n_facets, ==, 2 * N_DISTINCT - 4);
    g_assert_cmpuint (count_unbounded (batch), ==, 0);
    batch_free (batch);
  }
}

static void
test_flat_input_has_no_facet (void)
{
  const Site square[] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 1, 1 } };

  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++)
    for (uint32_t n = 0; n <= G_N_ELEMENTS (square); n++) {
      Batch *batch = batch_build (square, n, &(Order){ kind, 1 }, BATCH_LOCAL);

      g_assert_cmpuint (batch->n_facets, ==, 0);
      batch_free (batch);
    }
}

static uint64_t
count_created (const SiteSet *set, BatchTurn turn)
{
  Batch *batch = batch_build (set->sites, set->n_sites,
                              &(Order){ ORDER_INPUT, 0 }, turn);
  const uint64_t n_created = batch->counts.facets_created;

  g_assert_cmpuint (batch->counts.visibility_tests, >=, n_created);
  batch_free (batch);
  return n_created;
}

/* Inside three sites a round makes lower facets alone. The fourth site makes a
 * simplex of four; with a site at infinity three more than the simplex. */
static void
test_events_and_batch_create_the_same_facets (void)
{
  g_autoptr (Fixture) random = fixture_new (FAMILY_RANDOM, 3, 500, ORDER_INPUT);
  const uint32_t n = random->set->n_sites + 3;
  g_autofree Site *sites = g_new (Site, n);
  SiteSet *inside;
  Trace *trace;

  memcpy (sites, (Site[]){ { -9e9, -9e9 }, { 9e9, -9e9 }, { 0, 9e9 } },
          3 * sizeof *sites);
  memcpy (sites + 3, random->set->sites, (n - 3) * sizeof *sites);
  inside = site_set_new (sites, n);
  trace = trace_record (inside, &(Order){ ORDER_INPUT, 0 });
  g_assert_cmpuint (count_created (inside, BATCH_OLDEST), ==, trace->n_facets);
  g_assert_cmpuint (count_created (inside, BATCH_LOCAL), ==,
                    trace->n_facets + 3);
  trace_free (trace);
  site_set_free (inside);
}

/* On a grid of 2^k × 2^k the curve goes from each node to a neighbour. */
static void
test_curve_steps_to_neighbours (void)
{
  enum { SIDE = 32, N = SIDE * SIDE };
  Site sites[N];
  uint32_t list[N];

  for (uint32_t i = 0; i < N; i++) {
    const uint32_t column = i % SIDE, row = i / SIDE;

    sites[i] = (Site){ column, row };
  }
  hilbert_sort (sites, N, list);
  for (uint32_t i = 1; i < N; i++) {
    const Site *a = &sites[list[i - 1]], *b = &sites[list[i]];

    g_assert_cmpfloat (fabs (a->x - b->x) + fabs (a->y - b->y), ==, 1);
  }
}

static void
test_rounds_hold_every_site_once (void)
{
  enum { N = 1000 };
  Site sites[N];
  uint32_t list[N];
  gboolean is_there[N] = { FALSE };

  for (uint32_t i = 0; i < N; i++)
    sites[i] = (Site){ i % 37, i % 41 };
  hilbert_brio (sites, N, list);
  for (uint32_t i = 0; i < N; i++) {
    g_assert_cmpuint (list[i], <, N);
    g_assert_false (is_there[list[i]]);
    is_there[list[i]] = TRUE;
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/batch/every-order-builds-the-same-hull",
                   test_every_order_builds_the_same_hull);
  g_test_add_func ("/batch/results-of-every-family-are-certified",
                   test_results_of_every_family_are_certified);
  g_test_add_func ("/batch/avx2-makes-no-difference",
                   test_avx2_makes_no_difference);
  g_test_add_func ("/batch/neighbours-agree", test_neighbours_agree);
  g_test_add_func ("/batch/doubtful-and-flat-upper-hulls-are-certified",
                   test_doubtful_and_flat_upper_hulls_are_certified);
  g_test_add_func ("/batch/the-lower-hull-is-closed-by-facets-to-infinity",
                   test_the_lower_hull_is_closed_by_infinity);
  g_test_add_func ("/batch/flat-input-has-no-facet",
                   test_flat_input_has_no_facet);
  g_test_add_func ("/batch/with-and-without-events-the-same-facets-are-made",
                   test_events_and_batch_create_the_same_facets);
  g_test_add_func ("/hilbert/the-curve-steps-to-neighbours",
                   test_curve_steps_to_neighbours);
  g_test_add_func ("/hilbert/rounds-hold-every-site-once",
                   test_rounds_hold_every_site_once);
  return g_test_run ();
}
