/* Lines as shapes: a rectangle for each segment, a wedge for each join, half a
 * disc for each round end. All turn the same way, and none overlaps another on
 * the outside. */
#include "coverage.h"

#include <math.h>

#define TURN 6.28318530717958647692
#define N_ARC 33 /* corners of half a disc at most */

/* A direction, length 1, turned by a quarter and as long as half the width. */
static bool
side_of (Pixel from, Pixel to, double half, Pixel *side)
{
  const double x = to.x - from.x, y = to.y - from.y;
  const double length = sqrt (x * x + y * y);

  if (!(length > 0))
    return false;
  *side = (Pixel){ -y / length * half, x / length * half };
  return true;
}

static Pixel
plus (Pixel a, Pixel b, double times)
{
  return (Pixel){ a.x + times * b.x, a.y + times * b.y };
}

static void
add_segment (Coverage *coverage, Pixel from, Pixel to, Pixel side)
{
  coverage_polygon (coverage,
                    (Pixel[4]){ plus (from, side, 1), plus (from, side, -1),
                                plus (to, side, -1), plus (to, side, 1) },
                    4);
}

/* A slice of a disc round @at, from @side on by @angle, which is positive. */
static void
add_slice (Coverage *coverage, Pixel at, Pixel side, double angle)
{
  const double radius = sqrt (side.x * side.x + side.y * side.y);
  const double wanted = ceil (angle / TURN * (8 + 6 * radius));
  const int n = wanted < 1 ? 1 : wanted < N_ARC - 2 ? (int)wanted : N_ARC - 2;
  Pixel corners[N_ARC];
  int i;

  corners[0] = at;
  for (i = 0; i <= n; i++) {
    const double c = cos (angle * i / n), s = sin (angle * i / n);

    corners[i + 1] = (Pixel){ at.x + c * side.x - s * side.y,
                              at.y + s * side.x + c * side.y };
  }
  coverage_polygon (coverage, corners, (uint32_t)n + 2);
}

/* The wedge on the outer side, where the line turns from @before to @after. So
 * flat a one is a triangle. */
#define FLAT 0.15

static void
add_join (Coverage *coverage, Pixel at, Pixel before, Pixel after)
{
  const double cross = before.x * after.y - before.y * after.x;
  const double dot = before.x * after.x + before.y * after.y;
  const double side = cross > 0 ? -1 : 1;
  double angle;

  if (fabs (cross) <= FLAT * dot) {
    coverage_polygon (
        coverage,
        (Pixel[3]){ at, plus (at, before, side), plus (at, after, side) }, 3);
    return;
  }
  angle = atan2 (fabs (cross), dot);
  if (cross > 0)
    add_slice (coverage, at, (Pixel){ -before.x, -before.y }, angle);
  else
    add_slice (coverage, at, after, angle);
}

/* On which sides of what is painted a place lies, with all that is within
 * @reach of it. What lies wholly on one side of it leaves nothing in any sum.
 */
enum { SIDE_ABOVE = 1, SIDE_BELOW = 2, SIDE_LEFT = 4, SIDE_RIGHT = 8 };

static unsigned
sides_of (const PixelClip *clip, Pixel at, double reach)
{
  return (at.y + reach < clip->top ? SIDE_ABOVE : 0U)
         | (at.y - reach > clip->bottom ? SIDE_BELOW : 0U)
         | (at.x + reach < clip->left ? SIDE_LEFT : 0U)
         | (at.x - reach > clip->right ? SIDE_RIGHT : 0U);
}

/* One dash, or all of a solid line. A long one lies beside the clip for the
 * most part. */
static void
add_dash (Coverage *coverage,
          const Pixel *pixels,
          uint32_t n,
          const Widening *widening)
{
  const double half = widening->width / 2, reach = half + 1;
  const unsigned start = sides_of (&coverage->clip, pixels[0], reach);
  Pixel side, first = { 0, 0 }, last = { 0, 0 };
  unsigned from = start, to = start;
  bool has_side = false;
  uint32_t i;

  for (i = 0; i + 1 < n; i++, from = to) {
    to = sides_of (&coverage->clip, pixels[i + 1], reach);
    if ((from & to) || !side_of (pixels[i], pixels[i + 1], half, &side))
      continue;
    add_segment (coverage, pixels[i], pixels[i + 1], side);
    /* Where nothing is left out, the last side is that of the segment before.
     */
    if (has_side && !from)
      add_join (coverage, pixels[i], last, side);
    else if (!has_side)
      first = side;
    last = side;
    has_side = true;
  }
  if (!has_side)
    return;
  if (widening->is_closed && !start)
    add_join (coverage, pixels[0], last, first);
  else if (widening->has_round_ends && !widening->is_closed) {
    if (!start)
      add_slice (coverage, pixels[0], first, TURN / 2);
    if (!to)
      add_slice (coverage, pixels[n - 1], (Pixel){ -last.x, -last.y },
                 TURN / 2);
  }
}

#define N_DASH 512 /* pixels of one dash at most */

/* A dash being gathered. */
typedef struct Dash {
  Coverage *coverage;
  const Widening *widening;
  Pixel pixels[N_DASH];
  uint32_t n;
} Dash;

static void
dash_add (Dash *dash, Pixel pixel)
{
  if (dash->n < N_DASH)
    dash->pixels[dash->n++] = pixel;
}

static void
dash_end (Dash *dash)
{
  if (dash->n > 1)
    add_dash (dash->coverage, dash->pixels, dash->n, dash->widening);
  dash->n = 0;
}

static void
add_dashes (Coverage *coverage,
            const Pixel *pixels,
            uint32_t n,
            const Widening *widening)
{
  Dash dash = { .coverage = coverage, .widening = widening };
  double left = widening->dash; /* of the current dash or gap */
  bool is_on = true;
  uint32_t i;

  dash_add (&dash, pixels[0]);
  for (i = 0; i + 1 < n; i++) {
    const Pixel a = pixels[i], b = pixels[i + 1];
    const double length
        = sqrt ((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    double at = 0;

    while (length - at > left) {
      const double part = (at += left) / length;
      const Pixel here = { a.x + part * (b.x - a.x), a.y + part * (b.y - a.y) };

      if (is_on) {
        dash_add (&dash, here);
        dash_end (&dash);
      } else {
        dash_add (&dash, here);
      }
      is_on = !is_on;
      left = is_on ? widening->dash : widening->gap;
    }
    left -= length - at;
    if (is_on)
      dash_add (&dash, b);
  }
  dash_end (&dash);
}

void
coverage_line (Coverage *coverage,
               const Pixel *pixels,
               uint32_t n,
               const Widening *widening)
{
  /* So short a period is no dash any more. */
  if (widening->dash > 0 && widening->dash + widening->gap > 0.05)
    add_dashes (coverage, pixels, n, widening);
  else
    add_dash (coverage, pixels, n, widening);
}
