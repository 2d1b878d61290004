#include "performance.h"

Performance *
performance_new (Run *run,
                 const Occasion *occasion,
                 guint n_insertions,
                 guint n_retries)
{
  Performance *performance = g_new0 (Performance, 1);
  const Trace *trace = run->trace;
  Task *task;

  performance->run = run_ref (run);
  performance->choices = g_array_new (FALSE, FALSE, sizeof (HullChoice));
  performance->tasks
      = g_ptr_array_new_with_free_func ((GDestroyNotify)task_free);
  performance->n_retries = n_retries;
  performance->first_round = occasion->round;
  performance->last_round = occasion->round + n_insertions - 1;
  performance->has_partition = occasion->step == trace->simplex_end
                               && trace->start_end > trace->simplex_end;
  if (performance->has_partition) {
    g_autoptr (GArray) sites = task_sites (trace, 0);

    task = task_new (run, TASK_PARTITION, 0, g_array_index (sites, guint, 0),
                     n_retries);
  } else
    task = task_new (run, TASK_FACET, occasion->round, INDEX_NONE, n_retries);
  g_ptr_array_add (performance->tasks, task);
  return performance;
}

void
performance_free (Performance *performance)
{
  run_unref (performance->run);
  g_array_unref (performance->choices);
  g_ptr_array_unref (performance->tasks);
  g_free (performance);
}

Task *
performance_task (const Performance *performance)
{
  return g_ptr_array_index (performance->tasks, performance->tasks->len - 1);
}

Task *
performance_shown (const Performance *performance)
{
  return g_ptr_array_index (performance->tasks, performance->shown);
}

/* What comes next */

/* A task that follows: its kind, round and site. */
typedef struct Following {
  TaskKind kind;
  guint round, site;
} Following;

/* The site after @site that is handed over in the round; INDEX_NONE: the
 * first, and none left. */
static guint
site_after (const Trace *trace, guint round, guint site)
{
  g_autoptr (GArray) sites = task_sites (trace, round);

  for (guint i = 0; i < sites->len; i++)
    if (site == INDEX_NONE || g_array_index (sites, guint, i) > site)
      return g_array_index (sites, guint, i);
  return INDEX_NONE;
}

/* The first task of a round. */
static gboolean
begin_round (const Performance *performance, guint round, Following *following)
{
  *following = (Following){ TASK_FACET, round, INDEX_NONE };
  return round <= performance->last_round;
}

/* Returns: FALSE: the current task is the last one. */
static gboolean
find_following (const Performance *performance, Following *following)
{
  const Task *task = performance_task (performance);
  const Trace *trace = performance->run->trace;
  guint site;

  switch (task->kind) {
  case TASK_PARTITION:
  case TASK_HAND_OVER:
    site = site_after (trace, task->round, task->site);
    if (site == INDEX_NONE)
      return begin_round (performance, task->round + 1, following);
    *following = (Following){ task->kind, task->round, site };
    return TRUE;
  case TASK_CONE:
    site = site_after (trace, task->round, INDEX_NONE);
    if (site == INDEX_NONE)
      return begin_round (performance, task->round + 1, following);
    *following = (Following){ TASK_HAND_OVER, task->round, site };
    return TRUE;
  case TASK_FACET:
  case TASK_SITE:
  case TASK_SEE:
  case TASK_HORIZON:
    *following
        = (Following){ (TaskKind)(task->kind + 1), task->round, INDEX_NONE };
    return TRUE;
  }
  return FALSE;
}

gboolean
performance_advance (Performance *performance)
{
  Following following;
  Task *task;

  if (!performance_task (performance)->is_settled
      || !find_following (performance, &following))
    return FALSE;
  task = task_new (performance->run, following.kind, following.round,
                   following.site, performance->n_retries);
  g_ptr_array_add (performance->tasks, task);
  performance->shown = performance->tasks->len - 1;
  return TRUE;
}

/* What was chosen */

/* Where the engine lets the site wait. */
static guint
facet_of_claim (const Trace *trace, guint round, guint site)
{
  const guint first
      = round == 0 ? trace->simplex_end : trace->rounds[round - 1].last_retire;

  for (guint i = first; i < trace->n_events; i++)
    if (trace_event (trace, i).kind == EVENT_CLAIM
        && trace_event (trace, i).site == site)
      return trace_event (trace, i).facet;
  return INDEX_NONE;
}

/* The choice that the task leaves open, as the engine would make it. */
static gboolean
find_choice (const Task *task, const Trace *trace, HullChoice *choice)
{
  const RoundRow *round
      = task->round == 0 ? NULL : &trace->rounds[task->round - 1];

  *choice = (HullChoice){ EVENT_SELECT, task->round, INDEX_NONE, INDEX_NONE };
  switch (task->kind) {
  case TASK_PARTITION:
  case TASK_HAND_OVER:
    choice->kind = EVENT_CLAIM;
    choice->site = task->site;
    choice->facet = facet_of_claim (trace, task->round, task->site);
    return TRUE;
  case TASK_FACET:
    choice->facet = round->facet;
    return TRUE;
  case TASK_SITE:
    choice->facet = round->facet;
    choice->site = round->site;
    return TRUE;
  case TASK_SEE:
  case TASK_HORIZON:
  case TASK_CONE:
    break;
  }
  return FALSE;
}

/* Puts the choice in place of the one before it in its round, the facet
 * alone. */
static void
keep_choice (Performance *performance, const HullChoice *choice)
{
  GArray *choices = performance->choices;

  for (guint i = 0; i < choices->len; i++) {
    HullChoice *row = &g_array_index (choices, HullChoice, i);

    if (row->kind == choice->kind && row->round == choice->round
        && choice->kind == EVENT_SELECT) {
      *row = *choice;
      return;
    }
  }
  g_array_append_vals (choices, choice, 1);
}

/* The run goes on as it was chosen, and all tasks stand in it: up to where
 * they are asked it is the same. */
static void
follow_choices (Performance *performance)
{
  const HullChoices choices
      = { (const HullChoice *)(gpointer)performance->choices->data,
          performance->choices->len };
  Run *run = run_new_chosen (performance->run, &choices);

  run_unref (performance->run);
  performance->run = run;
  for (guint i = 0; i < performance->tasks->len; i++)
    task_move (g_ptr_array_index (performance->tasks, i), run);
}

/* What of a choice the task asks for. */
static guint *
open_part (const Task *task, HullChoice *choice)
{
  return task->kind == TASK_SITE ? &choice->site : &choice->facet;
}

static void
choose (Performance *performance, const Task *task)
{
  const Exercise *exercise = task->exercise;
  HullChoice choice;
  guint *open, engine;

  if (!find_choice (task, performance->run->trace, &choice))
    return;
  open = open_part (task, &choice);
  engine = *open;
  if (exercise->verdict != NULL && exercise->verdict->is_right)
    *open = g_array_index (exercise->attempt->objects, Object, 0).number;
  keep_choice (performance, &choice);
  if (*open != engine)
    follow_choices (performance);
}

void
performance_settle (Performance *performance)
{
  Task *task = performance_task (performance);
  Following following;

  if (task->exercise->is_open || task->is_settled)
    return;
  task->is_settled = TRUE;
  choose (performance, task);
  performance->is_over = !find_following (performance, &following);
}

/* From task to task */

void
performance_give_up (Performance *performance)
{
  do {
    exercise_reveal (performance_task (performance)->exercise);
    performance_settle (performance);
  } while (performance_advance (performance));
}

gboolean
performance_browse (Performance *performance, gboolean forwards)
{
  const guint shown = performance->shown + (forwards ? 1 : -1u);

  if (!performance->is_over || shown >= performance->tasks->len)
    return FALSE;
  performance->shown = shown;
  return TRUE;
}

/* Of all that is legal the model answer takes what the engine takes. */
static Attempt *
make_attempt (const Task *task, gboolean rightly)
{
  const Exercise *exercise = task->exercise;
  HullChoice choice;
  Attempt *model;

  if (!rightly)
    return answer_wrong (exercise->question, &exercise->occasion);
  model = answer_model (exercise->question, &exercise->occasion);
  if (find_choice (task, exercise->run->trace, &choice))
    g_array_index (model->objects, Object, 0).number
        = *open_part (task, &choice);
  return model;
}

void
performance_play (Performance *performance, gboolean rightly)
{
  do {
    const Task *task = performance_task (performance);
    Exercise *exercise = task->exercise;

    attempt_free (exercise->attempt);
    exercise->attempt = make_attempt (task, rightly);
    while (exercise_check (exercise))
      ;
    performance_settle (performance);
  } while (performance_advance (performance));
}

PerformanceScore
performance_score (const Performance *performance)
{
  PerformanceScore score = { 0, 0, 0, 0 };

  for (guint i = 0; i < performance->tasks->len; i++) {
    const Task *task = g_ptr_array_index (performance->tasks, i);

    score.total += task->is_settled ? 1 : 0;
    score.correct += task->exercise->was_right_at_once ? 1 : 0;
    score.undone += task->exercise->n_undone;
    score.hinted += task->exercise->n_hints;
  }
  return score;
}
