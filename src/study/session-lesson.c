#include "session-private.h"

#include <glib/gi18n.h>

StopState *
session_get_state (Session *session)
{
  StopState *state = g_new0 (StopState, 1);

  state->run = run_ref (session->run);
  state->step = session->step;
  state->look = session->look;
  /* A selection is replaced as a whole, never changed. */
  if (session->selected != NULL)
    state->selected = g_array_ref (session->selected);
  state->exhibit_kind = session->exhibit_kind;
  state->exhibit_step = session->exhibit_step;
  state->views = session->views;
  state->listing = session->listing;
  state->other_order = session->other_order;
  state->compares_space = session->compares_space;
  state->turn = session->turn;
  state->camera = session->camera;
  state->told_theme = session->told_theme;
  return state;
}

void
stop_state_free (StopState *state)
{
  run_unref (state->run);
  g_clear_pointer (&state->selected, g_array_unref);
  g_free (state);
}

/* The look of a stop. A camera that a person has turned since @from, and a
 * theme that a person has chosen, are kept unless the lesson changes them on
 * the way; @from NULL: they are not kept. */
static void
put_look (Session *session, const StopState *from, const StopState *state)
{
  const SceneLook old = session->look;
  GArray *selected = state->selected;

  if (selected != NULL)
    g_array_ref (selected);
  g_clear_pointer (&session->selected, g_array_unref);
  session->selected = selected;
  /* What is under the pointer stays there. */
  session->look = state->look;
  session->look.hover = old.hover;
  session->look.has_preview = old.has_preview;
  session->look.preview = old.preview;
  session->look.extent = old.extent;
  /* The question's part is refreshed for itself. */
  session->look.mask = old.mask;
  session->look.answers = old.answers;
  session->look.n_answers = old.n_answers;
  session_tell (session, CHANGED_LOOK);
  if (from == NULL || !camera_equal (&from->camera, &state->camera))
    session_set_camera (session, &state->camera);
  session_put_staging (session, from, state);
  if (from == NULL || from->told_theme != state->told_theme)
    session_tell_theme (session, state->told_theme);
}

void
session_put_state (Session *session,
                   const StopState *from,
                   const StopState *state)
{
  session_hold (session);
  session_end_edit (session);
  session_put_exhibit (session, EXHIBIT_LIFTS, session->step);
  session_put_other_order (session, &state->other_order);
  session_set_compares_space (session, state->compares_space);
  session_put_turn (session, &state->turn);
  if (session->run == state->run) {
    session_put_step (session, state->step);
  } else {
    session_put_run (session, run_ref (state->run), state->step);
    session_set_hover (session, (Object){ OBJECT_NONE, 0 });
    plane_camera_init (&session->plane_camera);
    session_tell (session, CHANGED_CAMERA);
  }
  if (state->exhibit_kind != EXHIBIT_LIFTS)
    session_put_exhibit (session, state->exhibit_kind,
                         state->exhibit_kind == EXHIBIT_COMPARE
                             ? state->step
                             : state->exhibit_step);
  put_look (session, from, state);
  session->look.extent = state->look.extent;
  session_release (session);
}

/* Goes to a state; a person's sites that it replaces can be had back. */
static void
enter_state (Session *session,
             const StopState *from,
             const StopState *state,
             const char *edit)
{
  const OwnSites kept = session_keep_own_sites (session);

  session_put_state (session, from, state);
  session_remember_own_sites (session, &kept, edit);
}

/* What is shown when the lesson is opened there. */
static const StopState *
first_state (const LessonStop *stop)
{
  return stop->ask_state != NULL ? stop->ask_state : stop->state;
}

/* What it has hidden, faded or put beside goes with it. */
static void
leave_lesson (Session *session)
{
  session_clear_staging (session);
  session_tell_theme (session, THEME_UNTOLD);
}

static void
put_lesson (Session *session, Lesson *lesson)
{
  Lesson *old = session->lesson;

  if (lesson == old)
    return;
  session_hold (session);
  if (lesson != NULL)
    enter_state (session, NULL,
                 first_state (lesson_stop (lesson_ref (lesson), 0)),
                 _ ("opening a lesson"));
  else
    leave_lesson (session);
  session->lesson = lesson;
  session->stop = 0;
  session_question_forget (session);
  /* The first question may have been answered another time. */
  if (lesson != NULL
      && session_state_of (session, 0) == lesson_stop (lesson, 0)->state)
    session_put_state (session, NULL, lesson_stop (lesson, 0)->state);
  session_question_refresh (session);
  session_show_task (session);
  if (lesson != NULL && lesson->step_size >= 0)
    session_set_step_size (session, (StepSize)lesson->step_size);
  g_clear_pointer (&old, lesson_unref);
  session_set_playing (session, FALSE);
  session_tell (session, CHANGED_LESSON);
  session_release (session);
}

void
session_forget_lost_stop (Session *session)
{
  g_clear_pointer (&session->sought, lesson_unref);
}

void
session_set_lesson (Session *session, Lesson *lesson)
{
  session_forget_lost_stop (session);
  put_lesson (session, lesson);
}

/* Finds the stop of @lesson that was @stop of @old.
 *
 * Returns: FALSE: there is none; *@found is the nearest. */
static gboolean
find_stop (const Lesson *lesson, const Lesson *old, guint stop, guint *found)
{
  const char *title = lesson_stop (old, stop)->title;

  *found = MIN (stop, lesson->stops->len - 1);
  /* Of several with one title, the one at this place. */
  if (g_str_equal (lesson_stop (lesson, *found)->title, title))
    return TRUE;
  for (guint i = 0; i < lesson->stops->len; i++)
    if (g_str_equal (lesson_stop (lesson, i)->title, title)) {
      *found = i;
      return TRUE;
    }
  return FALSE;
}

/* A file that is cut off while it is saved may be a lesson too, one without
 * the stop where the person is. They are back there when it is whole, unless
 * they have gone elsewhere. */
static guint
follow_stop (Session *session, const Lesson *lesson)
{
  const gboolean is_lost
      = session->sought != NULL && session->stop == session->stop_instead;
  g_autoptr (Lesson) old
      = lesson_ref (is_lost ? session->sought : session->lesson);
  const guint stop = is_lost ? session->sought_stop : session->stop;
  guint found;

  session_forget_lost_stop (session);
  if (find_stop (lesson, old, stop, &found))
    return found;
  session->sought = g_steal_pointer (&old);
  session->sought_stop = stop;
  session->stop_instead = found;
  return found;
}

void
session_renew_lesson (Session *session, Lesson *lesson)
{
  const Camera camera = session->camera;
  const PlaneCamera plane_camera = session->plane_camera;
  const StepSize step_size = session->step_size;
  guint stop;

  if (session->lesson == NULL) {
    session_set_lesson (session, lesson);
    return;
  }
  stop = follow_stop (session, lesson);
  session_hold (session);
  put_lesson (session, lesson);
  session_set_stop (session, stop);
  session_set_step_size (session, step_size);
  session_set_camera (session, &camera);
  session_set_plane_camera (session, &plane_camera);
  session_release (session);
}

Lesson *
session_get_lesson (Session *session)
{
  return session->lesson;
}

guint
session_get_n_stops (Session *session)
{
  return session->lesson == NULL ? 0 : session->lesson->stops->len;
}

guint
session_get_stop (Session *session)
{
  return session->stop;
}

gboolean
session_set_stop (Session *session, guint stop)
{
  if (stop >= session_get_n_stops (session))
    return FALSE;
  session_hold (session);
  enter_state (session, session_state_of (session, session->stop),
               session_state_of (session, stop),
               _ ("return to the lesson’s sites"));
  session->stop = stop;
  g_clear_pointer (&session->another, exercise_free);
  session_question_refresh (session);
  session_show_task (session);
  session_tell (session, CHANGED_LESSON);
  session_release (session);
  return TRUE;
}

gboolean
session_get_stop_step (Session *session, guint stop, guint *step)
{
  const StopState *state;

  if (stop >= session_get_n_stops (session))
    return FALSE;
  state = session_state_of (session, stop);
  if (state->run != session->run
      || state->exhibit_kind != session->exhibit_kind)
    return FALSE;
  *step = state->exhibit_kind <= EXHIBIT_COMPARE ? state->step
                                                 : state->exhibit_step;
  return TRUE;
}

/* Stops are passed in their order; one that leads back in time ends the way,
 * and of several at one step the nearest is entered. */
static guint
stop_ahead (Session *session)
{
  guint stop = session->stop;
  guint here, next;

  while (session_get_stop_step (session, stop, &here)
         && session_get_stop_step (session, stop + 1, &next) && here <= next
         && next <= session_get_step (session)) {
    stop += 1;
    if (next == session_get_step (session))
      break;
  }
  return stop;
}

static guint
stop_behind (Session *session)
{
  guint stop = session->stop;
  guint here, previous;

  while (stop > 0 && session_get_stop_step (session, stop, &here)
         && session_get_stop_step (session, stop - 1, &previous)
         && previous <= here && session_get_step (session) < here)
    stop -= 1;
  return stop;
}

void
session_follow_step (Session *session, guint old_step)
{
  guint stop;

  if (session->lesson == NULL || session->is_replaying
      || session_get_step (session) == old_step)
    return;
  session_question_follow_step (session);
  stop = session_get_step (session) > old_step ? stop_ahead (session)
                                               : stop_behind (session);
  if (stop == session->stop)
    return;
  put_look (session, session_state_of (session, session->stop),
            session_state_of (session, stop));
  session->stop = stop;
  session_question_refresh (session);
  session_tell (session, CHANGED_LESSON);
}
