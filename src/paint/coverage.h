/* Coverage: how much of each pixel a shape covers, as the areas that its edges
 * cut off. Shapes that turn the same way add up to their union. All is counted
 * in whole numbers, where sums are the same in any order: a part of a picture
 * painted alone has the same pixels as in the whole, and what lies beside it
 * need not be added up.
 *
 * Source: Raph Levien's font-rs (2016), accumulation of signed areas.
 */
#ifndef COVERAGE_H
#define COVERAGE_H

#include "clip.h"

/* Device pixels; right and bottom are not in it. */
typedef struct PixelClip {
  int left, top, right, bottom;
} PixelClip;

typedef struct Coverage {
  int width, height; /* of the picture */
  PixelClip clip;    /* nothing is painted outside it */
  PixelClip box;     /* of the current shape, in the clip */
  int *cells;        /* of the box: its width + 2 for each row; all 0 between
                        two shapes */
  int *left, *right; /* per row of the box: the columns touched; left > right:
                        none */
  uint32_t cells_room, left_room, right_room;
} Coverage;

void coverage_init (Coverage *coverage, int width, int height);
void coverage_clear (Coverage *coverage);

/* Begins shapes that lie within @box, device pixels. */
void coverage_begin (Coverage *coverage, const double box[4]);

/* Adds an edge of a shape; all edges of it close a ring. */
void coverage_edge (Coverage *coverage, Pixel from, Pixel to);
void coverage_polygon (Coverage *coverage, const Pixel *corners, uint32_t n);

/* How a line is widened. */
typedef struct Widening {
  double width;
  double dash, gap; /* dash 0: solid */
  bool has_round_ends, is_closed;
} Widening;

/* Adds a line with round joins. */
void coverage_line (Coverage *coverage,
                    const Pixel *pixels,
                    uint32_t n,
                    const Widening *widening);

/* Lays a colour, 0xAARRGGBB premultiplied, over what is covered, and forgets
 * the shape. */
void coverage_fill (Coverage *coverage,
                    uint32_t *pixels,
                    int stride,
                    uint32_t colour);

/* Returns: part/256 of a premultiplied colour. */
static inline uint32_t
pixel_scale (uint32_t colour, uint32_t part)
{
  const uint32_t mask = 0xff00ff, half = 0x800080;
  const uint32_t rb = ((colour & mask) * part + half) >> 8;
  const uint32_t ag = ((colour >> 8) & mask) * part + half;

  return (rb & mask) | (ag & ~mask);
}

/* Lays a premultiplied colour over another. */
static inline uint32_t
pixel_over (uint32_t under, uint32_t over)
{
  const uint32_t alpha = over >> 24;

  return over + pixel_scale (under, 256 - alpha - (alpha >> 7));
}

/* Lays a colour over @n pixels. */
void pixels_blend (uint32_t *pixels, int n, uint32_t over);

#endif
