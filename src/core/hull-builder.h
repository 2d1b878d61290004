/* What the parts of QuickHull share: the facets and the round in hand.
 * Private to hull, simplex, outside, hand-over, horizon and walk.
 *
 * These parts are compiled twice from one source. As they are, they tell a
 * hook of every event. With HULL_BATCH they tell nothing, so that no event
 * costs anything; a cone takes over the numbers of the facets that retire, so
 * that only the hull is kept; and listed sites may be located by walking. */
#ifndef HULL_BUILDER_H
#define HULL_BUILDER_H

#include "event.h"
#include "hull-mesh.h"
#include "order.h"
#include "predicate.h"

#include <stddef.h>

#ifdef HULL_BATCH
#define hull_run batch_hull_run
#define hull_clear batch_hull_clear
#define simplex_find batch_simplex_find
#define simplex_build batch_simplex_build
#define outside_partition batch_outside_partition
#define outside_claim batch_outside_claim
#define outside_next_facet batch_outside_next_facet
#define outside_select batch_outside_select
#define outside_enqueue batch_outside_enqueue
#define outside_is_further batch_outside_is_further
#define hand_over batch_hand_over
#define horizon_collect_visible batch_horizon_collect_visible
#define horizon_collect batch_horizon_collect
#define walk_to batch_walk_to
#endif

typedef struct HorizonRidge {
  uint32_t tail;   /* its head is the tail of the next */
  HullEdge beyond; /* the edge in the facet that is not visible */
} HorizonRidge;

/* A facet with an outside set; stale when the facet's mark is another. */
typedef struct QueueEntry {
  uint32_t facet, birth;
} QueueEntry;

/* A facet of the cone as it looks from the apex: the determinant of a site
 * at d from the apex is area · |d|² - normal · d. */
typedef struct ConePlane {
  double area, normal_x, normal_y;
  double furthest;       /* the greatest determinant in its outside set */
  double furthest_doubt; /* and how far rounding may have moved it */
} ConePlane;

typedef struct HullBuilder {
  const Site *sites;
  uint32_t n_sites;
  const uint32_t *first; /* of a SiteSet; NULL: duplicates are found and
                            dropped on the way */
#ifndef HULL_BATCH
  const HullHook *hook;
#endif

  HullFacet *facets;
  uint32_t n_facets, facets_room;
  uint32_t round;      /* 1 for the first insertion */
  double doubt;        /* bounds rounding in the lift_orient() of any sites */
  double orient_doubt; /* and in their orient() */
  uint32_t simplex[4]; /* its sites, base first, then the top */

  /* The first n_listed sites to insert are listed; then the furthest of the
   * oldest facet. Listed sites wait in outside sets, or are walked to. */
  const uint32_t *list; /* all sites; NULL: as they come */
  uint32_t n_listed, list_position;
  bool walks;
  uint32_t near; /* where the next walk starts: a lower facet, or one of the
                    last cone */
  uint32_t *claimed_by; /* the facet a site waits at, while sites are listed
                           and not walked to */

  uint32_t *next_outside; /* a site's follower in its outside set */
  QueueEntry *queue;      /* oldest first, a ring of queue_room = 2^k */
  uint32_t queue_head, n_queue, queue_room;

  uint32_t *visible; /* in the batch build also the cone's numbers */
  uint32_t n_visible, visible_room;
  uint32_t *orphans; /* heads of the visible facets' outside sets */
  uint32_t n_orphans, orphans_room;
  HorizonRidge *horizon;
  uint32_t n_horizon, horizon_room;
  ConePlane *planes;
  uint32_t planes_room;
  uint32_t first_cone; /* the first number of the cone */

  HullCounts counts;
} HullBuilder;

/* hull.c: builds the hull of the sites; all else starts at zero.
 *
 * Returns: false when all lifts lie in one plane: nothing is built. */
bool hull_run (HullBuilder *b);

/* Frees all but the facets. */
void hull_clear (HullBuilder *b);

/* simplex.c: finds the first simplex, and builds it.
 *
 * Returns: false when all lifts lie in one plane. */
bool simplex_find (HullBuilder *b);
void simplex_build (HullBuilder *b);

/* outside.c: outside sets, and whose turn it is. */
void outside_partition (HullBuilder *b);
uint32_t outside_next_facet (HullBuilder *b);
uint32_t outside_select (HullBuilder *b, uint32_t facet);

/* Puts the site into the facet's outside set, at its head when it is the
 * furthest there. */
void
outside_claim (HullBuilder *b, uint32_t site, uint32_t facet, bool is_furthest);

/* Whether the site lies further from the facet than the head of its outside
 * set, exactly; a tie goes to the lower index. */
bool outside_is_further (const HullBuilder *b, uint32_t site, uint32_t facet);

/* Lets a facet that has an outside set wait for its turn. */
void outside_enqueue (HullBuilder *b, uint32_t facet);

/* hand-over.c: gives the orphans to the cone. */
void hand_over (HullBuilder *b, uint32_t apex);

/* horizon.c: the visible facets and their boundary in loop order. */
void horizon_collect_visible (HullBuilder *b, uint32_t facet, uint32_t apex);
void horizon_collect (HullBuilder *b, uint32_t apex);

/* walk.c: walks from the last cone through the shadows of lower facets.
 *
 * Returns: a facet that the site sees, or INDEX_NONE when the site equals a
 *          vertex of the hull. */
uint32_t walk_to (HullBuilder *b, uint32_t site);

/* The number of the cone's facet on horizon ridge @i. */
static inline uint32_t
hull_cone_facet (const HullBuilder *b, uint32_t i)
{
#ifdef HULL_BATCH
  return b->visible[i];
#else
  return b->first_cone + i;
#endif
}

/* An event that concerns no ridge. */
#define EVENT(kind, facet, site)                                               \
  (Event)                                                                      \
  {                                                                            \
    (kind), (facet), (site), { INDEX_NONE, INDEX_NONE }                        \
  }

static inline void
hull_tell (const HullBuilder *b, Event event)
{
#ifdef HULL_BATCH
  (void)b;
  (void)event;
#else
  if (b->hook != NULL)
    b->hook->on_event (&event, b->hook->user);
#endif
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

#endif
