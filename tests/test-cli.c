/* What hull2vd-cli prints and how it ends. */
#include "script.h"

#include <glib/gstdio.h>
#include <json-glib/json-glib.h>
#include <string.h>

/* A line of arguments, and what it must lead to. Nothing is on stdout when
 * the status is not 0. */
typedef struct Row {
  const char *line;
  int status;
  const char *err; /* how stderr begins */
} Row;

static const Row refusals[] = {
  { "compute bad.txt", 1, "bad.txt:2: " },
  { "compute --round 5 five.txt", 1,
    "five.txt: there is no round 5: the last is 1\n" },
  { "compute --round 0 square.txt", 1, "square.txt: there is no round 0: " },
  { "trace bad.txt", 1, "bad.txt:2: " },
  { "compute /dev/zero", 1, "/dev/zero:1: " },
  { "replay /dev/zero", 2, "/dev/zero:1:1: " },
  { "export -o a.svg bad.txt", 1, "bad.txt:2: " },
  { "export --event 99 -o a.svg five.txt", 1, "five.txt: there is no event" },
  { "export --round 2 -o a.svg five.txt", 1, "five.txt: there is no round 2" },
  { "export --round 0 -o a.svg square.txt", 1, "square.txt: there are no" },
  { "export --stop 3 -o a.svg good.md", 1, "good.md: there is no stop 3" },
  { "export --stop 1 -o a.svg five.txt", 1, "five.txt: points have no stops" },
  { "storyboard -o a.svg good.md", 64,
    "hull2vd-cli: a.svg: the name of a PDF" },
  { "handout -o a.png good.md", 64, "hull2vd-cli: a.png: the name of a PDF" },
  { "export --stop 0 -o a.svg good.md", 1, "good.md: there is no stop 0" },
  { "replay broken.md", 2, "broken.md:11:1: “gotto” is not a command" },
  { "replay good.md broken.md", 2, "broken.md:11:1: " },
  { "replay far.md", 2, "far.md:11:1: there is no “round 7 see”" },
  { "export -o a.svg broken.md", 2, "broken.md:11:1: " },
  { "storyboard -o a.pdf broken.md", 2, "broken.md:11:1: " },
  { "handout -o a.pdf broken.md", 2, "broken.md:11:1: " },
  { "handout -o a.pdf five.txt", 1, "five.txt: a handout needs a lesson" },
  { "compute", 64, "hull2vd-cli: compute: no file is given\nusage: " },
  { "compute five.txt five.txt", 64, "hull2vd-cli: compute: too many files" },
  { "compute --no-such-option five.txt", 64, "hull2vd-cli: " },
  { "compute --round x five.txt", 64, "hull2vd-cli: --round needs a whole" },
  { "compute --round -1 five.txt", 64, "hull2vd-cli: --round needs a whole" },
  { "compute --round 99999999999 five.txt", 64, "hull2vd-cli: --round needs" },
  { "compute --order last five.txt", 64, "hull2vd-cli: there is no order" },
  { "compute --seed 3 five.txt", 64, "hull2vd-cli: --seed needs --order" },
  { "export --order input -o a.svg good.md", 1,
    "good.md: --order is for points" },
  { "replay - -", 64, "hull2vd-cli: replay: “-”, standard input" },
  { "trace --detail all five.txt", 64, "hull2vd-cli: there is no detail" },
  { "replay", 64, "hull2vd-cli: replay: no file is given\nusage: " },
  { "export five.txt", 64, "hull2vd-cli: no output file is given" },
  { "export -o a.gif five.txt", 64,
    "hull2vd-cli: a.gif: the name of a picture" },
  { "export -o a.svg --view side five.txt", 64, "hull2vd-cli: there is no" },
  { "export -o a.svg --size 0x0 five.txt", 64,
    "hull2vd-cli: the size must be" },
  { "export -o a.svg --size 1000000x1 five.txt", 64, "hull2vd-cli: the size" },
  { "export -o a.svg --scale 99 five.txt", 64,
    "hull2vd-cli: the size must be" },
  { "export -o a.svg --scale -1 five.txt", 64, "hull2vd-cli: --scale: “-1”" },
  { "export -o a.svg --theme drak five.txt", 64,
    "hull2vd-cli: there is no theme “drak” (did you mean “dark”?)" },
  { "export -o a.svg --layers hull,cels five.txt", 64,
    "hull2vd-cli: there is no layer “cels”" },
  { "export -o a.svg --camera up five.txt", 64,
    "hull2vd-cli: there is no camera “up”" },
  { "export -o a.svg --camera 10,91 five.txt", 64, "hull2vd-cli: --camera: " },
  { "export -o a.svg --line-scale 4 five.txt", 64,
    "hull2vd-cli: --line-scale: “4” is not a number from 0.5 to 3\n" },
  { "export -o a.svg --line-scale 1,5 five.txt", 64,
    "hull2vd-cli: --line-scale: “1,5” is not a number from 0.5 to 3; write "
    "decimals with a point" },
  { "export -o a.svg --size -5x5 five.txt", 64, "hull2vd-cli: --size WxH" },
  { "export -o a.svg --size 5 five.txt", 64, "hull2vd-cli: write the size" },
  { "export -o a.svg --event 1 --round 1 five.txt", 64,
    "hull2vd-cli: use only" },
  { "actions x", 64, "hull2vd-cli: actions: too many files" },
  { "dance", 64, "hull2vd-cli: there is no command “dance”\nusage: " },
  { "comput", 64, "hull2vd-cli: there is no command “comput” (did you mean" },
  { "", 64, "hull2vd-cli: no command is given\nusage: " },
  { "compute none.txt", 66, "none.txt: No such file or directory\n" },
  { "compute .", 66, ".: Is a directory\n" },
  { "trace none.txt", 66, "none.txt: No such file" },
  { "replay none.md", 66, "none.md: No such file" },
  { "export -o a.svg none.txt", 66, "none.txt: No such file" },
  { "compute -o no/such/a.json five.txt", 73,
    "no/such/a.json: No such file or directory" },
  { "compute -o /dev/full five.txt", 73, "/dev/full: No space left" },
  { "compute five.txt >/dev/full", 73, "hull2vd-cli: cannot write: No space" },
  { "trace five.txt >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "replay good.md >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "actions >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "--help >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "export -o no/such/a.svg five.txt", 73,
    "no/such/a.svg: No such file or directory" },
  { "results no/such.json", 66, "no/such.json: No such file or directory" },
};

static void
test_each_failure_has_its_status_and_message (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (refusals); i++) {
    const Row *row = &refusals[i];
    g_auto (ScriptResult) result = { 0 };

    script_run_in ("C.UTF-8", NULL, &result, row->line);
    if (result.status != row->status || *result.out != '\0'
        || !g_str_has_prefix (result.err, row->err)) {
      g_test_message ("%s: status %d, %s", row->line, result.status,
                      result.err);
      g_test_fail ();
    }
  }
  g_assert_false (script_exists ("a.svg"));
  g_assert_false (script_exists ("a.pdf"));
}

static JsonObject *
compute (JsonParser *parser, const char *line)
{
  g_auto (ScriptResult) result = { 0 };

  script_run (&result, line);
  g_assert_cmpint (result.status, ==, 0);
  g_assert_cmpstr (result.err, ==, "");
  g_assert_true (json_parser_load_from_data (parser, result.out, -1, NULL));
  return json_node_get_object (json_parser_get_root (parser));
}

static guint
length_of (JsonObject *object, const char *key)
{
  return json_array_get_length (json_object_get_array_member (object, key));
}

static void
test_compute_writes_the_result (void)
{
  g_autoptr (JsonParser) parser = json_parser_new ();
  JsonObject *object = compute (parser, "compute --verify five.txt");

  g_assert_cmpint (json_object_get_int_member (object, "n"), ==, 5);
  g_assert_cmpuint (length_of (object, "triangles"), ==, 4);
  g_assert_false (json_object_has_member (object, "active"));
}

static void
test_a_round_has_as_many_active_sites (void)
{
  g_autoptr (JsonParser) parser = json_parser_new ();
  JsonObject *object = compute (parser, "compute --round 0 five.txt");

  g_assert_cmpuint (length_of (object, "active"), ==, 4);
  object = compute (parser, "compute --verify --round 1 five.txt");
  g_assert_cmpuint (length_of (object, "active"), ==, 5);
}

static void
test_every_order_gives_the_same_triangles (void)
{
  static const char *const lines[]
      = { "compute --verify --order furthest five.txt",
          "compute --verify --order input five.txt",
          "compute --verify --order random --seed 3 five.txt" };

  for (guint i = 0; i < G_N_ELEMENTS (lines); i++) {
    g_autoptr (JsonParser) parser = json_parser_new ();

    g_assert_cmpuint (length_of (compute (parser, lines[i]), "triangles"), ==,
                      4);
  }
}

static void
test_dash_is_the_standard_input (void)
{
  g_auto (ScriptResult) piped = { 0 }, read = { 0 }, refused = { 0 };
  g_autofree char *text = script_get ("five.txt");

  script_run_in ("C", text, &piped, "compute -");
  script_run (&read, "compute five.txt");
  g_assert_cmpstr (piped.out, ==, read.out);
  script_run_in ("C", "0 0\n0 x\n", &refused, "compute -");
  g_assert_cmpint (refused.status, ==, 1);
  g_assert_true (g_str_has_prefix (refused.err, "-:2: "));
}

/* The same is done, and said under its name, whichever way a lesson comes. */
static void
test_dash_is_a_lesson_where_there_must_be_one (void)
{
  static const char *const lines[]
      = { "replay %s", "lint %s", "storyboard -o s.pdf %s && md5sum <s.pdf",
          "handout -o h.pdf %s && md5sum <h.pdf", "questions -f gift %s" };
  g_autofree char *good = script_get ("good.md");
  g_autofree char *broken = script_get ("broken.md");

  for (guint i = 0; i < G_N_ELEMENTS (lines); i++) {
    g_auto (ScriptResult) piped = { 0 }, read = { 0 }, refused = { 0 };
    g_auto (GStrv) parts = g_strsplit (lines[i], "%s", -1);
    g_autofree char *from_input = g_strjoinv ("-", parts);
    g_autofree char *from_file = g_strjoinv ("good.md", parts);

    script_run_in ("C", good, &piped, from_input);
    script_run_in ("C", NULL, &read, from_file);
    g_assert_cmpint (piped.status, ==, 0);
    g_assert_true (g_str_equal (piped.out, read.out));
    script_run_in ("C", broken, &refused, from_input);
    g_assert_cmpint (refused.status, ==, 2);
    g_assert_true (g_str_has_prefix (refused.err, "-:11:1: "));
  }
}

static void
test_outputs_are_whole_or_not_at_all (void)
{
  g_auto (ScriptResult) good = { 0 }, bad = { 0 };
  g_autofree char *first = NULL, *second = NULL;

  script_run (&good, "compute -o out.json five.txt");
  g_assert_cmpint (good.status, ==, 0);
  g_assert_cmpstr (good.out, ==, "");
  first = script_get ("out.json");
  script_run (&bad, "compute -o out.json bad.txt");
  g_assert_cmpint (bad.status, ==, 1);
  second = script_get ("out.json");
  g_assert_cmpstr (first, ==, second);
}

static void
test_trace_tells_events_phases_or_rounds (void)
{
  static const char *const lines[]
      = { "trace five.txt", "trace --detail event five.txt",
          "trace --detail phase five.txt", "trace --detail round five.txt" };
  static const guint n_lines[] = { 27, 27, 16, 12 };

  for (guint i = 0; i < G_N_ELEMENTS (lines); i++) {
    g_auto (ScriptResult) result = { 0 };
    g_auto (GStrv) split = NULL;

    script_run (&result, lines[i]);
    g_assert_cmpint (result.status, ==, 0);
    split = g_strsplit (result.out, "\n", -1);
    g_assert_cmpstr (split[0], ==, "hull2vd-trace 1");
    g_assert_cmpuint (g_strv_length (split), ==, n_lines[i]);
  }
}

static void
test_replay_names_lesson_stop_and_text (void)
{
  g_auto (ScriptResult) good = { 0 }, failing = { 0 };

  script_run (&good, "replay good.md");
  g_assert_cmpint (good.status, ==, 0);
  g_assert_cmpstr (good.out, ==,
                   "ok 1 - Good: See: expect visible 2\n"
                   "ok 2 - Good: End: expect facets 6\n"
                   "1..2\n");
  script_run (&failing, "replay good.md failing.md");
  g_assert_cmpint (failing.status, ==, 1);
  g_assert_cmpstr (failing.err, ==, "");
  g_assert_cmpstr (failing.out, ==,
                   "ok 1 - Good: See: expect visible 2\n"
                   "ok 2 - Good: End: expect facets 6\n"
                   "not ok 3 - Failing: See: expect visible 3\n"
                   "# failing.md:12: expect visible 3, but found: 2\n"
                   "1..3\n");
}

static void
check_locale (const char *locale, const char *line)
{
  g_auto (ScriptResult) in_c = { 0 }, elsewhere = { 0 };

  script_run_in ("C", NULL, &in_c, line);
  script_run_in (locale, NULL, &elsewhere, line);
  g_assert_cmpint (in_c.status, ==, 0);
  g_assert_cmpuint (strlen (in_c.out), >, 10);
  /* Not g_assert_cmpstr(), which would print pictures. */
  g_assert_true (g_str_equal (in_c.out, elsewhere.out));
}

/* A picture is described in the language of whoever asks for it, and there is
 * no Arabic. */
static void
test_results_do_not_depend_on_the_locale (void)
{
  static const char *const results[]
      = { "compute five.txt", "trace five.txt", "replay good.md" };
  static const char *const pictures[]
      = { "export --view both -o p.svg five.txt && cat p.svg",
          "export --stop 1 -o q.svg good.md && cat q.svg" };

  for (guint i = 0; i < G_N_ELEMENTS (results); i++) {
    check_locale ("de_DE.UTF-8", results[i]);
    check_locale ("ar_EG.UTF-8", results[i]);
  }
  for (guint i = 0; i < G_N_ELEMENTS (pictures); i++)
    check_locale ("ar_EG.UTF-8", pictures[i]);
}

static void
test_actions_are_listed_in_columns (void)
{
  g_auto (ScriptResult) result = { 0 };

  script_run (&result, "actions");
  g_assert_cmpint (result.status, ==, 0);
  g_assert_nonnull (strstr (result.out, "goto\ts\t-\tlesson,window\t"));
  g_assert_nonnull (strstr (result.out, "n-sites\t-\tu\twindow\t"));
  g_assert_nonnull (strstr (result.out, "quit\t-\t-\twindow\t"));
}

static void
test_help_and_version_are_no_failures (void)
{
  static const struct {
    const char *line, *out;
  } rows[] = {
    { "--help", "usage: hull2vd-cli COMMAND" },
    { "--version", "hull2vd-cli 0." },
    { "compute --help", "Usage:\n  hull2vd-cli compute" },
    { "export --help", "Usage:\n  hull2vd-cli export" },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_auto (ScriptResult) result = { 0 };

    script_run (&result, rows[i].line);
    g_assert_cmpint (result.status, ==, 0);
    g_assert_cmpstr (result.err, ==, "");
    g_assert_true (g_str_has_prefix (result.out, rows[i].out));
  }
}

static void
test_messages_are_one_line_without_control_bytes (void)
{
  g_auto (ScriptResult) result = { 0 };

  script_run (&result, "compute \"$(printf 'no\\n\\033[2Jfile')\"");
  g_assert_cmpint (result.status, ==, 66);
  g_assert_null (strchr (result.err, '\x1B'));
  g_assert_true (strchr (result.err, '\n')
                 == result.err + strlen (result.err) - 1);
}

static void
test_no_window_system_is_linked (void)
{
  g_auto (ScriptResult) result = { 0 };

  script_run (&result, "--version >/dev/null; ldd \"$HULL2VD_CLI\"");
  g_assert_cmpint (result.status, ==, 0);
  g_assert_nonnull (strstr (result.out, "libglib-2.0"));
  g_assert_null (strstr (result.out, "libgtk"));
  g_assert_null (strstr (result.out, "libgdk"));
}

/* 300 sites that are nowhere near a tie. */
static void
put_scattered (const char *name)
{
  g_autoptr (GString) text = g_string_new (NULL);
  g_autoptr (GRand) random = g_rand_new_with_seed (11);

  for (guint i = 0; i < 2 * 300; i++)
    g_string_append_printf (text, i % 2 == 0 ? "%d " : "%d\n",
                            g_rand_int_range (random, 0, 1 << 24));
  script_put (name, text->str);
}

/* What an order costs is told by the trace as well: births and claims. */
static void
test_count_agrees_with_the_trace (void)
{
  g_auto (ScriptResult) counts = { 0 }, trace = { 0 };
  guint n_created = 0, n_claims = 0;
  g_autofree char *created = NULL, *claims = NULL;
  g_auto (GStrv) lines = NULL;

  put_scattered ("scattered.txt");
  script_run (&counts, "count --order random --seed 4 scattered.txt");
  script_run (&trace, "trace --order random --seed 4 scattered.txt");
  g_assert_cmpint (counts.status, ==, 0);
  lines = g_strsplit (trace.out, "\n", -1);
  g_assert_cmpstr (lines[1], ==, "order random 4");
  for (guint i = 0; lines[i] != NULL; i++) {
    n_created += g_str_has_prefix (lines[i], "cone ")
                 || g_str_has_prefix (lines[i], "simplex ");
    n_claims += g_str_has_prefix (lines[i], "claim ");
  }
  created = g_strdup_printf ("%-28s %12u ", "facets created", n_created);
  claims
      = g_strdup_printf ("%-28s %12u ", "claims and redistributions", n_claims);
  g_assert_nonnull (strstr (counts.out, created));
  g_assert_nonnull (strstr (counts.out, claims));
}

static void
test_walking_claims_nothing (void)
{
  g_auto (ScriptResult) counts = { 0 };
  g_autofree char *no_claim
      = g_strdup_printf ("%-28s %12u ", "claims and redistributions", 0);
  g_autofree char *no_step = g_strdup_printf ("%-28s %12u ", "walk steps", 0);

  put_scattered ("scattered.txt");
  script_run (&counts, "count --order hilbert scattered.txt");
  g_assert_cmpint (counts.status, ==, 0);
  g_assert_nonnull (strstr (counts.out, no_claim));
  g_assert_null (strstr (counts.out, no_step));
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/cli/count-agrees-with-the-trace", test_count_agrees_with_the_trace },
  { "/cli/walking-claims-nothing", test_walking_claims_nothing },
  { "/cli/each-failure-has-its-status-and-message",
    test_each_failure_has_its_status_and_message },
  { "/cli/compute-writes-the-result", test_compute_writes_the_result },
  { "/cli/a-round-has-as-many-active-sites",
    test_a_round_has_as_many_active_sites },
  { "/cli/every-order-gives-the-same-triangles",
    test_every_order_gives_the_same_triangles },
  { "/cli/dash-is-the-standard-input", test_dash_is_the_standard_input },
  { "/cli/dash-is-a-lesson-where-there-must-be-one",
    test_dash_is_a_lesson_where_there_must_be_one },
  { "/cli/outputs-are-whole-or-not-at-all",
    test_outputs_are_whole_or_not_at_all },
  { "/cli/trace-tells-events-phases-or-rounds",
    test_trace_tells_events_phases_or_rounds },
  { "/cli/replay-names-lesson-stop-and-text",
    test_replay_names_lesson_stop_and_text },
  { "/cli/results-do-not-depend-on-the-locale",
    test_results_do_not_depend_on_the_locale },
  { "/cli/actions-are-listed-in-columns", test_actions_are_listed_in_columns },
  { "/cli/help-and-version-are-no-failures",
    test_help_and_version_are_no_failures },
  { "/cli/messages-are-one-line-without-control-bytes",
    test_messages_are_one_line_without_control_bytes },
  { "/cli/no-window-system-is-linked", test_no_window_system_is_linked },
};

#define PROGRESS                                                               \
  "{\"format\": 1, \"learner\": \"u\", \"lessons\": [{\"lesson\": \"a.md\", "  \
  "\"title\": \"A, B\", \"stop\": 1, \"furthest\": 1, \"stops\": 3, "          \
  "\"seconds\": 9, \"first\": 1, \"last\": 2, \"questions\": [{\"question\": " \
  "\"q\", \"title\": \"T\", \"stop\": 1, \"outcome\": \"shown\", "             \
  "\"total\": 3, \"correct\": 2, \"checks\": 1, \"hinted\": 1, "               \
  "\"undone\": 0, \"seconds\": 4.5, \"answered\": 86400}]}]}"

static void
test_results_are_written_whole_or_not_at_all (void)
{
  g_auto (ScriptResult) csv = { 0 }, xapi = { 0 }, broken = { 0 };
  g_auto (ScriptResult) missing = { 0 }, usage = { 0 };
  g_auto (ScriptResult) piped = { 0 };

  script_put ("good.json", PROGRESS);
  script_put ("broken.json", "{\"format\": 1,\n\"lessons\": oops");
  script_run (&csv, "results good.json --name Ann");
  g_assert_cmpint (csv.status, ==, 0);
  g_assert_true (g_str_has_suffix (
      csv.out, "\r\nAnn,a.md,\"A, B\",2,T,q,shown,3,2,1,1,0,4.5,"
               "1970-01-02T00:00:00Z\r\n"));
  script_run_in ("C", PROGRESS, &piped, "results - --name Ann");
  g_assert_cmpstr (piped.out, ==, csv.out);
  script_run (&xapi, "results good.json -f xapi");
  g_assert_nonnull (strstr (xapi.out, "\"scaled\":0.66"));
  g_assert_nonnull (strstr (xapi.out, "\"duration\":\"PT4.5S\""));
  script_run (&broken, "results broken.json -o out.csv");
  g_assert_cmpint (broken.status, ==, 1);
  g_assert_true (g_str_has_prefix (broken.err, "broken.json:"));
  g_assert_false (script_exists ("out.csv"));
  script_run (&missing, "results none.json -o out.csv");
  g_assert_cmpint (missing.status, ==, 66);
  script_run (&usage, "results good.json -f pdf");
  g_assert_cmpint (usage.status, ==, 64);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  g_test_add_func ("/cli/results-are-written-whole-or-not-at-all",
                   test_results_are_written_whole_or_not_at_all);
  return script_test_run ();
}
