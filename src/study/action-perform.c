/* You be QuickHull: the actions of a performance. */
#include "action-private.h"

#include <glib/gi18n.h>

static gboolean
refuse (const char *reason, GError **error)
{
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_DISABLED, "%s", reason);
  return FALSE;
}

static ACTION_RUN (action_perform)
{
  return session_perform (session, g_variant_get_string (parameter, NULL),
                          error);
}

static ACTION_RUN (action_grade)
{
  return session_grade (session)
         || refuse (_ ("there is no performance to grade"), error);
}

static ACTION_RUN (action_browse)
{
  return session_browse (session, action->data != 0)
         || refuse (_ ("there is no other task to look at"), error);
}

static ACTION_RUN (action_end_performance)
{
  return session_end_performance (session)
         || refuse (_ ("there is no performance to leave"), error);
}

static ACTION_ENABLED (action_can_grade) { return session_can_grade (session); }

static ACTION_ENABLED (action_can_browse)
{
  return session_can_browse (session, action->data != 0);
}

static ACTION_ENABLED (action_can_end_performance)
{
  return session_can_end_performance (session);
}

/* States */

static ACTION_STATE (action_state_performance)
{
  const Performance *performance = session_get_performance (session);

  if (performance == NULL)
    return g_variant_new_string ("none");
  return g_variant_new_string (performance->is_over ? "over" : "open");
}

static ACTION_STATE (action_state_task)
{
  const Performance *performance = session_get_performance (session);

  return performance == NULL ? g_variant_new_string ("")
                             : g_variant_new_take_string (
                                 task_text (performance_shown (performance)));
}

static ACTION_STATE (action_state_performance_score)
{
  const Performance *performance = session_get_performance (session);
  PerformanceScore score = { 0, 0, 0, 0 };

  if (performance != NULL)
    score = performance_score (performance);
  return g_variant_new ("(uuuu)", score.total, score.correct, score.undone,
                        score.hinted);
}

/* The rows of the table. */

static const Action rows[] = {
  { .name = "perform",
    .parameter = "s",
    .sentence = N_ ("You be QuickHull: perform insertions on these sites, or "
                    "on those of a source with a seed"),
    .where = ACTION_IN_WINDOW,
    .run = action_perform },
  { .name = "grade",
    .sentence = N_ ("Grade the performance, giving up what is left to do"),
    .where = ACTION_IN_WINDOW,
    .run = action_grade,
    .is_enabled = action_can_grade },
  { .name = "next-task",
    .sentence = N_ ("Look at the next task of the model answer"),
    .keys = "<Alt>Right",
    .where = ACTION_IN_WINDOW,
    .run = action_browse,
    .is_enabled = action_can_browse,
    .data = TRUE },
  { .name = "previous-task",
    .sentence = N_ ("Look at the previous task of the model answer"),
    .keys = "<Alt>Left",
    .where = ACTION_IN_WINDOW,
    .run = action_browse,
    .is_enabled = action_can_browse,
    .data = FALSE },
  { .name = "end-performance",
    .sentence = N_ ("Leave the performance"),
    .where = ACTION_IN_WINDOW,
    .run = action_end_performance,
    .is_enabled = action_can_end_performance },
  { .name = "performance",
    .state = "s",
    .sentence = N_ ("Whether you are QuickHull: none, open or over"),
    .where = ACTION_IN_WINDOW,
    .get_state = action_state_performance },
  { .name = "task",
    .state = "s",
    .sentence = N_ ("The task of the performance"),
    .where = ACTION_IN_WINDOW,
    .get_state = action_state_task },
  { .name = "performance-score",
    .state = "(uuuu)",
    .sentence = N_ ("The performance: how many tasks there are, right first "
                    "time, steps taken back and hints"),
    .where = ACTION_IN_WINDOW,
    .get_state = action_state_performance_score },
};

const ActionRows action_rows_perform = { rows, G_N_ELEMENTS (rows) };
