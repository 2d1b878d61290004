/* The facets of a hull and how they hang together. */
#ifndef HULL_MESH_H
#define HULL_MESH_H

#include "site.h"

/* An edge of a facet as a number: facet · 4 + the index of its tail. */
typedef uint32_t HullEdge;

typedef struct HullFacet {
  uint32_t site[3];   /* counter-clockwise seen from outside */
  HullEdge across[3]; /* site[i], site[i+1] is this edge of the neighbour */
  uint32_t outside;   /* while building: head of its outside set, which is
                         the furthest site in it */
  uint32_t mark;      /* while building: the round of its birth, or the one in
                         which it was found visible */
} HullFacet;

static inline HullEdge
hull_next_edge (HullEdge edge)
{
  return (edge & 3) == 2 ? edge - 2 : edge + 1;
}

/* What the engine did, for the teaching numbers. */
typedef struct HullCounts {
  uint64_t facets_created;   /* simplex and cones */
  uint64_t visibility_tests; /* of a site against a facet, to find cavities */
  uint64_t redistributions;  /* of a site to a facet's outside set, the first
                                partition included */
  uint64_t walk_steps;       /* from facet to facet, to locate a site */
} HullCounts;

#endif
