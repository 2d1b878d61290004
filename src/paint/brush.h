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

/* Widths of what a style says nothing of. */
#define BRUSH_HALO_ALPHA 0.5
#define BRUSH_HALO_FILL_ALPHA 0.22
#define BRUSH_HALO_OUTLINE 0.7 /* of a polygon, times the halo's width */

/* How the strokes of a hatch run: normal · (x, y) is a multiple of step. */
typedef struct HatchDirection {
  double normal[2], step; /* px */
} HatchDirection;

/* Returns: the number of directions, 0 to 2. */
int brush_hatch_directions (const Style *style,
                            const Theme *theme,
                            HatchDirection directions[2]);

/* Calls @on_stroke for each stroke of a hatch within a convex polygon. */
typedef void (*BrushHatch) (const Pixel ends[2], void *user);
void brush_hatch (const Style *style,
                  const Theme *theme,
                  const Pixel *corners,
                  uint32_t n,
                  BrushHatch on_stroke,
                  void *user);

/* Whether a line of this style ends in half discs; else it ends square. */
bool brush_has_round_ends (const Style *style);

/* Strokes the path of @cr and forgets it: halo, then line; the casing apart,
 * so that casings of a chain do not cut its lines. */
void brush_casing (cairo_t *cr, const Style *style, const Theme *theme);
void brush_line (cairo_t *cr, const Style *style);

void brush_mark (cairo_t *cr, const Style *style, const Theme *theme, Pixel at);

/* Returns: how far a mark reaches from its middle, px. */
double brush_mark_reach (const Style *style);

#endif
