/* Lessons that attack: each is refused by the program itself, with its place
 * and a reason, in bounded time and memory, and nothing comes of it.
 *
 * Here: bytes, sizes, syntax, numbers, loops, files, what writes or runs,
 * markup. Elsewhere: every prefix and flipped bit, places that are none
 * (test-lesson-refusals), names that steer a terminal (test-lesson, test-cli),
 * expectations that fail, and how many are told (test-replay), degenerate sets
 * (test-flat, test-site, test-session), pictures of no or any size (test-cli,
 * test-picture), files that change or go while they are open
 * (test-lesson-watch), progress that two programs keep (test-progress-file).
 */
#include "lesson-text.h"
#include "limited.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define BROKEN 2

/* FILE:LINE:COL: reason, without control characters. */
static void
check_message (const char *name, const LimitedResult *result)
{
  const char *end = strchr (result->err, '\n');
  g_autofree char *line = end == NULL
                              ? g_strdup ("")
                              : g_strndup (result->err, end - result->err);

  if (result->status == BROKEN && *result->out == '\0'
      && g_regex_match_simple ("^l\\.md:\\d+:\\d+: .", line, 0, 0)
      && strlen (line) < 2000
      && !g_regex_match_simple ("[\\x01-\\x1f\\x7f]", line, 0, 0))
    return;
  g_test_message ("%s: status %d, out “%.80s”, err “%.300s”", name,
                  result->status, result->out, result->err);
  g_test_fail ();
}

/* By lint and by replay, with the same words. */
static void
check_bytes_in (const char *folder,
                const char *name,
                const char *bytes,
                gsize length)
{
  g_autofree char *path = g_build_filename (folder, "l.md", NULL);
  LimitedResult lint, replay;

  g_assert_true (g_file_set_contents (path, bytes, (gssize)length, NULL));
  lint = limited_run (folder, "lint", "l.md");
  replay = limited_run (folder, "replay", "l.md");
  check_message (name, &lint);
  check_message (name, &replay);
  if (strstr (lint.err, replay.err) == NULL) {
    g_test_message ("%s: lint “%s”, replay “%s”", name, lint.err, replay.err);
    g_test_fail ();
  }
  limited_result_clear (&lint);
  limited_result_clear (&replay);
}

static void
check_bytes (const char *name, const char *bytes, gsize length)
{
  char *folder = limited_make_folder ();

  check_bytes_in (folder, name, bytes, length);
  limited_remove_folder (folder);
}

static void
check_text (const char *name, const char *text)
{
  check_bytes (name, text, strlen (text));
}

#define CHECK_BYTES(bytes) check_bytes (#bytes, bytes, sizeof (bytes) - 1)

static void
test_bytes_that_are_no_text (void)
{
  CHECK_BYTES ("");
  CHECK_BYTES ("# T\0\n");
  CHECK_BYTES ("# \xff\n");
  CHECK_BYTES ("# \xC0\xAF\n");          /* overlong */
  CHECK_BYTES ("# \xED\xA0\x80\n");      /* surrogate */
  CHECK_BYTES ("\xFF\xFE#\0 \0T\0\n\0"); /* UTF-16 */
  CHECK_BYTES ("# T\n\n\xEF\xBB\xBF## S\n");
  CHECK_BYTES ("# T\r\r## S\r");
  CHECK_BYTES ("\x7F"
               "ELF\x02\x01\x01\0\0\0");
  CHECK_BYTES ("\x1F\x8B\x08\0\0\0\0\0");
  CHECK_BYTES ("PK\x03\x04\x14\0\0\0");
}

/* @count times @piece between a good start and @end. */
static char *
repeat (const char *start, const char *piece, gsize count, const char *end)
{
  GString *text = g_string_new (start);

  for (gsize i = 0; i < count; i++)
    g_string_append (text, piece);
  g_string_append (text, end);
  return g_string_free (text, FALSE);
}

static void
test_what_is_too_large (void)
{
  static const struct {
    const char *name, *start, *piece, *end;
    gsize count;
  } rows[] = {
    { "5 MB", HEAD "## S\n\n", "word\n\n", "", 1000000 },
    { "a line of 1 MB", HEAD "## S\n\n", "x", "\n", 1 << 20 },
    { "1e6 steps", STOP "```steps\n", "next\n", "```\n", 800000 },
    { "1e6 failing expects", STOP "```steps\n", "expect sites 9\n", "```\n",
      250000 },
    { "a name of 1 MB", "# T\n\n```lesson\nformat 1\nsites file ", "n",
      "\n```\n\n## S\n", 1 << 20 },
    { "a number of 1 MB", "# T\n\n```lesson\nformat 1\nsites 0.", "1",
      " 0\n```\n\n## S\n", 1 << 20 },
    { "a number of 60 KB", "# T\n\n```lesson\nformat 1\nsites 0.", "1",
      " x\n```\n\n## S\n", 60000 },
    { "a text of 1 MB", HEAD "## S\n\n", "word word word\n", "", 70000 },
    { "1e6 lines of text", HEAD "## S\n\n", "w\n", "", 1000000 },
    { "quotations 100 000 deep", HEAD "## S\n\n", ">", " a\n", 60000 },
    { "lists 30 000 deep", HEAD "## S\n\n", "- ", "a\n", 30000 },
    { "brackets 60 000 deep", HEAD "## S\n\n", "[", "a\n", 60000 },
    { "100 000 brackets", HEAD "## S\n\n", "[a\n", "", 100000 },
    { "1e5 stops", HEAD, "## S\n\n", "", 100000 },
    { "1e5 wrong verbs", STOP "```steps\n", "nxet evnt\n", "```\n", 100000 },
    { "1e5 wrong questions", STOP "```ask\n", "clik horizn\n", "```\n",
      100000 },
    { "1e4 unclosed blocks", HEAD "## S\n\n", "```aks\n\n```\n\n", "", 10000 },
    { "a title of 60 KB", "# ", "T", "\n\n", 60000 },
    { "100 000 sites", "# T\n\n```lesson\nformat 1\nsites 0 0", "; 0 1",
      "\n```\n\n## S\n", 100000 },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autofree char *text
        = repeat (rows[i].start, rows[i].piece, rows[i].count, rows[i].end);

    check_text (rows[i].name, text);
  }
}

static void
check_commands (const char *const *lines)
{
  for (; *lines != NULL; lines++) {
    g_autofree char *text
        = g_strconcat (STOP "```steps\n", *lines, "\n```\n", NULL);

    check_text (*lines, text);
  }
}

static const char *const no_commands[] = {
  "fly",
  "goto",
  "goto round",
  "goto round one see",
  "goto round 1 sea",
  "next phase now",
  "show \"hull",
  "add site 1",
  "add site 1 2 3",
  "add site (1, 2)",
  "move site s1",
  "move site x 0 0",
  "select q1",
  "camera",
  "order random",
  "expect",
  "expect visible",
  "expect visible two",
  "expect visible 2.0",
  "expect delaunay",
  "expect step == 4",
  /* Numbers. */
  "add site nan 0",
  "add site inf 0",
  "add site 1e400 0",
  "add site 0x10 0",
  "add site 0,5 0,5",
  "goto round -1 see",
  "goto round 1e18 see",
  "goto round 2147483648 see",
  "goto round 9223372036854775808 see",
  "goto round 1.5 see",
  "remove site s99",
  "move site s2147483648 0 0",
  "order random -1",
  "sites random 1e9 seed 1",
  "sites random -5 seed 1",
  "add site 1e145 1e-145",
  /* Loops. */
  "repeat 1000000000",
  "loop",
  "while visible 0",
  "jump 1",
  "goto stop 1",
  "include l.md",
  "wait until visible 99",
  "wait 1000000000",
  "delay -1",
  "sites random 5",
  "sites random 20001 seed 1",
  "play",
  "speed 1e9",
  /* Files, programs, the desktop. */
  "open /etc/passwd",
  "open-file /etc/passwd",
  "save",
  "save-as x.txt",
  "export-picture",
  "storyboard",
  "handout",
  "run ls",
  "exec ls",
  "!ls",
  "$(ls)",
  "`ls`",
  "sites file ../l.md",
  "environment HOME",
  "quit",
  "close",
  "copy",
  "paste",
  "link http://example.org",
  "fullscreen",
  "undo",
  /* Events and places. */
  "goto round 99 see",
  "goto before start",
  "back until start",
  "on see next",
  "hook visible",
  "goto round 0 see",
  "expect cell s99 bounded",
  "expect waiting -1",
  NULL,
};

static void
test_words_that_are_no_commands (void)
{
  check_commands (no_commands);
}

static void
test_broken_structure (void)
{
  static const char *const texts[] = {
    "no title\n",
    "# T\n",
    "# T\n\n## S\n",
    "# T\n\n```lesson\nformat 1\nsites 0 0\n", /* not closed */
    "# T\n\n```lesson\nformat 1\nformat 1\nsites 0 0\n```\n\n## S\n",
    "# T\n\n```lesson\nsites 0 0\n```\n\n## S\n",
    "# T\n\n```lesson\nformat 999\nsites 0 0\n```\n\n## S\n",
    "# T\n\n```lesson\nformat x\nsites 0 0\n```\n\n## S\n",
    "# T\n\n```lesson\nformat 1\nsites 0 0\nsites 0 0\n```\n\n## S\n",
    "# T\n\n```lesson\nformat 1\nsites 0 0\ninclude l.md\n```\n\n## S\n",
    "# T\n\n```lesson\nformat 1\nsites 0 0\nmacro a b\n```\n\n## S\n",
    HEAD "## S\n\n```python\nimport os\n```\n",
    HEAD "## S\n\n```lua\nos.execute('ls')\n```\n",
    HEAD "## S\n\n- ```steps\n  next\n  ```\n",
    HEAD "## S\n\n```steps\nnext\n```\n\n```steps\nnext\n```\n",
    HEAD "## \xE2\x80\xAEgnp.exe\n", /* turns the text round */
    HEAD "## a\xE2\x80\x8B"
         "b\n", /* no width */
    HEAD "## \x1B[2Jclear\n",
  };

  for (guint i = 0; i < G_N_ELEMENTS (texts); i++)
    check_text (texts[i], texts[i]);
}

static void
test_questions_that_would_take_for_ever (void)
{
  g_autofree char *many = repeat (
      "# T\n\n```lesson\nformat 1\nsites random 20000 seed 1\n```\n\n",
      "## S\n\n```ask\ncomplete\nnumber facets\n```\n\n", 900, "");

  check_text ("a drag of 20 000 sites",
              "# T\n\n```lesson\nformat 1\nsites random 20000 seed 1\n```\n\n"
              "## S\n\n```ask\ncomplete\ndrag s3 until no-simplex\n```\n");
  check_text ("an order of 20 000 sites",
              "# T\n\n```lesson\nformat 1\nsites random 20000 seed 1\n```\n\n"
              "## S\n\n```ask\nbefore round 1\norder sites\n```\n");
  check_text ("900 questions about 20 000 sites", many);
}

/* Files of sites */

static void
check_site_file (const char *folder, const char *name)
{
  g_autofree char *text
      = g_strdup_printf ("# T\n\n```lesson\nformat 1\nsites file %s\n```\n\n"
                         "## S\n",
                         name);

  check_bytes_in (folder, name, text, strlen (text));
}

static void
test_files_outside_the_folder (void)
{
  static const char *const names[] = {
    "../../etc/passwd",
    "/etc/passwd",
    "~/x",
    "$HOME/x",
    "file:///etc/passwd",
    "http://example.org/x",
    "\\\\host\\x",
    "/dev/zero",
    "/dev/stdin",
    "/proc/self/mem",
    "out.txt",
    "zero.txt",
    "pipe.txt",
    "folder.txt",
    ".",
    "",
    "loop.txt",
    "%s%n.txt",
    "sites/../../x",
    "absent.txt",
  };
  char *folder = limited_make_folder ();
  g_autofree char *out = g_build_filename (folder, "out.txt", NULL);
  g_autofree char *zero = g_build_filename (folder, "zero.txt", NULL);
  g_autofree char *pipe = g_build_filename (folder, "pipe.txt", NULL);
  g_autofree char *below = g_build_filename (folder, "folder.txt", NULL);
  g_autofree char *loop = g_build_filename (folder, "loop.txt", NULL);

  g_assert_cmpint (symlink ("/etc/passwd", out), ==, 0);
  g_assert_cmpint (symlink ("/dev/zero", zero), ==, 0);
  g_assert_cmpint (symlink ("loop.txt", loop), ==, 0);
  g_assert_cmpint (mkfifo (pipe, 0600), ==, 0);
  g_assert_cmpint (g_mkdir (below, 0700), ==, 0);
  for (guint i = 0; i < G_N_ELEMENTS (names); i++)
    check_site_file (folder, names[i]);
  limited_remove_folder (folder);
}

/* Text that means something elsewhere is text here. */
static void
test_markup_is_shown_as_it_is_written (void)
{
  char *folder = limited_make_folder ();
  g_autofree char *path = g_build_filename (folder, "l.md", NULL);
  LimitedResult result;

  g_assert_true (g_file_set_contents (
      path,
      STOP "A <span size=\"999999\">b & c %n %s <a href=\"x\">d\n\n"
           "<div>unclosed\n",
      -1, NULL));
  result = limited_run (folder, "lint", "l.md");
  g_assert_cmpint (result.status, ==, 0);
  g_assert_nonnull (strstr (result.err, "l.md:12:1: warning: HTML"));
  limited_result_clear (&result);
  limited_remove_folder (folder);
}

/* Others' files stay as they are, and nothing new appears. */
static void
test_lint_tells_all_and_writes_nothing (void)
{
  char *folder = limited_make_folder ();
  g_autofree char *path = g_build_filename (folder, "l.md", NULL);
  g_autoptr (GDir) files = NULL;
  g_auto (GStrv) lines = NULL;
  static const char *const told[] = {
    "l.md:6:1: a lesson block has no “viws” (did you mean “views”?)",
    "l.md:12:1: “nxt” is not a command (did you mean “next”?)",
    "l.md:13:1: there is no “round 7 see”: the last round is 1",
    "l.md:14:1: there is no layer “hll” (did you mean “hull”?)",
    "l.md:21:7: nothing called “horizn” can be clicked (did you mean",
  };
  LimitedResult result;

  g_assert_true (g_file_set_contents (
      path,
      "# T\n\n```lesson\nformat 1\nsites 0 0; 1 0; 0 1; 2 3; 0.5 0.25\n"
      "viws both\n```\n\n## S\n\n```steps\nnxt\ngoto round 7 see\nshow hll\n"
      "```\n\n## R\n\n```ask\nbefore round 1 see\nclick horizn\n```\n",
      -1, NULL));
  result = limited_run (folder, "lint", "l.md");
  g_assert_cmpint (result.status, ==, BROKEN);
  lines = g_strsplit (result.err, "\n", -1);
  g_assert_cmpuint (g_strv_length (lines), ==, G_N_ELEMENTS (told) + 1);
  for (guint i = 0; i < G_N_ELEMENTS (told); i++)
    g_assert_true (g_str_has_prefix (lines[i], told[i]));
  files = g_dir_open (folder, 0, NULL);
  g_assert_cmpstr (g_dir_read_name (files), ==, "l.md");
  g_assert_null (g_dir_read_name (files));
  limited_result_clear (&result);
  limited_remove_folder (folder);
}

static void
test_a_pipe_nobody_writes_to_does_not_wait (void)
{
  char *folder = limited_make_folder ();
  g_autofree char *pipe = g_build_filename (folder, "l.md", NULL);
  g_autofree char *points = g_build_filename (folder, "p.txt", NULL);
  g_autofree char *command = NULL;
  LimitedResult result;

  g_assert_cmpint (mkfifo (pipe, 0600), ==, 0);
  result = limited_run (folder, "lint", "l.md");
  check_message ("a pipe", &result);
  limited_result_clear (&result);
  g_assert_cmpint (mkfifo (points, 0600), ==, 0);
  result = limited_run (folder, "compute", "p.txt");
  g_assert_cmpint (result.status, ==, 66);
  g_assert_nonnull (strstr (result.err, "p.txt: it is a pipe to which nobody"));
  limited_result_clear (&result);
  /* Who is late is waited for. */
  command = g_strdup_printf ("sh -c 'sleep 0.2; echo 0 0 >%s'", points);
  g_assert_true (g_spawn_command_line_async (command, NULL));
  result = limited_run (folder, "compute", "p.txt");
  g_assert_cmpint (result.status, ==, 0);
  limited_result_clear (&result);
  result = limited_run (folder, "lint", "absent.md");
  g_assert_cmpint (result.status, ==, 66);
  limited_result_clear (&result);
  limited_remove_folder (folder);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/hostile/bytes-that-are-no-text-are-refused",
    test_bytes_that_are_no_text },
  { "/hostile/what-is-too-large-is-refused", test_what_is_too_large },
  { "/hostile/words-that-are-no-commands-are-refused",
    test_words_that_are_no_commands },
  { "/hostile/broken-structure-is-refused", test_broken_structure },
  { "/hostile/questions-that-would-take-for-ever-are-refused",
    test_questions_that_would_take_for_ever },
  { "/hostile/files-outside-the-folder-are-refused",
    test_files_outside_the_folder },
  { "/hostile/markup-is-shown-as-it-is-written",
    test_markup_is_shown_as_it_is_written },
  { "/hostile/lint-tells-all-and-writes-nothing",
    test_lint_tells_all_and_writes_nothing },
  { "/hostile/a-pipe-nobody-writes-to-does-not-wait",
    test_a_pipe_nobody_writes_to_does_not_wait },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
