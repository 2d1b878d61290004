/* The examples say what a trace says, and the manual's says what it prints. */
#include "fixture.h"

#include <gio/gio.h>
#include <string.h>

/* Returns: (transfer full): what an example prints of a curated set; without
 *          a set when @sites is NULL. */
static char *
run (const char *example, const char *sites)
{
  g_autofree char *program
      = g_build_filename (g_getenv ("HULL2VD_EXAMPLES"), example, NULL);
  g_autofree char *path = sites == NULL ? NULL : fixture_set_path (sites);
  g_autoptr (GError) error = NULL;
  g_autoptr (GSubprocess) process = g_subprocess_new (
      G_SUBPROCESS_FLAGS_STDOUT_PIPE, &error, program, path, NULL);
  char *text = NULL;

  g_assert_no_error (error);
  g_subprocess_communicate_utf8 (process, NULL, NULL, &text, NULL, &error);
  g_assert_no_error (error);
  g_assert_true (g_subprocess_get_successful (process));
  return text;
}

/* The fifth site lies inside the lower facet of the first three. */
static void
test_program_of_the_manual_counts_cones (void)
{
  g_autofree char *text = run ("manual", NULL);

  g_assert_cmpstr (text, ==, "4 cone facets\n");
}

static void
test_counts_are_those_of_the_trace (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);
    g_autofree char *text = run ("count-events", *name);
    g_autoptr (GString) expected = g_string_new (NULL);
    guint n[N_EVENT_KINDS] = { 0 };

    for (uint32_t i = 0; i < fixture->trace->n_events; i++)
      n[trace_event (fixture->trace, i).kind] += 1;
    for (EventKind kind = 0; kind < N_EVENT_KINDS; kind++)
      g_string_append_printf (expected, "%s %u\n", event_kind_name (kind),
                              n[kind]);
    g_assert_cmpstr (text, ==, expected->str);
  }
}

static void
append_round (GString *text, const Trace *trace, uint32_t round)
{
  const RoundRow *row = &trace->rounds[round];

  g_string_append_printf (text, "round %u: s%u sees %u, horizon", round + 1,
                          row->site,
                          row->last_visible - row->first_visible + 1);
  for (uint32_t step = row->first_horizon; step <= row->last_horizon; step++)
    g_string_append_printf (text, " s%u",
                            trace_event (trace, step - 1).ridge[0]);
  g_string_append_c (text, '\n');
}

static void
test_horizons_are_those_of_the_trace (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);
    g_autofree char *text = run ("write-horizon", *name);
    g_autoptr (GString) expected = g_string_new (NULL);

    for (uint32_t i = 0; i < fixture->trace->n_rounds; i++)
      append_round (expected, fixture->trace, i);
    g_assert_cmpstr (text, ==, expected->str);
  }
}

static void
test_horizon_is_text (void)
{
  g_autofree char *text = run ("write-horizon", "lecture8");

  g_assert_true (g_str_has_prefix (text,
                                   "round 1: s4 sees 2, horizon s2 s1 s0 s3\n"
                                   "round 2: s5 sees 1, horizon s2 s1 s4\n"));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/examples/the-program-of-the-manual-counts-cones",
                   test_program_of_the_manual_counts_cones);
  g_test_add_func ("/examples/counts-are-those-of-the-trace",
                   test_counts_are_those_of_the_trace);
  g_test_add_func ("/examples/horizons-are-those-of-the-trace",
                   test_horizons_are_those_of_the_trace);
  g_test_add_func ("/examples/a-horizon-is-a-line-of-text",
                   test_horizon_is_text);
  return g_test_run ();
}
