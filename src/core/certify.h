/* Checks of results, independent of the code that made them and linear in
 * their size: local convexity at every ridge, one global argument, Euler.
 *
 * Source: Mehlhorn, Näher, Seel, Seidel, Schilz, Schirra, Uhrig 1999,
 *         "Checking geometric programs or verification of geometric
 *         structures"; Devillers, Liotta, Preparata, Tamassia 1998.
 */
#ifndef CERTIFY_H
#define CERTIFY_H

#include "frame.h"
#include "merged.h"

#define CERTIFY_ROOM 160

/* Checks that @facets (three sites each, counter-clockwise seen from outside)
 * are the convex hull of the lifts of the @n_active sites listed in @active,
 * which are distinct and not coplanar as lifts.
 *
 * Returns: true, or false with the first fault in words in @why.
 */
bool certify_hull (const SiteSet *set,
                   const uint32_t (*facets)[3],
                   uint32_t n_facets,
                   const uint32_t *active,
                   uint32_t n_active,
                   char why[CERTIFY_ROOM]);

/* Checks that the triangles are a Delaunay triangulation of the active
 * sites, with edges, groups, boundary and counts. Flat input too. */
bool certify_delaunay (const Delaunay *delaunay, char why[CERTIFY_ROOM]);

/* Checks that the diagram is the dual: one vertex a group, no edge of length
 * zero, centres within 1e-9 of equal distance, rays along outward normals. */
bool certify_voronoi (const Voronoi *voronoi, char why[CERTIFY_ROOM]);

/* All three, for a result; each triangle is the shadow of a facet. */
bool certify_result (const Result *result, char why[CERTIFY_ROOM]);

/* Checks that the polygons are those of the hull of the result, which
 * certify_result() accepts: flat, as large as can be, closed. */
bool certify_merged (const Merged *merged,
                     const Result *result,
                     char why[CERTIFY_ROOM]);

/* All three, for the triangulation and the hull that a frame shows. */
bool certify_frame (const Frame *frame, char why[CERTIFY_ROOM]);

#endif
