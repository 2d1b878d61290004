#include "trace-file.h"

#include "certify.h"
#include "fixture.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

/* Returns: the file; free with free(). */
static char *
write_trace (const Trace *trace, Grain grain)
{
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&text, &length);

  g_assert_true (trace_file_write (trace, grain, file));
  g_assert_cmpint (fclose (file), ==, 0);
  return text;
}

static Trace *
parse (const char *text, SiteSet **set, TraceFileError *error)
{
  return trace_file_parse (text, strlen (text), set, error);
}

static const char *const five = "hull2vd-trace 1\n"
                                "order furthest\n"
                                "site 0 -0.6 -0.5\n"
                                "site 1 0.7 -0.4\n"
                                "site 2 0.1 0.8\n"
                                "site 3 0 0.1\n"
                                "site 4 0.3 -0.1\n"
                                "simplex f0 s0 s1 s2\n"
                                "simplex f1 s0 s3 s1\n"
                                "simplex f2 s1 s3 s2\n"
                                "simplex f3 s2 s3 s0\n"
                                "claim s4 f1\n"
                                "select f1 s4\n"
                                "visible f1 s4\n"
                                "visible f2 s4\n"
                                "horizon s0 s3 f3\n"
                                "horizon s3 s2 f3\n"
                                "horizon s2 s1 f0\n"
                                "horizon s1 s0 f0\n"
                                "cone f4 s0 s3 s4\n"
                                "cone f5 s3 s2 s4\n"
                                "cone f6 s2 s1 s4\n"
                                "cone f7 s1 s0 s4\n"
                                "retire f1\n"
                                "retire f2\n"
                                "complete\n";

static Fixture *
five_sites (void)
{
  const Site sites[] = {
    { -0.6, -0.5 }, { 0.7, -0.4 }, { 0.1, 0.8 }, { 0, 0.1 }, { 0.3, -0.1 }
  };

  return fixture_take (g_strdup ("five"), site_set_new (sites, 5),
                       &(Order){ ORDER_FURTHEST, 0 });
}

static void
assert_five (Grain grain, const char *expected)
{
  g_autoptr (Fixture) fixture = five_sites ();
  char *text = write_trace (fixture->trace, grain);

  g_assert_cmpstr (text, ==, expected);
  free (text);
}

static void
test_five_sites_are_written_as_ever (void)
{
  assert_five (GRAIN_EVENT, five);
}

#define FIVE_SITES                                                             \
  "order furthest\nsite 0 -0.6 -0.5\nsite 1 0.7 -0.4\nsite 2 0.1 0.8\n"        \
  "site 3 0 0.1\nsite 4 0.3 -0.1\n"

static void
test_coarser_grains_have_a_line_each (void)
{
  assert_five (GRAIN_PHASE, "hull2vd-trace 1\ndetail phase\n" FIVE_SITES
                            "simplex duplicates 0 facets 4 claims 1\n"
                            "round 1 choose f1 s4\n"
                            "round 1 see 2\n"
                            "round 1 horizon 4\n"
                            "round 1 cone 4\n"
                            "round 1 hand-over retired 2 claims 0\n"
                            "complete\n");
  assert_five (GRAIN_ROUND,
               "hull2vd-trace 1\ndetail round\n" FIVE_SITES
               "simplex duplicates 0 facets 4 claims 1\n"
               "round 1 f1 s4 visible 2 horizon 4 cone 4 claims 0\n"
               "complete\n");
}

static void
test_locale_does_not_matter (void)
{
  g_assert_nonnull (setlocale (LC_ALL, "de_DE.UTF-8"));
  assert_five (GRAIN_EVENT, five);
  setlocale (LC_ALL, "C");
}

static void
assert_same_trace (const Trace *a, const Trace *b)
{
  g_assert_cmpuint (a->n_events, ==, b->n_events);
  for (guint i = 0; i < a->n_events; i++) {
    const Event event = trace_event (a, i), other = trace_event (b, i);

    g_assert_cmpmem (&event, sizeof event, &other, sizeof other);
  }
  g_assert_cmpmem (a->facets, a->n_facets * sizeof *a->facets, b->facets,
                   b->n_facets * sizeof *b->facets);
  g_assert_cmpmem (a->rounds, a->n_rounds * sizeof *a->rounds, b->rounds,
                   b->n_rounds * sizeof *b->rounds);
  g_assert_cmpuint (a->n_ridges, ==, b->n_ridges);
  g_assert_cmpuint (a->n_claims, ==, b->n_claims);
  g_assert_cmpint (a->order.kind, ==, b->order.kind);
  if (b->order.kind == ORDER_RANDOM)
    g_assert_cmpuint (a->order.seed, ==, b->order.seed);
}

static void
assert_round_trip (const Fixture *fixture)
{
  char *text = write_trace (fixture->trace, GRAIN_EVENT), *again;
  TraceFileError error = { 0, "" };
  SiteSet *set = NULL;
  Trace *trace = parse (text, &set, &error);

  if (trace == NULL)
    g_error ("%s: %u: %s", fixture->name, error.line, error.reason);
  assert_same_trace (trace, fixture->trace);
  again = write_trace (trace, GRAIN_EVENT);
  g_assert_cmpstr (again, ==, text);
  trace_free (trace);
  site_set_free (set);
  free (text);
  free (again);
}

static void
test_curated_sets_read_back_the_same (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    assert_round_trip (fixture);
  }
}

static void
test_families_read_back_the_same (void)
{
  fixture_for_each (4, 30, ORDER_FURTHEST, assert_round_trip);
  fixture_for_each (4, 30, ORDER_INPUT, assert_round_trip);
  fixture_for_each (4, 30, ORDER_RANDOM, assert_round_trip);
}

/* One line of the five-site file replaced by another. */
typedef struct BadLine {
  uint32_t line;
  const char *text;
  uint32_t refused_at;
} BadLine;

static const BadLine bad_lines[] = {
  { 1, "hull2vd-trace 2", 1 },
  { 1, "hull2vd-trace", 1 },
  { 1, "hull2vd-trace 1 ", 1 },
  { 1, "Hull2vd-trace 1", 1 },
  { 1, "", 1 },
  { 2, "detail phase", 2 },
  { 2, "order", 2 },
  { 2, "order nearest", 2 },
  { 2, "order random", 2 },
  { 2, "order random x", 2 },
  { 2, "order random -1", 2 },
  { 2, "order random 18446744073709551616", 2 },
  { 3, "site 1 -0.6 -0.5", 3 },
  { 3, "site 00 -0.6 -0.5", 3 },
  { 4, "site 1 0.7", 4 },
  { 4, "site 1 0.7 -0.4 1", 4 },
  { 4, "site 1 0.7  -0.4", 4 },
  { 4, "site 1 0,7 -0,4", 4 },
  { 4, "site 1 nan 0", 4 },
  { 4, "site 1 1e300 0", 4 },
  { 5, "site 3 0.1 0.8", 5 },
  { 5, "# comment", 5 },
  { 5, "", 5 },
  { 7, "site 4 0 0.1", 8 },
  { 8, "simplex f0 s2 s1 s0", 11 },
  { 8, "simplex f1 s0 s1 s2", 8 },
  { 8, "simplex f0 s0 s1 s9", 8 },
  { 8, "simplex f0 s0 s1", 8 },
  { 8, "simplex f0 s0 s1 s2 s3", 8 },
  { 8, "simplex s0 s0 s1 s2", 8 },
  { 8, "flat", 8 },
  { 8, "duplicate s4", 8 },
  { 8, "site 5 9 9", 9 },
  { 12, "claim s4 f0", 12 },
  { 12, "claim s4 f9", 12 },
  { 12, "claim s3 f1", 12 },
  { 12, "claim s4  f1", 12 },
  { 12, "claim s4 f01", 12 },
  { 12, "claim s4 f4294967295", 12 },
  { 12, "claim s4 f99999999999999999999", 12 },
  { 12, "select f1 s4", 12 },
  { 13, "select f2 s4", 13 },
  { 14, "visible f1 s3", 14 },
  { 14, "visible f0 s4", 14 },
  { 15, "visible f1 s4", 15 },
  { 15, "horizon s0 s3 f3", 16 },
  { 16, "horizon s3 s0 f3", 16 },
  { 17, "horizon s2 s1 f0", 17 },
  { 19,
    "horizon s1 s0 f0\nhorizon s0 s3 f3\nhorizon s3 s2 f3\n"
    "horizon s2 s1 f0\nhorizon s1 s0 f0",
    24 }, /* twice round */
  { 20, "cone f4 s3 s2 s4", 20 },
  { 20, "cone f5 s0 s3 s4", 20 },
  { 20, "cone f4 s0 s3 s2", 20 },
  { 22, "retire f1", 22 },
  { 24, "retire f0", 24 },
  { 25, "retire f1", 25 },
  { 25, "complete", 25 },
  { 26, "complete\ncomplete", 27 },
  { 26, "complete\n", 27 },
  { 26, "Complete", 26 },
  { 26, "finish", 26 },
};

static void
assert_refused (const char *text, size_t length, uint32_t line)
{
  TraceFileError error = { 0, "" };
  SiteSet *set = NULL;

  g_assert_null (trace_file_parse (text, length, &set, &error));
  g_assert_null (set);
  g_assert_cmpuint (strlen (error.reason), >, 5);
  g_assert_cmpuint (error.line, ==, line);
}

static void
test_bad_lines_are_refused_with_their_number (void)
{
  for (size_t i = 0; i < G_N_ELEMENTS (bad_lines); i++) {
    g_auto (GStrv) lines = g_strsplit (five, "\n", -1);
    g_autofree char *text = NULL;

    g_free (lines[bad_lines[i].line - 1]);
    lines[bad_lines[i].line - 1] = g_strdup (bad_lines[i].text);
    text = g_strjoinv ("\n", lines);
    g_test_message ("line %u: %s", bad_lines[i].line, bad_lines[i].text);
    assert_refused (text, strlen (text), bad_lines[i].refused_at);
  }
}

static void
test_cut_files_are_refused (void)
{
  uint32_t line = 1;

  for (size_t length = 0; length < strlen (five); length++) {
    assert_refused (five, length, line);
    line += five[length] == '\n';
  }
}

static void
test_bytes_that_are_no_text_are_refused (void)
{
  g_autofree char *nul = g_strdup (five);
  GString *long_line
      = g_string_new ("hull2vd-trace 1\norder furthest\nsite 0 ");

  nul[20] = '\0';
  assert_refused (nul, strlen (five), 2);
  for (int i = 0; i < 1000; i++)
    g_string_append_c (long_line, '1');
  g_string_append (long_line, " 1\n");
  assert_refused (long_line->str, long_line->len, 3);
  g_string_free (long_line, TRUE);
}

/* Whatever a file says, a trace that is read shows certified hulls. */
static void
assert_harmless (const char *text, size_t length)
{
  TraceFileError error = { 0, "" };
  SiteSet *set = NULL;
  Trace *trace = trace_file_parse (text, length, &set, &error);
  char why[CERTIFY_ROOM] = "";

  for (uint32_t step = 0; trace != NULL && step <= trace->n_events; step++) {
    Frame frame;

    frame_init (&frame, trace, step);
    if (!certify_frame (&frame, why))
      g_error ("step %u: %s\n%s", step, why, text);
    frame_clear (&frame);
  }
  trace_free (trace);
  site_set_free (set);
}

static void
test_changed_bytes_do_no_harm (void)
{
  static const char other[] = "0123456789 fs\n.-e";
  g_autoptr (Fixture) fixture = fixture_load ("square5", ORDER_FURTHEST);
  char *text = write_trace (fixture->trace, GRAIN_EVENT);

  for (size_t i = 0; i < strlen (text); i++) {
    const char kept = text[i];

    for (size_t k = 0; k + 1 < sizeof other; k++) {
      text[i] = other[k];
      assert_harmless (text, strlen (text));
    }
    text[i] = kept;
  }
  free (text);
}

static void
test_mixed_lines_do_no_harm (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  char *text = write_trace (fixture->trace, GRAIN_EVENT);
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  const guint n = g_strv_length (lines) - 1;

  for (guint i = 0; i < n * n; i++) {
    char *kept = lines[i / n];
    g_autofree char *mixed = NULL;

    lines[i / n] = lines[i % n];
    mixed = g_strjoinv ("\n", lines);
    assert_harmless (mixed, strlen (mixed));
    lines[i / n] = kept;
  }
  free (text);
}

static void
test_flat_is_checked (void)
{
  const char *line = "hull2vd-trace 1\norder input\nsite 0 1 1\nsite 1 2 2\n"
                     "site 2 3 3\nsite 3 4 5\nflat\ncomplete\n";
  const char *circle = "hull2vd-trace 1\norder input\nsite 0 1 0\nsite 1 0 1\n"
                       "site 2 -1 0\nsite 3 0 -1\nflat\ncomplete\n";
  TraceFileError error;
  SiteSet *set;
  Trace *trace = parse (circle, &set, &error);

  assert_refused (line, strlen (line), 7);
  g_assert_nonnull (trace);
  g_assert_true (trace->is_flat);
  trace_free (trace);
  site_set_free (set);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/trace-file/five-sites-are-written-as-ever",
                   test_five_sites_are_written_as_ever);
  g_test_add_func ("/trace-file/coarser-grains-have-a-line-each",
                   test_coarser_grains_have_a_line_each);
  g_test_add_func ("/trace-file/locale-does-not-matter",
                   test_locale_does_not_matter);
  g_test_add_func ("/trace-file/curated-sets-read-back-the-same",
                   test_curated_sets_read_back_the_same);
  g_test_add_func ("/trace-file/families-read-back-the-same",
                   test_families_read_back_the_same);
  g_test_add_func ("/trace-file/bad-lines-are-refused-with-their-number",
                   test_bad_lines_are_refused_with_their_number);
  g_test_add_func ("/trace-file/cut-files-are-refused",
                   test_cut_files_are_refused);
  g_test_add_func ("/trace-file/bytes-that-are-no-text-are-refused",
                   test_bytes_that_are_no_text_are_refused);
  g_test_add_func ("/trace-file/changed-bytes-do-no-harm",
                   test_changed_bytes_do_no_harm);
  g_test_add_func ("/trace-file/mixed-lines-do-no-harm",
                   test_mixed_lines_do_no_harm);
  g_test_add_func ("/trace-file/flat-is-checked", test_flat_is_checked);
  return g_test_run ();
}
