#include "trace.h"

#include "trace-recorder.h"

#include <stdlib.h>

Trace *
trace_record (const SiteSet *set, const Order *order)
{
  TraceRecorder *recorder = trace_recorder_new (set, order);
  const HullHook hook = { trace_recorder_hook, recorder };

  hull_build (set, order, &hook);
  return trace_recorder_finish (recorder);
}

Trace *
trace_record_chosen (const SiteSet *set, const HullChoices *choices)
{
  const Order order = { ORDER_FURTHEST, 0 };
  TraceRecorder *recorder = trace_recorder_new (set, &order);
  const HullHook hook = { trace_recorder_hook, recorder };

  hull_build_chosen (set, choices, &hook);
  return trace_recorder_finish (recorder);
}

void
trace_free (Trace *trace)
{
  if (trace == NULL)
    return;
  free (trace->events);
  free (trace->facets);
  free (trace->ridges);
  free (trace->claims);
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
