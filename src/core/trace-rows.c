#include "trace-rows.h"

#include "memory.h"

static void
add_facet (Trace *trace,
           const uint32_t site[3],
           Facing facing_of_it,
           uint32_t step)
{
  trace->facets[trace->n_facets++] = (FacetRow){
    { site[0], site[1], site[2] }, trace->n_rounds, STEP_NEVER, facing_of_it,
    { step, STEP_NEVER },
  };
}

static void
add_flat (Trace *trace)
{
  uint32_t site;

  trace->n_events += 1;
  for (site = 0; site < trace->set->n_sites; site++)
    if (trace->set->first[site] == site)
      trace->inserted[site] = trace->n_events;
  trace->is_flat = true;
  trace->simplex_end = trace->n_events;
  trace->start_end = trace->n_events;
}

static void
add_simplex (Trace *trace)
{
  const Site *sites = trace->set->sites;
  const TraceLog *log = &trace->log;
  uint32_t i;

  for (i = 0; i < 4; i++) {
    const uint32_t *site = log->simplex[i];

    add_facet (trace, site,
               facing (&sites[site[0]], &sites[site[1]], &sites[site[2]]),
               ++trace->n_events);
  }
  for (i = 0; i < 12; i++)
    trace->inserted[log->simplex[i / 3][i % 3]] = trace->n_events;
  trace->simplex_end = trace->n_events;
  trace->n_events += log->n_rounds > 0 ? log->rounds[0].claim : log->n_claims;
  trace->start_end = trace->n_events;
}

/* facing() of a cone facet, from what its ridge's tail and head are off the
 * apex. */
static inline Facing
cone_facing (const Trace *trace,
             const uint32_t site[3],
             const Site *tail,
             const Site *head)
{
  const Site *sites = trace->set->sites;
  const double left = tail->x * head->y, right = tail->y * head->x;

  if (orient_is_settled (left, right))
    return left > right ? FACING_UPPER : FACING_LOWER;
  return facing (&sites[site[0]], &sites[site[1]], &sites[site[2]]);
}

/* The facets on the horizon's ridges. */
static void
add_cone (Trace *trace, const LogRidge *ridge, uint32_t n, uint32_t apex)
{
  const Site *sites = trace->set->sites;
  const Site at = sites[apex], *first = &sites[ridge[0].tail];
  Site tail = { first->x - at.x, first->y - at.y };
  uint32_t i;

  for (i = 0; i < n; i++) {
    const uint32_t next = ridge[i + 1 < n ? i + 1 : 0].tail;
    const Site head = { sites[next].x - at.x, sites[next].y - at.y };
    const uint32_t site[3] = { ridge[i].tail, next, apex };

    add_facet (trace, site, cone_facing (trace, site, &tail, &head),
               ++trace->n_events);
    tail = head;
  }
}

static void
add_round (Trace *trace, uint32_t i)
{
  const TraceLog *log = &trace->log;
  const LogRound said = log->rounds[i], next = trace_log_round_end (log, i);
  RoundRow *row = &trace->rounds[trace->n_rounds++];
  uint32_t step = trace->n_events + 1, k;

  row->facet = said.facet;
  row->site = said.site;
  row->select = step;
  row->first_visible = step + 1;
  for (k = said.visible; k < next.visible; k++)
    trace->facets[log->visible[k]].seen = ++step;
  row->last_visible = step;
  row->first_horizon = step + 1;
  row->last_horizon = step + next.horizon - said.horizon;
  row->first_cone = row->last_horizon + 1;
  trace->n_events = row->last_horizon;
  add_cone (trace, &log->horizon[said.horizon], next.horizon - said.horizon,
            said.site);
  row->last_cone = step = trace->n_events;
  row->first_retire = step + 1;
  for (k = said.retired; k < next.retired; k++)
    trace->facets[log->retired[k]].span.death = ++step;
  row->last_retire = step;
  trace->inserted[said.site] = step;
  row->end = step + next.claim - said.claim;
  trace->n_events = row->end;
}

static void
add_hull (Trace *trace)
{
  const TraceLog *log = &trace->log;
  uint32_t i;

  trace->facets = memory_room (4 + log->n_horizon, sizeof *trace->facets);
  trace->rounds = memory_room (log->n_rounds, sizeof *trace->rounds);
  add_simplex (trace);
  for (i = 0; i < log->n_rounds; i++)
    add_round (trace, i);
  trace->n_ridges = 6 + 2 * log->n_horizon;
  trace->n_claims = log->n_claims;
}

Trace *
trace_rows_new (const SiteSet *set, const Order *order, const TraceLog *log)
{
  Trace *trace = memory_new (1, sizeof *trace);
  uint32_t site;

  trace->set = set;
  trace->order = *order;
  trace->log = *log;
  trace_log_fit (&trace->log);
  trace->inserted = memory_room (set->n_sites, sizeof *trace->inserted);
  for (site = 0; site < set->n_sites; site++)
    trace->inserted[site] = STEP_NEVER;
  trace->n_events = log->n_duplicates;
  if (log->is_flat)
    add_flat (trace);
  else
    add_hull (trace);
  trace->n_events += 1;
  return trace;
}
