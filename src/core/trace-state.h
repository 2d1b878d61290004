/* What the rules need to know of all events so far. Private to trace-rules. */
#ifndef TRACE_STATE_H
#define TRACE_STATE_H

#include "event.h"

typedef struct StateFacet {
  uint32_t site[3];
  uint32_t neighbour[3]; /* across site[i], site[i+1] */
  uint32_t round;        /* of its birth; 0 for the simplex */
  uint32_t n_waiting;    /* sites in its outside set */
  bool is_seen, is_retired;
} StateFacet;

typedef struct TraceState {
  const SiteSet *set;
  Event last;
  uint32_t n_events;
  StateFacet *facets;
  uint32_t n_facets, facets_room;
  uint32_t *waits_at; /* per site: the facet it went to last, or INDEX_NONE */
  bool *is_inserted;  /* per site */
  uint32_t n_free;    /* distinct sites neither on the hull nor claimed */
  uint32_t round;     /* the current one; 0 before the first */
  uint32_t apex, n_visible, n_cone, n_retired; /* of it */
  Event *horizon;
  uint32_t n_horizon, horizon_room;
} TraceState;

void trace_state_init (TraceState *state, const SiteSet *set);
void trace_state_clear (TraceState *state);

/* Takes an event that may come next. */
void trace_state_take (TraceState *state, const Event *event);

/* Returns: the index of the edge tail → head in a facet, or 3. */
uint32_t trace_state_edge (const TraceState *state,
                           uint32_t facet,
                           uint32_t tail,
                           uint32_t head);

#endif
