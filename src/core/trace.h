/* A trace: all that happened while one hull was built, kept for good.
 *
 * Steps count events: step 0 is before the first event, step s is after
 * event s - 1 of the list. Every row carries the span of steps in which it
 * stands; a row is shown at step s iff birth <= s < death. What a thing is at
 * a step (standing, visible, new) is computed from spans, never stored, so
 * going back is choosing a smaller step.
 *
 * Kept are the log (trace-log.h) and the rows of facets and rounds. Events,
 * ridges and claims are many, and all that is to be said of one follows from
 * these: they are told when somebody asks.
 */
#ifndef TRACE_H
#define TRACE_H

#include "choice.h"
#include "hull.h"
#include "predicate.h"
#include "trace-log.h"

#define STEP_NEVER UINT32_MAX

typedef struct Span {
  uint32_t birth, death; /* steps; death STEP_NEVER: stands to the end */
} Span;

/* Row number = facet number. */
typedef struct FacetRow {
  uint32_t site[3]; /* counter-clockwise seen from outside */
  uint32_t round;   /* of its birth; 0 for the simplex */
  uint32_t seen;    /* step at which it was found visible, or STEP_NEVER */
  Facing facing;
  Span span;
} FacetRow;

/* A pair of neighbouring facets. When a cone facet takes the place of a
 * visible one, the row of the old pair dies and one of the new pair is born
 * with the same sites. A ridge between two lower facets is a Delaunay edge
 * and, dually, a Voronoi edge. Numbered in the order of their births; those
 * that are born with one facet follow each other. */
typedef struct RidgeRow {
  uint32_t site[2];  /* tail and head; facet[0] on the left from outside */
  uint32_t facet[2]; /* left, right */
  Span span;
} RidgeRow;

/* Membership of a site in an outside set. */
typedef struct ClaimRow {
  uint32_t site, facet;
  Span span; /* dies when the site is selected or the facet retires */
} ClaimRow;

/* One insertion. Each field is the step after the named event. */
typedef struct RoundRow {
  uint32_t facet, site; /* of the SELECT event */
  uint32_t select;      /* phase choose is this one event */
  uint32_t first_visible, last_visible;
  uint32_t first_horizon, last_horizon;
  uint32_t first_cone, last_cone;
  uint32_t first_retire, last_retire;
  uint32_t end; /* last CLAIM, or last_retire */
} RoundRow;

typedef struct Trace {
  const SiteSet *set; /* borrowed: must outlive the trace */
  Order order;
  TraceLog log;
  uint32_t n_events; /* = the last step */
  FacetRow *facets;
  uint32_t n_facets;
  uint32_t n_ridges;
  uint32_t n_claims;
  RoundRow *rounds; /* rounds[0] is round 1 */
  uint32_t n_rounds;
  uint32_t *inserted;   /* per site: step from which it is on the hull, or
                           STEP_NEVER (duplicates); flat input: the FLAT step */
  bool is_flat;         /* there is no simplex */
  uint32_t simplex_end; /* step after the last SIMPLEX event; FLAT if flat */
  uint32_t start_end;   /* step after the last event before round 1 */
} Trace;

/* Runs QuickHull and keeps what it says: as a hook of hull_build() that feeds
 * a TraceRecorder, but compiled into the engine.
 *
 * Owns: the caller frees with trace_free(). */
Trace *trace_record (const SiteSet *set, const Order *order);

/* The same of hull_build_while().
 *
 * Returns: NULL when it was given up. */
Trace *trace_record_while (const SiteSet *set,
                           const Order *order,
                           HullWanted is_wanted,
                           void *user);

/* The same in ORDER_FURTHEST, where somebody else has chosen. A choice that
 * QuickHull may not make is a mistake of the programmer. */
Trace *trace_record_chosen (const SiteSet *set, const HullChoices *choices);
void trace_free (Trace *trace);

/* Returns: the event that leads to step @i + 1.
 *
 * Cost: the logarithm of the rounds, as of a ridge and a claim. */
Event trace_event (const Trace *trace, uint32_t i);
RidgeRow trace_ridge (const Trace *trace, uint32_t ridge);
ClaimRow trace_claim (const Trace *trace, uint32_t claim);

/* A site waits at a facet from the round of the facet's birth on: all claims
 * of the facet are among those of that round. */
typedef struct ClaimRange {
  uint32_t first, end;
} ClaimRange;

ClaimRange trace_claims_with (const Trace *trace, uint32_t facet);

/* Returns: how many sites are in the outside set of @facet at @step. */
uint32_t trace_n_waiting (const Trace *trace, uint32_t facet, uint32_t step);

/* Returns: whether the row with @span is shown at @step. */
static inline bool
span_has (Span span, uint32_t step)
{
  return span.birth <= step && step < span.death;
}

/* Returns: the step whose standing facets are the triangulation to show at
 *          @step: @step itself, or inside a round, until its last facet is
 *          retired, the step just before the round. */
uint32_t trace_base (const Trace *trace, uint32_t step);

/* Returns: the index into rounds of the current round at @step, that is of
 *          the last round selected, or INDEX_NONE before the first. */
uint32_t trace_round (const Trace *trace, uint32_t step);

#endif
