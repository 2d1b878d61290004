/* The log of a run: all that QuickHull says, and nothing that follows from
 * what it has said before. The horizon of a round tells its cone, for ridge i
 * bears cone facet i, and its order is that of the loop; who is seen and who
 * sees is said by the round. So it takes 200 bytes a site, where events take
 * 700.
 *
 * The engine writes it as it goes (hull-builder.h), and a hook can, event by
 * event: both by trace_log_add(). */
#ifndef TRACE_LOG_H
#define TRACE_LOG_H

#include "event.h"

#include <stddef.h>

/* A horizon ridge; its head is the tail of the next. */
typedef struct LogRidge {
  uint32_t tail;
  uint32_t beyond; /* facet on the other side */
} LogRidge;

typedef struct LogClaim {
  uint32_t site, facet;
} LogClaim;

/* A round, and the rows where what it says begins. */
typedef struct LogRound {
  uint32_t facet, site; /* selected */
  uint32_t visible, horizon, retired, claim;
} LogRound;

typedef struct TraceLog {
  uint32_t *duplicates; /* sites */
  uint32_t n_duplicates, duplicates_room;
  uint32_t simplex[4][3]; /* the sites of its facets */
  uint32_t n_simplex;
  LogRound *rounds;
  uint32_t n_rounds, rounds_room;
  uint32_t *visible; /* facets */
  uint32_t n_visible, visible_room;
  LogRidge *horizon; /* row i bears facet 4 + i */
  uint32_t n_horizon, horizon_room;
  uint32_t *retired; /* facets */
  uint32_t n_retired, retired_room;
  LogClaim *claims;
  uint32_t n_claims, claims_room;
  bool is_flat, is_complete;
} TraceLog;

/* Makes room for what QuickHull says of so many uniform sites, so that nothing
 * is moved while it grows. */
void trace_log_init (TraceLog *log, uint32_t n_sites);
void trace_log_clear (TraceLog *log);

/* Gives back what was not needed. */
void trace_log_fit (TraceLog *log);

/* Returns: where the rows of round @i end: where those of the next begin. */
LogRound trace_log_round_end (const TraceLog *log, uint32_t i);

/* Makes a list longer by at least one. */
void *trace_log_grow (void *rows, uint32_t *room, size_t size);

/* Room for one more row of a list. */
#define TRACE_LOG_ROOM(log, list)                                              \
  do {                                                                         \
    if (__builtin_expect ((log)->n_##list == (log)->list##_room, 0))           \
      (log)->list = trace_log_grow ((log)->list, &(log)->list##_room,          \
                                    sizeof *(log)->list);                      \
  } while (0)

static inline void
trace_log_round (TraceLog *log, uint32_t facet, uint32_t site)
{
  TRACE_LOG_ROOM (log, rounds);
  log->rounds[log->n_rounds++]
      = (LogRound){ facet,          site,           log->n_visible,
                    log->n_horizon, log->n_retired, log->n_claims };
}

static inline void
trace_log_simplex (TraceLog *log, const Event *event)
{
  uint32_t *site = log->simplex[log->n_simplex++];

  site[0] = event->ridge[0];
  site[1] = event->ridge[1];
  site[2] = event->site;
}

/* Keeps an event. Where its kind is a constant, this is a store or two. */
static inline void
trace_log_add (TraceLog *log, const Event *event)
{
  switch (event->kind) {
  case EVENT_DUPLICATE:
    TRACE_LOG_ROOM (log, duplicates);
    log->duplicates[log->n_duplicates++] = event->site;
    break;
  case EVENT_FLAT:
    log->is_flat = true;
    break;
  case EVENT_SIMPLEX:
    trace_log_simplex (log, event);
    break;
  case EVENT_CLAIM:
    TRACE_LOG_ROOM (log, claims);
    log->claims[log->n_claims++] = (LogClaim){ event->site, event->facet };
    break;
  case EVENT_SELECT:
    trace_log_round (log, event->facet, event->site);
    break;
  case EVENT_VISIBLE:
    TRACE_LOG_ROOM (log, visible);
    log->visible[log->n_visible++] = event->facet;
    break;
  case EVENT_HORIZON:
    TRACE_LOG_ROOM (log, horizon);
    log->horizon[log->n_horizon++]
        = (LogRidge){ event->ridge[0], event->facet };
    break;
  case EVENT_CONE:
    break;
  case EVENT_RETIRE:
    TRACE_LOG_ROOM (log, retired);
    log->retired[log->n_retired++] = event->facet;
    break;
  case EVENT_COMPLETE:
    log->is_complete = true;
    break;
  }
}

#endif
