/* Squares of a picture that are to be painted. */
#ifndef SQUARES_H
#define SQUARES_H

#include "box-index.h"
#include "drawing.h"

#include <cairo.h>

typedef struct Squares {
  int side; /* of each, device pixels */
  int columns, rows;
  double per_px; /* squares per px */
  bool *is_marked;
} Squares;

/* A picture of this size, @scale device pixels to a px. None is marked. */
void squares_init (
    Squares *squares, double width, double height, double scale, int side);
void squares_clear (Squares *squares);

/* Marks those that meet a box; that a stroke is painted on. Long lines do not
 * mark all that lies beside them. */
void squares_mark (Squares *squares, const PixelBox *box);
void squares_mark_stroke (Squares *squares,
                          const Drawing *drawing,
                          const Stroke *stroke);

/* Marks where two drawings of one size and theme differ; elsewhere they have
 * the same pixels. Their names must be of the same Names. */
void
drawing_compare (const Drawing *before, const Drawing *after, Squares *squares);

/* Returns: whether a box meets any that is marked. */
bool squares_meet (const Squares *squares, const PixelBox *box);

/* Returns: (transfer full): what is marked, in device pixels. */
cairo_region_t *squares_region (const Squares *squares);

#endif
