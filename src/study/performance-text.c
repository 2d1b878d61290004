/* How far a performance is and how it went, in words. */
#include "performance.h"

#include <glib/gi18n.h>

#define N_STEPS 6 /* of an insertion: from the facet to the hand-over */

char *
task_text (const Task *task)
{
  GString *text = g_string_new (NULL);

  if (task->round > 0)
    g_string_append_printf (text, "round %u ", task->round);
  g_string_append (text, task_kind_name (task->kind));
  if (task->site != INDEX_NONE)
    g_string_append_printf (text, " s%u", task->site);
  return g_string_free (text, FALSE);
}

static const char *
step_words (TaskKind kind)
{
  switch (kind) {
  case TASK_FACET:
    return _ ("the facet");
  case TASK_SITE:
    return _ ("its furthest site");
  case TASK_SEE:
    return _ ("the visible facets");
  case TASK_HORIZON:
    return _ ("the horizon");
  case TASK_CONE:
    return _ ("the cone");
  case TASK_PARTITION:
  case TASK_HAND_OVER:
    break;
  }
  return "";
}

static guint
n_insertions (const Performance *performance)
{
  return performance->last_round - performance->first_round + 1;
}

char *
performance_progress (const Performance *performance)
{
  const Task *task = performance_shown (performance);
  const guint insertion = task->round - performance->first_round + 1;
  const guint step = task->kind - TASK_FACET + 1;

  if (task->kind == TASK_PARTITION)
    return g_strdup_printf (_ ("First partition: site %u of %u"), task->place,
                            task->n);
  if (task->kind == TASK_HAND_OVER)
    return g_strdup_printf (_ ("Insertion %u of %u, step %u of %u: hand over, "
                               "site %u of %u"),
                            insertion, n_insertions (performance), step,
                            N_STEPS, task->place, task->n);
  return g_strdup_printf (_ ("Insertion %u of %u, step %u of %u: %s"),
                          insertion, n_insertions (performance), step, N_STEPS,
                          step_words (task->kind));
}

/* Tasks of a round, as far as the run tells. */
static guint
n_tasks (const Performance *performance, guint round)
{
  g_autoptr (GArray) sites = task_sites (performance->run->trace, round);

  return sites->len + (round == 0 ? 0 : TASK_CONE - TASK_FACET + 1);
}

double
performance_fraction (const Performance *performance)
{
  guint n = performance->has_partition ? n_tasks (performance, 0) : 0;

  for (guint round = performance->first_round; round <= performance->last_round;
       round++)
    n += n_tasks (performance, round);
  return (double)performance_score (performance).total / n;
}

char *
performance_score_text (const Performance *performance)
{
  const PerformanceScore score = performance_score (performance);
  GString *text = g_string_new (NULL);

  g_string_printf (text, _ ("%u of %u right"), score.correct, score.total);
  if (performance->is_over && score.total > 0)
    g_string_append_printf (text, _ (" (%u%%)"),
                            100 * score.correct / score.total);
  if (score.hinted > 0)
    g_string_append_printf (
        text, ngettext (", %u hint", ", %u hints", score.hinted), score.hinted);
  if (score.undone > 0)
    g_string_append_printf (text,
                            ngettext (", %u step taken back",
                                      ", %u steps taken back", score.undone),
                            score.undone);
  return g_string_free (text, FALSE);
}

static void
begin_line (GString *text, const Performance *performance, const Task *task)
{
  if (text->len > 0)
    g_string_append_c (text, '\n');
  if (task->round == 0)
    g_string_append (text, _ ("First partition:"));
  else
    g_string_append_printf (text, _ ("Insertion %u:"),
                            task->round - performance->first_round + 1);
}

char *
performance_marks (const Performance *performance)
{
  GString *text = g_string_new (NULL);
  guint round = INDEX_NONE;

  for (guint i = 0; i < performance->tasks->len; i++) {
    const Task *task = g_ptr_array_index (performance->tasks, i);

    if (!task->is_settled)
      break;
    if (task->round != round)
      begin_line (text, performance, task);
    round = task->round;
    g_string_append (text, task->exercise->was_right_at_once ? " ✓" : " ✗");
  }
  return g_string_free (text, FALSE);
}
