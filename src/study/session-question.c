/* The question of the stop: asked, answered, shown. */
#include "attempt.h"
#include "session-private.h"

static LessonStop *
get_stop (Session *session)
{
  return session->lesson == NULL
             ? NULL
             : g_ptr_array_index (session->lesson->stops, session->stop);
}

void
session_question_forget (Session *session)
{
  g_clear_pointer (&session->exercises, g_ptr_array_unref);
  g_clear_pointer (&session->another, exercise_free);
}

static void
free_exercise (gpointer exercise)
{
  if (exercise != NULL)
    exercise_free (exercise);
}

/* The exercise of a stop, begun when it is first met; NULL: no question. */
static Exercise *
get_exercise (Session *session, guint stop)
{
  LessonStop *row = g_ptr_array_index (session->lesson->stops, stop);
  gpointer *exercise;

  if (row->question == NULL || row->ask_state == NULL)
    return NULL;
  if (session->exercises == NULL)
    session->exercises = g_ptr_array_new_with_free_func (free_exercise);
  if (session->exercises->len < session->lesson->stops->len)
    g_ptr_array_set_size (session->exercises, (int)session->lesson->stops->len);
  exercise = &g_ptr_array_index (session->exercises, stop);
  if (*exercise == NULL) {
    *exercise
        = exercise_new (row->question, row->ask_state->run, &row->occasion);
    session_recall (session, stop, *exercise);
  }
  return *exercise;
}

const Exercise *
session_begun_exercise (Session *session, guint stop)
{
  return session->exercises == NULL || stop >= session->exercises->len
             ? NULL
             : g_ptr_array_index (session->exercises, stop);
}

const StopState *
session_state_of (Session *session, guint stop)
{
  const LessonStop *row = lesson_stop (session->lesson, stop);
  const Exercise *exercise
      = session->is_replaying ? NULL : get_exercise (session, stop);

  return exercise != NULL && exercise->is_open ? row->ask_state : row->state;
}

Exercise *
session_question_whole (Session *session)
{
  if (session->another != NULL)
    return session->another;
  return session->lesson == NULL || session->is_replaying
             ? NULL
             : get_exercise (session, session->stop);
}

const Exercise *
session_get_exercise (Session *session)
{
  const Exercise *whole = session_question_whole (session);

  return whole != NULL && whole->performance != NULL
             ? performance_shown (whole->performance)->exercise
             : whole;
}

gboolean
session_question_owns_run (Session *session, const Run *run)
{
  const Exercise *whole = session_question_whole (session);

  return whole != NULL
         && (run == whole->run
             || (whole->performance != NULL && run == whole->performance->run));
}

const Exercise *
session_get_exercise_of (Session *session, guint stop)
{
  return session->lesson == NULL ? NULL : get_exercise (session, stop);
}

static Exercise *
current_exercise (Session *session)
{
  return (Exercise *)session_get_exercise (session);
}

static gboolean
is_drag (const Exercise *exercise)
{
  return exercise->question->kind == QUESTION_DRAG
         || exercise->question->kind == QUESTION_ALWAYS;
}

/* Whether the pictures show what it asks about. */
static gboolean
is_here (Session *session, const Exercise *exercise)
{
  return session->run == exercise->run
         && session->step == exercise->occasion.step;
}

gboolean
session_is_asking (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);

  return exercise != NULL && exercise->is_open && !is_drag (exercise)
         && is_here (session, exercise);
}

gboolean
session_is_answering (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);

  return session_is_asking (session)
         && (exercise->question->kind == QUESTION_CLICK
             || exercise->question->kind == QUESTION_ORDER);
}

/* What the pictures show of it */

static gboolean
shows_answers (Session *session, const Exercise *exercise)
{
  return exercise != NULL && !is_drag (exercise)
         && session->run == exercise->run
         && (!exercise->is_open || is_here (session, exercise));
}

void
session_question_refresh (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);

  session->look.mask = session_is_asking (session)
                           ? MASK_WHY | question_mask (exercise->question)
                           : 0;
  g_array_set_size (session->answers, 0);
  if (shows_answers (session, exercise))
    session_find_answers (session, exercise);
  session->look.answers = (const SceneAnswer *)(gpointer)session->answers->data;
  session->look.n_answers = session->answers->len;
}

static gboolean
told (Session *session, gboolean has_changed)
{
  if (!has_changed)
    return FALSE;
  session_question_refresh (session);
  session_tell (session, CHANGED_QUESTION | CHANGED_LOOK);
  return TRUE;
}

/* Following the sites and the time */

void
session_question_follow_run (Session *session)
{
  Exercise *exercise;

  /* A performance on a person's own sites ends with them. */
  if (session_can_end_performance (session)
      && !session_question_owns_run (session, session->run)) {
    g_clear_pointer (&session->another, exercise_free);
    told (session, TRUE);
  }
  exercise = current_exercise (session);

  if (exercise == NULL || !exercise->is_open || !is_drag (exercise)
      || exercise->attempt->run == session->run)
    return;
  if (session->run == exercise->run && exercise->attempt->run == NULL)
    return;
  exercise_set_run (exercise, session->run);
  told (session, TRUE);
}

/* Whoever steps past the event has seen the answer. */
void
session_question_follow_step (Session *session)
{
  Exercise *exercise = current_exercise (session);

  if (exercise == NULL || !exercise->is_open || is_drag (exercise)
      || session->run != exercise->run
      || session->step <= exercise->occasion.step)
    return;
  exercise_reveal (exercise);
  told (session, TRUE);
}

/* What was dragged rightly is right once it is let go. */
void
session_question_settle (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);

  if (exercise != NULL && exercise->is_open && exercise->attempt->run != NULL
      && exercise_holds_now (exercise))
    session_check (session);
}

/* Answering */

gboolean
session_answer_toggle (Session *session, Object object)
{
  Exercise *exercise = current_exercise (session);

  return exercise != NULL && told (session, exercise_toggle (exercise, object));
}

gboolean
session_answer_number (Session *session, guint index, gint64 number)
{
  Exercise *exercise = current_exercise (session);

  return exercise != NULL
         && told (session, exercise_set_number (exercise, index, number));
}

gboolean
session_answer_undo (Session *session)
{
  Exercise *exercise = current_exercise (session);

  return exercise != NULL && told (session, exercise_undo (exercise));
}

gboolean
session_hint (Session *session)
{
  Exercise *exercise = current_exercise (session);

  return exercise != NULL && told (session, exercise_hint (exercise));
}

/* Showing the answer */

/* Sites that make the condition of a drag hold, or a law fail. */
static void
show_sites (Session *session, const Exercise *exercise)
{
  g_autoptr (Answer) answer
      = answer_new (exercise->question, &exercise->occasion);
  const Order order = session_get_order (session);
  Run *run = answer->sites == NULL
                 ? NULL
                 : run_new (answer->sites, answer->n_sites, &order);

  if (run == NULL)
    return;
  session_put_run (session, run, run->trace->n_events);
  session_show_all_sites (session);
}

/* The lesson goes on to where the answer is seen; what a person has dragged
 * rightly stays as it is. */
static void
show_answer (Session *session, const Exercise *exercise)
{
  const LessonStop *stop = get_stop (session);

  if (exercise->is_open || session_settle_task (session))
    return;
  if (is_drag (exercise)) {
    if (exercise->verdict == NULL || !exercise->verdict->is_right)
      show_sites (session, exercise);
  } else if (exercise == session->another) {
    session_put_step (session, exercise->occasion.reveal);
  } else if (session->run == exercise->run) {
    session_put_state (session, stop->ask_state, stop->state);
  }
}

gboolean
session_can_check (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);

  return exercise != NULL && exercise->is_open
         && !attempt_is_empty (exercise->attempt);
}

gboolean
session_check (Session *session)
{
  Exercise *exercise = current_exercise (session);

  if (!session_can_check (session))
    return FALSE;
  session_hold (session);
  exercise_check (exercise);
  show_answer (session, exercise);
  told (session, TRUE);
  session_release (session);
  return TRUE;
}

gboolean
session_reveal (Session *session)
{
  Exercise *exercise = current_exercise (session);

  if (exercise == NULL || !exercise->is_open)
    return FALSE;
  session_hold (session);
  exercise_reveal (exercise);
  show_answer (session, exercise);
  told (session, TRUE);
  session_release (session);
  return TRUE;
}

/* Where it is asked; sites that were dragged go back. */
static void
show_question (Session *session, const Exercise *exercise)
{
  if (exercise->performance != NULL)
    session_show_task (session);
  else if (exercise == session->another)
    session_put_run (session, run_ref (exercise->run), exercise->occasion.step);
  else
    session_put_state (session, NULL, get_stop (session)->ask_state);
}

gboolean
session_retry (Session *session)
{
  Exercise *exercise = session_question_whole (session);

  if (exercise == NULL)
    return FALSE;
  session_hold (session);
  exercise_retry (exercise);
  show_question (session, exercise);
  told (session, TRUE);
  session_release (session);
  return TRUE;
}

/* Going on */

gboolean
session_question_is_open (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);

  return exercise != NULL && exercise->is_open
         && (is_drag (exercise) || is_here (session, exercise));
}

gboolean
session_answer_then_go (Session *session)
{
  if (!session_question_is_open (session))
    return FALSE;
  session_hold (session);
  if (session_can_check (session))
    session_check (session);
  session_reveal (session);
  session_release (session);
  return TRUE;
}

gboolean
session_can_continue (Session *session)
{
  const Exercise *whole = session_question_whole (session);

  return session_can_next_task (session)
         || (whole != NULL && !whole->is_open
             && session->stop + 1 < session_get_n_stops (session));
}

gboolean
session_continue (Session *session)
{
  return session_can_continue (session)
         && (session_next_task (session)
             || session_set_stop (session, session->stop + 1));
}
