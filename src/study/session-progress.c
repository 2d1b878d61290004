/* What a person does, written down; what was done another time, recalled. */
#include "session-private.h"

/* Whoever does nothing for longer has gone away, µs. */
#define LONGEST_THOUGHT (120 * G_USEC_PER_SEC)

static void
forget_keys (Session *session)
{
  session->keyed = NULL;
  session->has_moved = FALSE;
  session->noted = 0;
  g_clear_pointer (&session->lesson_key, g_free);
  g_clear_pointer (&session->question_keys, g_ptr_array_unref);
}

void
session_progress_end (Session *session)
{
  forget_keys (session);
  g_clear_pointer (&session->progress, progress_unref);
}

/* Of two that ask the same the second one is another. */
static char *
make_key (Session *session, const LessonStop *stop)
{
  g_autofree char *key = NULL;
  guint n = 1;

  if (stop->question == NULL || stop->ask_state == NULL)
    return NULL;
  key = question_key (stop->question, stop->ask_state->run);
  for (guint i = 0; i < session->question_keys->len; i++) {
    const char *other = g_ptr_array_index (session->question_keys, i);

    n += other != NULL && g_str_has_prefix (other, key);
  }
  return n == 1 ? g_steal_pointer (&key) : g_strdup_printf ("%s-%u", key, n);
}

/* Finds out what the lesson and its questions are called. */
static void
find_keys (Session *session)
{
  const Lesson *lesson = session->lesson;

  if (session->keyed == lesson)
    return;
  forget_keys (session);
  session->keyed = lesson;
  session->lesson_key = lesson_key (lesson);
  session->question_keys = g_ptr_array_new_with_free_func (g_free);
  for (guint i = 0; i < lesson->stops->len; i++)
    g_ptr_array_add (session->question_keys,
                     make_key (session, lesson_stop (lesson, i)));
}

static gboolean
has_progress (Session *session)
{
  if (session->progress == NULL || session->lesson == NULL)
    return FALSE;
  find_keys (session);
  return TRUE;
}

const LessonRecord *
session_get_record (Session *session)
{
  return has_progress (session)
             ? progress_find (session->progress, session->lesson_key)
             : NULL;
}

const QuestionRecord *
session_get_record_of (Session *session, guint stop)
{
  const LessonRecord *lesson = session_get_record (session);
  const char *key = lesson == NULL || stop >= session->question_keys->len
                        ? NULL
                        : g_ptr_array_index (session->question_keys, stop);

  return key == NULL ? NULL : lesson_record_find (lesson, key);
}

void
session_recall (Session *session, guint stop, Exercise *exercise)
{
  const QuestionRecord *record = session_get_record_of (session, stop);

  if (record != NULL)
    question_record_restore (record, exercise);
}

/* Writing down */

static void
set_title (char **to, const char *title)
{
  if (g_str_equal (*to, title))
    return;
  g_free (*to);
  *to = g_strdup (title);
}

/* The time since the last note belongs to the stop where it passed. */
static void
note_time (Session *session, LessonRecord *lesson)
{
  const gint64 now = g_get_monotonic_time ();
  const gint64 passed = MIN (now - session->noted, LONGEST_THOUGHT);
  const double seconds = (double)passed / G_USEC_PER_SEC;
  const char *key
      = session->noted == 0
                || session->noted_stop >= session->question_keys->len
            ? NULL
            : g_ptr_array_index (session->question_keys, session->noted_stop);
  QuestionRecord *question
      = key == NULL ? NULL : lesson_record_question (lesson, key);

  if (session->noted != 0)
    lesson->seconds += seconds;
  if (question != NULL && question->outcome == OUTCOME_OPEN)
    question->seconds += seconds;
  session->noted = now;
  session->noted_stop = session->stop;
}

static gboolean
note_question (Session *session, LessonRecord *lesson, guint stop)
{
  const char *key = g_ptr_array_index (session->question_keys, stop);
  const Exercise *exercise = session_begun_exercise (session, stop);
  QuestionRecord *record;

  if (key == NULL)
    return FALSE;
  record = lesson_record_question (lesson, key);
  set_title (&record->title, lesson_stop (session->lesson, stop)->title);
  record->stop = stop;
  return exercise != NULL && question_record_take (record, exercise);
}

static gboolean
note_stop (Session *session, LessonRecord *lesson)
{
  const guint stop = session->stop, furthest = lesson->furthest;
  const guint before = lesson->stop;

  session->has_moved = session->has_moved || stop > 0;
  if (session->has_moved)
    lesson->stop = stop;
  lesson->n_stops = session->lesson->stops->len;
  /* Not less in a file that is cut off while it is saved. */
  lesson->furthest = MAX (furthest, stop);
  return lesson->stop != before || lesson->furthest != furthest;
}

static void
note (Session *session)
{
  LessonRecord *lesson
      = progress_lesson (session->progress, session->lesson_key);
  gboolean has_changed = lesson->first == 0;

  set_title (&lesson->title, session->lesson->title);
  note_time (session, lesson);
  has_changed |= note_stop (session, lesson);
  for (guint i = 0; i < session->lesson->stops->len; i++)
    has_changed |= note_question (session, lesson, i);
  lesson->last = g_get_real_time () / G_USEC_PER_SEC;
  if (lesson->first == 0)
    lesson->first = lesson->last;
  if (!has_changed)
    return;
  lesson->is_changed = TRUE;
  session->progress->is_changed = TRUE;
}

static void
on_changed (Session *session, guint changes, gpointer user)
{
  (void)user;
  if (session->lesson == NULL)
    forget_keys (session);
  if ((changes & (CHANGED_LESSON | CHANGED_QUESTION)) != 0
      && !session->is_replaying && has_progress (session))
    note (session);
}

void
session_set_progress (Session *session, Progress *progress)
{
  g_assert (session->progress == NULL);
  session->progress = progress_ref (progress);
  g_signal_connect (session, "changed", G_CALLBACK (on_changed), NULL);
}

Progress *
session_get_progress (Session *session)
{
  return session->progress;
}

/* Going on */

gboolean
session_can_resume (Session *session, guint *stop)
{
  const LessonRecord *record = session_get_record (session);

  if (record == NULL || session->has_moved || session->stop != 0
      || record->stop == 0 || record->stop >= session_get_n_stops (session))
    return FALSE;
  if (stop != NULL)
    *stop = record->stop;
  return TRUE;
}

gboolean
session_resume (Session *session)
{
  guint stop;

  return session_can_resume (session, &stop)
         && session_set_stop (session, stop);
}

char *
session_clear_progress (Session *session)
{
  char *kept
      = session->progress == NULL ? NULL : progress_clear (session->progress);

  session_hold (session);
  session_question_forget (session);
  session->noted = 0;
  if (session->lesson != NULL)
    session_set_stop (session, session->stop);
  session_question_refresh (session);
  session_tell (session, CHANGED_LESSON | CHANGED_QUESTION);
  session_release (session);
  return kept;
}
