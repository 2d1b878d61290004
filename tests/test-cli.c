/* Drives the built hull2vd-cli as scripts do. */
#include <gio/gio.h>
#include <glib/gstdio.h>
#include <json-glib/json-glib.h>
#include <string.h>

/* What a run of the program left behind. */
typedef struct Result {
  int status;
  char *out, *err;
} Result;

static void
result_clear (Result *result)
{
  g_free (result->out);
  g_free (result->err);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Result, result_clear)

static char *folder; /* the tests run in it */

static void
run_in (const char *locale, const char *input, Result *result, const char *line)
{
  g_autoptr (GSubprocessLauncher) launcher = g_subprocess_launcher_new (
      G_SUBPROCESS_FLAGS_STDIN_PIPE | G_SUBPROCESS_FLAGS_STDOUT_PIPE
      | G_SUBPROCESS_FLAGS_STDERR_PIPE);
  g_autoptr (GSubprocess) process = NULL;
  g_autoptr (GError) error = NULL;
  g_autofree char *command = g_strdup_printf ("\"$HULL2VD_CLI\" %s", line);
  const char *const argv[] = { "sh", "-c", command, NULL };

  g_subprocess_launcher_setenv (launcher, "LC_ALL", locale, TRUE);
  g_subprocess_launcher_set_cwd (launcher, folder);
  process = g_subprocess_launcher_spawnv (launcher, argv, &error);
  g_assert_no_error (error);
  g_subprocess_communicate_utf8 (process, input, NULL, &result->out,
                                 &result->err, &error);
  g_assert_no_error (error);
  g_assert_true (g_subprocess_get_if_exited (process));
  result->status = g_subprocess_get_exit_status (process);
}

static void
run (Result *result, const char *line)
{
  run_in ("C", NULL, result, line);
}

static void
put (const char *name, const char *text)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);

  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

static gboolean
exists (const char *name)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);

  return g_file_test (path, G_FILE_TEST_EXISTS);
}

static char *
get (const char *name)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  char *text = NULL;

  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  return text;
}

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
  { "export --stop 0 -o a.svg good.md", 1, "good.md: there is no stop 0" },
  { "replay broken.md", 2, "broken.md:11:1: “gotto” is no command" },
  { "replay good.md broken.md", 2, "broken.md:11:1: " },
  { "replay far.md", 2, "far.md:11:1: there is no “round 7 see”" },
  { "export -o a.svg broken.md", 2, "broken.md:11:1: " },
  { "storyboard -o a.pdf broken.md", 2, "broken.md:11:1: " },
  { "compute", 64, "hull2vd-cli: compute: a file is missing\nusage: " },
  { "compute five.txt five.txt", 64, "hull2vd-cli: compute: too many files" },
  { "compute --no-such-option five.txt", 64, "hull2vd-cli: " },
  { "compute --round x five.txt", 64, "hull2vd-cli: --round needs a whole" },
  { "compute --round -1 five.txt", 64, "hull2vd-cli: --round needs a whole" },
  { "compute --round 99999999999 five.txt", 64, "hull2vd-cli: --round needs" },
  { "compute --order last five.txt", 64, "hull2vd-cli: there is no order" },
  { "trace --detail all five.txt", 64, "hull2vd-cli: there is no detail" },
  { "replay", 64, "hull2vd-cli: replay: a file is missing\nusage: " },
  { "export five.txt", 64, "hull2vd-cli: which file to write?" },
  { "export -o a.gif five.txt", 64, "hull2vd-cli: a.gif: a picture's name" },
  { "export -o a.svg --view side five.txt", 64, "hull2vd-cli: there is no" },
  { "export -o a.svg --size 0x0 five.txt", 64, "hull2vd-cli: a size lies" },
  { "export -o a.svg --size 1000000x1 five.txt", 64, "hull2vd-cli: a size" },
  { "export -o a.svg --scale 99 five.txt", 64, "hull2vd-cli: a size lies" },
  { "export -o a.svg --scale -1 five.txt", 64, "hull2vd-cli: --scale: “-1”" },
  { "export -o a.svg --theme drak five.txt", 64,
    "hull2vd-cli: there is no theme “drak” (did you mean “dark”?)" },
  { "export -o a.svg --layers hull,cels five.txt", 64,
    "hull2vd-cli: there is no layer “cels”" },
  { "export -o a.svg --camera up five.txt", 64,
    "hull2vd-cli: there is no camera “up”" },
  { "export -o a.svg --camera 10,91 five.txt", 64, "hull2vd-cli: --camera: " },
  { "export -o a.svg --line-scale 4 five.txt", 64,
    "hull2vd-cli: --line-scale: “4” is no number from 0.5 to 3" },
  { "export -o a.svg --size -5x5 five.txt", 64, "hull2vd-cli: --size WxH" },
  { "export -o a.svg --size 5 five.txt", 64, "hull2vd-cli: write the size" },
  { "export -o a.svg --event 1 --round 1 five.txt", 64, "hull2vd-cli: write" },
  { "actions x", 64, "hull2vd-cli: actions: too many files" },
  { "dance", 64, "hull2vd-cli: there is no command “dance”\nusage: " },
  { "", 64, "hull2vd-cli: which command?\nusage: " },
  { "compute none.txt", 66, "none.txt: No such file or directory\n" },
  { "compute .", 66, ".: Is a directory\n" },
  { "trace none.txt", 66, "none.txt: No such file" },
  { "replay none.md", 66, "none.md: No such file" },
  { "export -o a.svg none.txt", 66, "none.txt: No such file" },
  { "compute -o no/such/a.json five.txt", 73, "no/such/a.json: " },
  { "compute -o /dev/full five.txt", 73, "/dev/full: No space left" },
  { "compute five.txt >/dev/full", 73, "hull2vd-cli: cannot write: No space" },
  { "trace five.txt >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "replay good.md >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "actions >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "--help >/dev/full", 73, "hull2vd-cli: cannot write" },
  { "export -o no/such/a.svg five.txt", 73, "no/such/a.svg: " },
};

static void
test_each_failure_has_its_status_and_message (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (refusals); i++) {
    const Row *row = &refusals[i];
    g_auto (Result) result = { 0 };

    run_in ("C.UTF-8", NULL, &result, row->line);
    if (result.status != row->status || *result.out != '\0'
        || !g_str_has_prefix (result.err, row->err)) {
      g_test_message ("%s: status %d, %s", row->line, result.status,
                      result.err);
      g_test_fail ();
    }
  }
  g_assert_false (exists ("a.svg"));
  g_assert_false (exists ("a.pdf"));
}

static JsonObject *
compute (JsonParser *parser, const char *line)
{
  g_auto (Result) result = { 0 };

  run (&result, line);
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
  g_auto (Result) piped = { 0 }, read = { 0 }, refused = { 0 };
  g_autofree char *text = get ("five.txt");

  run_in ("C", text, &piped, "compute -");
  run (&read, "compute five.txt");
  g_assert_cmpstr (piped.out, ==, read.out);
  run_in ("C", "0 0\n0 x\n", &refused, "compute -");
  g_assert_cmpint (refused.status, ==, 1);
  g_assert_true (g_str_has_prefix (refused.err, "-:2: "));
}

static void
test_outputs_are_whole_or_not_at_all (void)
{
  g_auto (Result) good = { 0 }, bad = { 0 };
  g_autofree char *first = NULL, *second = NULL;

  run (&good, "compute -o out.json five.txt");
  g_assert_cmpint (good.status, ==, 0);
  g_assert_cmpstr (good.out, ==, "");
  first = get ("out.json");
  run (&bad, "compute -o out.json bad.txt");
  g_assert_cmpint (bad.status, ==, 1);
  second = get ("out.json");
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
    g_auto (Result) result = { 0 };
    g_auto (GStrv) split = NULL;

    run (&result, lines[i]);
    g_assert_cmpint (result.status, ==, 0);
    split = g_strsplit (result.out, "\n", -1);
    g_assert_cmpstr (split[0], ==, "hull2vd-trace 1");
    g_assert_cmpuint (g_strv_length (split), ==, n_lines[i]);
  }
}

static void
test_replay_names_lesson_stop_and_text (void)
{
  g_auto (Result) good = { 0 }, failing = { 0 };

  run (&good, "replay good.md");
  g_assert_cmpint (good.status, ==, 0);
  g_assert_cmpstr (good.out, ==,
                   "ok 1 - Good: See: expect visible 2\n"
                   "ok 2 - Good: End: expect facets 6\n"
                   "1..2\n");
  run (&failing, "replay good.md failing.md");
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
test_results_do_not_depend_on_the_locale (void)
{
  static const char *const lines[]
      = { "compute five.txt", "trace five.txt", "replay good.md",
          "export --view both -o p.svg five.txt && cat p.svg",
          "export --stop 1 -o q.svg good.md && cat q.svg" };

  for (guint i = 0; i < G_N_ELEMENTS (lines); i++) {
    g_auto (Result) in_c = { 0 }, in_german = { 0 };

    run_in ("C", NULL, &in_c, lines[i]);
    run_in ("de_DE.UTF-8", NULL, &in_german, lines[i]);
    g_assert_cmpint (in_c.status, ==, 0);
    g_assert_cmpuint (strlen (in_c.out), >, 10);
    g_assert_cmpstr (in_c.out, ==, in_german.out);
  }
}

static void
test_pictures_are_of_the_kind_of_their_name (void)
{
  static const struct {
    const char *line, *name, *magic;
  } rows[] = {
    { "export -o p.svg five.txt", "p.svg", "<?xml" },
    { "export --view plane -o p.pdf five.txt", "p.pdf", "%PDF-" },
    { "export --view space -o p.png five.txt", "p.png", "\x89PNG" },
    { "export --event 3 -o e.svg five.txt", "e.svg", "<?xml" },
    { "export --round 0 -o r.svg five.txt", "r.svg", "<?xml" },
    { "export --stop 2 -o s.svg good.md", "s.svg", "<?xml" },
    { "export -o l.svg good.md", "l.svg", "<?xml" },
    { "export --size 320x200 -o t.svg square.txt", "t.svg", "<?xml" },
    { "storyboard -o b.pdf good.md", "b.pdf", "%PDF-" },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_auto (Result) result = { 0 };
    g_autofree char *bytes = NULL;

    run (&result, rows[i].line);
    g_assert_cmpstr (result.err, ==, "");
    g_assert_cmpint (result.status, ==, 0);
    bytes = get (rows[i].name);
    g_assert_true (g_str_has_prefix (bytes, rows[i].magic));
  }
}

/* Each option shows: no two of these pictures are alike. */
static void
test_the_look_of_a_picture_matters (void)
{
  static const char *const options[] = { "",
                                         "--theme paper",
                                         "--theme projector",
                                         "--theme dark",
                                         "--theme print",
                                         "--theme contrast",
                                         "--line-scale 2",
                                         "--mark-scale 2",
                                         "--text-scale 2",
                                         "--layers hull",
                                         "--layers -hull",
                                         "--layers +circumcircles,-lifts",
                                         "--camera look-up",
                                         "--camera 40,10",
                                         "--camera 40,10,1.5",
                                         "--scale 2",
                                         "--transparent" };
  g_autoptr (GHashTable) seen
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);

  for (guint i = 0; i < G_N_ELEMENTS (options); i++) {
    g_auto (Result) result = { 0 };
    g_autofree char *line = g_strdup_printf (
        "export --round 0 %s -o m.svg five.txt && cat m.svg", options[i]);

    run (&result, line);
    g_assert_cmpint (result.status, ==, 0);
    if (!g_hash_table_add (seen, g_steal_pointer (&result.out)))
      g_error ("%s: changes nothing", options[i]);
  }
}

static void
test_the_moment_of_a_picture_matters (void)
{
  static const char *const lines[]
      = { "export --event 3 -o m.svg five.txt && cat m.svg",
          "export --round 0 -o m.svg five.txt && cat m.svg",
          "export -o m.svg five.txt && cat m.svg",
          "export --stop 1 -o m.svg good.md && cat m.svg" };
  g_autoptr (GHashTable) seen
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);

  for (guint i = 0; i < G_N_ELEMENTS (lines); i++) {
    g_auto (Result) result = { 0 };

    run (&result, lines[i]);
    g_assert_true (g_hash_table_add (seen, g_steal_pointer (&result.out)));
  }
}

static void
test_actions_are_listed_in_columns (void)
{
  g_auto (Result) result = { 0 };

  run (&result, "actions");
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
    g_auto (Result) result = { 0 };

    run (&result, rows[i].line);
    g_assert_cmpint (result.status, ==, 0);
    g_assert_cmpstr (result.err, ==, "");
    g_assert_true (g_str_has_prefix (result.out, rows[i].out));
  }
}

static void
test_messages_are_one_line_without_control_bytes (void)
{
  g_auto (Result) result = { 0 };

  run (&result, "compute \"$(printf 'no\\n\\033[2Jfile')\"");
  g_assert_cmpint (result.status, ==, 66);
  g_assert_null (strchr (result.err, '\x1B'));
  g_assert_true (strchr (result.err, '\n')
                 == result.err + strlen (result.err) - 1);
}

static void
test_no_window_system_is_linked (void)
{
  g_auto (Result) result = { 0 };

  run (&result, "--version >/dev/null; ldd \"$HULL2VD_CLI\"");
  g_assert_cmpint (result.status, ==, 0);
  g_assert_nonnull (strstr (result.out, "libglib-2.0"));
  g_assert_null (strstr (result.out, "libgtk"));
  g_assert_null (strstr (result.out, "libgdk"));
}

#define LESSON(title, steps)                                                   \
  "# " title "\n\n```lesson\nformat 1\nsites -1 -0.5; 1 -0.8125; "             \
  "0.75 0.8125; -0.9375 0.5625; 0.1875 -0.1875\n```\n\n## See\n\n"             \
  "```steps\n" steps "```\n"

static void
put_files (void)
{
  put ("five.txt",
       "-1 -0.5\n1 -0.8125\n0.75 0.8125\n-0.9375 0.5625\n0.1875 -0.1875\n");
  put ("bad.txt", "0 0\n1 one\n");
  put ("square.txt", "0 0\n1 0\n1 1\n0 1\n");
  put ("good.md", LESSON ("Good", "goto round 1 see\nexpect visible 2\n") //
       "\n## End\n\n```steps\ngoto complete\nexpect facets 6\n```\n");
  put ("failing.md",
       LESSON ("Failing", "goto round 1 see\nexpect visible 3\n"));
  put ("broken.md", LESSON ("Broken", "gotto round 1 see\n"));
  put ("far.md", LESSON ("Far", "goto round 7 see\n"));
}

/* The third site to be inserted differs, so the pictures do. */
static void
test_export_follows_the_order (void)
{
  g_auto (Result) furthest = { 0 }, input = { 0 };
  g_autofree char *first = NULL, *second = NULL;

  put ("wheel.txt", "13 2\n7 12\n-4 13\n-13 4\n-10 -9\n1 -14\n11 -9\n0 0\n");
  run (&furthest, "export --round 1 -o furthest.svg wheel.txt");
  run (&input, "export --round 1 --order input -o input.svg wheel.txt");
  g_assert_cmpint (furthest.status, ==, 0);
  g_assert_cmpint (input.status, ==, 0);
  first = get ("furthest.svg");
  second = get ("input.svg");
  g_assert_cmpstr (first, !=, second);
}

/* 300 sites that are nowhere near a tie. */
static void
put_scattered (const char *name)
{
  g_autoptr (GString) text = g_string_new (NULL);
  g_autoptr (GRand) random = g_rand_new_with_seed (11);

  for (guint i = 0; i < 300; i++)
    g_string_append_printf (text, "%d %d\n",
                            g_rand_int_range (random, 0, 1 << 24),
                            g_rand_int_range (random, 0, 1 << 24));
  put (name, text->str);
}

/* What an order costs is told by the trace as well: births and claims. */
static void
test_count_agrees_with_the_trace (void)
{
  g_auto (Result) counts = { 0 }, trace = { 0 };
  guint n_created = 0, n_claims = 0;
  g_autofree char *created = NULL, *claims = NULL;
  g_auto (GStrv) lines = NULL;

  put_scattered ("scattered.txt");
  run (&counts, "count --order random --seed 4 scattered.txt");
  run (&trace, "trace --order random --seed 4 scattered.txt");
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
      = g_strdup_printf ("%-28s %12u ", "claims, redistributed too", n_claims);
  g_assert_nonnull (strstr (counts.out, created));
  g_assert_nonnull (strstr (counts.out, claims));
}

static void
test_walking_claims_nothing (void)
{
  g_auto (Result) counts = { 0 };
  g_autofree char *no_claim
      = g_strdup_printf ("%-28s %12u ", "claims, redistributed too", 0);
  g_autofree char *no_step
      = g_strdup_printf ("%-28s %12u ", "steps of walks", 0);

  put_scattered ("scattered.txt");
  run (&counts, "count --order hilbert scattered.txt");
  g_assert_cmpint (counts.status, ==, 0);
  g_assert_nonnull (strstr (counts.out, no_claim));
  g_assert_null (strstr (counts.out, no_step));
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/cli/the-look-of-a-picture-matters", test_the_look_of_a_picture_matters },
  { "/cli/export-follows-the-order", test_export_follows_the_order },
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
  { "/cli/outputs-are-whole-or-not-at-all",
    test_outputs_are_whole_or_not_at_all },
  { "/cli/trace-tells-events-phases-or-rounds",
    test_trace_tells_events_phases_or_rounds },
  { "/cli/replay-names-lesson-stop-and-text",
    test_replay_names_lesson_stop_and_text },
  { "/cli/results-do-not-depend-on-the-locale",
    test_results_do_not_depend_on_the_locale },
  { "/cli/pictures-are-of-the-kind-of-their-name",
    test_pictures_are_of_the_kind_of_their_name },
  { "/cli/the-moment-of-a-picture-matters",
    test_the_moment_of_a_picture_matters },
  { "/cli/actions-are-listed-in-columns", test_actions_are_listed_in_columns },
  { "/cli/help-and-version-are-no-failures",
    test_help_and_version_are_no_failures },
  { "/cli/messages-are-one-line-without-control-bytes",
    test_messages_are_one_line_without_control_bytes },
  { "/cli/no-window-system-is-linked", test_no_window_system_is_linked },
};

int
main (int argc, char **argv)
{
  g_autofree char *remove = NULL;
  int status;

  g_test_init (&argc, &argv, NULL);
  folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  put_files ();
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  status = g_test_run ();

  remove = g_strdup_printf ("rm -rf '%s'", folder);
  g_spawn_command_line_sync (remove, NULL, NULL, NULL, NULL);
  g_free (folder);
  return status;
}
