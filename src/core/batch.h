/* The batch engine: hulls without events, as fast as can be. It is the same
 * QuickHull, compiled without a hook. */
#ifndef BATCH_H
#define BATCH_H

#include "hull-mesh.h"
#include "order.h"

typedef struct Batch {
  HullFacet *facets; /* sites as given */
  uint32_t n_facets; /* 0 when the input is flat */
  bool is_whole;     /* or the lower hull alone */
  HullCounts counts;
} Batch;

/* Which of the facets that have outside sets comes next.
 *
 * The oldest is the policy of lessons and traces: progress everywhere, small
 * cavities, and the same numbers as a trace, claim for claim. BATCH_LOCAL
 * chooses for speed: the oldest of a few hundred young facets, which lie near
 * each other in the plane and in memory, until nothing waits there; then the
 * youngest of all others. For speed, too, it builds the lower hull alone. */
typedef enum BatchTurn {
  BATCH_LOCAL,
  BATCH_OLDEST,
} BatchTurn;

/* Builds the hull of the lifts of @sites, whose magnitudes are in the range
 * of SiteSet.sites. Sites that equal others are dropped.
 *
 * BATCH_OLDEST builds the whole hull: lower, upper and vertical facets.
 * BATCH_LOCAL builds that of the lifts and one site more, INDEX_NONE, at
 * infinity above them: lower facets, and those that reach up to infinity from
 * the edges of the hull in the plane. Where several of these lie in one plane,
 * some facets in it may be vertical ones. Sites on a circle but for rounding,
 * whose upper and lower hull lie in each other's doubt, are then as easy as
 * any others. batch_close() makes it whole.
 *
 * ORDER_SEEDED and ORDER_HILBERT locate sites by walking.
 *
 * Memory: at most 100 bytes a site.
 * Owns:   the caller frees with batch_free().
 */
Batch *batch_build (const Site *sites,
                    uint32_t n_sites,
                    const Order *order,
                    BatchTurn turn);
void batch_free (Batch *batch);

/* Puts upper and vertical facets in the place of those that reach up to
 * infinity. @sites are those that it was built of; a whole hull stays as it
 * is. Facets get other numbers.
 *
 * Cost: as batch_build(), of the sites on the border of the hull in the plane.
 */
void batch_close (Batch *batch, const Site *sites, uint32_t n_sites);

/* Whether AVX2 is used where the processor has it, as it is unless a test or a
 * measurement says otherwise; the results are the same. */
void batch_use_avx2 (bool is_used);

#endif
