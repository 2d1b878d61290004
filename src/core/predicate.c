#include "predicate.h"

#include "exact.h"

#include <float.h>
#include <math.h>

/* Half a unit in the last place of 1: the relative error of one rounding. */
#define HALF_ULP (DBL_EPSILON / 2)

/* Shewchuk 1997: iccerrboundA, times the sum of magnitudes;
 * COMPARE_DOUBT also covers the rounding of one difference. DBL_MIN is more
 * than underflow can take away. */
#define INCIRCLE_DOUBT ((10 + 96 * HALF_ULP) * HALF_ULP)
#define COMPARE_DOUBT (12 * HALF_ULP)

int
orient (const Site *a, const Site *b, const Site *c)
{
  const double left = (a->x - c->x) * (b->y - c->y);
  const double right = (a->y - c->y) * (b->x - c->x);

  if (orient_is_settled (left, right))
    return left > right ? 1 : -1;
  return exact_orient (a, b, c);
}

/* Shewchuk's INCIRCLE determinant in doubles: positive when @d lies inside
 * the circle of the counter-clockwise triangle abc, that is behind it.
 *
 * Returns: the determinant; *@magnitude bounds it and, with a factor, its
 *          error. */
static double
rounded_incircle (const Site *a,
                  const Site *b,
                  const Site *c,
                  const Site *d,
                  double *magnitude)
{
  const double ax = a->x - d->x, ay = a->y - d->y;
  const double bx = b->x - d->x, by = b->y - d->y;
  const double cx = c->x - d->x, cy = c->y - d->y;
  const double bxcy = bx * cy, cxby = cx * by;
  const double cxay = cx * ay, axcy = ax * cy;
  const double axby = ax * by, bxay = bx * ay;
  const double a_square = ax * ax + ay * ay;
  const double b_square = bx * bx + by * by;
  const double c_square = cx * cx + cy * cy;

  *magnitude = (fabs (bxcy) + fabs (cxby)) * a_square
               + (fabs (cxay) + fabs (axcy)) * b_square
               + (fabs (axby) + fabs (bxay)) * c_square;
  return a_square * (bxcy - cxby) + b_square * (cxay - axcy)
         + c_square * (axby - bxay);
}

int
lift_orient (const Site *a, const Site *b, const Site *c, const Site *d)
{
  double magnitude;
  const double behind = rounded_incircle (a, b, c, d, &magnitude);

  if (fabs (behind) > INCIRCLE_DOUBT * magnitude + DBL_MIN)
    return behind > 0 ? -1 : 1;
  return exact_lift_orient (a, b, c, d);
}

int
lift_further (const Site plane[3], const Site *p, const Site *q)
{
  const Site *a = &plane[0], *b = &plane[1], *c = &plane[2];
  double p_magnitude, q_magnitude;
  const double p_behind = rounded_incircle (a, b, c, p, &p_magnitude);
  const double q_behind = rounded_incircle (a, b, c, q, &q_magnitude);
  const double lead = q_behind - p_behind;
  const double doubt = COMPARE_DOUBT * (p_magnitude + q_magnitude) + DBL_MIN;

  if (fabs (lead) > doubt)
    return lead > 0 ? 1 : -1;
  return exact_lift_further (plane, p, q);
}

Facing
facing (const Site *a, const Site *b, const Site *c)
{
  const int turn = orient (a, b, c);

  if (turn == 0)
    return FACING_VERTICAL;
  return turn > 0 ? FACING_UPPER : FACING_LOWER;
}
