/* Bounds on rounding, where u = 2^-53: a sum is off by 3 u² of itself, a
 * product by 7 u² (Joldes, Muller, Popescu 2017, algorithms 6 and 10, to first
 * order). Let a magnitude be the same formula with all differences made sums.
 * A square of a length is then off by 10 u² of its magnitude, and so is a
 * cross product; their product by 27 u², a sum of three such by 33 u², a
 * difference of two sums by 36 u², a numerator of the centre by at most that.
 * DOUBT is 64 u²: it covers the terms of higher order and the rounding of the
 * magnitudes, too.
 */
#include "exact-double-word.h"

#include <math.h>

#define DOUBT 0x1p-100

/* A number and its magnitude, which bounds the error. */
typedef struct Bounded {
  DoubleWord value;
  double magnitude;
} Bounded;

/* Returns: a + b, where |a| >= |b|, exactly.
 * Source:  Dekker; Shewchuk 1997, theorem 6. */
static inline DoubleWord
fast_two_sum (double a, double b)
{
  const double sum = a + b;

  return (DoubleWord){ sum, b - (sum - a) };
}

static inline DoubleWord
negative (DoubleWord a)
{
  return (DoubleWord){ -a.high, -a.low };
}

/* Source: Joldes, Muller, Popescu 2017, AccurateDWPlusDW. */
static inline DoubleWord
add (DoubleWord a, DoubleWord b)
{
  const DoubleWord high = two_sum (a.high, b.high);
  const DoubleWord low = two_sum (a.low, b.low);
  const DoubleWord sum = fast_two_sum (high.high, high.low + low.high);

  return fast_two_sum (sum.high, low.low + sum.low);
}

/* Source: Joldes, Muller, Popescu 2017, DWTimesDW1. */
static inline DoubleWord
multiply (DoubleWord a, DoubleWord b)
{
  const DoubleWord product = two_product (a.high, b.high);
  const double cross = a.high * b.low + a.low * b.high;

  return fast_two_sum (product.high, product.low + cross);
}

static inline Bounded
bounded_add (Bounded a, Bounded b)
{
  return (Bounded){ add (a.value, b.value), a.magnitude + b.magnitude };
}

static inline Bounded
bounded_subtract (Bounded a, Bounded b)
{
  return bounded_add (a, (Bounded){ negative (b.value), b.magnitude });
}

static inline Bounded
bounded_multiply (Bounded a, Bounded b)
{
  return (Bounded){ multiply (a.value, b.value), a.magnitude * b.magnitude };
}

static inline Bounded
exactly (DoubleWord a)
{
  return (Bounded){ a, fabs (a.high) };
}

static inline Bounded
square (const Vector *v)
{
  const Bounded x = exactly (v->x), y = exactly (v->y);

  return bounded_add (bounded_multiply (x, x), bounded_multiply (y, y));
}

static inline Bounded
cross (const Vector *v, const Vector *w)
{
  return bounded_subtract (bounded_multiply (exactly (v->x), exactly (w->y)),
                           bounded_multiply (exactly (v->y), exactly (w->x)));
}

static Bounded
element (const Vector *u, const Vector *v, const Vector *w)
{
  return bounded_multiply (square (u), cross (v, w));
}

static Bounded
incircle (const Vector v[3])
{
  return bounded_add (bounded_add (element (&v[0], &v[1], &v[2]),
                                   element (&v[1], &v[2], &v[0])),
                      element (&v[2], &v[0], &v[1]));
}

static bool
sign_of (Bounded a, int *sign)
{
  *sign = a.value.high > 0 ? 1 : -1;
  return fabs (a.value.high) > DOUBT * a.magnitude;
}

bool
double_word_cross (const Vector v[2], int *sign)
{
  return sign_of (cross (&v[0], &v[1]), sign);
}

bool
double_word_incircle (const Vector v[3], int *sign)
{
  return sign_of (incircle (v), sign);
}

bool
double_word_incircle_compare (const Vector v[6], int *sign)
{
  return sign_of (bounded_subtract (incircle (v), incircle (v + 3)), sign);
}

/* Whether the high word is right to a unit in the last place. */
static bool
is_settled (Bounded a)
{
  return fabs (a.value.high) * (DBL_EPSILON / 2) > DOUBT * a.magnitude;
}

/* centre = (offset + coordinate * divisor) / divisor */
static bool
centre_coordinate (Bounded offset,
                   double coordinate,
                   Bounded divisor,
                   double *centre)
{
  const Bounded origin = exactly ((DoubleWord){ coordinate, 0 });
  const Bounded numerator
      = bounded_add (offset, bounded_multiply (origin, divisor));

  *centre = numerator.value.high / divisor.value.high;
  return is_settled (numerator) && is_settled (divisor);
}

bool
double_word_circumcentre (const Site *a, const Vector v[2], Site *centre)
{
  const Bounded b_x = exactly (v[0].x), b_y = exactly (v[0].y);
  const Bounded c_x = exactly (v[1].x), c_y = exactly (v[1].y);
  const Bounded b_square = square (&v[0]), c_square = square (&v[1]);
  const Bounded area = cross (&v[0], &v[1]);
  const Bounded divisor = bounded_add (area, area);
  const Bounded x = bounded_subtract (bounded_multiply (c_y, b_square),
                                      bounded_multiply (b_y, c_square));
  const Bounded y = bounded_subtract (bounded_multiply (b_x, c_square),
                                      bounded_multiply (c_x, b_square));

  return centre_coordinate (x, a->x, divisor, &centre->x)
         && centre_coordinate (y, a->y, divisor, &centre->y);
}
