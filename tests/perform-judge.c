#include "perform-judge.h"

#include "lift-judge.h"

PerformJudge *
perform_judge_new (const SiteSet *set)
{
  PerformJudge *judge = g_new0 (PerformJudge, 1);

  judge->judge = judge_new (set);
  judge->waits_at = g_new (guint, set->n_sites + 1);
  for (guint i = 0; i < set->n_sites; i++)
    judge->waits_at[i] = INDEX_NONE;
  judge->facet = INDEX_NONE;
  return judge;
}

void
perform_judge_free (PerformJudge *judge)
{
  judge_free (judge->judge);
  g_free (judge->waits_at);
  g_free (judge);
}

/* A task and what stands while it is asked. */
typedef struct Asked {
  const PerformJudge *judge;
  const Trace *trace;
  const Task *task;
  const Standing *standing;
  GArray *right; /* of Object */
} Asked;

static void
add (const Asked *asked, ObjectKind kind, guint number)
{
  const Object object = { kind, number };

  g_array_append_val (asked->right, object);
}

static guint
apex (const Asked *asked)
{
  return asked->trace->rounds[asked->task->round - 1].site;
}

/* Facets that are new: the first simplex, or those that hold the apex. */
static void
judge_hand_over (const Asked *asked)
{
  for (guint i = 0; i < asked->trace->n_facets; i++) {
    const FacetRow *row = &asked->trace->facets[i];
    const gboolean is_new = span_has (row->span, asked->standing->step)
                            && row->round == asked->task->round;

    if (is_new && standing_sees (asked->standing, i, asked->task->site))
      add (asked, OBJECT_FACET, i);
  }
}

static void
judge_facet (const Asked *asked)
{
  const guint n_sites = asked->trace->set->n_sites;

  for (guint facet = 0; facet < asked->trace->n_facets; facet++)
    for (guint site = 0; site < n_sites; site++)
      if (asked->judge->waits_at[site] == facet) {
        add (asked, OBJECT_FACET, facet);
        break;
      }
}

static gboolean
is_furthest (const Asked *asked, guint site)
{
  const Site *sites = asked->trace->set->sites;
  const uint32_t *corner = asked->trace->facets[asked->judge->facet].site;
  const Site plane[3]
      = { sites[corner[0]], sites[corner[1]], sites[corner[2]] };

  for (guint i = 0; i < asked->trace->set->n_sites; i++)
    if (asked->judge->waits_at[i] == asked->judge->facet
        && lift_judge_further (plane, &sites[i], &sites[site]) > 0)
      return FALSE;
  return TRUE;
}

static void
judge_site (const Asked *asked)
{
  for (guint i = 0; i < asked->trace->set->n_sites; i++)
    if (asked->judge->waits_at[i] == asked->judge->facet
        && is_furthest (asked, i))
      add (asked, OBJECT_SITE, i);
}

static void
judge_see (const Asked *asked)
{
  for (guint i = 0; i < asked->standing->n_facets; i++)
    if (standing_sees (asked->standing, asked->standing->facets[i],
                       apex (asked)))
      add (asked, OBJECT_FACET, asked->standing->facets[i]);
}

/* Whether a ridge that stands has one visible facet beside it. */
static gboolean
is_on_horizon (const Asked *asked, RidgeRow row)
{
  return span_has (row.span, asked->standing->step)
         && standing_sees (asked->standing, row.facet[0], apex (asked))
                != standing_sees (asked->standing, row.facet[1], apex (asked));
}

static void
judge_horizon (const Asked *asked)
{
  for (guint i = 0; i < asked->trace->n_ridges; i++)
    if (is_on_horizon (asked, trace_ridge (asked->trace, i)))
      add (asked, OBJECT_RIDGE, i);
}

/* A facet of the hull is a lower one when its circle is empty: when it has a
 * circle, and no site of the hull lies strictly inside. */
static gboolean
is_lower (const Asked *asked, const uint32_t corner[3])
{
  const Judge *judge = asked->judge->judge;

  if (judge_orient (judge, corner[0], corner[1], corner[2]) == 0)
    return FALSE;
  for (guint i = 0; i < asked->standing->n_active; i++)
    if (judge_circle (judge, corner, asked->standing->active[i]) < 0)
      return FALSE;
  return TRUE;
}

static void
judge_cone (const Asked *asked)
{
  for (guint i = 0; i < asked->trace->n_ridges; i++) {
    const RidgeRow row = trace_ridge (asked->trace, i);
    const uint32_t corner[3] = { row.site[0], row.site[1], apex (asked) };

    if (is_on_horizon (asked, row) && is_lower (asked, corner))
      add (asked, OBJECT_RIDGE, i);
  }
}

GArray *
perform_judge_answer (const PerformJudge *judge, const Performance *performance)
{
  static void (*const find[N_TASK_KINDS]) (const Asked *asked)
      = { [TASK_PARTITION] = judge_hand_over, [TASK_FACET] = judge_facet,
          [TASK_SITE] = judge_site,           [TASK_SEE] = judge_see,
          [TASK_HORIZON] = judge_horizon,     [TASK_CONE] = judge_cone,
          [TASK_HAND_OVER] = judge_hand_over };
  const Task *task = performance_task (performance);
  const Fixture fixture = { (char *)"performance", performance->run->set,
                            performance->run->trace };
  g_autoptr (Standing) standing
      = standing_new (&fixture, judge->judge, task->exercise->occasion.step);
  const Asked asked = { judge, fixture.trace, task, standing,
                        g_array_new (FALSE, FALSE, sizeof (Object)) };

  find[task->kind](&asked);
  return asked.right;
}

void
perform_judge_follow (PerformJudge *judge,
                      const Performance *performance,
                      Object chosen)
{
  const Task *task = performance_task (performance);

  switch (task->kind) {
  case TASK_PARTITION:
  case TASK_HAND_OVER:
    judge->waits_at[task->site] = chosen.number;
    break;
  case TASK_FACET:
    judge->facet = chosen.number;
    break;
  case TASK_SITE:
    judge->waits_at[chosen.number] = INDEX_NONE;
    break;
  case TASK_SEE:
  case TASK_HORIZON:
  case TASK_CONE:
    break;
  }
}
