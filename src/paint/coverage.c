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

/* The box does not follow the clip: sums must begin at the same column
 * whatever is painted. */
void
coverage_begin (Coverage *coverage, const double box[4])
{
  PixelClip *to = &coverage->box;

  to->left = between (floor (box[0]), 0, coverage->width);
  to->top = between (floor (box[1]), 0, coverage->height);
  to->right = between (ceil (box[2]), to->left, coverage->width);
  to->bottom = between (ceil (box[3]), to->top, coverage->height);
  make_room (coverage);
}

/* Adds the areas right of a piece of an edge within one row: @area is its
 * height, with a sign; it runs from column @low to @high. */
static void
add_to_row (float *cells, float low, float high, float area)
{
  const int first = (int)low, whole = (int)high;
  const int end = whole + ((float)whole < high);
  const float slope = 1 / (high - low);
  const float in = low - (float)first;
  const float out = high - (float)end + 1;
  const float start = 0.5F * slope * (1 - in) * (1 - in);
  const float last = 0.5F * slope * out * out;
  const float second = slope * (1.5F - in);
  int i;

  if (end <= first + 1) {
    const float middle = 0.5F * (low + high) - (float)first;

    cells[first] += area - area * middle;
    cells[first + 1] += area * middle;
    return;
  }
  cells[first] += area * start;
  if (end == first + 2) {
    cells[first + 1] += area * (1 - start - last);
  } else {
    cells[first + 1] += area * (second - start);
    for (i = first + 2; i < end - 1; i++)
      cells[i] += area * slope;
    cells[end - 1]
        += area * (1 - second - (float)(end - first - 3) * slope - last);
  }
  cells[end] += area * last;
}

static float
clamp (float value, float high)
{
  const float low = value > 0 ? value : 0;

  return low < high ? low : high;
}

/* From @a down to @b, in the box; @sign tells which way the shape runs. */
static void
add_edge (Coverage *coverage, const float a[2], const float b[2], float sign)
{
  const PixelClip *box = &coverage->box, *clip = &coverage->clip;
  const float slope = (b[0] - a[0]) / (b[1] - a[1]);
  const int width = box->right - box->left;
  const int end_of_edge = (int)b[1] + ((float)(int)b[1] < b[1]);
  const int end
      = least (end_of_edge, least (box->bottom, clip->bottom) - box->top);
  int row = most (a[1] > 0 ? (int)a[1] : 0, clip->top - box->top);

  for (; row < end; row++) {
    const float top = (float)row > a[1] ? (float)row : a[1];
    const float bottom = (float)(row + 1) < b[1] ? (float)(row + 1) : b[1];
    const float from = clamp (a[0] + (top - a[1]) * slope, (float)width);
    const float to = clamp (a[0] + (bottom - a[1]) * slope, (float)width);
    const float low = from < to ? from : to, high = from < to ? to : from;

    add_to_row (&coverage->cells[row * (width + 2)], low, high,
                sign * (bottom - top));
    coverage->left[row] = least (coverage->left[row], (int)low);
    coverage->right[row] = most (coverage->right[row], (int)high + 1);
  }
}

void
coverage_edge (Coverage *coverage, Pixel from, Pixel to)
{
  const PixelClip *box = &coverage->box;
  const float height = (float)(box->bottom - box->top);
  const float a[2]
      = { (float)(from.x - box->left), (float)(from.y - box->top) };
  const float b[2] = { (float)(to.x - box->left), (float)(to.y - box->top) };

  if (a[1] < b[1]) {
    if (b[1] > 0 && a[1] < height)
      add_edge (coverage, a, b, 1);
  } else if (b[1] < a[1]) {
    if (a[1] > 0 && b[1] < height)
      add_edge (coverage, b, a, -1);
  }
}

void
coverage_polygon (Coverage *coverage, const Pixel *corners, uint32_t n)
{
  uint32_t i;

  for (i = 0; i < n; i++)
    coverage_edge (coverage, corners[i], corners[i + 1 < n ? i + 1 : 0]);
}

/* Paints one part of a row, evenly covered. */
static void
fill_run (uint32_t *pixels, int n, uint32_t colour, float sum)
{
  const float part = sum < 0 ? -sum : sum;
  const uint32_t k = part > 0.998F ? 256 : (uint32_t)(part * 256);
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
end_of_run (const float *cells, int from, int end)
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

/* Sums up a row, paints what of it lies in the clip, and forgets it. */
static void
fill_row (Coverage *coverage, int row, uint32_t *pixels, uint32_t colour)
{
  const PixelClip *box = &coverage->box, *clip = &coverage->clip;
  const int width = box->right - box->left;
  float *cells = &coverage->cells[row * (width + 2)];
  const int end = least (coverage->right[row], width + 1) + 1;
  const int left = clip->left - box->left;
  const int right = least (clip->right - box->left, width);
  float sum = 0;
  int i = coverage->left[row];

  while (i < end) {
    const int next = end_of_run (cells, i + 1, end);
    const int first = most (i, left);

    sum += cells[i];
    cells[i] = 0;
    if (first < least (next, right))
      fill_run (pixels + first, least (next, right) - first, colour, sum);
    i = next;
  }
}

void
coverage_fill (Coverage *coverage,
               uint32_t *pixels,
               int stride,
               uint32_t colour)
{
  const PixelClip *box = &coverage->box, *clip = &coverage->clip;
  const int first = most (clip->top - box->top, 0);
  const int end = least (box->bottom, clip->bottom) - box->top;
  int row;

  for (row = first; row < end; row++)
    if (coverage->left[row] <= coverage->right[row])
      fill_row (coverage, row,
                pixels + (ptrdiff_t)(row + box->top) * stride + box->left,
                colour);
  if (first < end)
    forget_rows (coverage, first, end);
}
