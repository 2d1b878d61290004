/* The hand-over: each site that waited at a retired facet goes to one cone
 * facet that it sees. All cone facets share the apex, so seen from there the
 * determinant of each is a short sum (ConePlane). */
#include "hull-builder.h"
#include "memory.h"

#include <assert.h>
#include <float.h>
#include <math.h>

/* A determinant as rounded, and how far off it may be. */
typedef struct Rounded {
  double value, doubt;
} Rounded;

/* A horizon site as seen from the apex. */
typedef struct Offset {
  double x, y, square;
} Offset;

static inline Offset
offset_of (const Site *site, const Site *apex)
{
  const double x = site->x - apex->x, y = site->y - apex->y;

  return (Offset){ x, y, x * x + y * y };
}

/* Writes the planes of the cone.
 *
 * Returns: the greatest distance of a horizon site from the apex. */
static double
write_planes (HullBuilder *b, const Site *apex)
{
  const uint32_t n = b->n_horizon;
  const Offset first = offset_of (&b->sites[b->horizon[0].tail], apex);
  Offset tail = first;
  double reach = 0;
  uint32_t i;

  if (n > b->planes_room)
    b->planes = memory_grow (b->planes, &b->planes_room, n, sizeof *b->planes);
  for (i = 0; i < n; i++) {
    const Offset head
        = i + 1 < n ? offset_of (&b->sites[b->horizon[i + 1].tail], apex)
                    : first;

    b->planes[i]
        = (ConePlane){ tail.x * head.y - tail.y * head.x,
                       tail.square * head.y - head.square * tail.y,
                       head.square * tail.x - tail.square * head.x, 0, 0 };
    if (tail.square > reach)
      reach = tail.square;
    tail = head;
  }
  return sqrt (reach);
}

/* Each of a determinant's three terms is off by less than 12 half ulps of its
 * greatest value, where |area| <= 2 reach² and |normal| <= 4 reach³. */
static inline double
doubt_at (const Offset *at, double reach)
{
  return 14 * (DBL_EPSILON / 2) * reach * reach
             * (2 * at->square + 4 * reach * (fabs (at->x) + fabs (at->y)))
         + DBL_MIN;
}

/* Whether a site that sees cone facet @i is the furthest so far. */
static inline bool
leads (HullBuilder *b, uint32_t site, uint32_t i, Rounded front)
{
  ConePlane *plane = &b->planes[i];
  const uint32_t facet = hull_cone_facet (b, i);
  const double doubt = front.doubt + plane->furthest_doubt;

  if (b->facets[facet].outside != INDEX_NONE) {
    if (front.value < plane->furthest - doubt)
      return false;
    if (front.value <= plane->furthest + doubt
        && !outside_is_further (b, site, facet))
      return false;
  }
  plane->furthest = front.value;
  plane->furthest_doubt = front.doubt;
  return true;
}

/* Gives the site to the first cone facet that it sees. Every lift is extreme,
 * so only a site that equals the apex sees none: it is done. */
static void
hand_over_one (HullBuilder *b, uint32_t site, const Site *apex, double reach)
{
  const Offset at = offset_of (&b->sites[site], apex);
  const double doubt = doubt_at (&at, reach);
  uint32_t i;

  for (i = 0; i < b->n_horizon; i++) {
    const ConePlane *plane = &b->planes[i];
    const double front = plane->area * at.square - plane->normal_x * at.x
                         - plane->normal_y * at.y;

    if (front > doubt
        || (front >= -doubt && hull_sees (b, site, hull_cone_facet (b, i)))) {
      outside_claim (b, site, hull_cone_facet (b, i),
                     leads (b, site, i, (Rounded){ front, doubt }));
      return;
    }
  }
  assert (at.square == 0);
  if (b->claimed_by != NULL)
    b->claimed_by[site] = INDEX_NONE;
}

void
hand_over (HullBuilder *b, uint32_t apex)
{
  const Site at = b->sites[apex];
  double reach = -1;
  uint32_t i, site, next;

  for (i = 0; i < b->n_orphans; i++)
    for (site = b->orphans[i]; site != INDEX_NONE; site = next) {
      next = b->next_outside[site];
      if (site == apex)
        continue;
      if (reach < 0)
        reach = write_planes (b, &at);
      hand_over_one (b, site, &at, reach);
    }
  if (reach >= 0)
    for (i = 0; i < b->n_horizon; i++)
      outside_enqueue (b, hull_cone_facet (b, i));
}
