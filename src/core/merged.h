/* The hull of a result with neighbouring facets that lie in one plane merged
 * into one polygon: lower ones are the circle groups, upper ones the groups
 * of circles around all sites, vertical ones stand over hull edges with three
 * sites or more. Which diagonals the engine chose can no longer be told. */
#ifndef MERGED_H
#define MERGED_H

#include "result.h"

typedef struct Polygon {
  uint32_t first, n_sites; /* its part of Merged.sites */
  Facing facing;
} Polygon;

typedef struct Merged {
  Polygon *polygons;
  uint32_t n_polygons;
  uint32_t *sites; /* counter-clockwise seen from outside; a polygon starts
                      with its lowest site */
  uint32_t n_sites;
} Merged;

/* Sites on one circle are one polygon with two sides; on one line there is
 * none.
 *
 * Cost: linear. */
void merged_init (Merged *merged, const Result *result);
void merged_clear (Merged *merged);

#endif
