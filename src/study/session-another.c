/* The question of the stop, asked once more on other sites. */
#include "session-private.h"
#include "site-source.h"

#include <glib/gi18n.h>

#define MOST_SEEDS 50 /* that are tried until a question is found */
#define LEAST_SITES 6
#define MOST_SITES 10

gboolean
session_can_another (Session *session)
{
  const Exercise *exercise = session_question_whole (session);

  if (exercise != NULL && exercise->performance != NULL)
    return session_can_perform_another (session);
  return exercise != NULL && !exercise->is_open
         && question_generator_of (exercise->question) != NULL;
}

/* Makes an exercise of @kind on random sites that @seed gives; NULL: there is
 * none. */
static Exercise *
make_another (const Exercise *like, const char *kind, guint64 seed)
{
  const guint n = CLAMP (like->run->set->n_sites, LEAST_SITES, MOST_SITES);
  g_autofree char *source
      = g_strdup_printf ("random %u seed %" G_GUINT64_FORMAT, n, seed);
  gsize fault;
  guint n_sites;
  g_autofree Site *sites = site_source_make (source, &n_sites, &fault, NULL);
  g_autoptr (Run) run = run_new (sites, n_sites, &like->run->trace->order);
  g_autoptr (Question) question
      = question_generate (run->trace, kind, seed, NULL);
  Occasion occasion;

  if (question == NULL
      || !question_locate (question, run->trace, &occasion, NULL))
    return NULL;
  question->n_retries = like->question->n_retries;
  return exercise_new (question, run, &occasion);
}

static void
put_another (Session *session, Exercise *exercise)
{
  const OwnSites kept = session_keep_own_sites (session);

  g_clear_pointer (&session->another, exercise_free);
  session->another = exercise;
  session->another_is_own = FALSE;
  session_put_run (session, run_ref (exercise->run), exercise->occasion.step);
  session_remember_own_sites (session, &kept, _ ("generating sites"));
  session_set_selection (session, (Object){ OBJECT_NONE, 0 });
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  session_fit (session);
}

gboolean
session_another (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);
  const char *kind;
  Exercise *another = NULL;

  if (!session_can_another (session))
    return FALSE;
  if (session_get_performance (session) != NULL)
    return session_perform_another (session);
  kind = question_generator_of (exercise->question);
  for (guint i = 0; another == NULL && i < MOST_SEEDS; i++)
    another = make_another (exercise, kind, ++session->another_seed);
  if (another == NULL)
    return FALSE;
  session_hold (session);
  put_another (session, another);
  session_question_refresh (session);
  session_tell (session, CHANGED_QUESTION | CHANGED_LOOK);
  session_release (session);
  return TRUE;
}
