/* Thin straight lines, most of what a large picture consists of: painted
 * column by column, or row by row where they are steep. A pixel is covered as
 * much as the line covers the middle of its column. */
#ifndef THIN_LINE_H
#define THIN_LINE_H

#include "coverage.h"

/* Where pixels are painted. */
typedef struct PixelGrid {
  uint32_t *pixels;
  int stride; /* in pixels */
  PixelClip clip;
} PixelGrid;

/* Lines up to this width, device pixels; the ends of wider ones would show
 * that they are cut along the columns. */
#define THIN_LINE_WIDEST 3.0

/* Lays a premultiplied colour over the line from @ends[0] to @ends[1]. Its
 * dashes have square ends. */
void thin_line (const PixelGrid *grid,
                const Pixel ends[2],
                const Widening *widening,
                uint32_t colour);

#endif
