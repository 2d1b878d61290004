/* What stands at one step of a trace, by its spans, judged by brute force. */
#ifndef STANDING_H
#define STANDING_H

#include "fixture.h"
#include "judge.h"

typedef struct Standing {
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
} Standing;

Standing *
standing_new (const Fixture *fixture, const Judge *judge, uint32_t step);
void standing_free (Standing *standing);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Standing, standing_free)
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Judge, judge_free)

/* Returns: what the turn of the facet's shadow says it is. */
Facing standing_facing (const Standing *standing, uint32_t facet);

/* Returns: whether @site sees @facet, in the words of the plane: strictly
 *          inside the circle of a lower facet, strictly outside the circle of
 *          an upper one, strictly beyond the hull edge of a vertical one. */
bool standing_sees (const Standing *standing, uint32_t facet, uint32_t site);

/* Returns: (transfer full): the standing facets that @site sees: "0 1". */
char *standing_seen (const Standing *standing, uint32_t site);

/* Returns: the number of standing facets that face so. */
uint32_t standing_count (const Standing *standing, Facing facing);

/* Fails with the fixture's name and the step. */
#define standing_assert(standing, condition)                                   \
  G_STMT_START                                                                 \
  {                                                                            \
    if (!(condition))                                                          \
      g_error ("%s, step %u: not true: %s", (standing)->fixture->name,         \
               (standing)->step, #condition);                                  \
  }                                                                            \
  G_STMT_END

#endif
