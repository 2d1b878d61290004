/* What the parts of QuickHull share: the facets and the round in hand.
 * Private to simplex, outside, horizon and hull. */
#ifndef HULL_BUILDER_H
#define HULL_BUILDER_H

#include "event.h"
#include "order.h"
#include "predicate.h"

#include <stddef.h>

/* An edge of a facet as a number: facet · 4 + the index of its tail. */
typedef uint32_t HullEdge;

typedef struct HullFacet {
  uint32_t site[3];   /* counter-clockwise seen from outside */
  HullEdge across[3]; /* the same edge in the neighbour */
  uint32_t outside;   /* head of the outside set: its furthest site */
  uint32_t mark;      /* the round of its birth, then that of its death */
} HullFacet;

typedef struct HorizonRidge {
  uint32_t tail;   /* its head is the tail of the next */
  HullEdge beyond; /* the edge in the facet that is not visible */
} HorizonRidge;

/* A facet of the cone as it looks from the apex: the determinant of a site
 * at d from the apex is area · |d|² - normal · d. */
typedef struct ConePlane {
  double area, normal_x, normal_y;
  double furthest;       /* the greatest determinant in its outside set */
  double furthest_doubt; /* and how far rounding may have moved it */
} ConePlane;

typedef struct HullBuilder {
  const SiteSet *set;
  const Site *sites; /* of the set */
  const HullHook *hook;

  HullFacet *facets;
  uint32_t n_facets, facets_room;
  uint32_t round; /* 1 for the first insertion */
  double doubt;   /* bounds the rounding of any four sites' determinant */

  uint32_t *next_outside; /* a site's follower in its outside set */
  uint32_t *queue;        /* facets with outside sets, oldest first */
  uint32_t queue_head, queue_tail, queue_room;
  uint32_t simplex[4]; /* its sites, base first, then the top */

  uint32_t *list; /* the order of insertion, or NULL: furthest */
  uint32_t list_position;
  uint32_t *claimed_by; /* with a list: the facet a site waits at */

  uint32_t *visible;
  uint32_t n_visible, visible_room;
  HorizonRidge *horizon;
  uint32_t n_horizon, horizon_room;
  ConePlane *planes;
  uint32_t planes_room;
  uint32_t first_cone; /* the round's cone: first_cone … n_facets - 1 */
} HullBuilder;

/* hull.c */
uint32_t hull_add_facet (HullBuilder *b, const uint32_t site[3]);

/* An event that concerns no ridge. */
#define EVENT(kind, facet, site)                                               \
  (Event)                                                                      \
  {                                                                            \
    (kind), (facet), (site), { INDEX_NONE, INDEX_NONE }                        \
  }

static inline void
hull_tell (const HullBuilder *b, Event event)
{
  if (b->hook != NULL)
    b->hook->on_event (&event, b->hook->user);
}

static inline HullEdge
hull_next_edge (HullEdge edge)
{
  return (edge & 3) == 2 ? edge - 2 : edge + 1;
}

/* lift_orient() > 0, with a filter for the whole set first. */
static inline bool
hull_sees (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  const uint32_t *corner = b->facets[facet].site;
  const Site *p = &b->sites[site], *s0 = &b->sites[corner[0]];
  const Site *s1 = &b->sites[corner[1]], *s2 = &b->sites[corner[2]];
  const double ax = s0->x - p->x, ay = s0->y - p->y;
  const double bx = s1->x - p->x, by = s1->y - p->y;
  const double cx = s2->x - p->x, cy = s2->y - p->y;
  const double behind = (ax * ax + ay * ay) * (bx * cy - cx * by)
                        + (bx * bx + by * by) * (cx * ay - ax * cy)
                        + (cx * cx + cy * cy) * (ax * by - bx * ay);

  if (behind > b->doubt)
    return false;
  if (behind < -b->doubt)
    return true;
  return lift_orient (s0, s1, s2, p) > 0;
}

/* simplex.c: finds the first simplex.
 * Returns: false when all lifts lie in one plane. */
bool simplex_find (HullBuilder *b);
void simplex_build (HullBuilder *b);

/* outside.c: outside sets. */
void outside_partition (HullBuilder *b);
uint32_t outside_next_facet (HullBuilder *b);
uint32_t outside_select (HullBuilder *b, uint32_t facet);
void outside_redistribute (HullBuilder *b, uint32_t apex);

/* horizon.c: the visible facets and their boundary in loop order. */
void horizon_collect_visible (HullBuilder *b, uint32_t facet, uint32_t apex);
void horizon_collect (HullBuilder *b, uint32_t apex);

#endif
