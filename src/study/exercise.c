#include "exercise.h"

#include "performance.h"

#define MAX_UNDO 200

static void
begin_performance (Exercise *exercise)
{
  const Question *question = exercise->question;

  g_clear_pointer (&exercise->performance, performance_free);
  if (question->kind == QUESTION_PERFORM)
    exercise->performance
        = performance_new (exercise->run, &exercise->occasion,
                           (guint)question->n_insertions, question->n_retries);
}

Exercise *
exercise_new (Question *question, Run *run, const Occasion *occasion)
{
  Exercise *exercise = g_new0 (Exercise, 1);

  exercise->question = question_ref (question);
  exercise->run = run_ref (run);
  exercise->occasion = *occasion;
  exercise->attempt = attempt_new (question);
  exercise->undo
      = g_ptr_array_new_with_free_func ((GDestroyNotify)attempt_free);
  exercise->is_open = TRUE;
  begin_performance (exercise);
  return exercise;
}

void
exercise_free (Exercise *exercise)
{
  question_unref (exercise->question);
  run_unref (exercise->run);
  attempt_free (exercise->attempt);
  g_ptr_array_unref (exercise->undo);
  g_clear_pointer (&exercise->verdict, verdict_free);
  g_clear_pointer (&exercise->performance, performance_free);
  g_free (exercise);
}

/* What was graded is another attempt now. */
static void
forget_verdict (Exercise *exercise)
{
  g_clear_pointer (&exercise->verdict, verdict_free);
}

static void
remember (Exercise *exercise)
{
  if (exercise->undo->len == MAX_UNDO)
    g_ptr_array_remove_index (exercise->undo, 0);
  g_ptr_array_add (exercise->undo, attempt_copy (exercise->attempt));
  forget_verdict (exercise);
}

/* Options, yes and no, and what is put in order have no place in the
 * pictures. */
static gboolean
is_item (const Exercise *exercise, Object object)
{
  const Question *question = exercise->question;
  g_autoptr (GArray) items = NULL;
  gboolean is_one = FALSE;

  if (question->kind == QUESTION_CHOOSE)
    return object.kind == OBJECT_NONE && object.number < question->options->len;
  if (question->kind == QUESTION_ALWAYS)
    return object.kind == OBJECT_NONE && object.number < 2;
  if (question->kind != QUESTION_ORDER)
    return FALSE;
  items = question_items (question, &exercise->occasion);
  for (guint i = 0; i < items->len; i++)
    is_one = is_one || object_equal (g_array_index (items, Object, i), object);
  return is_one;
}

static gboolean
is_object (const Exercise *exercise, Object *object)
{
  gboolean takes;
  Frame frame;

  if (exercise->question->kind != QUESTION_CLICK)
    return is_item (exercise, *object);
  frame_init (&frame, exercise->occasion.trace, exercise->occasion.step);
  takes = question_takes (exercise->question, &frame, object);
  if (object->kind == OBJECT_FACET)
    takes = takes && frame_facet_roles (&frame, object->number) != 0;
  frame_clear (&frame);
  if (object->kind == OBJECT_SITE)
    return takes && object->number < exercise->occasion.trace->set->n_sites;
  if (object->kind == OBJECT_RIDGE)
    return takes && object->number < exercise->occasion.trace->n_ridges;
  return takes;
}

gboolean
exercise_toggle (Exercise *exercise, Object object)
{
  if (!exercise->is_open || !is_object (exercise, &object))
    return FALSE;
  remember (exercise);
  attempt_toggle (exercise->attempt, exercise->question, object);
  return TRUE;
}

gboolean
exercise_set_number (Exercise *exercise, guint index, gint64 number)
{
  GArray *numbers = exercise->attempt->numbers;

  if (!exercise->is_open || index >= numbers->len
      || g_array_index (numbers, gint64, index) == number)
    return FALSE;
  remember (exercise);
  g_array_index (exercise->attempt->numbers, gint64, index) = number;
  return TRUE;
}

gboolean
exercise_undo (Exercise *exercise)
{
  const guint n = exercise->undo->len;

  if (!exercise->is_open || n == 0)
    return FALSE;
  attempt_free (exercise->attempt);
  exercise->attempt = g_ptr_array_steal_index (exercise->undo, n - 1);
  exercise->n_undone += 1;
  forget_verdict (exercise);
  return TRUE;
}

gboolean
exercise_hint (Exercise *exercise)
{
  if (!exercise->is_open || exercise->n_hints == exercise->question->hints->len)
    return FALSE;
  exercise->n_hints += 1;
  return TRUE;
}

void
exercise_set_run (Exercise *exercise, Run *run)
{
  const QuestionKind kind = exercise->question->kind;

  if (!exercise->is_open || (kind != QUESTION_DRAG && kind != QUESTION_ALWAYS))
    return;
  run_ref (run);
  g_clear_pointer (&exercise->attempt->run, run_unref);
  exercise->attempt->run = run;
  forget_verdict (exercise);
}

gboolean
exercise_holds_now (const Exercise *exercise)
{
  g_autoptr (Verdict) verdict = NULL;

  if (exercise->question->kind != QUESTION_DRAG)
    return FALSE;
  verdict = attempt_grade (exercise->attempt, exercise->question,
                           &exercise->occasion);
  return verdict->is_right;
}

gboolean
exercise_check (Exercise *exercise)
{
  if (!exercise->is_open)
    return FALSE;
  forget_verdict (exercise);
  exercise->verdict = attempt_grade (exercise->attempt, exercise->question,
                                     &exercise->occasion);
  exercise->n_checks += 1;
  if (exercise->n_checks == 1)
    exercise->was_right_at_once = exercise->verdict->is_right;
  exercise->is_open = !exercise->verdict->is_right
                      && exercise->n_checks <= exercise->question->n_retries;
  return TRUE;
}

void
exercise_reveal (Exercise *exercise)
{
  if (!exercise->is_open)
    return;
  exercise->is_open = FALSE;
  exercise->is_shown = TRUE;
}

void
exercise_retry (Exercise *exercise)
{
  attempt_free (exercise->attempt);
  exercise->attempt = attempt_new (exercise->question);
  g_ptr_array_set_size (exercise->undo, 0);
  forget_verdict (exercise);
  exercise->is_open = TRUE;
  begin_performance (exercise);
}

void
exercise_finish (Exercise *exercise)
{
  const PerformanceScore score = performance_score (exercise->performance);

  if (!exercise->is_open || !exercise->performance->is_over)
    return;
  forget_verdict (exercise);
  exercise->verdict = verdict_new ();
  exercise->verdict->total = score.total;
  exercise->verdict->right = score.correct;
  exercise->verdict->missing = score.total - score.correct;
  exercise->verdict->is_right = score.correct == score.total;
  exercise->n_hints = score.hinted;
  exercise->n_undone = score.undone;
  exercise->n_checks += 1;
  if (exercise->n_checks == 1)
    exercise->was_right_at_once = exercise->verdict->is_right;
  exercise->is_open = FALSE;
}
