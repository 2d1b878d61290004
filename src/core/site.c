#include "site.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

int
site_compare (const Site *a, const Site *b)
{
  if (a->x != b->x)
    return a->x < b->x ? -1 : 1;
  if (a->y != b->y)
    return a->y < b->y ? -1 : 1;
  return 0;
}

static void
range_add_magnitude (SiteRange *range, double coordinate)
{
  const int exponent = coordinate != 0 ? ilogb (coordinate) : 0;

  if (coordinate == 0)
    return;
  if (exponent < range->lowest)
    range->lowest = exponent;
  if (exponent > range->highest)
    range->highest = exponent;
}

static bool
range_fits (const SiteRange *range)
{
  return range->lowest > range->highest
         || range->highest - range->lowest <= 2 * SITE_RANGE;
}

bool
site_range_add (SiteRange *range, const Site *site)
{
  range_add_magnitude (range, site->x);
  range_add_magnitude (range, site->y);
  return range_fits (range);
}

static bool
is_in_range (double coordinate)
{
  return coordinate == 0
         || (isfinite (coordinate) && abs (ilogb (coordinate)) <= SITE_RANGE);
}

bool
site_is_in_range (const Site *site)
{
  return is_in_range (site->x) && is_in_range (site->y);
}

/* Returns: the power of two nearest to 0 that, taken out of all coordinates,
 *          brings them into the range. */
static int
range_exponent (const SiteRange *range)
{
  if (range->lowest > range->highest)
    return 0;
  if (range->highest > SITE_RANGE)
    return range->highest - SITE_RANGE;
  if (range->lowest < -SITE_RANGE)
    return range->lowest + SITE_RANGE;
  return 0;
}

static bool
find_exponent (const Site *sites, uint32_t n_sites, int *exponent)
{
  SiteRange range = SITE_RANGE_INIT;

  for (uint32_t i = 0; i < n_sites; i += 1) {
    if (!isfinite (sites[i].x) || !isfinite (sites[i].y))
      return false;
    if (!site_range_add (&range, &sites[i]))
      return false;
  }
  *exponent = range_exponent (&range);
  return true;
}

/* Exact: the result is in the range. A negative zero becomes zero. */
static double
scale_down (double coordinate, int exponent)
{
  return coordinate == 0 ? 0 : ldexp (coordinate, -exponent);
}

typedef struct NumberedSite {
  Site at;
  uint32_t site;
} NumberedSite;

static int
compare_numbered (const void *left, const void *right)
{
  const NumberedSite *a = left, *b = right;
  const int order = site_compare (&a->at, &b->at);

  if (order != 0)
    return order;
  return a->site < b->site ? -1 : 1;
}

/* Fills set->first and set->n_distinct: equal sites become neighbours by
 * sorting, the lowest index first. */
static void
find_duplicates (SiteSet *set)
{
  NumberedSite *sorted = memory_new (set->n_sites, sizeof *sorted);

  for (uint32_t i = 0; i < set->n_sites; i += 1)
    sorted[i] = (NumberedSite){ set->sites[i], i };
  qsort (sorted, set->n_sites, sizeof *sorted, compare_numbered);

  for (uint32_t i = 0; i < set->n_sites; i += 1) {
    const bool is_duplicate
        = i > 0 && site_compare (&sorted[i - 1].at, &sorted[i].at) == 0;

    if (is_duplicate)
      set->first[sorted[i].site] = set->first[sorted[i - 1].site];
    else
      set->first[sorted[i].site] = sorted[i].site;
    set->n_distinct += is_duplicate ? 0 : 1;
  }
  free (sorted);
}

SiteSet *
site_set_new (const Site *sites, uint32_t n_sites)
{
  SiteSet *set;
  int exponent;

  if (!find_exponent (sites, n_sites, &exponent))
    return NULL;

  set = memory_new (1, sizeof *set);
  set->sites = memory_new (n_sites, sizeof *set->sites);
  set->first = memory_new (n_sites, sizeof *set->first);
  set->n_sites = n_sites;
  set->exponent = exponent;
  for (uint32_t i = 0; i < n_sites; i += 1)
    set->sites[i] = (Site){ scale_down (sites[i].x, exponent),
                            scale_down (sites[i].y, exponent) };
  find_duplicates (set);
  return set;
}

void
site_set_free (SiteSet *set)
{
  if (set == NULL)
    return;
  free (set->sites);
  free (set->first);
  free (set);
}

Site
site_set_given (const SiteSet *set, uint32_t site)
{
  const Site *scaled = &set->sites[site];

  return (Site){ ldexp (scaled->x, set->exponent),
                 ldexp (scaled->y, set->exponent) };
}

Extent
site_set_extent (const SiteSet *set)
{
  Extent extent = { { 0, 0 }, 1 };
  Site low, high;

  if (set->n_sites == 0)
    return extent;
  low = high = set->sites[0];
  for (uint32_t i = 1; i < set->n_sites; i += 1) {
    low.x = fmin (low.x, set->sites[i].x);
    low.y = fmin (low.y, set->sites[i].y);
    high.x = fmax (high.x, set->sites[i].x);
    high.y = fmax (high.y, set->sites[i].y);
  }
  extent.centre = (Site){ low.x / 2 + high.x / 2, low.y / 2 + high.y / 2 };
  if (set->n_distinct > 1)
    extent.radius = fmax (high.x - low.x, high.y - low.y) / 2;
  return extent;
}
