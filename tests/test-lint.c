/* Lint: what is wrong, with what may have been meant, and what could be
 * better. */
#include "lesson-text.h"
#include "lint.h"

#include <glib/gstdio.h>
#include <string.h>

typedef struct Row {
  const char *text; /* of the lesson */
  const char *line; /* that must be told, from its place on */
} Row;

static Lint *
lint_text (const char *text)
{
  g_autofree char *folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "l.md", NULL);
  Lint *lint = lint_new ();

  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  lint_add (lint, path);
  g_unlink (path);
  g_rmdir (folder);
  return lint;
}

static gboolean
tells (const GPtrArray *lines, const char *line)
{
  for (guint i = 0; i < lines->len; i++) {
    const char *file = strstr (g_ptr_array_index (lines, i), "l.md");

    if (file != NULL && g_str_has_prefix (file, line))
      return TRUE;
  }
  return FALSE;
}

static void
check_rows (const Row *rows, gsize n, gboolean are_errors)
{
  for (gsize i = 0; i < n; i++) {
    g_autoptr (Lint) lint = lint_text (rows[i].text);
    const GPtrArray *lines = are_errors ? lint->errors : lint->warnings;

    g_assert_true ((lint->errors->len > 0) == are_errors);
    if (tells (lines, rows[i].line))
      continue;
    g_test_message ("it is not told: %s", rows[i].line);
    for (guint k = 0; k < lines->len; k++)
      g_test_message ("but: %s", (char *)g_ptr_array_index (lines, k));
    g_test_fail ();
  }
}

static void
test_what_was_meant_is_told (void)
{
  static const Row rows[] = {
    { STEPS ("move s4 1 1"),
      "l.md:11:1: “move” is not a command (did you mean “move site”?)" },
    { STEPS ("GOTO complete"),
      "l.md:11:1: “GOTO” is not a command (did you mean “goto”?)" },
    { STEPS ("nxt event"),
      "l.md:11:1: “nxt” is not a command (did you mean “next”?)" },
    { STEPS ("expect visible = upper"),
      "l.md:11:1: expect visible takes only a whole number: comparisons" },
    { STEPS ("expect visible x"),
      "l.md:11:1: expect visible needs a whole number" },
    { STEPS ("opacity upper-facets 0"),
      "l.md:11:1: nothing in the pictures is called “upper-facets” (did you "
      "mean “upper”?)" },
    { ASK ("before round 1 see\nclick visible"),
      "l.md:12:7: nothing called “visible” can be clicked (did you mean "
      "“visible-facets”?)" },
    { LECTURE "## S\n\n```steps\ngoto complete\n```\n\n"
              "## T\n\n```ask\nbefore round 2 see\nclick horizon\n```\n",
      "l.md:16:1: this gives the answer away: the stop on line 8 has shown" },
  };

  check_rows (rows, G_N_ELEMENTS (rows), TRUE);
}

static void
test_what_could_be_better_is_told (void)
{
  static const Row rows[] = {
    { STEPS ("goto complete"), "l.md:8:1: warning: this stop expects nothing" },
    { STEPS ("goto complete\nexpect sites 5"),
      "l.md:1:1: warning: there is nothing to do" },
    { STOP "> note: for me alone\n", "l.md:8:1: warning: students read" },
    { STOP "> **Note:** for me alone\n", "l.md:8:1: warning: students read" },
    { ASK ("complete\nchoose one\noption a if sites > 1\noption b if sites > "
           "2\noption c if sites = 1"),
      "l.md:10:1: warning: 2 options are right here" },
    { ASK ("complete\ndrag s4 until facets = 100"),
      "l.md:10:1: warning: no place was found" },
  };

  check_rows (rows, G_N_ELEMENTS (rows), FALSE);
}

static void
test_a_good_lesson_is_not_blamed (void)
{
  static const char *const texts[]
      = { ASK ("before round 1 see\nclick visible-facets"),
          ASK ("before round 1 see\nclick horizon") "\n> Note: for me alone\n",
          ASK ("complete\nchoose one\noption a if sites > 1\noption b if "
               "sites = 1"),
          ASK ("complete\nchoose several\noption a if sites > 1\noption b if "
               "sites > 2\noption c if sites = 1"),
          ASK ("complete\ndrag s0 until bounded s0") "\n> A quotation.\n" };

  for (gsize i = 0; i < G_N_ELEMENTS (texts); i++) {
    g_autoptr (Lint) lint = lint_text (texts[i]);

    g_assert_cmpuint (lint->errors->len, ==, 0);
    if (lint->warnings->len == 0)
      continue;
    g_test_message ("%s", (char *)g_ptr_array_index (lint->warnings, 0));
    g_test_fail ();
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/lint/what-was-meant-is-told", test_what_was_meant_is_told);
  g_test_add_func ("/lint/what-could-be-better-is-told",
                   test_what_could_be_better_is_told);
  g_test_add_func ("/lint/a-good-lesson-is-not-blamed",
                   test_a_good_lesson_is_not_blamed);
  return g_test_run ();
}
