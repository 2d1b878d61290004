#include "coverage.h"

#include "memory.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static int
least (int a, int b)
{
  return a < b ? a : b;
}

static int
most (int a, int b)
{
  return a > b ? a : b;
}

void
coverage_init (Coverage *coverage, int width, int height)
{
  *coverage = (Coverage){ .width = width,
                          .height = height,
                          .clip = { 0, 0, width, height } };
}

void
coverage_clear (Coverage *coverage)
{
  free (coverage->cells);
  free (coverage->left);
  free (coverage->right);
}

static int
between (double value, int low, int high)
{
  return value < low ? low : value > high ? high : (int)value;
}

static void
forget_rows (Coverage *coverage, int from, int to)
{
  int row;

  for (row = from; row < to; row++) {
    coverage->left[row] = INT_MAX;
    coverage->right[row] = -1;
  }
}

/* Makes room for the box; what is new is 0. */
static void
make_room (Coverage *coverage)
{
  const PixelClip *box = &coverage->box;
  const uint32_t rows = (uint32_t)(box->bottom - box->top);
  const uint32_t cells = rows * (uint32_t)(box->right - box->left + 2);
  const uint32_t old_cells = coverage->cells_room;
  const uint32_t old_rows = coverage->left_room;

  if (cells > old_cells) {
    coverage->cells = memory_grow (coverage->cells, &coverage->cells_room,
                                   cells, sizeof *coverage->cells);
    memset (coverage->cells + old_cells, 0,
            (coverage->cells_room - old_cells) * sizeof *coverage->cells);
  }
  if (rows <= old_rows)
    return;
  coverage->left = memory_grow (coverage->left, &coverage->left_room, rows,
                                sizeof *coverage->left);
  coverage->right = memory_grow (coverage->right, &coverage->right_room, rows,
                                 sizeof *coverage->right);
  forget_rows (coverage, (int)old_rows, (int)coverage->left_room);
}

void
coverage_begin (Coverage *coverage, const double box[4])
{
  const PixelClip *clip = &coverage->clip;
  PixelClip *to = &coverage->box;

  to->left = between (floor (box[0]), clip->left, clip->right);
  to->top = between (floor (box[1]), clip->top, clip->bottom);
  to->right = between (ceil (box[2]), to->left, clip->right);
  to->bottom = between (ceil (box[3]), to->top, clip->bottom);
  make_room (coverage);
}

/* Places are whole numbers of parts of a pixel, and all sums are exact. */
#define PART_BITS 8
#define PARTS (1 << PART_BITS)

/* How finely slopes are counted: of an edge, as columns per row; within a row,
 * the other way round, where there is room for no more. */
#define SLOPE_BITS 32
#define ROW_SLOPE_BITS 23

typedef struct Place {
  int x, y;
} Place;

static int
in_parts (double px)
{
  const double above_zero = 1 << 24;

  return (int)(px * PARTS + (above_zero + 0.5)) - (int)above_zero;
}

static Place
place_of (Pixel pixel)
{
  return (Place){ in_parts (pixel.x), in_parts (pixel.y) };
}

/* What the parts of an edge within one row need to know of it. */
typedef struct Row {
  int *cells;        /* of the box */
  int *left, *right; /* the columns touched */
  int width;         /* of the box */
} Row;

/* Adds to one column what lies right of a piece of an edge that is @height
 * high, with a sign; @ends is the sum of how far its ends lie from the left
 * side of the column. */
static void
add_to_cell (int *cells, int column, int height, int ends)
{
  const int area = height * ends;

  cells[column] += height * 2 * PARTS - area;
  cells[column + 1] += area;
}

/* Adds the areas right of a piece of an edge within one row, which runs from
 * @low to @high, through several columns. How high it is where it comes to a
 * column follows from that column alone. */
static void
add_through (const Row *row, int low, int high, int height)
{
  const int sign = height < 0 ? -1 : 1;
  const uint64_t slope
      = ((uint32_t)(sign * height) << ROW_SLOPE_BITS) / (uint32_t)(high - low);
  const int last = (high - 1) >> PART_BITS;
  const int end = last < row->width ? last + 1 : row->width;
  int column = low >> PART_BITS;
  int from = low, at = 0;

  if (column < 0) {
    column = from = 0;
    at = (int)(slope * (uint32_t)-low >> ROW_SLOPE_BITS);
    row->cells[0] += sign * at * 2 * PARTS;
  }
  for (; column < end; column++) {
    const int start = column * PARTS;
    const int to = column < last ? start + PARTS : high;
    const int next = column < last
                         ? (int)(slope * (uint32_t)(to - low) >> ROW_SLOPE_BITS)
                         : sign * height;

    add_to_cell (row->cells, column, sign * (next - at), from + to - 2 * start);
    from = to;
    at = next;
  }
}

static void
add_to_row (const Row *row, int low, int high, int height)
{
  const int first = low >> PART_BITS, last = (high - 1) >> PART_BITS;
  const int end = high > low ? last : first;

  if (first >= row->width)
    return;
  if (end < 0)
    row->cells[0] += height * 2 * PARTS;
  else if (first == end)
    add_to_cell (row->cells, first, height, low + high - 2 * first * PARTS);
  else
    add_through (row, low, high, height);
  *row->left = least (*row->left, most (first, 0));
  *row->right = most (*row->right, most (least (end, row->width - 1), 0) + 1);
}

/* From @a down to @b, @sign tells which way the shape runs. What comes of a
 * part of an edge does not depend on what else of it lies in the box. */
static void
add_edge (Coverage *coverage, Place a, Place b, int sign)
{
  const PixelClip *box = &coverage->box;
  const int64_t slope
      = (int64_t)(b.x - a.x) * ((int64_t)1 << SLOPE_BITS) / (b.y - a.y);
  const int first = most (a.y >> PART_BITS, box->top);
  const int end = least ((b.y + PARTS - 1) >> PART_BITS, box->bottom);
  const int left = a.x - box->left * PARTS;
  int top = most (first * PARTS, a.y);
  int from = left + (int)((top - a.y) * slope >> SLOPE_BITS);
  int i;

  for (i = first; i < end; i++) {
    const int number = i - box->top;
    const int bottom = least ((i + 1) * PARTS, b.y);
    const int to = left + (int)((bottom - a.y) * slope >> SLOPE_BITS);
    const Row row = { &coverage->cells[number * (box->right - box->left + 2)],
                      &coverage->left[number], &coverage->right[number],
                      box->right - box->left };

    add_to_row (&row, least (from, to), most (from, to), sign * (bottom - top));
    top = bottom;
    from = to;
  }
}

static void
add_placed_edge (Coverage *coverage, Place from, Place to)
{
  const PixelClip *box = &coverage->box;
  const int right = box->right * PARTS;

  if (from.y == to.y || (from.x >= right && to.x >= right))
    return;
  if (from.y < to.y) {
    if (to.y > box->top * PARTS && from.y < box->bottom * PARTS)
      add_edge (coverage, from, to, 1);
  } else if (from.y > box->top * PARTS && to.y < box->bottom * PARTS)
    add_edge (coverage, to, from, -1);
}

void
coverage_edge (Coverage *coverage, Pixel from, Pixel to)
{
  add_placed_edge (coverage, place_of (from), place_of (to));
}

void
coverage_polygon (Coverage *coverage, const Pixel *corners, uint32_t n)
{
  Place last = place_of (corners[n - 1]);
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Place here = place_of (corners[i]);

    add_placed_edge (coverage, last, here);
    last = here;
  }
}

/* Paints one part of a row, evenly covered. */
static void
fill_run (uint32_t *pixels, int n, uint32_t colour, int sum)
{
  const uint32_t part
      = (uint32_t)((sum < 0 ? -sum : sum) + PARTS) >> (PART_BITS + 1);
  const uint32_t k = part < 256 ? part : 256;
  int i;

  if (k == 0)
    return;
  if (k == 256 && colour >> 24 == 255)
    for (i = 0; i < n; i++)
      pixels[i] = colour;
  else
    pixels_blend (pixels, n, pixel_scale (colour, k));
}

/* Returns: the first column from @from on, or @end, whose cell is not 0. */
static int
end_of_run (const int *cells, int from, int end)
{
  uint64_t two;

  for (; from + 2 <= end; from += 2) {
    memcpy (&two, &cells[from], sizeof two);
    if (two != 0)
      break;
  }
  while (from < end && cells[from] == 0)
    from++;
  return from;
}

/* Sums up a row, paints it, and forgets it. */
static void
fill_row (Coverage *coverage, int row, uint32_t *pixels, uint32_t colour)
{
  const int width = coverage->box.right - coverage->box.left;
  int *cells = &coverage->cells[row * (width + 2)];
  const int end = coverage->right[row] + 1;
  int sum = 0;
  int i = coverage->left[row];

  while (i < end) {
    const int next = end_of_run (cells, i + 1, end);

    sum += cells[i];
    cells[i] = 0;
    if (i < width && sum != 0)
      fill_run (pixels + i, least (next, width) - i, colour, sum);
    i = next;
  }
  /* What ends right of the box has left nothing at its end. */
  if (i < width && sum != 0)
    fill_run (pixels + i, width - i, colour, sum);
}

void
coverage_fill (Coverage *coverage,
               uint32_t *pixels,
               int stride,
               uint32_t colour)
{
  const PixelClip *box = &coverage->box;
  const int n_rows = box->bottom - box->top;
  int row;

  for (row = 0; row < n_rows; row++)
    if (coverage->left[row] <= coverage->right[row])
      fill_row (coverage, row,
                pixels + (ptrdiff_t)(row + box->top) * stride + box->left,
                colour);
  forget_rows (coverage, 0, n_rows);
}
