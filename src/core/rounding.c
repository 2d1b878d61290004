#include "rounding.h"

#include "memory.h"
#include "predicate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int
sign_of (double value)
{
  return (value > 0) - (value < 0);
}

int
rounded_orient (const Site *p, const Site *q, const Site *r)
{
  return sign_of ((q->x - p->x) * (r->y - p->y)
                  - (q->y - p->y) * (r->x - p->x));
}

/* Sign maps */

Site
sign_map_site (const SignMap *map, uint32_t column, uint32_t row)
{
  return (Site){ map->corner.x + column * map->step,
                 map->corner.y + row * map->step };
}

/* The last place of the larger coordinate; where both are zero, of @other. */
static double
last_place (const Site *site, const Site *other)
{
  double size = fmax (fabs (site->x), fabs (site->y));

  if (size == 0)
    size = fmax (fabs (other->x), fabs (other->y));
  return size == 0 ? 0x1p-53 : ldexp (1, ilogb (size) - 52);
}

static bool
is_in_range (const Site *site)
{
  return fabs (site->x) < 0x1p145 && fabs (site->y) < 0x1p145;
}

static void
fill (SignMap *map)
{
  uint32_t column, row;

  for (row = 0; row < SIGN_MAP_SIDE; row++)
    for (column = 0; column < SIGN_MAP_SIDE; column++) {
      const Site p = sign_map_site (map, column, row);
      const int rounded = rounded_orient (&p, &map->q, &map->r);
      const int exact = orient (&p, &map->q, &map->r);

      map->rounded[row][column] = (signed char)rounded;
      map->exact[row][column] = (signed char)exact;
      map->n_wrong += rounded != exact;
    }
}

bool
sign_map_init (SignMap *map, const Site *p, const Site *q, const Site *r)
{
  const double step = last_place (p, q);
  const Site corner = { p->x - SIGN_MAP_SIDE / 2.0 * step,
                        p->y - SIGN_MAP_SIDE / 2.0 * step };

  memset (map, 0, sizeof *map);
  map->corner = corner;
  map->step = step;
  map->q = *q;
  map->r = *r;
  if (step < 0x1p-145 || !is_in_range (p) || !is_in_range (q)
      || !is_in_range (r))
    return false;
  fill (map);
  return true;
}

/* Hulls */

static void
list_sites (RoundedHull *hull)
{
  const SiteSet *set = hull->set;
  uint32_t site;

  hull->order = memory_new (set->n_sites, sizeof *hull->order);
  for (site = 0; site < set->n_sites && hull->n_order < ROUNDED_MOST; site++)
    if (set->first[site] == site)
      hull->order[hull->n_order++] = site;
}

static Site
site_at (const RoundedHull *hull, uint32_t site)
{
  return site_set_given (hull->set, site);
}

static int
turn (const RoundedHull *hull, uint32_t a, uint32_t b, uint32_t c)
{
  const Site p = site_at (hull, a), q = site_at (hull, b);
  const Site r = site_at (hull, c);

  return rounded_orient (&p, &q, &r);
}

static int
true_turn (const RoundedHull *hull, uint32_t a, uint32_t b, uint32_t c)
{
  const Site *sites = hull->set->sites;

  return orient (&sites[a], &sites[b], &sites[c]);
}

/* The first two sites and the first off their line, as rounded signs have it;
 * the third is moved to the third place.
 *
 * Returns: false when there is none. */
static bool
begin (RoundedHull *hull)
{
  uint32_t *order = hull->order;
  uint32_t i = 2, third;
  int side = 0;

  for (; i < hull->n_order && side == 0; i++)
    side = turn (hull, order[0], order[1], order[i]);
  if (side == 0)
    return false;
  third = order[i - 1];
  memmove (order + 3, order + 2, (i - 3) * sizeof *order);
  order[2] = third;
  hull->corners[0] = order[0];
  hull->corners[1] = side > 0 ? order[1] : third;
  hull->corners[2] = side > 0 ? third : order[1];
  hull->n_corners = 3;
  hull->steps[hull->n_steps++]
      = (RoundedStep){ .kind = ROUNDED_TRIANGLE, .site = third };
  return true;
}

static uint32_t
after (const RoundedHull *hull, uint32_t edge)
{
  return (edge + 1) % hull->n_corners;
}

/* The turn of @site at an edge of the rounded hull. */
static int
turn_at (const RoundedHull *hull, uint32_t edge, uint32_t site)
{
  return turn (hull, hull->corners[edge], hull->corners[after (hull, edge)],
               site);
}

static void
count_wrong (const RoundedHull *hull, RoundedStep *step)
{
  uint32_t edge;

  for (edge = 0; edge < hull->n_corners; edge++) {
    const uint32_t tail = hull->corners[edge];
    const uint32_t head = hull->corners[after (hull, edge)];

    if (turn (hull, tail, head, step->site)
        == true_turn (hull, tail, head, step->site))
      continue;
    if (step->n_wrong == 0) {
      step->wrong[0] = tail;
      step->wrong[1] = head;
    }
    step->n_wrong += 1;
  }
}

/* Puts @site in the place of the corners between the first and the last edge
 * of the chain. */
static void
replace (RoundedHull *hull, const uint32_t chain[2], uint32_t site)
{
  uint32_t *corners = memory_new (hull->n_corners + 1, sizeof *corners);
  uint32_t n = 0, corner = after (hull, chain[1]);

  while (corner != chain[0]) {
    corners[n++] = hull->corners[corner];
    corner = after (hull, corner);
  }
  corners[n++] = hull->corners[chain[0]];
  corners[n++] = site;
  memcpy (hull->corners, corners, n * sizeof *corners);
  hull->n_corners = n;
  free (corners);
}

/* Finds the chain of edges that are seen or in line, from the first that is
 * seen.
 *
 * Returns: how many there are; all of them: there is no end. */
static uint32_t
find_chain (const RoundedHull *hull, uint32_t site, uint32_t chain[2])
{
  const uint32_t n = hull->n_corners;
  uint32_t edge = 0, n_seen = 1;

  while (edge < n && turn_at (hull, edge, site) >= 0)
    edge++;
  if (edge == n)
    return 0;
  chain[0] = chain[1] = edge;
  while (n_seen < n && turn_at (hull, after (hull, chain[1]), site) <= 0) {
    chain[1] = after (hull, chain[1]);
    n_seen++;
  }
  while (n_seen < n && turn_at (hull, (chain[0] + n - 1) % n, site) <= 0) {
    chain[0] = (chain[0] + n - 1) % n;
    n_seen++;
  }
  return n_seen;
}

static void
insert (RoundedHull *hull, uint32_t site)
{
  RoundedStep *step = &hull->steps[hull->n_steps++];
  uint32_t chain[2] = { 0, 0 };

  *step = (RoundedStep){ .kind = ROUNDED_INSERT, .site = site };
  count_wrong (hull, step);
  step->n_seen = find_chain (hull, site, chain);
  if (step->n_seen == 0)
    step->kind = ROUNDED_INSIDE;
  else if (step->n_seen == hull->n_corners)
    step->kind = ROUNDED_STUCK;
  else
    replace (hull, chain, site);
}

static int
compare_sites (const void *a, const void *b)
{
  return site_compare (a, b);
}

/* A site with its number, to be sorted from left to right. */
typedef struct Sorted {
  Site at; /* first, for the comparison */
  uint32_t site;
} Sorted;

/* Puts one chain of the hull on @corners, turning left with exact signs.
 *
 * Source: Andrew 1979, monotone chains. */
static uint32_t
add_chain (const RoundedHull *hull,
           const uint32_t *sites,
           uint32_t n_sites,
           uint32_t *corners)
{
  uint32_t i, n = 0;

  for (i = 0; i < n_sites; i++) {
    while (n >= 2
           && true_turn (hull, corners[n - 2], corners[n - 1], sites[i]) <= 0)
      n--;
    corners[n++] = sites[i];
  }
  return n > 0 ? n - 1 : 0;
}

/* The true hull of the sites tried so far. */
static void
find_true_hull (RoundedHull *hull, uint32_t n_tried)
{
  Sorted *sorted = memory_new (n_tried, sizeof *sorted);
  uint32_t *forwards = memory_new (n_tried, sizeof *forwards);
  uint32_t *backwards = memory_new (n_tried, sizeof *backwards);
  uint32_t i;

  for (i = 0; i < n_tried; i++)
    sorted[i] = (Sorted){ hull->set->sites[hull->order[i]], hull->order[i] };
  qsort (sorted, n_tried, sizeof *sorted, compare_sites);
  for (i = 0; i < n_tried; i++)
    forwards[i] = backwards[n_tried - 1 - i] = sorted[i].site;
  hull->true_corners
      = memory_new (2 * (size_t)n_tried + 2, sizeof *hull->true_corners);
  hull->n_true = add_chain (hull, forwards, n_tried, hull->true_corners);
  hull->n_true += add_chain (hull, backwards, n_tried,
                             hull->true_corners + hull->n_true);
  free (sorted);
  free (forwards);
  free (backwards);
}

static bool
has (const uint32_t *sites, uint32_t n, uint32_t site)
{
  uint32_t i;

  for (i = 0; i < n; i++)
    if (sites[i] == site)
      return true;
  return false;
}

bool
rounded_hull_has_corner (const RoundedHull *hull, bool is_exact, uint32_t site)
{
  return is_exact ? has (hull->true_corners, hull->n_true, site)
                  : has (hull->corners, hull->n_corners, site);
}

bool
rounded_hull_has_lost (const RoundedHull *hull, uint32_t site)
{
  return rounded_hull_has_corner (hull, true, site)
         && !rounded_hull_has_corner (hull, false, site);
}

static uint32_t
n_tried (const RoundedHull *hull)
{
  return hull->n_steps == 0 ? 0 : hull->n_steps + 2;
}

bool
rounded_hull_has_tried (const RoundedHull *hull, uint32_t site)
{
  return has (hull->order, n_tried (hull), site);
}

void
rounded_hull_init (RoundedHull *hull, const SiteSet *set, uint32_t n_steps)
{
  uint32_t i;

  memset (hull, 0, sizeof *hull);
  hull->set = set;
  list_sites (hull);
  hull->corners = memory_new (hull->n_order + 1, sizeof *hull->corners);
  hull->steps = memory_new (hull->n_order + 1, sizeof *hull->steps);
  if (n_steps > 0 && begin (hull))
    for (i = 3; i < hull->n_order && hull->n_steps < n_steps
                && hull->steps[hull->n_steps - 1].kind != ROUNDED_STUCK;
         i++)
      insert (hull, hull->order[i]);
  find_true_hull (hull, n_tried (hull));
  for (i = 0; i < hull->n_true; i++)
    hull->n_lost += rounded_hull_has_lost (hull, hull->true_corners[i]);
}

void
rounded_hull_clear (RoundedHull *hull)
{
  free (hull->order);
  free (hull->corners);
  free (hull->true_corners);
  free (hull->steps);
}
