#include "squares.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

void
squares_init (
    Squares *squares, double width, double height, double scale, int side)
{
  squares->side = side;
  squares->per_px = scale / side;
  squares->columns = (int)ceil (width * squares->per_px);
  squares->rows = (int)ceil (height * squares->per_px);
  squares->is_marked
      = memory_new ((size_t)squares->columns * (size_t)squares->rows,
                    sizeof *squares->is_marked);
}

void
squares_clear (Squares *squares)
{
  free (squares->is_marked);
}

/* Squares that a box meets; right and bottom are in it. */
typedef struct Reach {
  int left, right, top, bottom;
} Reach;

static int
square_at (float px, float per_px, int most)
{
  const float square = px * per_px;

  return !(square > 0) ? 0 : square >= (float)most ? most : (int)square;
}

/* Returns: false when it lies outside the picture. */
static bool
reach_of (const Squares *squares, const PixelBox *box, Reach *reach)
{
  const float per_px = (float)squares->per_px;

  if (box->right <= 0 || box->bottom <= 0
      || box->left * per_px >= (float)squares->columns
      || box->top * per_px >= (float)squares->rows)
    return false;
  *reach = (Reach){ square_at (box->left, per_px, squares->columns - 1),
                    square_at (box->right, per_px, squares->columns - 1),
                    square_at (box->top, per_px, squares->rows - 1),
                    square_at (box->bottom, per_px, squares->rows - 1) };
  return true;
}

void
squares_mark (Squares *squares, const PixelBox *box)
{
  Reach reach;
  int row, column;

  if (!reach_of (squares, box, &reach))
    return;
  for (row = reach.top; row <= reach.bottom; row++)
    for (column = reach.left; column <= reach.right; column++)
      squares->is_marked[row * squares->columns + column] = true;
}

bool
squares_meet (const Squares *squares, const PixelBox *box)
{
  Reach reach;
  int row, column;

  if (!reach_of (squares, box, &reach))
    return false;
  for (row = reach.top; row <= reach.bottom; row++)
    for (column = reach.left; column <= reach.right; column++)
      if (squares->is_marked[row * squares->columns + column])
        return true;
  return false;
}

/* Marks along a segment, @reach px to all sides of it. */
static void
mark_segment (Squares *squares, const Pixel ends[2], double reach)
{
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y;
  const double length = fmax (fabs (dx), fabs (dy)) * squares->per_px;
  const int n = (int)ceil (fmax (length, 1));
  int i;

  for (i = 0; i < n; i++) {
    const double from = (double)i / n, to = (double)(i + 1) / n;
    const double x[2] = { ends[0].x + from * dx, ends[0].x + to * dx };
    const double y[2] = { ends[0].y + from * dy, ends[0].y + to * dy };
    const PixelBox box = { (float)(fmin (x[0], x[1]) - reach),
                           (float)(fmin (y[0], y[1]) - reach),
                           (float)(fmax (x[0], x[1]) + reach),
                           (float)(fmax (y[0], y[1]) + reach) };

    squares_mark (squares, &box);
  }
}

void
squares_mark_stroke (Squares *squares,
                     const Drawing *drawing,
                     const Stroke *stroke)
{
  const Pixel *pixels = &drawing->pixels[stroke->first];
  const double reach = stroke_reach (drawing, stroke);
  uint32_t i;

  if ((stroke->kind != STROKE_LINE && stroke->kind != STROKE_CASING)
      || stroke->n < 2) {
    squares_mark (squares, &stroke->box);
    return;
  }
  for (i = 0; i + 1 < stroke->n; i++)
    mark_segment (squares, &pixels[i], reach);
}

cairo_region_t *
squares_region (const Squares *squares)
{
  cairo_region_t *region = cairo_region_create ();
  int row, column, end;

  for (row = 0; row < squares->rows; row++)
    for (column = 0; column < squares->columns; column = end + 1) {
      const bool *marked = &squares->is_marked[row * squares->columns];
      cairo_rectangle_int_t part = { 0, row * squares->side, 0, squares->side };

      while (column < squares->columns && !marked[column])
        column++;
      for (end = column; end < squares->columns && marked[end]; end++)
        continue;
      part.x = column * squares->side;
      part.width = (end - column) * squares->side;
      if (part.width > 0)
        cairo_region_union_rectangle (region, &part);
    }
  return region;
}
