#include "insertion-cost.h"

static void
count_cones (InsertionCost *cost, const Trace *trace, uint32_t step)
{
  double sum = 0;
  uint32_t i;

  for (i = 0; i < trace->n_rounds && trace->rounds[i].last_cone <= step; i++) {
    const RoundRow *row = &trace->rounds[i];

    cost->n_cones += 1;
    cost->cone_facets += row->last_cone - row->first_cone + 1;
    /* The first simplex has four sites, so round 1 inserts the fifth. */
    sum += 6 - 12.0 / (i + 5);
  }
  if (cost->n_cones > 0)
    cost->expected_cone = sum / cost->n_cones;
}

InsertionCost
insertion_cost (const Trace *trace, uint32_t step)
{
  InsertionCost cost = { .expected_cone = 0 };
  uint32_t i;

  for (i = 0; i < step; i++) {
    const EventKind kind = trace_event (trace, i).kind;

    cost.facets_created += kind == EVENT_SIMPLEX || kind == EVENT_CONE;
    cost.facets_seen += kind == EVENT_VISIBLE;
    cost.redistributions += kind == EVENT_CLAIM && i >= trace->start_end;
  }
  count_cones (&cost, trace, step);
  return cost;
}
