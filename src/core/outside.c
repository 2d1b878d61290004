/* Outside sets: each waiting site belongs to just one facet that it sees.
 * They are a partition, not the lists of all sites that see a facet. */
#include "hull-builder.h"
#include "memory.h"
#include "predicate.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stddef.h>

/* Puts the site at the head of the facet's outside set, or behind it. */
static inline void
claim (HullBuilder *b, uint32_t site, uint32_t facet, bool is_furthest)
{
  HullFacet *row = &b->facets[facet];

  if (is_furthest) {
    b->next_outside[site] = row->outside;
    row->outside = site;
  } else {
    b->next_outside[site] = b->next_outside[row->outside];
    b->next_outside[row->outside] = site;
  }
  if (b->claimed_by != NULL)
    b->claimed_by[site] = facet;
  hull_tell (b, EVENT (EVENT_CLAIM, facet, site));
}

static void
enqueue (HullBuilder *b, uint32_t facet)
{
  if (b->facets[facet].outside == INDEX_NONE)
    return;
  if (b->queue_tail == b->queue_room)
    b->queue = memory_grow (b->queue, &b->queue_room, b->queue_tail + 1,
                            sizeof *b->queue);
  b->queue[b->queue_tail++] = facet;
}

/* Whether the site lies further from the facet than the head of its outside
 * set, exactly; a tie goes to the lower index. */
static bool
is_further (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  const HullFacet *row = &b->facets[facet];
  const Site *sites = b->sites;
  const uint32_t head = row->outside;
  const Site plane[3]
      = { sites[row->site[0]], sites[row->site[1]], sites[row->site[2]] };
  const int further = lift_further (plane, &sites[site], &sites[head]);

  return further > 0 || (further == 0 && site < head);
}

static bool
is_simplex_site (const HullBuilder *b, uint32_t site)
{
  const uint32_t *s = b->simplex;

  return site == s[0] || site == s[1] || site == s[2] || site == s[3];
}

/* Hands every site but the simplex to the first of its facets that it sees. */
void
outside_partition (HullBuilder *b)
{
  uint32_t site, facet;

  for (site = 0; site < b->set->n_sites; site++) {
    if (b->claimed_by != NULL)
      b->claimed_by[site] = INDEX_NONE;
    if (b->set->first[site] != site || is_simplex_site (b, site))
      continue;
    for (facet = 0; !hull_sees (b, site, facet); facet++)
      assert (facet < 3);
    claim (b, site, facet,
           b->facets[facet].outside == INDEX_NONE
               || is_further (b, site, facet));
  }
  for (facet = 0; facet < 4; facet++)
    enqueue (b, facet);
}

/* Facets get their outside sets at birth and join the queue then, so the
 * oldest comes first; those that have retired are passed over. */
static uint32_t
oldest_facet (HullBuilder *b)
{
  while (b->queue_head < b->queue_tail) {
    const uint32_t facet = b->queue[b->queue_head++];

    if (b->facets[facet].outside != INDEX_NONE)
      return facet;
  }
  return INDEX_NONE;
}

static uint32_t
facet_of_next_listed (HullBuilder *b)
{
  while (b->list_position < b->set->n_sites) {
    const uint32_t site = b->list[b->list_position];

    if (b->claimed_by[site] != INDEX_NONE)
      return b->claimed_by[site];
    b->list_position += 1;
  }
  return INDEX_NONE;
}

uint32_t
outside_next_facet (HullBuilder *b)
{
  return b->list != NULL ? facet_of_next_listed (b) : oldest_facet (b);
}

/* Takes the next site from the facet's outside set and begins a round. */
uint32_t
outside_select (HullBuilder *b, uint32_t facet)
{
  const uint32_t apex
      = b->list != NULL ? b->list[b->list_position] : b->facets[facet].outside;

  b->round += 1;
  if (b->claimed_by != NULL)
    b->claimed_by[apex] = INDEX_NONE;
  hull_tell (b, EVENT (EVENT_SELECT, facet, apex));
  return apex;
}

/* A determinant as rounded, and how far off it may be. */
typedef struct Rounded {
  double value, doubt;
} Rounded;

/* Whether a site that sees cone facet @i is the furthest so far. */
static bool
leads (HullBuilder *b, uint32_t site, uint32_t i, Rounded front)
{
  ConePlane *plane = &b->planes[i];
  const uint32_t facet = b->first_cone + i;
  const double doubt = front.doubt + plane->furthest_doubt;

  if (b->facets[facet].outside != INDEX_NONE) {
    if (front.value < plane->furthest - doubt)
      return false;
    if (front.value <= plane->furthest + doubt && !is_further (b, site, facet))
      return false;
  }
  plane->furthest = front.value;
  plane->furthest_doubt = front.doubt;
  return true;
}

/* Writes the planes of the cone.
 *
 * Returns: the greatest coordinate of a horizon site seen from the apex. */
static double
write_planes (HullBuilder *b, uint32_t apex)
{
  const uint32_t n = b->n_horizon;
  const Site p = b->sites[apex];
  const Site *u = &b->sites[b->horizon[0].tail];
  const double first_x = u->x - p.x, first_y = u->y - p.y;
  const double first_square = first_x * first_x + first_y * first_y;
  double ax = first_x, ay = first_y, a_square = first_square;
  double reach = 0;
  uint32_t i;

  if (n > b->planes_room)
    b->planes = memory_grow (b->planes, &b->planes_room, n, sizeof *b->planes);
  for (i = 0; i < n; i++) {
    ConePlane *plane = &b->planes[i];
    double bx = first_x, by = first_y, b_square = first_square;

    if (i + 1 < n) {
      u = &b->sites[b->horizon[i + 1].tail];
      bx = u->x - p.x;
      by = u->y - p.y;
      b_square = bx * bx + by * by;
    }
    plane->area = ax * by - ay * bx;
    plane->normal_x = a_square * by - b_square * ay;
    plane->normal_y = b_square * ax - a_square * bx;
    if (a_square > reach)
      reach = a_square;
    ax = bx;
    ay = by;
    a_square = b_square;
  }
  return sqrt (reach);
}

/* Each of a determinant's three terms is off by less than 12 half ulps of its
 * greatest value, where |area| <= 2 reach² and |normal| <= 4 reach³. */
static double
doubt_at (double x, double y, double square, double reach)
{
  return 14 * (DBL_EPSILON / 2) * reach * reach
             * (2 * square + 4 * reach * (fabs (x) + fabs (y)))
         + DBL_MIN;
}

/* Gives the site to the first cone facet that it sees. The determinant that
 * says so also tells how far in front the site lies. */
static void
hand_over (HullBuilder *b, uint32_t site, const Site *apex, double reach)
{
  const double x = b->sites[site].x - apex->x;
  const double y = b->sites[site].y - apex->y;
  const double square = x * x + y * y;
  const double doubt = doubt_at (x, y, square, reach);
  uint32_t i;
  double front = 0;

  for (i = 0; i < b->n_horizon; i++) {
    const ConePlane *plane = &b->planes[i];

    front = plane->area * square - plane->normal_x * x - plane->normal_y * y;
    if (front > doubt
        || (front >= -doubt && hull_sees (b, site, b->first_cone + i)))
      break;
  }
  /* Every lift is extreme: nothing is ever discarded. */
  assert (i < b->n_horizon);
  claim (b, site, b->first_cone + i,
         leads (b, site, i, (Rounded){ front, doubt }));
}

/* Hands each outside site of the retired facets to one cone facet that it
 * sees. */
void
outside_redistribute (HullBuilder *b, uint32_t apex)
{
  const Site p = b->sites[apex];
  double reach = -1;
  uint32_t i, site, next;

  for (i = 0; i < b->n_visible; i++) {
    site = b->facets[b->visible[i]].outside;
    b->facets[b->visible[i]].outside = INDEX_NONE;
    for (; site != INDEX_NONE; site = next) {
      next = b->next_outside[site];
      if (site == apex)
        continue;
      if (reach < 0)
        reach = write_planes (b, apex);
      hand_over (b, site, &p, reach);
    }
  }
  if (reach >= 0)
    for (i = 0; i < b->n_horizon; i++)
      enqueue (b, b->first_cone + i);
}
