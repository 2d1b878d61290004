#include "insertion-cost.h"

/* How many of the steps first … last have been taken. */
static uint32_t
taken (uint32_t step, uint32_t first, uint32_t last)
{
  if (step < first)
    return 0;
  return (step < last ? step : last) - first + 1;
}

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

  if (!trace->is_flat)
    cost.facets_created
        = taken (step, trace->simplex_end - 3, trace->simplex_end);
  for (i = 0; i < trace->n_rounds && trace->rounds[i].select <= step; i++) {
    const RoundRow *row = &trace->rounds[i];

    cost.facets_created += taken (step, row->first_cone, row->last_cone);
    cost.facets_seen += taken (step, row->first_visible, row->last_visible);
    cost.redistributions += taken (step, row->last_retire + 1, row->end);
  }
  count_cones (&cost, trace, step);
  return cost;
}
