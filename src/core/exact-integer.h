/* The signs in integers, for vectors whose coordinates are all whole numbers
 * of steps of one power of two. Found from the vectors alone: the largest
 * coordinate fixes the step. Private to exact.c.
 *
 * Up to 31 bits, which grids and sites set with a mouse need, 128 bits hold
 * the determinant. Up to 62 bits, which nearly all doubles of one magnitude
 * need, 256 bits do.
 *
 * Each function returns false when the vectors lie on no such grid, and has
 * then decided nothing.
 */
#ifndef EXACT_INTEGER_H
#define EXACT_INTEGER_H

#include "exact-vector.h"

/* Sign of v[0] × v[1]. */
bool integer_cross (const Vector v[2], int *sign);

/* Sign of Shewchuk's INCIRCLE: positive when the origin lies inside the
 * circle of the counter-clockwise triangle v[0] v[1] v[2]. */
bool integer_incircle (const Vector v[3], int *sign);

/* Sign of the determinant of v[0] v[1] v[2] less that of v[3] v[4] v[5]. */
bool integer_incircle_compare (const Vector v[6], int *sign);

/* Centre, to a few units in the last place, of the circle through the site at
 * v[0] from the origin and the two at v[1], v[2] from there. */
bool integer_circumcentre (const Vector v[3], Site *centre);

#endif
