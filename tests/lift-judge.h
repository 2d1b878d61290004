/* The signs of predicate.h in rational numbers of any length, from the
 * definition by lifts, not from the formula that the engine uses. */
#ifndef LIFT_JUDGE_H
#define LIFT_JUDGE_H

#include "site.h"

int lift_judge_orient (const Site *a, const Site *b, const Site *c);
int lift_judge_side (const Site plane[3], const Site *d);
int lift_judge_further (const Site plane[3], const Site *p, const Site *q);

#endif
