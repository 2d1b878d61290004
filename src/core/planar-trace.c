#include "planar-trace.h"

#include "memory.h"

#include <stdlib.h>

/* Grows a table of the trace by one row. */
#define NEW_ROW(trace, rows)                                                   \
  ((trace)->n_##rows == (trace)->rows##_room                                   \
       ? (trace)->rows                                                         \
         = memory_grow ((trace)->rows, &(trace)->rows##_room,                  \
                        (trace)->n_##rows + 1, sizeof *(trace)->rows)          \
       : NULL,                                                                 \
   &(trace)->rows[(trace)->n_##rows++])

static PlanarRound *
last_round (PlanarTrace *trace)
{
  return trace->n_rounds > 0 ? &trace->rounds[trace->n_rounds - 1] : NULL;
}

/* A site is in one outside set at most, that of its latest claim. */
static void
end_claim (PlanarTrace *trace, uint32_t site, uint32_t step)
{
  const uint32_t claim = trace->claim_of[site];

  if (claim != INDEX_NONE)
    trace->claims[claim].span.death = step;
  trace->claim_of[site] = INDEX_NONE;
}

static void
record_claim (PlanarTrace *trace, const PlanarEvent *event, uint32_t step)
{
  end_claim (trace, event->site, step);
  trace->claim_of[event->site] = trace->n_claims;
  *NEW_ROW (trace, claims)
      = (PlanarClaim){ event->site, event->edge, { step, STEP_NEVER } };
}

static void
record_selection (PlanarTrace *trace, const PlanarEvent *event, uint32_t step)
{
  end_claim (trace, event->site, step);
  *NEW_ROW (trace, rounds) = (PlanarRound){ .edge = event->edge,
                                            .site = event->site,
                                            .select = step };
}

static void
record_edge (PlanarTrace *trace, const PlanarEvent *event, uint32_t step)
{
  PlanarEdge *row = NEW_ROW (trace, edges);
  int i;

  *row = (PlanarEdge){ .corner = { event->corner[0], event->corner[1] },
                       .round = trace->n_rounds,
                       .seen = STEP_NEVER,
                       .span = { step, STEP_NEVER } };
  for (i = 0; i < 2; i++)
    if (trace->corner_from[row->corner[i]] == STEP_NEVER)
      trace->corner_from[row->corner[i]] = step;
}

static void
record_row (PlanarTrace *trace, const PlanarEvent *event, uint32_t step)
{
  switch (event->kind) {
  case PLANAR_FLAT:
    trace->is_flat = true;
    break;
  case PLANAR_SIMPLEX:
  case PLANAR_CONE:
    record_edge (trace, event, step);
    break;
  case PLANAR_CLAIM:
    record_claim (trace, event, step);
    break;
  case PLANAR_IGNORE:
    end_claim (trace, event->site, step);
    trace->inside_from[event->site] = step;
    break;
  case PLANAR_SELECT:
    record_selection (trace, event, step);
    break;
  case PLANAR_VISIBLE:
    trace->edges[event->edge].seen = step;
    break;
  case PLANAR_RETIRE:
    trace->edges[event->edge].span.death = step;
    last_round (trace)->last_retire = step;
    break;
  case PLANAR_DUPLICATE:
  case PLANAR_HORIZON:
  case PLANAR_COMPLETE:
    break;
  }
}

static Phase
phase_of (PlanarKind kind, bool is_start)
{
  switch (kind) {
  case PLANAR_DUPLICATE:
  case PLANAR_FLAT:
  case PLANAR_SIMPLEX:
    return PHASE_SIMPLEX;
  case PLANAR_CLAIM:
  case PLANAR_IGNORE:
    return is_start ? PHASE_SIMPLEX : PHASE_HAND_OVER;
  case PLANAR_SELECT:
    return PHASE_CHOOSE;
  case PLANAR_VISIBLE:
    return PHASE_SEE;
  case PLANAR_HORIZON:
    return PHASE_HORIZON;
  case PLANAR_CONE:
    return PHASE_CONE;
  case PLANAR_RETIRE:
    return PHASE_HAND_OVER;
  case PLANAR_COMPLETE:
    return PHASE_COMPLETE;
  }
  return PHASE_START;
}

static void
on_event (const PlanarEvent *event, void *user)
{
  PlanarTrace *trace = user;
  uint32_t step;

  *NEW_ROW (trace, events) = *event;
  step = trace->n_events;
  record_row (trace, event, step);
  if (event->kind != PLANAR_COMPLETE && last_round (trace) != NULL)
    last_round (trace)->end = step;
  if (event->kind != PLANAR_COMPLETE && last_round (trace) == NULL)
    trace->start_end = step;
  course_add (
      &trace->course,
      (Place){ trace->n_rounds, phase_of (event->kind, trace->n_rounds == 0) });
}

PlanarTrace *
planar_trace_record (const SiteSet *set)
{
  PlanarTrace *trace = memory_new (1, sizeof *trace);
  const PlanarHook hook = { on_event, trace };
  uint32_t site;

  trace->set = set;
  trace->corner_from = memory_new (set->n_sites, sizeof *trace->corner_from);
  trace->inside_from = memory_new (set->n_sites, sizeof *trace->inside_from);
  trace->claim_of = memory_new (set->n_sites, sizeof *trace->claim_of);
  for (site = 0; site < set->n_sites; site++)
    trace->corner_from[site] = trace->inside_from[site] = trace->claim_of[site]
        = STEP_NEVER;
  planar_build (set, &hook);
  return trace;
}

void
planar_trace_free (PlanarTrace *trace)
{
  if (trace == NULL)
    return;
  free (trace->events);
  free (trace->edges);
  free (trace->claims);
  free (trace->rounds);
  free (trace->corner_from);
  free (trace->inside_from);
  free (trace->claim_of);
  course_clear (&trace->course);
  free (trace);
}

uint32_t
planar_trace_round (const PlanarTrace *trace, uint32_t step)
{
  uint32_t low = 0, high = trace->n_rounds;

  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;

    if (trace->rounds[middle].select <= step)
      low = middle + 1;
    else
      high = middle;
  }
  return low == 0 ? INDEX_NONE : low - 1;
}

uint32_t
planar_trace_base (const PlanarTrace *trace, uint32_t step)
{
  const uint32_t round = planar_trace_round (trace, step);

  if (round == INDEX_NONE || step >= trace->rounds[round].last_retire)
    return step;
  return trace->rounds[round].select - 1;
}
