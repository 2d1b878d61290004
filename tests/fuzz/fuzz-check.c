#include "fuzz-check.h"

#include "fuzz.h"

static uint32_t
check_result (const Result *result)
{
  char why[CERTIFY_ROOM] = "";
  uint32_t n_polygons;
  Merged merged;

  merged_init (&merged, result);
  if (!certify_result (result, why) || !certify_merged (&merged, result, why))
    fprintf (stderr, "%s\n", why);
  fuzz_assert (why[0] == '\0');
  n_polygons = merged.n_polygons;
  merged_clear (&merged);
  return n_polygons;
}

void
fuzz_check_orders (const SiteSet *set)
{
  uint32_t n_polygons = 0;

  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind += 1) {
    Result result;
    uint32_t n;

    result_init_batch (&result, set, &(Order){ kind, 1 });
    n = check_result (&result);
    fuzz_assert (kind == ORDER_FURTHEST || n == n_polygons);
    n_polygons = n;
    result_clear (&result);
  }
}

static void
check_step (const Trace *trace, uint32_t step)
{
  char why[CERTIFY_ROOM] = "";
  Frame frame;

  frame_init (&frame, trace, step);
  if (!certify_frame (&frame, why))
    fprintf (stderr, "step %u: %s\n", step, why);
  fuzz_assert (why[0] == '\0');
  frame_clear (&frame);
}

void
fuzz_check_rounds (const Trace *trace)
{
  check_step (trace, trace->start_end);
  for (uint32_t i = 0; i < trace->n_rounds; i += 1)
    check_step (trace, trace->rounds[i].end);
  check_step (trace, trace->n_events);
}
