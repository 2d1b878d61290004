#include "squares.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

/* How many times as large a rectangle may be as what is marked of it. */
#define CLOSE_MOST 3

SquareGrid
square_grid_of (double width, double height, double scale, int side)
{
  const double per_px = scale / side;

  return (SquareGrid){ side, (int)ceil (width * per_px),
                       (int)ceil (height * per_px), per_px };
}

void
squares_init (Squares *squares, const SquareGrid *grid)
{
  squares->grid = *grid;
  squares->is_marked = memory_new ((size_t)grid->columns * (size_t)grid->rows,
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
reach_of (const SquareGrid *grid, const PixelBox *box, Reach *reach)
{
  const float per_px = (float)grid->per_px;

  if (box->right <= 0 || box->bottom <= 0
      || box->left * per_px >= (float)grid->columns
      || box->top * per_px >= (float)grid->rows)
    return false;
  *reach = (Reach){ square_at (box->left, per_px, grid->columns - 1),
                    square_at (box->right, per_px, grid->columns - 1),
                    square_at (box->top, per_px, grid->rows - 1),
                    square_at (box->bottom, per_px, grid->rows - 1) };
  return true;
}

void
squares_mark (Squares *squares, const PixelBox *box)
{
  Reach reach;
  int row, column;

  if (!reach_of (&squares->grid, box, &reach))
    return;
  for (row = reach.top; row <= reach.bottom; row++)
    for (column = reach.left; column <= reach.right; column++)
      squares->is_marked[row * squares->grid.columns + column] = true;
}

bool
squares_meet (const Squares *squares, const PixelBox *box)
{
  Reach reach;
  int row, column;

  if (!reach_of (&squares->grid, box, &reach))
    return false;
  for (row = reach.top; row <= reach.bottom; row++)
    for (column = reach.left; column <= reach.right; column++)
      if (squares->is_marked[row * squares->grid.columns + column])
        return true;
  return false;
}

void
square_sums_add (SquareSums *sums, const PixelBox *box, uint64_t mark)
{
  Reach reach;
  int row, column;

  if (!reach_of (&sums->grid, box, &reach))
    return;
  for (row = reach.top; row <= reach.bottom; row++)
    for (column = reach.left; column <= reach.right; column++) {
      uint64_t *sum = &sums->sums[row * sums->grid.columns + column];

      *sum = (*sum ^ mark) * 0x9fb21c651e98df25U;
      *sum ^= *sum >> 32;
    }
}

/* Who is told of the boxes that a stroke is painted on. */
typedef struct Listener {
  const SquareGrid *grid;
  Squares *squares; /* to mark in; or NULL: */
  SquareSums *sums; /* to add to */
  uint64_t mark;
} Listener;

static void
tell (const Listener *listener, const PixelBox *box)
{
  if (listener->squares != NULL)
    squares_mark (listener->squares, box);
  else
    square_sums_add (listener->sums, box, listener->mark);
}

/* Tells of boxes along a segment, @reach px to all sides of it. */
static void
tell_segment (const Listener *listener, const Pixel ends[2], double reach)
{
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y;
  const double length = fmax (fabs (dx), fabs (dy)) * listener->grid->per_px;
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

    tell (listener, &box);
  }
}

/* A line that runs straight along the squares meets none beside it. */
static bool
is_slim (const SquareGrid *grid, const Stroke *stroke)
{
  const float width = stroke->box.right - stroke->box.left;
  const float height = stroke->box.bottom - stroke->box.top;

  return (width < height ? width : height) * (float)grid->per_px < 1;
}

static void
tell_stroke (const Listener *listener,
             const Drawing *drawing,
             const Stroke *stroke)
{
  const Pixel *pixels = &drawing->pixels[stroke->first];
  const bool is_line
      = stroke->kind == STROKE_LINE || stroke->kind == STROKE_CASING;
  double reach;
  uint32_t i;

  if (!is_line || stroke->n < 2 || is_slim (listener->grid, stroke)) {
    tell (listener, &stroke->box);
    return;
  }
  reach = stroke_reach (drawing, stroke);
  for (i = 0; i + 1 < stroke->n; i++)
    tell_segment (listener, &pixels[i], reach);
}

void
squares_mark_stroke (Squares *squares,
                     const Drawing *drawing,
                     const Stroke *stroke)
{
  const Listener listener = { .grid = &squares->grid, .squares = squares };

  tell_stroke (&listener, drawing, stroke);
}

void
square_sums_add_stroke (SquareSums *sums,
                        const Drawing *drawing,
                        const Stroke *stroke,
                        uint64_t mark)
{
  const Listener listener = { .grid = &sums->grid, .sums = sums, .mark = mark };

  tell_stroke (&listener, drawing, stroke);
}

/* Returns: the number of those that are marked; right and bottom are in
 *          @all. */
static int
reach_of_all (const Squares *squares, Reach *all)
{
  const SquareGrid *grid = &squares->grid;
  int row, column, n = 0;

  *all = (Reach){ grid->columns, -1, grid->rows, -1 };
  for (row = 0; row < grid->rows; row++)
    for (column = 0; column < grid->columns; column++) {
      if (!squares->is_marked[row * grid->columns + column])
        continue;
      n++;
      all->left = column < all->left ? column : all->left;
      all->right = column > all->right ? column : all->right;
      all->top = row < all->top ? row : all->top;
      all->bottom = row;
    }
  return n;
}

PixelBox
squares_extents (const Squares *squares)
{
  const double side = 1 / squares->grid.per_px;
  Reach all;

  if (reach_of_all (squares, &all) == 0)
    return (PixelBox){ -2e9F, -2e9F, -1e9F, -1e9F };
  return (PixelBox){ (float)(all.left * side), (float)(all.top * side),
                     (float)((all.right + 1) * side),
                     (float)((all.bottom + 1) * side) };
}

void
squares_close (Squares *squares)
{
  const SquareGrid *grid = &squares->grid;
  Reach all;
  const int n = reach_of_all (squares, &all);
  int row, column;

  if ((all.right - all.left + 1) * (all.bottom - all.top + 1) > CLOSE_MOST * n)
    return;
  for (row = all.top; row <= all.bottom; row++)
    for (column = all.left; column <= all.right; column++)
      squares->is_marked[row * grid->columns + column] = true;
}

cairo_region_t *
squares_region (const Squares *squares)
{
  const SquareGrid *grid = &squares->grid;
  cairo_region_t *region = cairo_region_create ();
  int row, column, end;

  for (row = 0; row < grid->rows; row++)
    for (column = 0; column < grid->columns; column = end + 1) {
      const bool *marked = &squares->is_marked[row * grid->columns];
      cairo_rectangle_int_t part = { 0, row * grid->side, 0, grid->side };

      while (column < grid->columns && !marked[column])
        column++;
      for (end = column; end < grid->columns && marked[end]; end++)
        continue;
      part.x = column * grid->side;
      part.width = (end - column) * grid->side;
      if (part.width > 0)
        cairo_region_union_rectangle (region, &part);
    }
  return region;
}
