/* Choices: what QuickHull leaves open. Any facet with an outside set may be
 * the next one, any of the furthest sites that tie may be its apex, and a
 * site may wait at any facet that it sees, of those that are new. Where
 * nothing is chosen the engine goes its own way (event.h).
 */
#ifndef CHOICE_H
#define CHOICE_H

#include "event.h"

/* One choice is the event that it leads to. */
typedef struct HullChoice {
  EventKind kind; /* SELECT or CLAIM */
  uint32_t round; /* from 1; 0: the first partition */
  uint32_t facet;
  uint32_t site; /* of SELECT, INDEX_NONE: the furthest of the facet */
} HullChoice;

/* Shape: any order; one SELECT for each round, one CLAIM for each round and
 *        site. */
typedef struct HullChoices {
  const HullChoice *rows;
  uint32_t n_rows;
} HullChoices;

/* Returns: the choice of @kind in @round, of a CLAIM that of @site, or NULL;
 *          @choices NULL: there is none. */
const HullChoice *hull_choices_find (const HullChoices *choices,
                                     EventKind kind,
                                     uint32_t round,
                                     uint32_t site);

#endif
