/* The record of a planar hull, kept for good: as trace.h, with edges instead
 * of facets. A row is shown at step s iff birth <= s < death. */
#ifndef PLANAR_TRACE_H
#define PLANAR_TRACE_H

#include "course.h"
#include "narration.h"
#include "planar.h"
#include "pseudocode.h"

/* Row number = edge number. */
typedef struct PlanarEdge {
  uint32_t corner[2]; /* tail and head, the hull on the left */
  uint32_t round;     /* of its birth; 0 for the first triangle */
  uint32_t seen;      /* step at which it was found visible, or STEP_NEVER */
  Span span;
} PlanarEdge;

/* Membership of a site in an outside set, until the site is selected or has
 * been handed on. */
typedef struct PlanarClaim {
  uint32_t site, edge;
  Span span;
} PlanarClaim;

/* Each field is the step after the named event. */
typedef struct PlanarRound {
  uint32_t edge, site; /* of the SELECT event */
  uint32_t select, last_retire, end;
} PlanarRound;

typedef struct PlanarTrace {
  const SiteSet *set; /* borrowed: must outlive the trace */
  PlanarEvent *events;
  uint32_t n_events; /* = the last step */
  PlanarEdge *edges;
  uint32_t n_edges;
  PlanarClaim *claims;
  uint32_t n_claims;
  PlanarRound *rounds;
  uint32_t n_rounds;
  uint32_t *corner_from; /* per site: step from which it is a corner */
  uint32_t *inside_from; /* per site: step from which it is ignored */
  uint32_t *claim_of;    /* per site: its last claim, for the recorder */
  bool is_flat;
  uint32_t start_end; /* step after the last event before round 1 */
  Course course;
  uint32_t events_room, edges_room, claims_room, rounds_room;
} PlanarTrace;

/* Owns: the caller frees with planar_trace_free(). */
PlanarTrace *planar_trace_record (const SiteSet *set);
void planar_trace_free (PlanarTrace *trace);

/* Returns: the step whose hull is the one to show at @step: @step itself, or
 *          inside a round, until its last edge is retired, the step just
 *          before the round. */
uint32_t planar_trace_base (const PlanarTrace *trace, uint32_t step);

/* Returns: the index into rounds of the current round, INDEX_NONE before. */
uint32_t planar_trace_round (const PlanarTrace *trace, uint32_t step);

/* One sentence for the event that led to @step; @translate may be NULL. */
void planar_narration_write (const PlanarTrace *trace,
                             uint32_t step,
                             NarrationTranslate translate,
                             char text[NARRATION_ROOM]);

/* The listing, and the line that the event carried out. */
const PseudocodeLine *planar_pseudocode_lines (uint32_t *n_lines);
uint32_t planar_pseudocode_line (const PlanarTrace *trace, uint32_t step);

#endif
