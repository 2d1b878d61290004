/* The rows of a trace: births, deaths and the links between them that only
 * their recorder needs. Private to trace-recorder and trace-rules. */
#ifndef TRACE_ROWS_H
#define TRACE_ROWS_H

#include "trace.h"

/* What a facet's birth, its neighbours and its end need to know of it. */
typedef struct FacetLinks {
  uint32_t ridge[3];  /* rows of the pairs across its three edges */
  uint32_t n_waiting; /* sites in its outside set */
} FacetLinks;

typedef struct TraceRows {
  Trace *trace;
  FacetLinks *links;  /* per facet */
  uint32_t *claim_of; /* per site: its last claim, or INDEX_NONE */
  uint32_t n_free;    /* distinct sites neither on the hull nor claimed */
  uint32_t facets_room, links_room, ridges_room, claims_room, events_room;
} TraceRows;

void trace_rows_init (TraceRows *rows, const SiteSet *set, const Order *order);

/* Frees all but the trace. */
void trace_rows_clear (TraceRows *rows);

/* The step after the event in hand, which is added to the list last. */
static inline uint32_t
trace_rows_step (const TraceRows *rows)
{
  return rows->trace->n_events + 1;
}

void trace_rows_add_facet (TraceRows *rows, const Event *event);

/* Returns: the index of the edge tail → head in a facet, or 3. */
uint32_t trace_rows_edge (const TraceRows *rows,
                          uint32_t facet,
                          uint32_t tail,
                          uint32_t head);

/* Joins edge @k of @left to edge @right_k of @right, the same the other way. */
void trace_rows_add_ridge (TraceRows *rows,
                           uint32_t left,
                           uint32_t k,
                           uint32_t right,
                           uint32_t right_k);

void trace_rows_add_claim (TraceRows *rows, uint32_t site, uint32_t facet);

/* Whether the site waits at a facet that stands. */
bool trace_rows_is_claimed (const TraceRows *rows, uint32_t site);

/* Takes a site out of the outside set of a facet, onto the hull. */
void trace_rows_end_claim (TraceRows *rows, uint32_t facet);

/* Ends a facet, its ridges and its claims; the rows of claims are told when
 * the trace is complete. */
void trace_rows_end_facet (TraceRows *rows, uint32_t facet);

/* Writes when claims died: with their facet, or when the site was selected. */
void trace_rows_end_claims (TraceRows *rows);

#endif
