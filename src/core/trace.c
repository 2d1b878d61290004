#include "trace.h"

#include "hull-record.h"
#include "trace-rows.h"

#include <stdlib.h>

static Trace *
record (const SiteSet *set, const Order *order, const HullWishes *wishes)
{
  TraceLog log;

  trace_log_init (&log, set->n_sites);
  if (hull_record (set, order, wishes, &log))
    return trace_rows_new (set, order, &log);
  trace_log_clear (&log);
  return NULL;
}

Trace *
trace_record (const SiteSet *set, const Order *order)
{
  return record (set, order, &(HullWishes){ NULL, NULL, NULL });
}

Trace *
trace_record_while (const SiteSet *set,
                    const Order *order,
                    HullWanted is_wanted,
                    void *user)
{
  return record (set, order, &(HullWishes){ NULL, is_wanted, user });
}

Trace *
trace_record_chosen (const SiteSet *set, const HullChoices *choices)
{
  return record (set, &(Order){ ORDER_FURTHEST, 0 },
                 &(HullWishes){ choices, NULL, NULL });
}

void
trace_free (Trace *trace)
{
  if (trace == NULL)
    return;
  trace_log_clear (&trace->log);
  free (trace->facets);
  free (trace->rounds);
  free (trace->inserted);
  free (trace);
}

uint32_t
trace_round (const Trace *trace, uint32_t step)
{
  uint32_t low = 0, high = trace->n_rounds;

  /* Rounds before low begin at or before the step, those from high after. */
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
trace_base (const Trace *trace, uint32_t step)
{
  const uint32_t round = trace_round (trace, step);

  if (round == INDEX_NONE || step >= trace->rounds[round].last_retire)
    return step;
  return trace->rounds[round].select - 1;
}
