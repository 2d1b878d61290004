/* What the insertions so far have cost, to compare orders. */
#ifndef INSERTION_COST_H
#define INSERTION_COST_H

#include "trace.h"

typedef struct InsertionCost {
  uint32_t facets_created;  /* those of the first simplex too */
  uint32_t facets_seen;     /* found visible */
  uint32_t redistributions; /* claims since the first partition */
  uint32_t n_cones;         /* rounds whose cone is complete */
  uint32_t cone_facets;     /* of these cones */
  double expected_cone; /* mean over these rounds of 6 - 12/k, the mean size of
                           the cone of the k-th site in a random order */
} InsertionCost;

InsertionCost insertion_cost (const Trace *trace, uint32_t step);

#endif
