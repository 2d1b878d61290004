#include "progress.h"

#include "locate.h"
#include "number.h"
#include "object-name.h"
#include "performance.h"
#include "question-click.h"

#include <string.h>

static const char *const outcome_names[]
    = { "open", "at-once", "after-help", "shown" };

const char *
outcome_name (Outcome outcome)
{
  return outcome_names[outcome];
}

gboolean
outcome_parse (const char *name, Outcome *outcome)
{
  for (guint i = 0; i < N_OUTCOMES; i++)
    if (g_str_equal (name, outcome_names[i])) {
      *outcome = (Outcome)i;
      return TRUE;
    }
  return FALSE;
}

static void
free_question (gpointer data)
{
  QuestionRecord *record = data;

  g_free (record->key);
  g_free (record->title);
  g_clear_pointer (&record->memory, json_object_unref);
  g_free (record);
}

static void
free_lesson (gpointer data)
{
  LessonRecord *record = data;

  g_free (record->key);
  g_free (record->title);
  g_ptr_array_unref (record->questions);
  g_free (record);
}

Progress *
progress_new (const char *path)
{
  Progress *progress = g_new0 (Progress, 1);

  progress->reference_count = 1;
  progress->path = g_strdup (path);
  progress->learner = g_uuid_string_random ();
  progress->lessons = g_ptr_array_new_with_free_func (free_lesson);
  return progress;
}

Progress *
progress_ref (Progress *progress)
{
  progress->reference_count += 1;
  return progress;
}

void
progress_unref (Progress *progress)
{
  progress->reference_count -= 1;
  if (progress->reference_count > 0)
    return;
  g_free (progress->path);
  g_free (progress->learner);
  g_ptr_array_unref (progress->lessons);
  g_free (progress);
}

char *
progress_default_path (void)
{
  return g_build_filename (g_get_user_data_dir (), "hull2vd", "progress.json",
                           NULL);
}

/* Finding */

LessonRecord *
progress_find (const Progress *progress, const char *key)
{
  for (guint i = 0; i < progress->lessons->len; i++) {
    LessonRecord *record = g_ptr_array_index (progress->lessons, i);

    if (g_str_equal (record->key, key))
      return record;
  }
  return NULL;
}

LessonRecord *
progress_lesson (Progress *progress, const char *key)
{
  LessonRecord *record = progress_find (progress, key);

  if (record != NULL)
    return record;
  record = g_new0 (LessonRecord, 1);
  record->key = g_strdup (key);
  record->title = g_strdup ("");
  record->questions = g_ptr_array_new_with_free_func (free_question);
  g_ptr_array_add (progress->lessons, record);
  return record;
}

QuestionRecord *
lesson_record_find (const LessonRecord *lesson, const char *key)
{
  for (guint i = 0; i < lesson->questions->len; i++) {
    QuestionRecord *record = g_ptr_array_index (lesson->questions, i);

    if (g_str_equal (record->key, key))
      return record;
  }
  return NULL;
}

QuestionRecord *
lesson_record_question (LessonRecord *lesson, const char *key)
{
  QuestionRecord *record = lesson_record_find (lesson, key);

  if (record != NULL)
    return record;
  record = g_new0 (QuestionRecord, 1);
  record->key = g_strdup (key);
  record->title = g_strdup ("");
  g_ptr_array_add (lesson->questions, record);
  return record;
}

guint
lesson_record_count (const LessonRecord *lesson, Outcome outcome)
{
  guint n = 0;

  for (guint i = 0; i < lesson->questions->len; i++)
    n += ((QuestionRecord *)g_ptr_array_index (lesson->questions, i))->outcome
         == outcome;
  return n;
}

gboolean
lesson_record_is_done (const LessonRecord *lesson)
{
  return lesson->n_stops > 0 && lesson->furthest + 1 >= lesson->n_stops
         && lesson_record_count (lesson, OUTCOME_OPEN) == 0;
}

/* Questions */

static Outcome
outcome_of (const Exercise *exercise)
{
  if (exercise->is_open)
    return OUTCOME_OPEN;
  if (exercise->verdict == NULL || !exercise->verdict->is_right)
    return OUTCOME_SHOWN;
  return exercise->was_right_at_once && exercise->n_hints == 0
                 && exercise->n_checks == 1
             ? OUTCOME_AT_ONCE
             : OUTCOME_AFTER_HELP;
}

static void
settle (QuestionRecord *record, const Exercise *exercise, Outcome outcome)
{
  record->outcome = outcome;
  record->answered = g_get_real_time () / G_USEC_PER_SEC;
  g_clear_pointer (&record->memory, json_object_unref);
  record->memory = exercise_remember (exercise);
}

/* How many tasks of a performance are remembered. */
static guint
count_tasks (const QuestionRecord *record)
{
  JsonNode *tasks = record->memory == NULL
                        ? NULL
                        : json_object_get_member (record->memory, "tasks");

  return tasks != NULL && JSON_NODE_HOLDS_ARRAY (tasks)
             ? json_array_get_length (json_node_get_array (tasks))
             : 0;
}

/* A performance is kept task by task, for it takes its time.
 *
 * Returns: whether more of it is done than was. */
static gboolean
take_tasks (QuestionRecord *record, const Exercise *exercise)
{
  if (exercise->performance == NULL || record->outcome != OUTCOME_OPEN
      || performance_score (exercise->performance).total
             <= count_tasks (record))
    return FALSE;
  g_clear_pointer (&record->memory, json_object_unref);
  record->memory = exercise_remember (exercise);
  return TRUE;
}

gboolean
question_record_take (QuestionRecord *record, const Exercise *exercise)
{
  const Outcome outcome = outcome_of (exercise);
  const gboolean is_first
      = record->outcome == OUTCOME_OPEN && outcome != OUTCOME_OPEN;
  const gboolean is_better
      = record->outcome == OUTCOME_SHOWN && outcome == OUTCOME_AFTER_HELP;
  gboolean has_changed = take_tasks (record, exercise) || is_first || is_better;

  if (record->n_checks == 0 && exercise->verdict != NULL) {
    record->total = exercise->verdict->total;
    record->correct = MIN (exercise->verdict->right, record->total);
  }
  if (is_first || is_better)
    settle (record, exercise, outcome);
  if (record->n_checks < exercise->n_checks
      || record->hinted < exercise->n_hints
      || record->undone < exercise->n_undone)
    has_changed = TRUE;
  record->n_checks = MAX (record->n_checks, exercise->n_checks);
  record->hinted = MAX (record->hinted, exercise->n_hints);
  record->undone = MAX (record->undone, exercise->n_undone);
  return has_changed;
}

void
question_record_restore (const QuestionRecord *record, Exercise *exercise)
{
  if (record->outcome == OUTCOME_OPEN && exercise->performance != NULL
      && record->memory != NULL)
    exercise_recall (exercise, record->memory);
  if (record->outcome != OUTCOME_OPEN
      && (record->memory == NULL
          || !exercise_recall (exercise, record->memory)))
    return;
  exercise->n_checks = record->n_checks;
  exercise->n_hints = MIN (record->hinted, exercise->question->hints->len);
  exercise->n_undone = record->undone;
  exercise->was_right_at_once = record->outcome == OUTCOME_AT_ONCE;
}

/* Keys */

char *
lesson_key (const Lesson *lesson)
{
  g_autofree char *path = g_canonicalize_filename (lesson->path, NULL);
  g_autofree char *folder = g_path_get_dirname (path);
  g_autofree char *given = locate_lessons ();
  g_autofree char *shipped = g_canonicalize_filename (given, NULL);

  return g_str_equal (folder, shipped) ? g_path_get_basename (path)
                                       : g_filename_display_name (path);
}

static void
add_sites (GString *text, const Run *run)
{
  g_autofree Site *sites = run_given (run);

  g_string_append_printf (text, "%s %" G_GUINT64_FORMAT "\n",
                          order_kind_name (run->trace->order.kind),
                          (guint64)run->trace->order.seed);
  for (guint i = 0; i < run->set->n_sites; i++) {
    char x[NUMBER_ROOM], y[NUMBER_ROOM];

    number_write_whole (sites[i].x, x);
    number_write_whole (sites[i].y, y);
    g_string_append_printf (text, "%s %s\n", x, y);
  }
}

static void
add_condition (GString *text, const Condition *condition)
{
  if (condition != NULL)
    g_string_append_printf (text, "%s\n", condition_text (condition));
}

/* Its prompt, hints and options may be worded otherwise, or translated: it
 * still asks the same. */
static void
add_question (GString *text, const Question *question)
{
  char argument[OBJECT_NAME_ROOM];

  object_name_write (question->argument, argument);
  g_string_append_printf (text, "%d %s %d %s %d %u\n", (int)question->kind,
                          question->position, question->is_several, argument,
                          (int)question->order, question->site);
  if (question->click != NULL)
    g_string_append_printf (text, "%s\n", question->click->name);
  for (guint i = 0; i < question->quantities->len; i++)
    g_string_append_printf (
        text, "%s\n",
        quantity_name (g_array_index (question->quantities, Quantity, i)));
  for (guint i = 0; i < question->options->len; i++)
    add_condition (text,
                   ((QuestionOption *)g_ptr_array_index (question->options, i))
                       ->condition);
  add_condition (text, question->condition);
  if (question->kind == QUESTION_PERFORM)
    g_string_append_printf (text, "%" G_GUINT64_FORMAT "\n",
                            question->n_insertions);
}

char *
question_key (const Question *question, const Run *run)
{
  g_autoptr (GString) text = g_string_new (NULL);
  char *digest;

  add_question (text, question);
  add_sites (text, run);
  digest = g_compute_checksum_for_string (G_CHECKSUM_SHA256, text->str,
                                          (gssize)text->len);
  digest[32] = '\0';
  return digest;
}
