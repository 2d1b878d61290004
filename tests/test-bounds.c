/* A walk over a mesh that is none stops with a message, it does not go on for
 * ever. */
#include "hull-builder.h"

#include <glib.h>

/* Two facets that face up, each across all edges of the other. */
static void
walk_over_upper_facets (void)
{
  const Site sites[] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
  HullFacet facets[] = { { { 0, 1, 2 }, { 4, 5, 6 }, INDEX_NONE, 0 },
                         { { 0, 1, 2 }, { 0, 1, 2 }, INDEX_NONE, 0 } };
  HullBuilder b
      = { .sites = sites, .n_sites = 4, .facets = facets, .n_facets = 2 };

  walk_to (&b, 3);
}

/* The first edge of the visible facet is on the horizon; the others lead to
 * one of them. */
static void
walk_round_no_horizon (void)
{
  const Site sites[] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
  HullFacet facets[] = { { { 0, 1, 2 }, { 4, 1, 1 }, INDEX_NONE, 1 },
                         { { 1, 0, 3 }, { 0, 0, 0 }, INDEX_NONE, 0 } };
  uint32_t visible[] = { 0 };
  HullBuilder b = { .sites = sites,
                    .n_sites = 4,
                    .facets = facets,
                    .n_facets = 2,
                    .round = 1,
                    .visible = visible,
                    .n_visible = 1 };

  horizon_collect (&b, 3);
}

static void
assert_stops (void (*walk) (void), const char *message)
{
  if (g_test_subprocess ()) {
    walk ();
    return;
  }
  g_test_trap_subprocess (NULL, 30 * G_USEC_PER_SEC, 0);
  g_test_trap_assert_failed ();
  g_test_trap_assert_stderr (message);
}

static void
test_walk_without_a_lower_facet_stops (void)
{
  assert_stops (walk_over_upper_facets, "*a lower facet lies round*");
}

static void
test_horizon_that_is_no_loop_stops (void)
{
  assert_stops (walk_round_no_horizon, "*the horizon is one loop*");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/bounds/a-walk-without-a-lower-facet-stops",
                   test_walk_without_a_lower_facet_stops);
  g_test_add_func ("/bounds/a-horizon-that-is-no-loop-stops",
                   test_horizon_that_is_no_loop_stops);
  return g_test_run ();
}
