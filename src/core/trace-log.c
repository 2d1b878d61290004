#include "trace-log.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* Beyond, rows grow as they come. */
#define ROOM_MAX 50000

/* A little more than a round and 5.6 facets a site, and 15 to 19 claims. */
void
trace_log_init (TraceLog *log, uint32_t n_sites)
{
  const uint32_t n = n_sites < ROOM_MAX ? n_sites : ROOM_MAX;

  memset (log, 0, sizeof *log);
  log->rounds
      = memory_grow (NULL, &log->rounds_room, n + 16, sizeof *log->rounds);
  log->visible = memory_grow (NULL, &log->visible_room, 4 * n + 16,
                              sizeof *log->visible);
  log->horizon = memory_grow (NULL, &log->horizon_room, 6 * n + 16,
                              sizeof *log->horizon);
  log->retired = memory_grow (NULL, &log->retired_room, 4 * n + 16,
                              sizeof *log->retired);
  log->claims
      = memory_grow (NULL, &log->claims_room, 20 * n + 16, sizeof *log->claims);
}

void
trace_log_clear (TraceLog *log)
{
  free (log->duplicates);
  free (log->rounds);
  free (log->visible);
  free (log->horizon);
  free (log->retired);
  free (log->claims);
  memset (log, 0, sizeof *log);
}

void *
trace_log_grow (void *rows, uint32_t *room, size_t size)
{
  return memory_grow (rows, room, *room + 1, size);
}

static void *
fit (void *rows, size_t n, size_t size)
{
  void *fitting = realloc (rows, n > 0 ? n * size : 1);

  if (fitting != NULL)
    rows = fitting;
  return rows;
}

void
trace_log_fit (TraceLog *log)
{
  log->visible = fit (log->visible, log->n_visible, sizeof *log->visible);
  log->horizon = fit (log->horizon, log->n_horizon, sizeof *log->horizon);
  log->retired = fit (log->retired, log->n_retired, sizeof *log->retired);
  log->claims = fit (log->claims, log->n_claims, sizeof *log->claims);
}

LogRound
trace_log_round_end (const TraceLog *log, uint32_t i)
{
  if (i + 1 < log->n_rounds)
    return log->rounds[i + 1];
  return (LogRound){ .visible = log->n_visible,
                     .horizon = log->n_horizon,
                     .retired = log->n_retired,
                     .claim = log->n_claims };
}
