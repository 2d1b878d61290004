/* The tasks of a performance: questions that a round of QuickHull asks. */
#include "performance.h"
#include "question-click.h"

#include <glib/gi18n.h>

static const struct {
  const char *name;
  const char *click;
} kinds[N_TASK_KINDS] = {
  [TASK_PARTITION] = { "partition", "hand-over" },
  [TASK_FACET] = { "facet", "next-facet" },
  [TASK_SITE] = { "site", "furthest-site" },
  [TASK_SEE] = { "see", "visible-facets" },
  [TASK_HORIZON] = { "horizon", "horizon" },
  [TASK_CONE] = { "cone", "new-triangles" },
  [TASK_HAND_OVER] = { "hand-over", "hand-over" },
};

const char *
task_kind_name (TaskKind kind)
{
  return kinds[kind].name;
}

static int
compare_sites (gconstpointer a, gconstpointer b)
{
  const guint left = *(const guint *)a, right = *(const guint *)b;

  return left < right ? -1 : left > right;
}

GArray *
task_sites (const Trace *trace, guint round)
{
  const guint first
      = round == 0 ? trace->simplex_end : trace->rounds[round - 1].last_retire;
  const guint end
      = round == 0 ? trace->start_end : trace->rounds[round - 1].end;
  GArray *sites = g_array_new (FALSE, FALSE, sizeof (guint));

  for (guint i = first; i < end; i++) {
    const guint site = trace_event (trace, i).site;

    g_array_append_val (sites, site);
  }
  g_array_sort (sites, compare_sites);
  return sites;
}

/* Where it is asked, and where its answer is seen. */

static guint
step_of (const Task *task, const Trace *trace)
{
  const RoundRow *round
      = task->round == 0 ? NULL : &trace->rounds[task->round - 1];

  switch (task->kind) {
  case TASK_PARTITION:
    return trace->simplex_end;
  case TASK_FACET:
  case TASK_SITE:
    return round->select - 1;
  case TASK_SEE:
    return round->select;
  case TASK_HORIZON:
    return round->last_visible;
  case TASK_CONE:
    return round->last_horizon;
  case TASK_HAND_OVER:
    return round->last_cone;
  }
  return 0;
}

/* The facet alone does not show its furthest site, and who is handed over
 * shows not where others go. */
static guint
reveal_of (const Task *task, const Trace *trace)
{
  const RoundRow *round
      = task->round == 0 ? NULL : &trace->rounds[task->round - 1];

  switch (task->kind) {
  case TASK_PARTITION:
    return task->place == task->n ? trace->start_end : trace->simplex_end;
  case TASK_FACET:
    return round->select - 1;
  case TASK_SITE:
    return round->select;
  case TASK_SEE:
    return round->last_visible;
  case TASK_HORIZON:
    return round->last_horizon;
  case TASK_CONE:
    return round->last_cone;
  case TASK_HAND_OVER:
    return task->place == task->n ? round->end : round->last_cone;
  }
  return 0;
}

/* What is asked */

/* Returns: (transfer full): "s4, s7": the outside set of the facet. */
static char *
outside_set_text (const Trace *trace, guint facet, guint step)
{
  GString *text = g_string_new (NULL);

  for (guint i = 0; i < trace->n_claims; i++)
    if (trace_claim (trace, i).facet == facet
        && span_has (trace_claim (trace, i).span, step))
      g_string_append_printf (text, "%ss%u", text->len == 0 ? "" : ", ",
                              trace_claim (trace, i).site);
  return g_string_free (text, FALSE);
}

static char *
make_prompt (const Task *task, const Trace *trace)
{
  g_autofree char *set = NULL;
  guint facet;

  if (task->kind == TASK_PARTITION)
    return g_strdup_printf (
        _ ("The first simplex stands; **s%u** is not on it. Click a facet at "
           "which **s%u may wait**."),
        task->site, task->site);
  if (task->kind != TASK_SITE)
    return NULL;
  facet = trace->rounds[task->round - 1].facet;
  set = outside_set_text (trace, facet, step_of (task, trace));
  return g_strdup_printf (_ ("The outside set of **f%u** is %s. Click the site "
                             "that is **furthest from f%u**."),
                          facet, set, facet);
}

/* Hints */

/* Returns: (transfer full): "s4, s7 at f1; s5 at f3". */
static char *
waiting_text (const Trace *trace, guint step)
{
  GString *text = g_string_new (NULL);

  for (guint facet = 0; facet < trace->n_facets; facet++) {
    g_autofree char *set = outside_set_text (trace, facet, step);

    if (*set != '\0')
      g_string_append_printf (text, _ ("%s%s at f%u"),
                              text->len == 0 ? "" : "; ", set, facet);
  }
  return g_string_free (text, FALSE);
}

static const char *
furthest_hint (Facing facing)
{
  switch (facing) {
  case FACING_LOWER:
    return _ ("f%u is a lower facet: the furthest site is the one nearest to "
              "the centre of its circle.");
  case FACING_UPPER:
    return _ ("f%u is an upper facet: the furthest site is the one farthest "
              "from the centre of its circle.");
  case FACING_VERTICAL:
    break;
  }
  return _ ("f%u is a vertical facet: the furthest site is the one farthest "
            "from its hull edge in the plane.");
}

static void
add_hint (Question *question, const char *hint)
{
  g_ptr_array_add (question->hints, g_strdup (hint));
}

static void
add_seeing_hint (Question *question)
{
  add_hint (question,
            _ ("A lower facet is seen from inside its circle, an upper one "
               "from outside its circle, a vertical one from beyond its hull "
               "edge."));
}

static void
add_facet_hints (Question *question, const Trace *trace, guint step)
{
  g_autofree char *waiting = waiting_text (trace, step);

  add_hint (question, _ ("Any facet whose outside set is not empty may be "
                         "taken: one at which a site waits."));
  g_ptr_array_add (question->hints,
                   g_strdup_printf (_ ("Here wait: %s."), waiting));
}

static void
add_site_hints (Question *question, const Trace *trace, guint facet)
{
  g_ptr_array_add (
      question->hints,
      g_strdup_printf (furthest_hint (trace->facets[facet].facing), facet));
  add_hint (question,
            _ ("Among sites that are exactly equally far, each is right."));
}

static void
add_hints (const Task *task, Question *question, const Trace *trace)
{
  switch (task->kind) {
  case TASK_PARTITION:
  case TASK_HAND_OVER:
    add_seeing_hint (question);
    add_hint (question, _ ("The site must see the facet. When it sees several, "
                           "any of them will do."));
    break;
  case TASK_FACET:
    add_facet_hints (question, trace, step_of (task, trace));
    break;
  case TASK_SITE:
    add_site_hints (question, trace, trace->rounds[task->round - 1].facet);
    break;
  case TASK_SEE:
    add_seeing_hint (question);
    add_hint (
        question,
        _ ("A site inside the hull in the plane sees only lower facets; one "
           "outside may see upper facets too: look at them in space."));
    break;
  case TASK_HORIZON:
    add_hint (question, _ ("A ridge of the horizon lies between a facet that "
                           "is visible and one that is not."));
    add_hint (question, _ ("The horizon is one closed loop. It has two ridges "
                           "more than there are visible facets."));
    break;
  case TASK_CONE:
    add_hint (question, _ ("Join each ridge of the horizon to the site: could "
                           "that facet be seen from below?"));
    add_hint (question, _ ("When the site lies inside the hull in the plane, "
                           "every new facet is a lower one."));
    break;
  }
}

/* Tasks */

static Question *
make_question (const Task *task, const Trace *trace, guint n_retries)
{
  Question *question = question_new ();

  question->kind = QUESTION_CLICK;
  question->click = click_kind_find (kinds[task->kind].click);
  question->n_retries = n_retries;
  question->prompt = make_prompt (task, trace);
  if (task->site != INDEX_NONE)
    question->argument = (Object){ OBJECT_SITE, task->site };
  add_hints (task, question, trace);
  return question;
}

static void
find_place (Task *task, const Trace *trace)
{
  g_autoptr (GArray) sites = task_sites (trace, task->round);

  task->n = sites->len;
  for (guint i = 0; i < sites->len; i++)
    if (g_array_index (sites, guint, i) == task->site)
      task->place = i + 1;
}

Task *
task_new (Run *run, TaskKind kind, guint round, guint site, guint n_retries)
{
  Task *task = g_new0 (Task, 1);
  g_autoptr (Question) question = NULL;
  Occasion occasion = { .trace = run->trace, .round = round };

  task->kind = kind;
  task->round = round;
  task->site = site;
  if (site != INDEX_NONE)
    find_place (task, run->trace);
  question = make_question (task, run->trace, n_retries);
  occasion.step = step_of (task, run->trace);
  occasion.reveal = reveal_of (task, run->trace);
  task->exercise = exercise_new (question, run, &occasion);
  return task;
}

void
task_free (Task *task)
{
  exercise_free (task->exercise);
  g_free (task);
}

void
task_move (Task *task, Run *run)
{
  Exercise *exercise = task->exercise;

  run_ref (run);
  run_unref (exercise->run);
  exercise->run = run;
  exercise->occasion.trace = run->trace;
  exercise->occasion.reveal = reveal_of (task, run->trace);
}
