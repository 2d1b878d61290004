/* Brushes: a style put on shapes that are pixels already. What the scene's
 * painter and the legend's samples have in common. */
#ifndef BRUSH_H
#define BRUSH_H

#include "clip.h"
#include "theme.h"

#include <cairo.h>

void brush_colour (cairo_t *cr, Colour colour);

/* Fills and hatches a convex polygon, outlines it when the style has a width,
 * and lays its halo over it. */
void brush_polygon (cairo_t *cr,
                    const Style *style,
                    const Theme *theme,
                    const Pixel *corners,
                    uint32_t n);

/* Strokes the path of @cr and forgets it: halo, then line; the casing apart,
 * so that casings of a chain do not cut its lines. */
void brush_casing (cairo_t *cr, const Style *style, const Theme *theme);
void brush_line (cairo_t *cr, const Style *style);

void brush_mark (cairo_t *cr, const Style *style, const Theme *theme, Pixel at);

/* Returns: how far a mark reaches from its middle, px. */
double brush_mark_reach (const Style *style);

#endif
