/* Pictures divided into squares: which of them are to be painted, and what
 * lies in each. */
#ifndef SQUARES_H
#define SQUARES_H

#include "box-index.h"
#include "drawing.h"

#include <cairo.h>

typedef struct SquareGrid {
  int side; /* of a square, device pixels */
  int columns, rows;
  double per_px; /* squares per px */
} SquareGrid;

/* @scale device pixels to a px. */
SquareGrid square_grid_of (double width, double height, double scale, int side);

/* Squares that are marked. */
typedef struct Squares {
  SquareGrid grid;
  bool *is_marked;
} Squares;

void squares_init (Squares *squares, const SquareGrid *grid);
void squares_clear (Squares *squares);

/* Marks those that meet a box; that a stroke is painted on. Long lines do not
 * mark all that lies beside them. */
void squares_mark (Squares *squares, const PixelBox *box);
void squares_mark_stroke (Squares *squares,
                          const Drawing *drawing,
                          const Stroke *stroke);

/* Returns: whether a box meets any that is marked. */
bool squares_meet (const Squares *squares, const PixelBox *box);

/* Returns: a box round all that are marked, px, to find sooner what meets
 *          none. */
PixelBox squares_extents (const Squares *squares);

/* Marks what lies between those that are marked, where that is not much more:
 * one rectangle is painted sooner than the many that it is made of. */
void squares_close (Squares *squares);

/* Returns: (transfer full): what is marked, in device pixels. */
cairo_region_t *squares_region (const Squares *squares);

/* For each square a sum over the strokes and names that lie in it, in their
 * order. Where two drawings have equal sums, they have the same pixels. */
typedef struct SquareSums {
  SquareGrid grid;
  uint64_t *sums;
} SquareSums;

/* Marks in @squares where two drawings differ, whose names are of one
 * edition. */
void
drawing_compare (const Drawing *before, const Drawing *after, Squares *squares);

/* Draws the stock of @scene as drawing_set_stock() does, where @before may be
 * much like it: the stock of another scene, in the same projection and theme.
 * Items that look the same are not drawn anew, and @changed is marked where
 * the two differ.
 *
 * Returns: false: they may differ anywhere. */
bool drawing_set_stock_again (Drawing *drawing,
                              const Drawing *before,
                              const Scene *scene,
                              const Projection *projection,
                              const Theme *theme,
                              Squares *changed);

/* For drawing-diff.c: adds @mark to the sums of the squares that meet a box;
 * that a stroke is painted on. */
void square_sums_add (SquareSums *sums, const PixelBox *box, uint64_t mark);
void square_sums_add_stroke (SquareSums *sums,
                             const Drawing *drawing,
                             const Stroke *stroke,
                             uint64_t mark);

#endif
