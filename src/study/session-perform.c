/* You be QuickHull, in the session: the pictures follow the tasks. */
#include "fresh-sites.h"
#include "performance.h"
#include "session-private.h"
#include "site-source.h"

#include <glib/gi18n.h>

static Performance *
performance_of (Session *session)
{
  const Exercise *whole = session_question_whole (session);

  return whole == NULL ? NULL : whole->performance;
}

const Performance *
session_get_performance (Session *session)
{
  return performance_of (session);
}

static gboolean
is_open (const Performance *performance)
{
  return performance != NULL && !performance->is_over;
}

/* What helps to find one's way: the facet or the site that the task is
 * about. */
static Object
subject_of (const Task *task)
{
  const Trace *trace = task->exercise->run->trace;

  if (task->site != INDEX_NONE)
    return (Object){ OBJECT_SITE, task->site };
  if (task->kind == TASK_SITE)
    return (Object){ OBJECT_FACET, trace->rounds[task->round - 1].facet };
  return (Object){ OBJECT_NONE, 0 };
}

static void
put_task (Session *session)
{
  const Performance *performance = performance_of (session);
  const Task *task;
  guint step;

  if (performance == NULL)
    return;
  task = performance_shown (performance);
  step = task->exercise->is_open ? task->exercise->occasion.step
                                 : task->exercise->occasion.reveal;
  session_hold (session);
  session_put_exhibit (session, EXHIBIT_LIFTS, session->step);
  if (session->run == performance->run)
    session_put_step (session, step);
  else
    session_put_run (session, run_ref (performance->run), step);
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  session_set_selection (session, subject_of (task));
  session_question_refresh (session);
  session_tell (session, CHANGED_QUESTION | CHANGED_LOOK);
  session_release (session);
}

void
session_show_task (Session *session)
{
  const OwnSites kept = session_keep_own_sites (session);

  put_task (session);
  session_remember_own_sites (session, &kept,
                              _ ("return to the lesson’s sites"));
}

/* Ends the question when its last task is done. */
static void
finish (Session *session)
{
  Exercise *whole = session_question_whole (session);

  if (whole->performance->is_over)
    exercise_finish (whole);
}

gboolean
session_settle_task (Session *session)
{
  Performance *performance = performance_of (session);

  if (performance == NULL)
    return FALSE;
  performance_settle (performance);
  finish (session);
  session_show_task (session);
  return TRUE;
}

gboolean
session_next_task (Session *session)
{
  Performance *performance = performance_of (session);

  if (performance == NULL || !performance_advance (performance))
    return FALSE;
  session_show_task (session);
  return TRUE;
}

gboolean
session_can_next_task (Session *session)
{
  const Performance *performance = performance_of (session);

  return is_open (performance) && performance_task (performance)->is_settled;
}

guint
session_last_step_allowed (Session *session)
{
  const Performance *performance
      = session->is_replaying ? NULL : performance_of (session);
  const Exercise *exercise;

  if (!is_open (performance) || session->run != performance->run)
    return G_MAXUINT;
  exercise = performance_task (performance)->exercise;
  return exercise->is_open ? exercise->occasion.step
                           : exercise->occasion.reveal;
}

/* Going through it with "next" and "back": tasks while it lasts, and after it
 * the model answer, beat by beat. */

static gboolean
is_here (Session *session, const Performance *performance)
{
  const Exercise *exercise = performance_shown (performance)->exercise;

  return session->run == performance->run
         && session->step
                == (exercise->is_open ? exercise->occasion.step
                                      : exercise->occasion.reveal);
}

gboolean
session_can_browse (Session *session, gboolean forwards)
{
  const Performance *performance = performance_of (session);

  return performance != NULL && performance->is_over
         && (forwards ? performance->shown + 1 < performance->tasks->len
                      : performance->shown > 0);
}

gboolean
session_browse (Session *session, gboolean forwards)
{
  Performance *performance = performance_of (session);

  if (performance == NULL || !performance_browse (performance, forwards))
    return FALSE;
  session_show_task (session);
  return TRUE;
}

gboolean
session_perform_can_next (Session *session)
{
  return !session->is_replaying
         && (is_open (performance_of (session))
             || (session->step_size == STEP_BEAT
                 && performance_of (session) != NULL
                 && (session_can_browse (session, TRUE)
                     || session_can_continue (session))));
}

gboolean
session_perform_next (Session *session)
{
  const Performance *performance = performance_of (session);

  if (!session_perform_can_next (session))
    return FALSE;
  if (!is_here (session, performance))
    session_show_task (session);
  else if (performance->is_over)
    (void)(session_browse (session, TRUE) || session_continue (session));
  else if (!session_next_task (session))
    session_answer_then_go (session);
  return TRUE;
}

gboolean
session_perform_back (Session *session)
{
  return session->step_size == STEP_BEAT && !session->is_replaying
         && session_browse (session, FALSE);
}

/* Beginning and ending */

/* Whether the sites can be performed on as they are. */
static gboolean
can_perform (const Run *run, GError **error)
{
  const char *reason = NULL;

  if (run->trace->n_rounds == 0)
    reason = _ ("nothing is inserted here: add sites, at least five");
  else if (run->set->n_sites > QUESTION_MAX_SITES)
    reason = _ ("this question is for at most 200 sites");
  if (reason != NULL)
    g_set_error (error, SESSION_ERROR, SESSION_ERROR_SITE, "%s", reason);
  return reason == NULL;
}

#define LEAST_SITES 6
#define MOST_SITES 8
#define MOST_INSERTIONS 3

/* The question about the sites as they are; @fresh NULL: others are random
 * ones. */
static Question *
make_question (const Run *run, const char *fresh, guint64 seed)
{
  const guint n = CLAMP (run->set->n_distinct, LEAST_SITES, MOST_SITES);
  Question *question = question_new ();

  question->kind = QUESTION_PERFORM;
  question->position = g_strdup ("start");
  question->n_insertions = MIN (run->trace->n_rounds, MOST_INSERTIONS);
  question->n_retries = 1;
  question->fresh
      = fresh == NULL ? g_strdup_printf ("random %u", n) : g_strdup (fresh);
  question->seed = seed;
  return question;
}

/* Takes @question, which is about the sites of @run, and @kept: what was shown
 * before. */
static void
begin (Session *session, Question *question, Run *run, const OwnSites *kept)
{
  Occasion occasion;

  g_clear_pointer (&session->another, exercise_free);
  if (question_locate (question, run->trace, &occasion, NULL))
    session->another = exercise_new (question, run, &occasion);
  session->another_is_own = kept->are_own && run_has_sites_of (run, kept->run);
  question_unref (question);
  put_task (session);
  session_remember_own_sites (session, kept, _ ("generating sites"));
}

/* Returns: (transfer full): the run of sites that a seed gives; NULL with
 *          @error set. */
static Run *
make_fresh (const char *text, GError **error)
{
  gsize fault;
  guint n_sites;
  g_autofree Site *sites = site_source_make (text, &n_sites, &fault, error);

  return sites == NULL
             ? NULL
             : run_new (sites, n_sites, &(Order){ ORDER_FURTHEST, 0 });
}

/* Puts sites in place; an edit like any other. */
static void
put_fresh (Session *session, const Run *run)
{
  g_autofree Site *sites = run_given (run);

  session_put_sites (session, sites, run->set->n_sites, _ ("generating sites"),
                     NULL);
}

/* Both pictures, with what can be pointed at in them. */
static void
show_what_is_clicked (Session *session)
{
  session_set_views (session, VIEWS_BOTH);
  session_set_layers (session, session->look.layers | LAYER_HULL
                                   | LAYER_DELAUNAY | LAYER_LABELS);
  session_set_lift (session, 1);
}

gboolean
session_perform (Session *session, const char *source, GError **error)
{
  const Order order = { ORDER_FURTHEST, 0 };
  g_autofree char *fresh = NULL;
  g_autoptr (Run) run = NULL;
  guint64 seed = 0;
  gsize fault;
  OwnSites kept;

  if (*source != '\0'
      && !fresh_sites_parse (source, &fresh, &seed, &fault, error))
    return FALSE;
  run = fresh == NULL ? run_ref (session->run) : make_fresh (source, error);
  if (run == NULL || !can_perform (run, error))
    return FALSE;
  session_hold (session);
  kept = session_keep_own_sites (session);
  g_clear_pointer (&session->another, exercise_free);
  session_put_exhibit (session, EXHIBIT_LIFTS, session->step);
  show_what_is_clicked (session);
  session_set_order (session, &order);
  if (fresh != NULL) {
    put_fresh (session, run);
    run_unref (kept.run);
    kept = session_keep_own_sites (session);
  }
  begin (session, make_question (session->run, fresh, seed), session->run,
         &kept);
  session_release (session);
  return TRUE;
}

gboolean
session_can_perform_another (Session *session)
{
  const Exercise *whole = session_question_whole (session);

  return whole != NULL && whole->performance != NULL && !whole->is_open
         && whole->question->fresh != NULL;
}

/* The same question on the sites of the next seed. */
gboolean
session_perform_another (Session *session)
{
  const Exercise *whole = session_question_whole (session);
  const Question *like = whole->question;
  guint64 seed = like->seed;
  g_autoptr (Run) run
      = fresh_sites_next (like->fresh, (guint)like->n_insertions, &seed);
  Question *question;
  OwnSites kept;

  if (run == NULL)
    return FALSE;
  question = make_question (run, like->fresh, seed);
  question->n_insertions = like->n_insertions;
  question->n_retries = like->n_retries;
  session_hold (session);
  if (session->lesson == NULL)
    put_fresh (session, run);
  kept = session_keep_own_sites (session);
  begin (session, question, run, &kept);
  session_fit (session);
  session_release (session);
  return TRUE;
}

gboolean
session_can_grade (Session *session)
{
  return is_open (performance_of (session));
}

gboolean
session_grade (Session *session)
{
  if (!session_can_grade (session))
    return FALSE;
  performance_give_up (performance_of (session));
  finish (session);
  session_show_task (session);
  return TRUE;
}

gboolean
session_can_end_performance (Session *session)
{
  return session->another != NULL && session->another->performance != NULL;
}

/* A lesson goes back to its stop; else a person can go through the run that
 * followed. */
gboolean
session_end_performance (Session *session)
{
  g_autoptr (Run) run = NULL;

  if (!session_can_end_performance (session))
    return FALSE;
  run = run_ref (session->another->run);
  session_hold (session);
  g_clear_pointer (&session->another, exercise_free);
  session_set_selection (session, (Object){ OBJECT_NONE, 0 });
  if (session->lesson != NULL) {
    /* Of a person's own sites there is something to remember. */
    session_put_run (session, run_ref (run), run->trace->n_events);
    session_set_stop (session, session->stop);
  }
  session_question_refresh (session);
  session_tell (session, CHANGED_QUESTION | CHANGED_LOOK);
  session_release (session);
  return TRUE;
}

char *
session_performance_sites (Session *session)
{
  const Exercise *whole = session_question_whole (session);

  if (whole == NULL || whole->performance == NULL || whole != session->another
      || whole->question->seed == 0)
    return g_strdup ("");
  return fresh_sites_text (whole->question->fresh, whole->question->seed);
}
