/* Room, where M bounds the coordinates: a square of a length and a cross
 * product are at most 2 M² in magnitude, and each of the three elements of
 * INCIRCLE 4 M⁴. The determinant is at most 8 M⁴: it is linear in each entry
 * of its rows (x, y, x² + y²), so that |x| = |y| = M and x² + y² = 0 or 2 M²
 * bound it; that is 2 M⁴ times three minors of ±1, and of three rows of ±1
 * two are parallel, so that one minor is 0 and the others at most 2.
 *
 * M = 2^31 - 1: lengths and cross products fit 64 bits, two elements 128, and
 * so does the determinant. M = 2^62: 128 bits, and 256.
 */
#include "exact-integer.h"

#include "exact-wide.h"

#include <math.h>
#include <string.h>

#define TWO_TO_31 0x1p31

/* A vector in steps of the grid. */
typedef struct Steps {
  int64_t x, y;
} Steps;

typedef enum Grid {
  GRID_NONE,
  GRID_SHORT, /* of less than 2^31 steps either way */
  GRID_LONG,  /* of less than 2^62 */
} Grid;

/* Returns: the power of two that brings the largest coordinate below 2^31 and
 *          no further, or 0 when that is no double. */
static inline double
scale_to_31_bits (const Vector *v, int n)
{
  const uint64_t bias = DBL_MAX_EXP - 1, mantissa = DBL_MANT_DIG - 1;
  double largest = 0, scale;
  uint64_t bits;

  for (int i = 0; i < n; i += 1) {
    const double x = fabs (v[i].x.high), y = fabs (v[i].y.high);
    const double larger = x > y ? x : y;

    largest = larger > largest ? larger : largest;
  }
  memcpy (&bits, &largest, sizeof bits);
  bits = 2 * bias + 30 - (bits >> mantissa);
  if (bits > 2 * bias)
    return 0;
  bits <<= mantissa;
  memcpy (&scale, &bits, sizeof scale);
  return scale;
}

/* Counts the whole steps in a value of at most 2^62 steps.
 *
 * Returns: the magnitude of the rest. */
static inline double
count (double value, double scale, int64_t *whole)
{
  const double steps = value * scale;

  *whole = (int64_t)steps;
  return fabs (steps - (double)*whole);
}

/* Returns: 0 when each vector is one of doubles that are whole steps. */
static inline double
count_short (const Vector *v, int n, double scale, Steps *steps)
{
  double rest = 0;

  for (int i = 0; i < n; i += 1)
    rest += fabs (v[i].x.low) + fabs (v[i].y.low)
            + count (v[i].x.high, scale, &steps[i].x)
            + count (v[i].y.high, scale, &steps[i].y);
  return rest;
}

/* The same with low words. The sums stay below 2^62: where a high word is
 * largest, so far below that its low word does not reach it. */
static inline double
count_long (const Vector *v, int n, double scale, Steps *steps)
{
  double rest = 0;

  for (int i = 0; i < n; i += 1) {
    int64_t x, y;

    rest += count (v[i].x.high, scale, &steps[i].x)
            + count (v[i].y.high, scale, &steps[i].y)
            + count (v[i].x.low, scale, &x) + count (v[i].y.low, scale, &y);
    steps[i].x += x;
    steps[i].y += y;
  }
  return rest;
}

/* @scale is scale_to_31_bits(). */
static inline Grid
find_grid (const Vector *v, int n, double scale, Steps *steps)
{
  if (scale == 0)
    return GRID_NONE;
  if (count_short (v, n, scale, steps) == 0)
    return GRID_SHORT;
  if (count_long (v, n, TWO_TO_31 * scale, steps) == 0)
    return GRID_LONG;
  return GRID_NONE;
}

static inline int64_t
short_cross (const Steps *v, const Steps *w)
{
  return v->x * w->y - v->y * w->x;
}

static inline Int128
long_cross (const Steps *v, const Steps *w)
{
  return (Int128)v->x * w->y - (Int128)v->y * w->x;
}

static inline Int128
long_square (const Steps *v)
{
  return (Int128)v->x * v->x + (Int128)v->y * v->y;
}

static inline Int128
short_element (const Steps *u, const Steps *v, const Steps *w)
{
  return (Int128)(u->x * u->x + u->y * u->y) * short_cross (v, w);
}

static inline Int128
short_incircle (const Steps s[3])
{
  return short_element (&s[0], &s[1], &s[2])
         + short_element (&s[1], &s[2], &s[0])
         + short_element (&s[2], &s[0], &s[1]);
}

static inline Wide
long_element (const Steps *u, const Steps *v, const Steps *w)
{
  return wide_multiply (long_square (u), long_cross (v, w));
}

static inline Wide
long_incircle (const Steps s[3])
{
  return wide_add (wide_add (long_element (&s[0], &s[1], &s[2]),
                             long_element (&s[1], &s[2], &s[0])),
                   long_element (&s[2], &s[0], &s[1]));
}

static inline int
compare (Int128 a, Int128 b)
{
  return (a > b) - (a < b);
}

bool
integer_cross (const Vector v[2], int *sign)
{
  Steps s[2];

  switch (find_grid (v, 2, scale_to_31_bits (v, 2), s)) {
  case GRID_SHORT:
    *sign = compare (short_cross (&s[0], &s[1]), 0);
    return true;
  case GRID_LONG:
    *sign = compare (long_cross (&s[0], &s[1]), 0);
    return true;
  case GRID_NONE:
    break;
  }
  return false;
}

bool
integer_incircle (const Vector v[3], int *sign)
{
  Steps s[3];

  switch (find_grid (v, 3, scale_to_31_bits (v, 3), s)) {
  case GRID_SHORT:
    *sign = compare (short_incircle (s), 0);
    return true;
  case GRID_LONG:
    *sign = wide_compare (long_incircle (s), (Wide){ 0, 0 });
    return true;
  case GRID_NONE:
    break;
  }
  return false;
}

bool
integer_incircle_compare (const Vector v[6], int *sign)
{
  Steps s[6];

  switch (find_grid (v, 6, scale_to_31_bits (v, 6), s)) {
  case GRID_SHORT:
    *sign = compare (short_incircle (s), short_incircle (s + 3));
    return true;
  case GRID_LONG:
    *sign = wide_compare (long_incircle (s), long_incircle (s + 3));
    return true;
  case GRID_NONE:
    break;
  }
  return false;
}

/* (plus plus_square - minus minus_square + coordinate divisor) / divisor */
static double
centre_coordinate (Wide plus, Wide minus, int64_t coordinate, Int128 divisor)
{
  const Wide offset = wide_add (plus, wide_negative (minus));
  const Wide numerator = wide_add (offset, wide_multiply (divisor, coordinate));

  return wide_round (numerator) / (double)divisor;
}

bool
integer_circumcentre (const Vector v[3], Site *centre)
{
  const double scale = scale_to_31_bits (v, 3);
  Steps s[3];
  const Grid grid = find_grid (v, 3, scale, s);

  if (grid == GRID_NONE)
    return false;

  const double step = 1 / (grid == GRID_LONG ? TWO_TO_31 * scale : scale);
  const Steps *b = &s[1], *c = &s[2];
  const Int128 divisor = 2 * long_cross (b, c);
  const Int128 b_square = long_square (b), c_square = long_square (c);

  centre->x
      = step
        * centre_coordinate (wide_multiply (b_square, c->y),
                             wide_multiply (c_square, b->y), s[0].x, divisor);
  centre->y
      = step
        * centre_coordinate (wide_multiply (c_square, b->x),
                             wide_multiply (b_square, c->x), s[0].y, divisor);
  return true;
}
