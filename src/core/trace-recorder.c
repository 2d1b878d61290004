#include "trace-recorder.h"

#include "memory.h"
#include "trace-rules.h"

#include <stdlib.h>

struct TraceRecorder {
  TraceRows rows;
  uint32_t rounds_room;
};

TraceRecorder *
trace_recorder_new (const SiteSet *set, const Order *order)
{
  TraceRecorder *r = memory_new (1, sizeof *r);

  trace_rows_init (&r->rows, set, order);
  return r;
}

static RoundRow *
round_in_hand (TraceRecorder *r)
{
  return &r->rows.trace->rounds[r->rows.trace->n_rounds - 1];
}

/* Extends the steps first … last by the event in hand. */
static void
extend (const TraceRecorder *r, uint32_t *first, uint32_t *last)
{
  *last = trace_rows_step (&r->rows);
  if (*first == 0)
    *first = *last;
}

static void
add_flat (TraceRecorder *r)
{
  Trace *trace = r->rows.trace;
  uint32_t site;

  for (site = 0; site < trace->set->n_sites; site++)
    if (trace->set->first[site] == site)
      trace->inserted[site] = trace_rows_step (&r->rows);
  r->rows.n_free = 0;
  trace->is_flat = true;
  trace->simplex_end = trace_rows_step (&r->rows);
  trace->start_end = trace_rows_step (&r->rows);
}

/* Joins the four facets along their six common edges. */
static void
link_simplex (TraceRecorder *r)
{
  const FacetRow *facets = r->rows.trace->facets;
  uint32_t a, b, k;

  for (a = 0; a < 4; a++)
    for (k = 0; k < 3; k++)
      for (b = a + 1; b < 4; b++) {
        const uint32_t b_k = trace_rows_edge (
            &r->rows, b, facets[a].site[(k + 1) % 3], facets[a].site[k]);

        if (b_k < 3)
          trace_rows_add_ridge (&r->rows, a, k, b, b_k);
      }
}

static void
add_simplex (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->rows.trace;
  uint32_t i;

  trace_rows_add_facet (&r->rows, event);
  if (trace->n_facets < 4)
    return;
  link_simplex (r);
  for (i = 0; i < 12; i++)
    trace->inserted[trace->facets[i / 3].site[i % 3]]
        = trace_rows_step (&r->rows);
  r->rows.n_free -= 4;
  trace->simplex_end = trace_rows_step (&r->rows);
  trace->start_end = trace_rows_step (&r->rows);
}

static void
add_claim (TraceRecorder *r, const Event *event)
{
  trace_rows_add_claim (&r->rows, event->site, event->facet);
  if (r->rows.trace->n_rounds == 0)
    r->rows.trace->start_end = trace_rows_step (&r->rows);
  else
    round_in_hand (r)->end = trace_rows_step (&r->rows);
}

static void
add_select (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->rows.trace;

  trace_rows_end_claim (&r->rows, event->facet);
  if (trace->n_rounds == r->rounds_room)
    trace->rounds = memory_grow (trace->rounds, &r->rounds_room,
                                 trace->n_rounds + 1, sizeof *trace->rounds);
  trace->rounds[trace->n_rounds++]
      = (RoundRow){ .facet = event->facet,
                    .site = event->site,
                    .select = trace_rows_step (&r->rows) };
}

/* Joins a new cone facet to the facet beyond its ridge and to the cone. */
static void
link_cone (TraceRecorder *r, uint32_t facet)
{
  const RoundRow *round = round_in_hand (r);
  const uint32_t i = trace_rows_step (&r->rows) - round->first_cone;
  const uint32_t n_ridges = round->last_horizon - round->first_horizon + 1;
  const Event *ridge = &r->rows.trace->events[round->first_horizon - 1 + i];

  trace_rows_add_ridge (&r->rows, facet, 0, ridge->facet,
                        trace_rows_edge (&r->rows, ridge->facet,
                                         ridge->ridge[1], ridge->ridge[0]));
  if (i > 0)
    trace_rows_add_ridge (&r->rows, facet, 2, facet - 1, 1);
  if (i + 1 == n_ridges)
    trace_rows_add_ridge (&r->rows, facet, 1, facet - i, 2);
}

static void
add_cone (TraceRecorder *r, const Event *event)
{
  RoundRow *round = round_in_hand (r);

  extend (r, &round->first_cone, &round->last_cone);
  trace_rows_add_facet (&r->rows, event);
  link_cone (r, event->facet);
}

static void
add_retire (TraceRecorder *r, const Event *event)
{
  RoundRow *round = round_in_hand (r);

  extend (r, &round->first_retire, &round->last_retire);
  round->end = round->last_retire;
  trace_rows_end_facet (&r->rows, event->facet);
  r->rows.trace->inserted[round->site] = round->last_retire;
}

/* Gives back what was not needed. */
static void *
fit (void *rows, size_t n, size_t size)
{
  void *fitting = realloc (rows, n > 0 ? n * size : 1);

  if (fitting == NULL)
    return rows;
  return fitting;
}

static void
fit_all (Trace *trace)
{
  trace->events = fit (trace->events, trace->n_events, sizeof *trace->events);
  trace->facets = fit (trace->facets, trace->n_facets, sizeof *trace->facets);
  trace->ridges = fit (trace->ridges, trace->n_ridges, sizeof *trace->ridges);
  trace->claims = fit (trace->claims, trace->n_claims, sizeof *trace->claims);
}

/* Writes what the event changes into the rows. */
static void
change_rows (TraceRecorder *r, const Event *event)
{
  RoundRow *round = r->rows.trace->n_rounds > 0 ? round_in_hand (r) : NULL;

  switch (event->kind) {
  case EVENT_DUPLICATE:
  case EVENT_COMPLETE:
    break;
  case EVENT_FLAT:
    add_flat (r);
    break;
  case EVENT_SIMPLEX:
    add_simplex (r, event);
    break;
  case EVENT_CLAIM:
    add_claim (r, event);
    break;
  case EVENT_SELECT:
    add_select (r, event);
    break;
  case EVENT_VISIBLE:
    extend (r, &round->first_visible, &round->last_visible);
    r->rows.trace->facets[event->facet].seen = round->last_visible;
    break;
  case EVENT_HORIZON:
    extend (r, &round->first_horizon, &round->last_horizon);
    break;
  case EVENT_CONE:
    add_cone (r, event);
    break;
  case EVENT_RETIRE:
    add_retire (r, event);
    break;
  }
}

void
trace_recorder_hook (const Event *event, void *recorder)
{
  TraceRecorder *r = recorder;
  Trace *trace = r->rows.trace;

  change_rows (r, event);
  if (trace->n_events == r->rows.events_room)
    trace->events = memory_grow (trace->events, &r->rows.events_room,
                                 trace->n_events + 1, sizeof *trace->events);
  trace->events[trace->n_events++] = *event;
}

const char *
trace_recorder_add (TraceRecorder *r, const Event *event)
{
  const char *why = trace_rules_check (&r->rows, event);

  if (why == NULL)
    trace_recorder_hook (event, r);
  return why;
}

Trace *
trace_recorder_finish (TraceRecorder *r)
{
  Trace *trace = r->rows.trace;
  const bool is_whole
      = trace->n_events > 0
        && trace->events[trace->n_events - 1].kind == EVENT_COMPLETE;

  if (is_whole && !trace->is_flat)
    trace_rows_end_claims (&r->rows);
  trace_rows_clear (&r->rows);
  fit_all (trace);
  free (r);
  if (is_whole)
    return trace;
  trace_free (trace);
  return NULL;
}
