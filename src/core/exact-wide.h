/* Integers of 128 and 256 bits. Private to exact-integer.c. */
#ifndef EXACT_WIDE_H
#define EXACT_WIDE_H

#include <stdint.h>

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

/* high 2^128 + low */
typedef struct Wide {
  Int128 high;
  Uint128 low;
} Wide;

static inline Wide
wide_add (Wide a, Wide b)
{
  const Uint128 low = a.low + b.low;

  return (Wide){ a.high + b.high + (low < a.low), low };
}

/* The product of factors below 2^126, by halves of 64 bits: the upper one
 * carries the sign. */
static inline Wide
wide_multiply (Int128 a, Int128 b)
{
  const int64_t a_upper = (int64_t)(a >> 64), b_upper = (int64_t)(b >> 64);
  const uint64_t a_lower = (uint64_t)a, b_lower = (uint64_t)b;
  const Int128 middle = (Int128)a_upper * b_lower + (Int128)b_upper * a_lower;
  const Wide outer = { (Int128)a_upper * b_upper, (Uint128)a_lower * b_lower };
  const Wide inner = { middle >> 64, (Uint128)middle << 64 };

  return wide_add (outer, inner);
}

static inline int
wide_compare (Wide a, Wide b)
{
  if (a.high != b.high)
    return a.high > b.high ? 1 : -1;
  return (a.low > b.low) - (a.low < b.low);
}

static inline Wide
wide_negative (Wide a)
{
  return (Wide){ -a.high - (a.low != 0), -a.low };
}

/* Returns: the number, right to a unit in the last place. */
static inline double
wide_round (Wide a)
{
  const Wide magnitude = a.high < 0 ? wide_negative (a) : a;
  const double sum = 0x1p128 * (double)magnitude.high + (double)magnitude.low;

  return a.high < 0 ? -sum : sum;
}

#endif
