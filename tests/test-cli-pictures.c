/* Pictures as hull2vd-cli writes them. */
#include "script.h"

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
    g_auto (ScriptResult) result = { 0 };
    g_autofree char *bytes = NULL;

    script_run (&result, rows[i].line);
    g_assert_cmpstr (result.err, ==, "");
    g_assert_cmpint (result.status, ==, 0);
    bytes = script_get (rows[i].name);
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
    g_auto (ScriptResult) result = { 0 };
    g_autofree char *line = g_strdup_printf (
        "export --round 0 %s -o m.svg five.txt && cat m.svg", options[i]);

    script_run (&result, line);
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
    g_auto (ScriptResult) result = { 0 };

    script_run (&result, lines[i]);
    g_assert_true (g_hash_table_add (seen, g_steal_pointer (&result.out)));
  }
}

/* The third site to be inserted differs, so the pictures do. */
static void
test_export_follows_the_order (void)
{
  g_auto (ScriptResult) furthest = { 0 }, input = { 0 };
  g_autofree char *first = NULL, *second = NULL;

  script_put ("wheel.txt",
              "13 2\n7 12\n-4 13\n-13 4\n-10 -9\n1 -14\n11 -9\n0 0\n");
  script_run (&furthest, "export --round 1 -o furthest.svg wheel.txt");
  script_run (&input, "export --round 1 --order input -o input.svg wheel.txt");
  g_assert_cmpint (furthest.status, ==, 0);
  g_assert_cmpint (input.status, ==, 0);
  first = script_get ("furthest.svg");
  second = script_get ("input.svg");
  g_assert_cmpstr (first, !=, second);
}

/* They have no name that says what they are. */
static void
test_points_and_lessons_come_through_a_pipe (void)
{
  static const char *const names[] = { "five.txt", "good.md" };
  static const char *const lines[]
      = { "export -o p.svg %s && sed '/<title/d' p.svg",
          "storyboard -o p.pdf %s && grep -ac obj p.pdf" };

  for (guint i = 0; i < G_N_ELEMENTS (names) * G_N_ELEMENTS (lines); i++) {
    g_auto (ScriptResult) piped = { 0 }, read = { 0 };
    g_autofree char *text = script_get (names[i / 2]);
    g_auto (GStrv) parts = g_strsplit (lines[i % 2], "%s", -1);
    g_autofree char *from_input = g_strjoinv ("-", parts);
    g_autofree char *from_file = g_strjoinv (names[i / 2], parts);

    script_run_in ("C", text, &piped, from_input);
    script_run (&read, from_file);
    g_assert_cmpstr (piped.err, ==, "");
    g_assert_cmpint (piped.status, ==, 0);
    g_assert_cmpstr (piped.out, ==, read.out);
  }
}

/* As on a disk that is full: nothing half done is left. */
static void
test_a_limit_of_files_is_told (void)
{
  g_auto (ScriptResult) result = { 0 };

  script_run (&result, "--version >version.txt; ulimit -f 1; "
                       "\"$HULL2VD_CLI\" export -o limit.png five.txt; "
                       "echo $? limit*");
  g_assert_cmpstr (result.err, ==, "limit.png: File too large\n");
  g_assert_cmpstr (result.out, ==, "73 limit*\n");
}

/* The signal comes while there is a temporary file. */
static void
test_a_file_that_is_begun_is_finished (void)
{
  g_auto (ScriptResult) result = { 0 };

  script_run (&result,
              "--version >version.txt; seq 5000 | awk '{ print $1, $1 * $1 }' "
              ">parabola.txt; \"$HULL2VD_CLI\" compute -o whole.json "
              "parabola.txt & until [ -e whole.json ] || "
              "{ set -- whole.json.*; [ -e \"$1\" ]; }; do :; done; kill $!; "
              "wait $!; echo whole.json* && tail -c 2 whole.json");
  g_assert_cmpstr (result.out, ==, "whole.json\n}\n");
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/cli-pictures/pictures-are-of-the-kind-of-their-name",
    test_pictures_are_of_the_kind_of_their_name },
  { "/cli-pictures/the-look-of-a-picture-matters",
    test_the_look_of_a_picture_matters },
  { "/cli-pictures/the-moment-of-a-picture-matters",
    test_the_moment_of_a_picture_matters },
  { "/cli-pictures/export-follows-the-order", test_export_follows_the_order },
  { "/cli-pictures/a-limit-of-files-is-told", test_a_limit_of_files_is_told },
  { "/cli-pictures/a-file-that-is-begun-is-finished",
    test_a_file_that_is_begun_is_finished },
  { "/cli-pictures/points-and-lessons-come-through-a-pipe",
    test_points_and_lessons_come_through_a_pipe },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return script_test_run ();
}
