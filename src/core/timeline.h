/* Positions in a trace: which round and phase a step belongs to, and the way
 * from one to the next. */
#ifndef TIMELINE_H
#define TIMELINE_H

#include "trace.h"

typedef enum Phase {
  PHASE_START,     /* step 0: nothing has happened */
  PHASE_SIMPLEX,   /* duplicates, the first simplex, the first partition */
  PHASE_CHOOSE,    /* SELECT */
  PHASE_SEE,       /* VISIBLE… */
  PHASE_HORIZON,   /* HORIZON… */
  PHASE_CONE,      /* CONE… */
  PHASE_HAND_OVER, /* RETIRE… CLAIM…: one movement */
  PHASE_COMPLETE,  /* COMPLETE */
} Phase;

#define N_PHASES (PHASE_COMPLETE + 1)

typedef enum Grain {
  GRAIN_EVENT,
  GRAIN_PHASE,
  GRAIN_ROUND,
} Grain;

typedef struct Place {
  uint32_t round; /* 0 before the first, then counted from 1 */
  Phase phase;    /* of the event that led to the step */
} Place;

/* Returns: "choose", "see", "horizon", "cone", "hand-over"; for the other
 *          phases "start", "simplex", "complete". */
const char *phase_name (Phase phase);
bool phase_parse (const char *name, Phase *phase);

Place timeline_place (const Trace *trace, uint32_t step);

/* Finds the step after the last event of @place, or before its first event
 * when @before.
 *
 * Place {0, PHASE_SIMPLEX} ends before round 1.
 *
 * Returns: false when the trace has no such place.
 */
bool
timeline_find (const Trace *trace, Place place, bool before, uint32_t *step);

/* Ends of events, of phases, or of rounds; the end of the simplex phase and
 * the last step count as ends of rounds.
 *
 * Returns: the nearest such step after (before) @step, or the last step
 *          (step 0). */
uint32_t timeline_next (const Trace *trace, uint32_t step, Grain grain);
uint32_t timeline_back (const Trace *trace, uint32_t step, Grain grain);

#endif
