/* The result as JSON: one object, whose lists name sites by their number in
 * the file, from 0.
 *
 *   n           sites read
 *   dimension   of the distinct ones: -1 none, 0 one, 1 on a line, 2
 *   points      [[x, y], …], all of them as they were given
 *   duplicates  if any: [[i, j], …], site i equals j, the first such one; all
 *               other lists have j alone
 *   active      after a round alone: the sites inserted so far, of which all
 *               that follows speaks
 *   hull2d      corners of the hull in the plane, counter-clockwise; on a line
 *               its two ends
 *   segments    dimension 1 alone: [[i, j], …], neighbours on the line
 *   triangles   [[i, j, k], …], Delaunay, counter-clockwise
 *   voronoi
 *     vertices            [[x, y], …], one for each circle, however many
 *                         triangles share it; null beyond the double range
 *     vertex_of_triangle  dimension 2 alone: an index into vertices for each
 *                         triangle
 *     edges               between the cells of i and j: [i, j, u, v] from
 *                         vertex u to vertex v; a ray [i, j, u, -1, dx, dy];
 *                         a line [i, j, -1, -1, dx, dy, px, py] through p
 *   hull3d
 *     dimension           of the lifts: -1 … 3; below 3 there are no facets
 *     facets              [[i, j, k, …], …], counter-clockwise seen from
 *                         outside: lower ones are clockwise in the plane
 *     kinds               "lower", "upper" or "vertical", for each facet
 *
 * The order in lists is free but where it is said. A key may be added.
 */
#ifndef RESULT_JSON_H
#define RESULT_JSON_H

#include "result.h"

#include <stdio.h>

typedef struct ResultForm {
  bool is_whole;  /* all sites are inserted; else `active` lists them */
  bool is_merged; /* facets of one plane are one polygon (merged.h) */
} ResultForm;

/* Writes the triangulation, the diagram and the hull.
 *
 * Shape: one JSON object and a newline; every number reads back as the same
 *        double, whatever the locale.
 * Returns: false when writing failed (errno).
 */
bool result_json_write (const Result *result, ResultForm form, FILE *file);

#endif
