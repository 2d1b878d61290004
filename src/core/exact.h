/* Exact arithmetic behind predicate.h, for what its filter leaves: integers
 * where the sites lie on a grid (exact-integer.h), else 106 bits with a bound
 * (exact-double-word.h), else expansions (exact-expansion.h). Never wrong
 * within SITE_RANGE.
 *
 * Cost: about 10, 40, 100 and 1000 ns for the sign of lift_orient() on a
 *       grid of 31 bits, on one of 62, by double words, and by expansions.
 */
#ifndef EXACT_H
#define EXACT_H

#include "site.h"

int exact_orient (const Site *a, const Site *b, const Site *c);

/* Which of p and q lies further to the right of the line from a to b.
 *
 * Returns: +1 when p does, -1 when q does, 0 when they tie. */
int exact_further_right (const Site *a,
                         const Site *b,
                         const Site *p,
                         const Site *q);

int
exact_lift_orient (const Site *a, const Site *b, const Site *c, const Site *d);
int exact_lift_further (const Site plane[3], const Site *p, const Site *q);

/* Centre of the circle through a, b, c, which are not collinear.
 *
 * Returns: the exact centre rounded to within a few units in the last place;
 *          infinite coordinates when it lies beyond the double range.
 */
Site exact_circumcentre (const Site *a, const Site *b, const Site *c);

#endif
