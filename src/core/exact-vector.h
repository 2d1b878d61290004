/* What the exact stages start from: the way from one site to another, as
 * sums of two doubles that lose nothing. Private to the exact-*.c files and
 * simplex.c.
 *
 * Nothing overflows or underflows: in SITE_RANGE every coordinate is a
 * multiple of 2^-197 and less than 2^146, and no predicate multiplies more
 * than four of their differences, so that every term stays a multiple of
 * 2^-788 and less than 2^600.
 */
#ifndef EXACT_VECTOR_H
#define EXACT_VECTOR_H

#include "site.h"

#include <float.h>

/* Error-free sums need every operation rounded once, to double. */
_Static_assert(FLT_EVAL_METHOD == 0, "doubles are not computed as doubles");

/* high + low, where high is that sum rounded.
 * Source: Dekker 1971, who calls it a doublelength number. */
typedef struct DoubleWord {
  double high, low;
} DoubleWord;

typedef struct Vector {
  DoubleWord x, y;
} Vector;

/* Returns: a + b, exactly.
 * Source:  Knuth; Shewchuk 1997, theorem 7. */
static inline DoubleWord
two_sum (double a, double b)
{
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;

  return (DoubleWord){ sum, (a - a_virtual) + (b - b_virtual) };
}

/* Splits @a into two halves of at most 26 bits.
 * Source: Dekker; Shewchuk 1997, theorem 17. */
static inline double
split (double a, double *low)
{
  const double big = 134217729 * a; /* 2^27 + 1 */
  const double high = big - (big - a);

  *low = a - high;
  return high;
}

/* Returns: a b, exactly.
 * Source:  Dekker, Veltkamp; Shewchuk 1997, theorem 18. */
static inline DoubleWord
two_product (double a, double b)
{
  const double product = a * b;
  double a_low, b_low;
  const double a_high = split (a, &a_low);
  const double b_high = split (b, &b_low);
  const double rest = product - a_high * b_high - a_low * b_high;

  return (DoubleWord){ product, a_low * b_low - (rest - a_high * b_low) };
}

static inline Vector
vector_between (const Site *from, const Site *to)
{
  return (Vector){ two_sum (to->x, -from->x), two_sum (to->y, -from->y) };
}

#endif
