/* The counters as laws: what stands left of = must be what stands right. */
#include "fixture.h"
#include "laws.h"

#include <stdlib.h>
#include <string.h>

/* Works out "2·7 − 4" from the left; there are no brackets. */
static int
evaluate (const char *text)
{
  g_auto (GStrv) words = g_strsplit (text, " ", -1);
  int sum = 0, sign = 1;

  for (guint i = 0; words[i] != NULL; i++) {
    const char *times = strstr (words[i], "·");

    if (g_str_equal (words[i], "−"))
      sign = -1;
    else if (g_str_equal (words[i], "+"))
      sign = 1;
    else
      sum += sign * atoi (words[i])
             * (times == NULL ? 1 : atoi (times + strlen ("·")));
  }
  return sum;
}

static guint n_laws;

static void
check_law (const Fixture *fixture, guint step, const Law *law)
{
  g_auto (GStrv) sides = g_strsplit (law->value, " = ", -1);

  if (g_strv_length (sides) != 2)
    return;
  n_laws += 1;
  if (evaluate (sides[0]) != evaluate (sides[1]))
    g_error ("%s, step %u: %s: %s", fixture->name, step, law->key, law->value);
}

static void
check_fixture (const Fixture *fixture)
{
  for (guint step = 0; step <= fixture->trace->n_events; step++) {
    g_autoptr (GPtrArray) laws = NULL;
    Frame frame;

    frame_init (&frame, fixture->trace, step);
    laws = laws_of (&frame);
    for (guint i = 0; i < laws->len; i++)
      check_law (fixture, step, g_ptr_array_index (laws, i));
    frame_clear (&frame);
  }
}

static void
test_every_law_is_true_at_every_step (void)
{
  const char *const *names = fixture_names ();

  for (; *names != NULL; names++) {
    g_autoptr (Fixture) fixture = fixture_load (*names, ORDER_FURTHEST);

    check_fixture (fixture);
  }
  fixture_for_each (1, 14, ORDER_RANDOM, check_fixture);
  g_assert_cmpuint (n_laws, >, 1000);
}

static char *
laws_at (const Fixture *fixture, guint step)
{
  GString *text = g_string_new (NULL);
  g_autoptr (GPtrArray) laws = NULL;
  Frame frame;

  frame_init (&frame, fixture->trace, step);
  laws = laws_of (&frame);
  for (guint i = 0; i < laws->len; i++) {
    const Law *law = g_ptr_array_index (laws, i);

    g_string_append_printf (text, "%s: %s\n", law->key, law->value);
  }
  frame_clear (&frame);
  return g_string_free (text, FALSE);
}

static void
test_laws_read_as_in_the_panel (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const RoundRow *round = &fixture->trace->rounds[3];
  g_autofree char *at_cone = laws_at (fixture, round->last_cone);
  g_autofree char *at_start = laws_at (fixture, fixture->trace->start_end);
  /* A site has been chosen, and nobody has looked what it sees. */
  g_autofree char *at_choose = laws_at (fixture, fixture->trace->start_end + 1);

  g_assert_cmpstr (at_choose, ==, at_start);
  g_assert_cmpstr (at_cone, ==,
                   "inserted: 7 of 8\n"
                   "facets: 10 = 2·7 − 4\n"
                   "lower: 8 = 2·7 − 2 − 4\n"
                   "upper: 2 = 4 − 2\n"
                   "visible: 4\n"
                   "horizon: 6 = 4 + 2\n"
                   "cone: 6 = 4 + 2\n");
  g_assert_cmpstr (at_start, ==,
                   "inserted: 4 of 8\n"
                   "facets: 4 = 2·4 − 4\n"
                   "lower: 2 = 2·4 − 2 − 4\n"
                   "upper: 2 = 4 − 2\n"
                   "outside-sets: 4 sites in 1\n");
}

static void
test_a_horizon_half_found_is_no_law_yet (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  g_autofree char *text
      = laws_at (fixture, fixture->trace->rounds[0].first_horizon);

  g_assert_nonnull (strstr (text, "horizon: 1\n"));
}

static void
test_sites_without_a_simplex_have_laws (void)
{
  g_autoptr (Fixture) square = fixture_load ("square4", ORDER_FURTHEST);
  g_autoptr (Fixture) line = fixture_load ("line4", ORDER_FURTHEST);
  g_autofree char *of_square = laws_at (square, square->trace->n_events);
  g_autofree char *of_line = laws_at (line, line->trace->n_events);

  g_assert_cmpstr (of_square, ==,
                   "inserted: 4 of 4\n"
                   "triangles: 2 = 4 − 2\n"
                   "voronoi-vertices: 1\n"
                   "rays: 4 = 4\n");
  g_assert_cmpstr (of_line, ==,
                   "inserted: 4 of 4\n"
                   "delaunay-edges: 3 = 4 − 1\n"
                   "voronoi-lines: 3 = 4 − 1\n");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/laws/every-law-is-true-at-every-step",
                   test_every_law_is_true_at_every_step);
  g_test_add_func ("/laws/laws-read-as-in-the-panel",
                   test_laws_read_as_in_the_panel);
  g_test_add_func ("/laws/a-horizon-half-found-is-no-law-yet",
                   test_a_horizon_half_found_is_no_law_yet);
  g_test_add_func ("/laws/sites-without-a-simplex-have-laws",
                   test_sites_without_a_simplex_have_laws);
  return g_test_run ();
}
