/* QuickHull on the lifts of sites, after Barber, Dobkin, Huhdanpaa 1996,
 * restricted to three dimensions and to exact signs, so that no facet is
 * ever merged and no width is ever guessed.
 *
 * Its only output is the event stream (event.h).
 */
#ifndef HULL_H
#define HULL_H

#include "event.h"
#include "order.h"

/* Builds the convex hull of the lifts of @set, upper facets too.
 *
 * The first simplex is made of the first three distinct sites and the first
 * site after them whose lift is not coplanar with theirs.
 */
void hull_build (const SiteSet *set, const Order *order, const HullHook *hook);

/* The same as long as it is wanted, which is asked before each round: else the
 * events stop after a round, without EVENT_COMPLETE.
 *
 * Returns: false when it was given up. */
bool hull_build_while (const SiteSet *set,
                       const Order *order,
                       const HullHook *hook,
                       HullWanted is_wanted);

#endif
