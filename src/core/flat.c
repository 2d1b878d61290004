#include "flat.h"

#include "memory.h"
#include "predicate.h"

#include <stdlib.h>
#include <string.h>

typedef struct NumberedSite {
  Site at;
  uint32_t site;
} NumberedSite;

static int
compare_numbered (const void *left, const void *right)
{
  const NumberedSite *a = left, *b = right;

  return site_compare (&a->at, &b->at);
}

/* Sorts @active from left to right. */
static void
sort_along (const SiteSet *set, uint32_t *active, uint32_t n_active)
{
  NumberedSite *sorted = memory_new (n_active, sizeof *sorted);

  for (uint32_t i = 0; i < n_active; i += 1)
    sorted[i] = (NumberedSite){ set->sites[active[i]], active[i] };
  qsort (sorted, n_active, sizeof *sorted, compare_numbered);
  for (uint32_t i = 0; i < n_active; i += 1)
    active[i] = sorted[i].site;
  free (sorted);
}

/* Turns the order from left to right into one round the circle: those right
 * of the line from the first to the last stay, those left of it come after,
 * backwards.
 *
 * Returns: whether there is one that is not on that line. */
static bool
sort_round (const SiteSet *set, uint32_t *active, uint32_t n_active)
{
  const Site *first = &set->sites[active[0]];
  const Site *last = &set->sites[active[n_active - 1]];
  uint32_t *round = memory_new (n_active, sizeof *round);
  uint32_t n_right = 0, n_left = 0;
  bool is_round = false;

  for (uint32_t i = 0; i < n_active; i += 1) {
    const int side = orient (first, last, &set->sites[active[i]]);

    is_round = is_round || side != 0;
    if (side > 0) {
      n_left += 1;
      round[n_active - n_left] = active[i];
    } else {
      round[n_right] = active[i];
      n_right += 1;
    }
  }
  memcpy (active, round, n_active * sizeof *round);
  free (round);
  return is_round;
}

int
flat_sort (const SiteSet *set, uint32_t *active, uint32_t n_active)
{
  if (n_active < 2)
    return (int)n_active - 1;
  sort_along (set, active, n_active);
  return sort_round (set, active, n_active) ? 2 : 1;
}
