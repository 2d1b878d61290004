/* The raster: drawings as pixels of an image, on the screen. Its pictures are
 * those of cairo (drawing_to_cairo), many times faster, because it knows that
 * all shapes are convex and all lines are short.
 *
 *   Raster *raster = raster_new (400, 400, 1);
 *
 *   raster_paint (raster, drawing, NULL);
 *   cairo_set_source_surface (cr, raster_get_surface (raster), 0, 0);
 */
#ifndef RASTER_H
#define RASTER_H

#include "squares.h"

typedef struct Raster Raster;

/* @scale is the number of device pixels per px. */
Raster *raster_new (double width, double height, double scale);
void raster_free (Raster *raster);

/* Paints the background and the drawing: all of it, or what lies in @squares.
 * A part painted alone has the same pixels as in the whole.
 *
 * Cost: O(strokes + pixels covered). */
void
raster_paint (Raster *raster, const Drawing *drawing, const Squares *squares);

/* Returns: the picture, borrowed; its device scale is the raster's. */
cairo_surface_t *raster_get_surface (Raster *raster);

#endif
