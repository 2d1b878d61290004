/* Regions, which are not convex, in convex pieces. */
#include "gl-batch.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* Cuts the convex polygon @corners along the line from @a to @b: what lies
 * left of it into @left, what lies right into @right, each with room for
 * n + 2. */
static void
cut (const Pixel *corners,
     uint32_t n,
     const Pixel line[2],
     Pixel *sides[2],
     uint32_t n_sides[2])
{
  const double dx = line[1].x - line[0].x, dy = line[1].y - line[0].y;
  uint32_t i;

  n_sides[0] = n_sides[1] = 0;
  for (i = 0; i < n; i++) {
    const Pixel p = corners[i], q = corners[i + 1 < n ? i + 1 : 0];
    const double from = dx * (p.y - line[0].y) - dy * (p.x - line[0].x);
    const double to = dx * (q.y - line[0].y) - dy * (q.x - line[0].x);

    if (from >= 0)
      sides[0][n_sides[0]++] = p;
    if (from <= 0)
      sides[1][n_sides[1]++] = p;
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
      const double part = from / (from - to);
      const Pixel here = { p.x + part * (q.x - p.x), p.y + part * (q.y - p.y) };

      sides[0][n_sides[0]++] = here;
      sides[1][n_sides[1]++] = here;
    }
  }
}

/* Twice the area, positive when the ring turns as angles grow. */
static double
turn_of (const Pixel *ring, uint32_t n)
{
  double sum = 0;
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Pixel p = ring[i], q = ring[i + 1 < n ? i + 1 : 0];

    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

/* What lies in the outer ring and not in the inner one, in convex pieces: each
 * edge of the inner ring cuts off what lies beyond it. */
void
gl_batch_region (GlBatch *batch, const Stroke *stroke, const Pixel *pixels)
{
  const Pixel *inner = pixels + stroke->n_outer;
  const uint32_t n_inner = stroke->n - stroke->n_outer;
  const int outside = turn_of (inner, n_inner) > 0 ? 1 : 0;
  Pixel *room = memory_new (3 * (stroke->n + 8), 2 * sizeof *room);
  Pixel *rest = room, *sides[2];
  uint32_t i, n_rest = stroke->n_outer, n_sides[2];

  sides[0] = room + 2 * (stroke->n + 8);
  sides[1] = sides[0] + 2 * (stroke->n + 8);
  memcpy (rest, pixels, n_rest * sizeof *rest);
  if (n_inner == 0)
    gl_batch_fill (batch, rest, n_rest, stroke->fill);
  for (i = 0; i < n_inner && n_rest > 2; i++) {
    const Pixel line[2] = { inner[i], inner[i + 1 < n_inner ? i + 1 : 0] };

    cut (rest, n_rest, line, sides, n_sides);
    gl_batch_fill (batch, sides[outside], n_sides[outside], stroke->fill);
    n_rest = n_sides[!outside];
    memcpy (rest, sides[!outside], n_rest * sizeof *rest);
  }
  free (room);
}
