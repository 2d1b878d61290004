#include "result-json.h"

#include "certify.h"
#include "fixture.h"
#include "oracle.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Returns: (transfer full): the result at @step; free with free(). */
static char *
write_result (const Trace *trace, uint32_t step)
{
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&text, &length);
  Result result;

  result_init (&result, trace, step);
  g_assert_true (result_json_write (
      &result, (ResultForm){ step == trace->n_events, false }, file));
  g_assert_cmpint (fclose (file), ==, 0);
  result_clear (&result);
  return text;
}

static void
judge_every_order (const Fixture *fixture)
{
  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++) {
    g_autofree char *name = g_strdup_printf ("%s, order %s", fixture->name,
                                             order_kind_name (kind));
    char why[CERTIFY_ROOM] = "";
    char *text = NULL;
    size_t length = 0;
    FILE *file = open_memstream (&text, &length);
    Result result;

    result_init_batch (&result, fixture->set, &(Order){ kind, 3 });
    if (!certify_result (&result, why))
      g_error ("%s: %s", name, why);
    g_assert_true (
        result_json_write (&result, (ResultForm){ true, false }, file));
    g_assert_cmpint (fclose (file), ==, 0);
    oracle_judge (text, fixture->set, name);
    result_clear (&result);
    free (text);
  }
}

static void
test_batch_of_every_order_is_right (void)
{
  fixture_for_each (2, 30, ORDER_FURTHEST, judge_every_order);
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    judge_every_order (fixture);
  }
}

/* A facet less, one twice, one turned over: each is found. */
static void
test_certify_refuses_spoiled_facets (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  char why[CERTIFY_ROOM];
  Result result;
  uint32_t site;

  result_init_batch (&result, fixture->set, &(Order){ ORDER_HILBERT, 0 });
  g_assert_true (certify_result (&result, why));
  result.n_facets -= 1;
  g_assert_false (certify_result (&result, why));
  result.n_facets += 1;
  site = result.facets[3][0];
  result.facets[3][0] = result.facets[3][1];
  result.facets[3][1] = site;
  g_assert_false (certify_result (&result, why));
  memcpy (result.facets[3], result.facets[4], sizeof result.facets[4]);
  g_assert_false (certify_result (&result, why));
  result_clear (&result);
}

static void
judge_every_round (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  uint32_t step = trace->simplex_end;

  for (;;) {
    g_autofree char *name
        = g_strdup_printf ("%s, step %u", fixture->name, step);
    char *json = write_result (trace, step);

    oracle_judge (json, fixture->set, name);
    free (json);
    if (step == trace->n_events)
      return;
    step = timeline_next (trace, step, GRAIN_ROUND);
  }
}

static void
test_every_round_of_the_curated_sets_is_right (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    judge_every_round (fixture);
  }
}

static void
test_every_round_of_every_family_is_right (void)
{
  fixture_for_each (2, 14, ORDER_FURTHEST, judge_every_round);
  fixture_for_each (1, 12, ORDER_RANDOM, judge_every_round);
}

static void
judge_sites (const char *name, const Site *sites, uint32_t n_sites)
{
  g_autoptr (Fixture) fixture
      = fixture_take (g_strdup (name), site_set_new (sites, n_sites),
                      &(Order){ ORDER_FURTHEST, 0 });

  judge_every_round (fixture);
}

static void
test_extreme_scales_are_right (void)
{
  const double large = ldexp (1, 1020), small = DBL_TRUE_MIN;
  const Site huge[]
      = { { large, 0 }, { -large, large }, { 3, 0 }, { 0, -1.5 * large } };
  const Site tiny[] = { { small, 0 },
                        { 0, 3 * small },
                        { -2 * small, small },
                        { 5 * small, 7 * small },
                        { 100 * small, 0 } };

  g_assert_null (site_set_new (huge, 4));
  judge_sites ("huge", (Site[]){ huge[0], huge[1], huge[3], { 0, 0 } }, 4);
  judge_sites ("tiny", tiny, 5);
}

static void
test_centre_beyond_doubles_is_null (void)
{
  const Site flat[] = { { -1e308, 1e298 }, { 1e308, 1e298 }, { 0, 0 } };
  g_autoptr (Fixture) fixture = fixture_take (
      g_strdup ("far"), site_set_new (flat, 3), &(Order){ ORDER_FURTHEST, 0 });
  char *json = write_result (fixture->trace, fixture->trace->n_events);

  g_assert_nonnull (strstr (json, "\"vertices\": [null]"));
  oracle_judge (json, fixture->set, fixture->name);
  free (json);
}

static const char *const square
    = "{\n"
      "  \"n\": 4,\n"
      "  \"dimension\": 2,\n"
      "  \"points\": [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]],\n"
      "  \"hull2d\": [0, 1, 2, 3],\n"
      "  \"triangles\": [[0, 1, 2], [0, 2, 3]],\n"
      "  \"voronoi\": {\n"
      "    \"vertices\": [[0, 0]],\n"
      "    \"vertex_of_triangle\": [0, 0],\n"
      "    \"edges\": [[0, 1, 0, -1, 0, -1], [1, 2, 0, -1, 1, 0], "
      "[2, 3, 0, -1, 0, 1], [3, 0, 0, -1, -1, 0]]\n"
      "  },\n"
      "  \"hull3d\": {\n"
      "    \"dimension\": 2,\n"
      "    \"facets\": [],\n"
      "    \"kinds\": []\n"
      "  }\n"
      "}\n";

static void
assert_square (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("square4", ORDER_FURTHEST);
  char *json = write_result (fixture->trace, fixture->trace->n_events);

  g_assert_cmpstr (json, ==, square);
  free (json);
}

static void
test_square_is_one_circle_group (void)
{
  assert_square ();
}

static void
test_locale_does_not_matter (void)
{
  g_assert_nonnull (setlocale (LC_ALL, "de_DE.UTF-8"));
  assert_square ();
  setlocale (LC_ALL, "C");
}

static void
test_only_unfinished_results_list_active_sites (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  char *first = write_result (fixture->trace, fixture->trace->start_end);
  char *last = write_result (fixture->trace, fixture->trace->n_events);

  g_assert_nonnull (strstr (first, "\"active\": [0, 1, 2, 3],\n"));
  g_assert_null (strstr (last, "active"));
  free (first);
  free (last);
}

static void
test_failing_file_is_reported (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("square4", ORDER_FURTHEST);
  FILE *full = fopen ("/dev/full", "w");
  Result result;

  g_assert_nonnull (full);
  setvbuf (full, NULL, _IONBF, 0);
  result_init (&result, fixture->trace, fixture->trace->n_events);
  g_assert_false (
      result_json_write (&result, (ResultForm){ true, false }, full));
  result_clear (&result);
  fclose (full);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/result-json/the-batch-of-every-order-is-right",
                   test_batch_of_every_order_is_right);
  g_test_add_func ("/result-json/certify-refuses-spoiled-facets",
                   test_certify_refuses_spoiled_facets);
  g_test_add_func ("/result-json/square-is-one-circle-group",
                   test_square_is_one_circle_group);
  g_test_add_func ("/result-json/locale-does-not-matter",
                   test_locale_does_not_matter);
  g_test_add_func ("/result-json/only-unfinished-results-list-active-sites",
                   test_only_unfinished_results_list_active_sites);
  g_test_add_func ("/result-json/centre-beyond-doubles-is-null",
                   test_centre_beyond_doubles_is_null);
  g_test_add_func ("/result-json/extreme-scales-are-right",
                   test_extreme_scales_are_right);
  g_test_add_func ("/result-json/every-round-of-the-curated-sets-is-right",
                   test_every_round_of_the_curated_sets_is_right);
  g_test_add_func ("/result-json/every-round-of-every-family-is-right",
                   test_every_round_of_every_family_is_right);
  g_test_add_func ("/result-json/failing-file-is-reported",
                   test_failing_file_is_reported);
  return g_test_run ();
}
