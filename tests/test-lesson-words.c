#include "lesson-words.h"

#include "locate.h"

#include <glib/gstdio.h>
#include <string.h>

static const char text[]
    = "# The title\n\n"
      "Some *prose*\non two lines.\n\n"
      "> Note: for you.\n\n"
      "```lesson\nformat 1\nsites 0 0; 1 0; 0 1; 1 2\n```\n\n"
      "## A `stop`\n\n"
      "- one\n- two\n\n"
      "> quoted\n\n"
      "### Below\n\n"
      "    code\n\n"
      "```ask\ncomplete\nchoose one\nprompt What?\nhint Look.\n"
      "option yes if bounded s0 if inserted = 4\noption no if sites = 3\n"
      "```\n\n"
      "```steps\ngoto complete\nexpect narration contains lower\n```\n";

static Lesson *
parse (const char *commonmark)
{
  g_autoptr (GError) error = NULL;
  Lesson *lesson
      = lesson_parse (commonmark, strlen (commonmark), "l.md", &error);

  g_assert_no_error (error);
  return lesson;
}

/* Tells that it was asked, by a mark behind the words. */
static const char *
mark (const char *words)
{
  static char *marked;

  g_free (marked);
  marked = g_strconcat (words, "+", NULL);
  return marked;
}

static void
test_every_word_of_a_lesson_is_translated (void)
{
  g_autoptr (Lesson) lesson = parse (text);
  const LessonStop *stop = lesson_stop (lesson, 0);
  const QuestionOption *option;

  lesson_words_translate_by (lesson, mark);
  option = g_ptr_array_index (stop->question->options, 1);
  g_assert_cmpstr (lesson->title, ==, "The title+");
  g_assert_cmpstr (lesson->prose, ==, "Some *prose* on two lines.+\n");
  g_assert_cmpstr (lesson->note, ==, "for you.+\n");
  g_assert_cmpstr (stop->title, ==, "A stop+");
  g_assert_cmpstr (stop->prose, ==,
                   "  - one+\n  - two+\n\n> quoted+\n\n### Below+\n\n"
                   "``` \ncode\n```\n");
  g_assert_cmpstr (stop->question->prompt, ==, "What?+");
  g_assert_cmpstr (g_ptr_array_index (stop->question->hints, 0), ==, "Look.+");
  g_assert_cmpstr (option->text, ==, "no+");
}

static void
test_commands_are_no_words (void)
{
  g_autoptr (Lesson) lesson = parse (text);
  const LessonStop *stop = lesson_stop (lesson, 0);
  const LessonCommand *command;

  lesson_words_translate_by (lesson, mark);
  command = g_ptr_array_index (stop->commands, 1);
  g_assert_cmpstr (command->text, ==, "expect narration contains lower");
  g_assert_cmpstr (stop->question->position, ==, "complete");
}

/* Knows all but titles. */
static const char *
mark_small_words (const char *words)
{
  return g_ascii_isupper (*words) ? NULL : mark (words);
}

static void
test_a_lesson_in_no_catalog_keeps_its_words (void)
{
  g_autoptr (Lesson) lesson = parse (text);

  lesson_words_translate_by (lesson, mark_small_words);
  g_assert_cmpstr (lesson->note, ==, "for you.\n");
}

static const char *
break_out (const char *words)
{
  return strchr (words, '*') != NULL ? "1. a list" : mark (words);
}

static void
test_a_translation_that_is_no_paragraph_is_left_out (void)
{
  g_autoptr (Lesson) lesson = parse (text);

  lesson_words_translate_by (lesson, break_out);
  g_assert_cmpstr (lesson->prose, ==, "Some *prose*\non two lines.\n");
}

/* What is looked up for a lesson, and what is found in its file. */
static GHashTable *asked;

static const char *
remember (const char *words)
{
  g_hash_table_add (asked, g_strdup (words));
  return words;
}

static void
expect_asked (const char *words, guint line, gpointer user)
{
  if (!g_hash_table_contains (asked, words))
    g_error ("%s:%u: nobody looks up “%s”", (const char *)user, line, words);
}

static void
forget (const char *words, guint line, gpointer user)
{
  (void)line;
  (void)user;
  g_hash_table_remove (asked, words);
}

/* Options that the program writes are words of its own. */
static const char *const program_options[] = { "a lower facet",
                                               "an upper facet",
                                               "a vertical facet",
                                               "lower facets",
                                               "upper facets",
                                               "vertical facets",
                                               NULL };

static void
forget_options_of_the_program (void)
{
  for (guint i = 0; program_options[i] != NULL; i++)
    g_hash_table_remove (asked, program_options[i]);
}

static const char *
mark_words_of_the_file (const char *words)
{
  return g_strv_contains (program_options, words) ? NULL : mark (words);
}

static void
test_what_is_found_in_lessons_is_what_is_looked_up (void)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  g_assert_cmpuint (paths->len, >, 10);
  for (guint i = 0; i < paths->len; i++) {
    char *path = g_ptr_array_index (paths, i);
    g_autoptr (Lesson) lesson = lesson_load (path, NULL);

    asked = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
    lesson_words_translate_by (lesson, remember);
    g_assert_true (lesson_words_find (path, expect_asked, path, NULL));
    g_assert_true (lesson_words_find (path, forget, NULL, NULL));
    forget_options_of_the_program ();
    g_assert_cmpuint (g_hash_table_size (asked), ==, 0);
    g_hash_table_unref (asked);
  }
}

/* A line of the text, from 1. */
static char *
line_of (guint number)
{
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);

  return g_strdup (lines[number - 1]);
}

static void
expect_on_line (const char *words, guint line, gpointer user)
{
  g_autofree char *here = line_of (line);
  g_autofree char *first = g_strndup (words, strcspn (words, " "));

  *(guint *)user += 1;
  if (strstr (here, first) == NULL)
    g_error ("“%s” is not in line %u: %s", words, line, here);
}

static void
test_words_are_found_in_their_lines (void)
{
  g_autofree char *folder = g_dir_make_tmp ("lesson-words-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "l.md", NULL);
  guint n_found = 0;

  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  g_assert_true (lesson_words_find (path, expect_on_line, &n_found, NULL));
  g_assert_cmpuint (n_found, ==, 12);
  g_assert_cmpint (g_remove (path), ==, 0);
  g_assert_cmpint (g_rmdir (folder), ==, 0);
}

/* What a person reads, in one text, layout aside. */
static void
append_text (GString *all, const char *prose)
{
  g_autofree char *words = prose != NULL ? prose_to_text (prose) : NULL;

  g_string_append_printf (all, "[%s]", words != NULL ? words : "");
}

static void
append_question (GString *all, const Question *question)
{
  g_string_append_printf (all, "<%s %s", question->position, question->prompt);
  for (guint i = 0; i < question->hints->len; i++)
    g_string_append_printf (
        all, ";%s", (const char *)g_ptr_array_index (question->hints, i));
  for (guint i = 0; i < question->options->len; i++) {
    const QuestionOption *option = g_ptr_array_index (question->options, i);

    g_string_append_printf (all, ";%s if %s", option->text,
                            condition_text (option->condition));
  }
}

/* Returns: (transfer full): all words and commands of a lesson. */
static char *
tell (const Lesson *lesson)
{
  GString *all = g_string_new (lesson->title);

  append_text (all, lesson->prose);
  append_text (all, lesson->note);
  for (guint i = 0; i < lesson->stops->len; i++) {
    const LessonStop *stop = lesson_stop (lesson, i);

    g_string_append_printf (all, "\n%s", stop->title);
    append_text (all, stop->prose);
    append_text (all, stop->note);
    for (guint k = 0; k < stop->commands->len; k++) {
      const LessonCommand *command = g_ptr_array_index (stop->commands, k);

      g_string_append_printf (all, ";%s", command->text);
    }
    if (stop->question != NULL)
      append_question (all, stop->question);
  }
  return g_string_free (all, FALSE);
}

static void
expect_written (const char *commonmark, const char *path)
{
  g_autoptr (Lesson) lesson
      = lesson_parse (commonmark, strlen (commonmark), path, NULL);
  g_autofree char *written
      = lesson_words_write (commonmark, strlen (commonmark), path, mark);
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) read
      = lesson_parse (written, strlen (written), path, &error);
  g_autofree char *expected = NULL, *found = NULL;

  g_assert_no_error (error);
  lesson_words_translate_by (lesson, mark_words_of_the_file);
  expected = tell (lesson);
  found = tell (read);
  g_assert_cmpstr (found, ==, expected);
}

/* Written and read again, a lesson is the one that is shown. */
static void
test_a_lesson_is_written_in_another_language (void)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  expect_written (text, "l.md");
  for (guint i = 0; i < paths->len; i++) {
    const char *path = g_ptr_array_index (paths, i);
    g_autofree char *commonmark = NULL;

    g_assert_true (g_file_get_contents (path, &commonmark, NULL, NULL));
    expect_written (commonmark, path);
  }
}

static void
test_a_lesson_in_no_catalog_is_not_written (void)
{
  g_assert_null (
      lesson_words_write (text, strlen (text), "l.md", mark_small_words));
}

static const char *
break_prompts (const char *words)
{
  return strchr (words, '?') != NULL ? "What?\nAnd why?" : mark (words);
}

static void
test_what_is_no_lesson_any_more_is_not_written (void)
{
  g_assert_null (
      lesson_words_write (text, strlen (text), "l.md", break_prompts));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/lesson-words/every-word-of-a-lesson-is-translated",
                   test_every_word_of_a_lesson_is_translated);
  g_test_add_func ("/lesson-words/commands-are-no-words",
                   test_commands_are_no_words);
  g_test_add_func ("/lesson-words/a-lesson-in-no-catalog-keeps-its-words",
                   test_a_lesson_in_no_catalog_keeps_its_words);
  g_test_add_func ("/lesson-words/"
                   "a-translation-that-is-no-paragraph-is-left-out",
                   test_a_translation_that_is_no_paragraph_is_left_out);
  g_test_add_func ("/lesson-words/"
                   "what-is-found-in-lessons-is-what-is-looked-up",
                   test_what_is_found_in_lessons_is_what_is_looked_up);
  g_test_add_func ("/lesson-words/words-are-found-in-their-lines",
                   test_words_are_found_in_their_lines);
  g_test_add_func ("/lesson-words/a-lesson-is-written-in-another-language",
                   test_a_lesson_is_written_in_another_language);
  g_test_add_func ("/lesson-words/a-lesson-in-no-catalog-is-not-written",
                   test_a_lesson_in_no_catalog_is_not_written);
  g_test_add_func ("/lesson-words/what-is-no-lesson-any-more-is-not-written",
                   test_what_is_no_lesson_any_more_is_not_written);
  return g_test_run ();
}
