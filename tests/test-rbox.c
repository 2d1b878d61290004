/* Sets of all kinds that qhull's rbox makes, and more: every order's result
 * is certified, and all orders agree once facets are merged. ./dev soak runs
 * ten thousand of them. */
#include "rbox.h"

#include "certify.h"
#include "fixture.h"

#include <stdlib.h>
#include <string.h>

typedef struct Outcome {
  Result result;
  Merged merged;
} Outcome;

static void
outcome_clear (Outcome *outcome)
{
  merged_clear (&outcome->merged);
  result_clear (&outcome->result);
}

static void
certify_outcome (Outcome *outcome, const char *name, const char *order)
{
  char why[CERTIFY_ROOM] = "";

  merged_init (&outcome->merged, &outcome->result);
  if (!certify_result (&outcome->result, why)
      || !certify_merged (&outcome->merged, &outcome->result, why))
    g_error ("%s, order %s: %s", name, order, why);
}

static int
compare_sites (const void *a, const void *b)
{
  const uint32_t left = *(const uint32_t *)a, right = *(const uint32_t *)b;

  return (left > right) - (left < right);
}

/* Returns: the polygons as text, each with its sites in ascending order. */
static GHashTable *
polygon_keys (const Merged *merged)
{
  GHashTable *keys
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);

  for (uint32_t i = 0; i < merged->n_polygons; i++) {
    const Polygon *polygon = &merged->polygons[i];
    GString *key = g_string_new (NULL);
    uint32_t *sites = merged->sites + polygon->first;

    qsort (sites, polygon->n_sites, sizeof *sites, compare_sites);
    g_string_printf (key, "%d", polygon->facing);
    for (uint32_t k = 0; k < polygon->n_sites; k++)
      g_string_append_printf (key, " %u", sites[k]);
    g_hash_table_add (keys, g_string_free (key, FALSE));
  }
  return keys;
}

static void
assert_same_polygons (GHashTable *a, GHashTable *b, const char *name)
{
  GHashTableIter iter;
  gpointer key;

  if (g_hash_table_size (a) != g_hash_table_size (b))
    g_error ("%s: %u polygons, or %u", name, g_hash_table_size (a),
             g_hash_table_size (b));
  g_hash_table_iter_init (&iter, a);
  while (g_hash_table_iter_next (&iter, &key, NULL))
    if (!g_hash_table_contains (b, key))
      g_error ("%s: polygon %s is not there", name, (const char *)key);
}

/* Takes over what is in @outcome. */
static void
check_against (GHashTable **expected, Outcome *outcome, const char *name)
{
  GHashTable *keys = polygon_keys (&outcome->merged);

  if (*expected == NULL)
    *expected = g_hash_table_ref (keys);
  assert_same_polygons (*expected, keys, name);
  g_hash_table_unref (keys);
  outcome_clear (outcome);
}

static void
check_every_order (const SiteSet *set, const char *name)
{
  GHashTable *expected = NULL;

  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++) {
    const Order order = { kind, 11 };
    const char *order_name = order_kind_name (kind);
    Trace *trace = trace_record (set, &order);
    Outcome outcome;

    result_init_batch (&outcome.result, set, &order);
    certify_outcome (&outcome, name, order_name);
    check_against (&expected, &outcome, name);
    result_init (&outcome.result, trace, trace->n_events);
    certify_outcome (&outcome, name, order_name);
    check_against (&expected, &outcome, name);
    trace_free (trace);
  }
  g_hash_table_unref (expected);
}

static void
test_every_order_is_right_and_all_agree (void)
{
  rbox_for_each (8, 200, check_every_order);
}

static void
certify_step (const Trace *trace, uint32_t step, const char *name)
{
  char why[CERTIFY_ROOM] = "";
  Frame frame;

  frame_init (&frame, trace, step);
  if (!certify_frame (&frame, why))
    g_error ("%s, step %u: %s", name, step, why);
  frame_clear (&frame);
}

/* The simplex, and the end of round 1 + @stride, 1 + 2 @stride and so on. */
static void
certify_rounds (const SiteSet *set, const char *name, uint32_t stride)
{
  Trace *trace = trace_record (set, &(Order){ ORDER_FURTHEST, 0 });

  certify_step (trace, trace->start_end, name);
  for (uint32_t i = 0; i < trace->n_rounds; i += stride)
    certify_step (trace, trace->rounds[i].end, name);
  certify_step (trace, trace->n_events, name);
  trace_free (trace);
}

static void
check_every_round (const SiteSet *set, const char *name)
{
  certify_rounds (set, name, 1);
}

static void
test_every_round_up_to_200_sites_is_right (void)
{
  rbox_for_each (1, 200, check_every_round);
}

static void
test_fifty_rounds_of_2000_sites_are_right (void)
{
  const guint n_seeds = MIN (fixture_soak_factor (), 10);

  /* Of every third kind, but of each in ./dev soak. */
  for (guint i = 0; i < n_seeds * N_RBOXES; i += n_seeds == 1 ? 3 : 1) {
    g_autofree char *name = g_strdup_printf (
        "%s %u of 2000 sites", rbox_name (i % N_RBOXES), i / N_RBOXES);
    SiteSet *set = rbox_new (i % N_RBOXES, i / N_RBOXES, 2000);

    certify_rounds (set, name, MAX (1, set->n_sites / 50));
    site_set_free (set);
  }
}

/* Returns: the same sites in another order; @names has their old indices. */
static SiteSet *
shuffled (const SiteSet *set, guint32 seed, uint32_t *names)
{
  g_autofree Site *sites = g_new (Site, set->n_sites + 1);
  GRand *random = g_rand_new_with_seed (seed);

  for (uint32_t i = 0; i < set->n_sites; i++)
    names[i] = i;
  for (uint32_t i = set->n_sites; i > 1; i--) {
    const uint32_t j = (uint32_t)g_rand_int_range (random, 0, (gint32)i);
    const uint32_t last = names[i - 1];

    names[i - 1] = names[j];
    names[j] = last;
  }
  for (uint32_t i = 0; i < set->n_sites; i++)
    sites[i] = site_set_given (set, names[i]);
  g_rand_free (random);
  return site_set_new (sites, set->n_sites);
}

/* The polygons of the sites in another order, by their names in @set. */
static GHashTable *
polygons_of_shuffle (const SiteSet *set, guint32 seed)
{
  g_autofree uint32_t *names = g_new (uint32_t, set->n_sites + 1);
  SiteSet *other = shuffled (set, seed, names);
  Trace *trace = trace_record (other, &(Order){ ORDER_FURTHEST, 0 });
  GHashTable *keys;
  Outcome outcome;

  result_init (&outcome.result, trace, trace->n_events);
  merged_init (&outcome.merged, &outcome.result);
  for (uint32_t i = 0; i < outcome.merged.n_sites; i++)
    outcome.merged.sites[i] = set->first[names[outcome.merged.sites[i]]];
  keys = polygon_keys (&outcome.merged);
  outcome_clear (&outcome);
  trace_free (trace);
  site_set_free (other);
  return keys;
}

static void
check_shuffles (const SiteSet *set, const char *name)
{
  g_autoptr (GHashTable) first = polygons_of_shuffle (set, 0);

  for (guint32 seed = 1; seed < 4; seed++) {
    g_autoptr (GHashTable) other = polygons_of_shuffle (set, seed);

    assert_same_polygons (first, other, name);
  }
}

static void
test_input_order_does_not_change_merged_facets (void)
{
  rbox_for_each (4, 100, check_shuffles);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/rbox/every-order-is-right-and-all-agree-once-merged",
                   test_every_order_is_right_and_all_agree);
  g_test_add_func ("/rbox/every-round-up-to-200-sites-is-right",
                   test_every_round_up_to_200_sites_is_right);
  g_test_add_func ("/rbox/fifty-rounds-of-2000-sites-are-right",
                   test_fifty_rounds_of_2000_sites_are_right);
  g_test_add_func ("/rbox/input-order-does-not-change-merged-facets",
                   test_input_order_does_not_change_merged_facets);
  return g_test_run ();
}
