/* The signs on which everything rests. A filter in doubles settles nearly
 * all of them; exact.h settles the rest. None is ever rounded.
 *
 * Coordinates are those of SiteSet.sites.
 */
#ifndef PREDICATE_H
#define PREDICATE_H

#include "site.h"

#include <float.h>
#include <math.h>

/* Sign of the signed area of triangle abc.
 *
 * Returns: +1 when a, b, c turn left, -1 when they turn right, 0 when they
 *          are collinear.
 * Source:  Shewchuk 1997, ORIENT2D: stage A, then exact arithmetic.
 */
int orient (const Site *a, const Site *b, const Site *c);

/* Shewchuk 1997, ccwerrboundA. Whether orient() is the sign of @left - @right,
 * which are the products (a.x - c.x) (b.y - c.y) and (a.y - c.y) (b.x - c.x):
 * rounding cannot turn the sign of a larger area. */
static inline bool
orient_is_settled (double left, double right)
{
  /* Half a unit in the last place of 1; more than underflow can take away. */
  const double half_ulp = DBL_EPSILON / 2;

  return fabs (left - right)
         > (3 + 16 * half_ulp) * half_ulp * (fabs (left) + fabs (right))
               + DBL_MIN;
}

/* Side of the plane through the lifts of a, b, c on which the lift of d lies.
 *
 * Returns: +1 when d sees facet abc, that is when its lift lies strictly on
 *          the side from which the lifts of a, b, c turn counter-clockwise;
 *          -1 when it lies behind; 0 when the four lifts are coplanar, that
 *          is when the four sites lie on one circle or line.
 * Source:  Shewchuk 1997, INCIRCLE, with the opposite sign.
 */
int lift_orient (const Site *a, const Site *b, const Site *c, const Site *d);

/* Whether four sites lie on one circle or line, lift_orient() being 0; nearly
 * always without a call. The determinant is a sum of six products of at most
 * half the square of @reach, each off by less than 14 half ulps. */
static inline bool
is_on_circle (const Site *a, const Site *b, const Site *c, const Site *d)
{
  const double ax = a->x - d->x, ay = a->y - d->y;
  const double bx = b->x - d->x, by = b->y - d->y;
  const double cx = c->x - d->x, cy = c->y - d->y;
  const double a_square = ax * ax + ay * ay;
  const double b_square = bx * bx + by * by;
  const double c_square = cx * cx + cy * cy;
  const double reach = a_square + b_square + c_square;
  const double behind = a_square * (bx * cy - cx * by)
                        + b_square * (cx * ay - ax * cy)
                        + c_square * (ax * by - bx * ay);

  if (fabs (behind) > 6 * 16 * (DBL_EPSILON / 2) * reach * reach + DBL_MIN)
    return false;
  return lift_orient (a, b, c, d) == 0;
}

/* Which of two lifts lies further in front of the plane through the lifts of
 * plane[0], plane[1], plane[2]: compares the signed determinants, which for
 * one facet order as the perpendicular distance and the vertical gap do.
 *
 * Returns: +1 when p lies further in front than q, -1 when q does, 0 when
 *          they tie.
 */
int lift_further (const Site plane[3], const Site *p, const Site *q);

/* Where the outward normal of a facet points. */
typedef enum Facing {
  FACING_LOWER,    /* down: its shadow is a Delaunay triangle, clockwise */
  FACING_UPPER,    /* up: its shadow is counter-clockwise */
  FACING_VERTICAL, /* level: its shadow is a segment */
} Facing;

Facing facing (const Site *a, const Site *b, const Site *c);

#endif
