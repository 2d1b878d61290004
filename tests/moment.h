/* What stands at one step of a trace, by its spans, judged by brute force. */
#ifndef MOMENT_H
#define MOMENT_H

#include "fixture.h"
#include "judge.h"

typedef struct Moment {
  const Fixture *fixture;
  const Judge *judge;
  uint32_t step;
  uint32_t *facets; /* standing, ascending */
  uint32_t n_facets;
  uint32_t *active; /* sites on the hull, ascending */
  uint32_t n_active;
  uint32_t *corners; /* of the hull in the plane, counter-clockwise */
  uint32_t n_corners;
  uint32_t n_boundary; /* sites on its border, corners included */
} Moment;

Moment *moment_new (const Fixture *fixture, const Judge *judge, uint32_t step);
void moment_free (Moment *moment);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Moment, moment_free)
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Judge, judge_free)

/* Returns: what the turn of the facet's shadow says it is. */
Facing moment_facing (const Moment *moment, uint32_t facet);

/* Returns: whether @site sees @facet, in the words of the plane: strictly
 *          inside the circle of a lower facet, strictly outside the circle of
 *          an upper one, strictly beyond the hull edge of a vertical one. */
bool moment_sees (const Moment *moment, uint32_t facet, uint32_t site);

/* Returns: (transfer full): the standing facets that @site sees: "0 1". */
char *moment_seen (const Moment *moment, uint32_t site);

/* Returns: the number of standing facets that face so. */
uint32_t moment_count (const Moment *moment, Facing facing);

/* Fails with the fixture's name and the step. */
#define moment_assert(moment, condition)                                       \
  G_STMT_START                                                                 \
  {                                                                            \
    if (!(condition))                                                          \
      g_error ("%s, step %u: not true: %s", (moment)->fixture->name,           \
               (moment)->step, #condition);                                    \
  }                                                                            \
  G_STMT_END

#endif
