/* Sites whose lifts all lie in one plane: on one circle, on one line, or
 * fewer than four. There is no simplex, but there is a Delaunay triangulation
 * and a Voronoi diagram. */
#ifndef FLAT_H
#define FLAT_H

#include "site.h"

/* Puts the @n_active sites listed in @active in the order of their convex
 * hull: counter-clockwise round a circle, or along the line.
 *
 * Returns: the dimension of the sites: -1 none, 0 one, 1 on a line, 2.
 * Cost:    O(n log n).
 */
int flat_sort (const SiteSet *set, uint32_t *active, uint32_t n_active);

#endif
