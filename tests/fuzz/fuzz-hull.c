/* Hulls of sites on a small integer grid, where ties are the rule: the first
 * byte is the side of the grid, the others are its nodes. */
#include "fuzz-check.h"

#include "fuzz.h"

enum { MOST = 32 };

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  Site sites[MOST];
  uint32_t n = 0;
  int side;
  SiteSet *set;
  Trace *trace;

  if (size == 0)
    return 0;
  side = 1 + data[0] % 16;
  for (size_t i = 1; i < size && n < MOST; i += 1) {
    sites[n] = (Site){ data[i] % 16 % side, data[i] / 16 % side };
    n += 1;
  }
  set = site_set_new (sites, n);
  fuzz_assert (set != NULL);
  fuzz_check_orders (set);
  trace = trace_record (set, &(Order){ ORDER_FURTHEST, 0 });
  fuzz_check_rounds (trace);
  trace_free (trace);
  site_set_free (set);
  return 0;
}
