/* What the parts of QuickHull share: the facets and the round in hand.
 * Private to simplex, outside, horizon and hull. */
#ifndef HULL_BUILDER_H
#define HULL_BUILDER_H

#include "event.h"
#include "order.h"

typedef struct HullFacet {
  uint32_t site[3];      /* counter-clockwise seen from outside */
  uint32_t neighbour[3]; /* neighbour[i] lies across site[i], site[i+1] */
  uint32_t outside;      /* head of the outside set, linked by next_outside */
  uint32_t outside_tail;
  uint32_t tested; /* the last round in which a site was tested against it */
  bool is_visible; /* the outcome of that test */
  bool is_retired;
} HullFacet;

typedef struct HorizonRidge {
  uint32_t site[2];      /* tail and head, visible facet on the left */
  uint32_t beyond;       /* the facet on the right, which is not visible */
  uint32_t beyond_index; /* of this ridge in the beyond facet */
} HorizonRidge;

typedef struct HullBuilder {
  const SiteSet *set;
  const HullHook *hook;

  HullFacet *facets;
  uint32_t n_facets, facets_room;
  uint32_t round;  /* 1 for the first insertion */
  uint32_t oldest; /* no facet before it has an outside set */

  uint32_t *next_outside; /* a site's follower in its outside set */
  uint32_t *claimed_by;   /* the facet whose outside set holds the site */
  uint32_t simplex[4];    /* its sites, base first, then the top */

  uint32_t *list; /* the order of insertion, or NULL: furthest */
  uint32_t list_position;

  uint32_t *visible;
  uint32_t n_visible, visible_room;
  HorizonRidge *horizon;
  uint32_t n_horizon, horizon_room;
  uint32_t first_cone; /* the round's cone: first_cone … n_facets - 1 */
} HullBuilder;

/* hull.c */
uint32_t hull_add_facet (HullBuilder *b, const uint32_t site[3]);
bool hull_sees (const HullBuilder *b, uint32_t site, uint32_t facet);
void
hull_tell (const HullBuilder *b, EventKind kind, uint32_t facet, uint32_t site);
void hull_tell_ridge (const HullBuilder *b,
                      EventKind kind,
                      uint32_t facet,
                      uint32_t site,
                      const uint32_t ridge[2]);

/* simplex.c: finds the first simplex.
 * Returns: false when all lifts lie in one plane. */
bool simplex_find (HullBuilder *b);
void simplex_build (HullBuilder *b);

/* outside.c: outside sets. */
void outside_partition (HullBuilder *b);
uint32_t outside_next_facet (HullBuilder *b);
uint32_t outside_select (HullBuilder *b, uint32_t facet);
void outside_redistribute (HullBuilder *b);

/* horizon.c: the visible facets and their boundary in loop order. */
void horizon_collect_visible (HullBuilder *b, uint32_t facet, uint32_t apex);
void horizon_collect (HullBuilder *b, uint32_t apex);

#endif
