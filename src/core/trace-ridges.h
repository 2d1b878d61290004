/* The ridges that were born with a facet, for who goes through facets in
 * ascending order. Private to trace-tell, delaunay and frame. */
#ifndef TRACE_RIDGES_H
#define TRACE_RIDGES_H

#include "trace.h"

/* Edge @k of the facet, with another facet to the right. */
typedef struct BornRidge {
  uint32_t k, right;
} BornRidge;

/* The cone that the current facet belongs to. */
typedef struct RidgeCursor {
  uint32_t first, end; /* facets */
} RidgeCursor;

#define RIDGE_CURSOR                                                           \
  (RidgeCursor) { 0, 4 }

/* The four facets have six ridges: 3, 2 and 1, and the last one none.
 *
 * Returns: how many. */
uint32_t
trace_simplex_ridges (const Trace *trace, uint32_t facet, BornRidge born[3]);

/* Number of the first of them. */
static inline uint32_t
trace_first_ridge (const RidgeCursor *cursor, uint32_t facet)
{
  if (facet < 4)
    return facet < 2 ? 3 * facet : facet + 3;
  return facet == cursor->first ? 2 * facet - 2 : 2 * facet - 3;
}

/* A cone facet has a ridge to the facet beyond the horizon; one to the facet
 * before it, unless it is the first; and the last has one to the first.
 *
 * Returns: how many. */
static inline uint32_t
trace_born_ridges (const Trace *trace,
                   RidgeCursor *cursor,
                   uint32_t facet,
                   BornRidge born[3])
{
  const TraceLog *log = &trace->log;
  uint32_t n = 1;

  if (facet < 4)
    return trace_simplex_ridges (trace, facet, born);
  if (facet >= cursor->end) {
    const uint32_t round = trace->facets[facet].round - 1;

    cursor->first = 4 + log->rounds[round].horizon;
    cursor->end = 4
                  + (round + 1 < log->n_rounds ? log->rounds[round + 1].horizon
                                               : log->n_horizon);
  }
  born[0] = (BornRidge){ 0, log->horizon[facet - 4].beyond };
  if (facet > cursor->first)
    born[n++] = (BornRidge){ 2, facet - 1 };
  if (facet + 1 == cursor->end)
    born[n++] = (BornRidge){ 1, cursor->first };
  return n;
}

#endif
