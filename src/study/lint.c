#include "lint.h"

#include "attempt.h"
#include "locate.h"
#include "prose.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

Lint *
lint_new (void)
{
  Lint *lint = g_new0 (Lint, 1);

  lint->errors = g_ptr_array_new_with_free_func (g_free);
  lint->warnings = g_ptr_array_new_with_free_func (g_free);
  lint->folders = g_ptr_array_new_with_free_func (g_free);
  return lint;
}

void
lint_free (Lint *lint)
{
  g_ptr_array_unref (lint->errors);
  g_ptr_array_unref (lint->warnings);
  g_ptr_array_unref (lint->folders);
  g_free (lint);
}

static void
warn (Lint *lint, const char *path, guint line, const char *format, ...)
    G_GNUC_PRINTF (4, 5);

static void
warn (Lint *lint, const char *path, guint line, const char *format, ...)
{
  g_autofree char *reason = NULL;
  va_list arguments;

  va_start (arguments, format);
  reason = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  g_ptr_array_add (
      lint->warnings,
      /* Translators: FILE:LINE:COL: warning: reason. */
      g_strdup_printf (_ ("%s:%u:1: warning: %s"), path, line, reason));
}

/* What a lecture hall needs */

static void
check_length (Lint *lint, const Lesson *lesson, const LessonStop *stop)
{
  g_autofree char *text = prose_to_text (stop->prose);
  guint n_words;

  for (char *at = text; *at != '\0'; at++)
    if (*at == '\n')
      *at = ' ';
  {
    g_auto (GStrv) words = words_split (text);

    n_words = g_strv_length (words);
  }
  if (n_words > LINT_MOST_WORDS)
    warn (lint, lesson->path, stop->line,
          _ ("%u words are too many for a projector; keep to %d, and make two "
             "stops of this one"),
          n_words, LINT_MOST_WORDS);
}

static void
check_expects (Lint *lint, const Lesson *lesson, const LessonStop *stop)
{
  for (guint i = 0; i < stop->commands->len; i++) {
    const LessonCommand *command = g_ptr_array_index (stop->commands, i);

    if (g_str_equal (command->verb, "expect"))
      return;
  }
  if (stop->question == NULL && stop->commands->len > 0)
    warn (lint, lesson->path, stop->line,
          _ ("this stop expects nothing, so nothing would show if it went "
             "wrong"));
}

/* Reading alone teaches little. */
#define MOST_STOPS_WITHOUT 3

static void
check_doing (Lint *lint, const Lesson *lesson)
{
  guint n_without = 0, n_questions = 0;

  for (guint i = 0; i < lesson->stops->len; i++) {
    const LessonStop *stop = lesson_stop (lesson, i);

    n_questions += stop->question != NULL ? 1 : 0;
    n_without = stop->question != NULL ? 0 : n_without + 1;
    if (n_without == MOST_STOPS_WITHOUT + 1 && n_questions > 0)
      warn (lint, lesson->path, stop->line,
            _ ("nothing to do at the last %d stops: ask something at every "
               "third"),
            MOST_STOPS_WITHOUT + 1);
  }
  if (n_questions == 0)
    warn (lint, lesson->path, 1,
          _ ("there is nothing to do in this lesson: ask something at every "
             "third stop"));
}

/* What is nearly a note for the lecturer would be read by the students. */
static void
check_quotations (Lint *lint, const Lesson *lesson, const LessonStop *stop)
{
  if (g_regex_match_simple ("^ {0,3}>[ *_]*note\\b", stop->prose,
                            G_REGEX_CASELESS | G_REGEX_MULTILINE, 0))
    warn (lint, lesson->path, stop->line,
          _ ("students read this quotation; what is for the lecturer begins "
             "with “> Note:”"));
}

static void
check_answer (Lint *lint, const Lesson *lesson, const LessonStop *stop)
{
  const Question *question = stop->question;
  g_autoptr (Answer) answer = NULL;

  if (question == NULL
      || (question->kind != QUESTION_DRAG
          && (question->kind != QUESTION_CHOOSE || question->is_several)))
    return;
  answer = answer_new (question, &stop->occasion);
  if (question->kind == QUESTION_DRAG && !answer->is_found)
    warn (lint, lesson->path, question->line,
          _ ("no place was found where this holds, so replay will fail; exact "
             "ties need sites on a grid"));
  if (question->kind == QUESTION_CHOOSE && answer->objects->len > 1)
    warn (lint, lesson->path, question->line,
          _ ("%u options are right here, and each of them counts"),
          answer->objects->len);
}

static void
check_lesson (Lint *lint, const Lesson *lesson)
{
  check_doing (lint, lesson);
  for (guint i = 0; i < lesson->stops->len; i++) {
    check_length (lint, lesson, lesson_stop (lesson, i));
    check_expects (lint, lesson, lesson_stop (lesson, i));
    check_quotations (lint, lesson, lesson_stop (lesson, i));
    check_answer (lint, lesson, lesson_stop (lesson, i));
  }
}

static void
note_folder (Lint *lint, const char *path)
{
  g_autofree char *folder = g_path_get_dirname (path);

  if (!g_ptr_array_find_with_equal_func (lint->folders, folder, g_str_equal,
                                         NULL))
    g_ptr_array_add (lint->folders, g_steal_pointer (&folder));
}

/* The line and the column of "FILE:LINE:COL: reason", as one number. */
static guint64
place_of (const GError *error, gsize name_length)
{
  const char *at = error->message + MIN (name_length, strlen (error->message));
  char *end;
  const guint64 line = g_ascii_strtoull (at + (*at == ':'), &end, 10);

  return line << 32 | g_ascii_strtoull (end + (*end == ':'), NULL, 10);
}

static int
compare_places (gconstpointer a, gconstpointer b, gpointer name_length)
{
  const guint64 left
      = place_of (*(const GError *const *)a, GPOINTER_TO_SIZE (name_length));
  const guint64 right
      = place_of (*(const GError *const *)b, GPOINTER_TO_SIZE (name_length));

  return left < right ? -1 : left > right;
}

/* What was found while playing stands where it is written. */
static void
sort (LessonFaults *faults, const char *path)
{
  g_autofree char *name = display_path (path);

  g_ptr_array_sort_with_data (faults->errors, compare_places,
                              GSIZE_TO_POINTER (strlen (name)));
}

void
lint_add (Lint *lint, const char *path)
{
  g_autoptr (LessonFaults) faults = lesson_faults_new ();
  g_autoptr (Lesson) lesson = lesson_load_all (path, faults);

  sort (faults, path);
  for (guint i = 0; i < faults->errors->len; i++) {
    const GError *error = g_ptr_array_index (faults->errors, i);

    lint->is_missing
        = lint->is_missing || error->code == LESSON_ERROR_CANNOT_OPEN;
    g_ptr_array_add (lint->errors, g_strdup (error->message));
  }
  for (guint i = 0; i < faults->html_lines->len; i++)
    warn (lint, path, g_array_index (faults->html_lines, guint, i),
          _ ("HTML is ignored"));
  if (lesson_faults_is_full (faults))
    g_ptr_array_add (lint->errors,
                     g_strdup_printf (_ ("%s: more than %d errors; the rest "
                                         "was not read"),
                                      path, LESSON_MAX_FAULTS - 1));
  if (lesson == NULL)
    return;
  note_folder (lint, path);
  check_lesson (lint, lesson);
}

/* Files of sites */

/* Whether a lesson of the folder has the line "sites file NAME". */
static gboolean
is_named (const char *folder, const char *name)
{
  g_autoptr (GDir) files = g_dir_open (folder, 0, NULL);
  g_autofree char *escaped = g_regex_escape_string (name, -1);
  g_autofree char *line
      = g_strdup_printf ("^[ \t]*sites[ \t]+file[ \t]+%s[ \t\r]*$", escaped);
  const char *file;

  while (files != NULL && (file = g_dir_read_name (files)) != NULL) {
    g_autofree char *path = g_build_filename (folder, file, NULL);
    g_autofree char *text = NULL;

    if (g_str_has_suffix (file, ".md")
        && g_file_get_contents (path, &text, NULL, NULL)
        && g_utf8_validate (text, -1, NULL)
        && g_regex_match_simple (line, text, G_REGEX_MULTILINE, 0))
      return TRUE;
  }
  return FALSE;
}

static int
compare_names (gconstpointer a, gconstpointer b)
{
  return g_strcmp0 (*(const char *const *)a, *(const char *const *)b);
}

static void
check_folder (Lint *lint, const char *folder)
{
  g_autofree char *sites = g_build_filename (folder, "sites", NULL);
  g_autoptr (GDir) files = g_dir_open (sites, 0, NULL);
  g_autoptr (GPtrArray) names = g_ptr_array_new_with_free_func (g_free);
  const char *file;

  while (files != NULL && (file = g_dir_read_name (files)) != NULL)
    if (g_str_has_suffix (file, ".txt"))
      g_ptr_array_add (names, g_strdup (file));
  g_ptr_array_sort (names, compare_names);
  for (guint i = 0; i < names->len; i++) {
    g_autofree char *name
        = g_build_filename ("sites", g_ptr_array_index (names, i), NULL);
    g_autofree char *path = g_build_filename (folder, name, NULL);

    if (!is_named (folder, name))
      warn (lint, path, 1, _ ("no lesson in this folder uses these sites"));
  }
}

/* The program offers the sites beside its own lessons by name. */
static gboolean
is_gallery (const char *folder)
{
  g_autofree char *lessons = locate_lessons ();
  g_autofree char *own = g_canonicalize_filename (lessons, NULL);
  g_autofree char *path = g_canonicalize_filename (folder, NULL);

  return g_str_equal (own, path);
}

void
lint_end (Lint *lint)
{
  for (guint i = 0; i < lint->folders->len; i++)
    if (!is_gallery (g_ptr_array_index (lint->folders, i)))
      check_folder (lint, g_ptr_array_index (lint->folders, i));
}
