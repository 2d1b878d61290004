/* Whose sites are shown: a person's, which no question and no stop may take
 * away for good, or the lesson's. */
#include "session-private.h"

static gboolean
is_run_of_lesson (Session *session)
{
  if (session->lesson == NULL)
    return FALSE;
  if (run_has_sites_of (session->run, session->lesson->start->run))
    return TRUE;
  for (guint i = 0; i < session_get_n_stops (session); i++) {
    const LessonStop *stop = lesson_stop (session->lesson, i);

    if (run_has_sites_of (session->run, stop->state->run)
        || (stop->ask_state != NULL
            && run_has_sites_of (session->run, stop->ask_state->run)))
      return TRUE;
  }
  return FALSE;
}

/* Returns: whether the sites shown are a person's, also when they perform on
 *          them. */
static gboolean
shows_own_sites (Session *session)
{
  if (session->run->set->n_sites == 0)
    return FALSE;
  if (session_question_owns_run (session, session->run))
    return session->another != NULL && session->another_is_own;
  return !is_run_of_lesson (session);
}

OwnSites
session_keep_own_sites (Session *session)
{
  return (OwnSites){ run_ref (session->run), shows_own_sites (session) };
}

void
session_remember_own_sites (Session *session,
                            const OwnSites *kept,
                            const char *edit)
{
  if (kept->are_own && !run_has_sites_of (kept->run, session->run))
    session_remember (session, kept->run, g_strdup (edit));
  run_unref (kept->run);
}
