/* Exact arithmetic behind predicate.h: expansions, sums of doubles that do
 * not overlap (Shewchuk 1997). Slow and never wrong within SITE_RANGE. */
#ifndef EXACT_H
#define EXACT_H

#include "site.h"

int exact_orient (const Site *a, const Site *b, const Site *c);
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
