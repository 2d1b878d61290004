/* Clipping: what of a scene lies before the eye and near the view, in
 * doubles, so that nothing far away ever reaches a painter. */
#ifndef CLIP_H
#define CLIP_H

#include "camera.h"

/* A place in a view, px, y down. */
typedef struct Pixel {
  double x, y;
} Pixel;

/* Projects the segment a, b and cuts it to the view widened by @margin px on
 * every side.
 *
 * Returns: false when nothing of it is left. */
bool clip_segment (const Projection *projection,
                   const Point3 segment[2],
                   double margin,
                   Pixel ends[2]);

/* Projects the convex polygon of @n points and cuts it to the view widened
 * by @margin px on every side.
 *
 * Shape:   @corners has room for CLIP_ROOM (n); they turn as the points do
 *          on the screen.
 * Returns: the number of corners, 0 when nothing is left. */
uint32_t clip_polygon (const Projection *projection,
                       const Point3 *points,
                       uint32_t n,
                       double margin,
                       Pixel *corners);

#define CLIP_ROOM(n) ((n) + 6)

/* Returns: whether @point lies before the eye; then its pixel is in *@pixel.
 */
bool clip_point (const Projection *projection, Point3 point, Pixel *pixel);

/* Cuts the segment to the rectangle low … high.
 *
 * Source:  Liang, Barsky 1984.
 * Returns: false when nothing of it is left. */
bool clip_to_rectangle (Pixel low, Pixel high, Pixel ends[2]);

/* Cuts the convex polygon in @corners, with room for n + 4, to the rectangle
 * low … high.
 *
 * Returns: the number of corners left. */
uint32_t
clip_polygon_to_rectangle (Pixel low, Pixel high, Pixel *corners, uint32_t n);

#endif
