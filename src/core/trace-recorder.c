#include "trace-recorder.h"

#include "memory.h"
#include "trace-rows.h"

#include <assert.h>
#include <stdlib.h>

struct TraceRecorder {
  TraceRows rows;
  uint32_t events_room, rounds_room;
  Event *horizon; /* of the round in hand */
  uint32_t n_horizon, horizon_room;
  uint32_t n_visible, n_retired, n_cone; /* of the round in hand */
  EventKind last;                        /* kind of the last event */
  bool has_begun;
  uint32_t n_duplicates, last_duplicate;
};

static bool
has_all_duplicates (const TraceRecorder *r)
{
  const SiteSet *set = r->rows.trace->set;

  return r->n_duplicates == set->n_sites - set->n_distinct;
}

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

static bool
is_distinct (const TraceRecorder *r, uint32_t site)
{
  return site < r->rows.trace->set->n_sites
         && r->rows.trace->set->first[site] == site;
}

static bool
is_standing (const TraceRecorder *r, uint32_t facet)
{
  return facet < r->rows.trace->n_facets
         && r->rows.trace->facets[facet].span.death == STEP_NEVER;
}

static const char *
add_duplicate (TraceRecorder *r, const Event *event)
{
  if (r->has_begun && r->last != EVENT_DUPLICATE)
    return "a duplicate comes too late";
  if (event->site >= r->rows.trace->set->n_sites
      || is_distinct (r, event->site))
    return "the site equals no earlier one";
  if (r->n_duplicates++ > 0 && event->site <= r->last_duplicate)
    return "duplicates come in order";
  r->last_duplicate = event->site;
  return NULL;
}

static const char *
add_flat (TraceRecorder *r)
{
  uint32_t site;

  if (r->has_begun && r->last != EVENT_DUPLICATE)
    return "flat comes too late";
  if (!has_all_duplicates (r))
    return "a duplicate is missing";
  for (site = 0; site < r->rows.trace->set->n_sites; site++)
    if (is_distinct (r, site))
      r->rows.trace->inserted[site] = trace_rows_step (&r->rows);
  r->rows.n_free = 0;
  r->rows.trace->is_flat = true;
  r->rows.trace->simplex_end = trace_rows_step (&r->rows);
  r->rows.trace->start_end = trace_rows_step (&r->rows);
  return NULL;
}

/* Whether the last facet of the simplex closes it: 4 sites, each edge of each
 * facet met by the same edge the other way. */
static bool
link_simplex (TraceRecorder *r)
{
  const FacetRow *facets = r->rows.trace->facets;
  uint32_t a, b, k, n = 0;

  for (a = 0; a < 4; a++)
    for (k = 0; k < 3; k++)
      for (b = 0; b < 4; b++)
        if (b != a
            && trace_rows_edge (&r->rows, b, facets[a].site[(k + 1) % 3],
                                facets[a].site[k])
                   < 3) {
          n++;
          if (a < b)
            trace_rows_add_ridge (&r->rows, a, k, b);
        }
  return n == 12;
}

static const char *
add_simplex (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->rows.trace;
  uint32_t i;

  if (r->has_begun && r->last != EVENT_DUPLICATE && r->last != EVENT_SIMPLEX)
    return "a simplex facet comes too late";
  if (!has_all_duplicates (r))
    return "a duplicate is missing";
  if (trace->n_facets == 4)
    return "a simplex has four facets";
  if (event->facet != trace->n_facets)
    return "facets are numbered in the order of their birth";
  if (!is_distinct (r, event->site) || !is_distinct (r, event->ridge[0])
      || !is_distinct (r, event->ridge[1]))
    return "no such site";
  trace_rows_add_facet (&r->rows, event);
  if (trace->n_facets < 4)
    return NULL;
  if (!link_simplex (r))
    return "the four facets do not close";
  for (i = 0; i < 12; i++)
    trace->inserted[trace->facets[i / 3].site[i % 3]]
        = trace_rows_step (&r->rows);
  r->rows.n_free -= 4;
  trace->simplex_end = trace_rows_step (&r->rows);
  trace->start_end = trace_rows_step (&r->rows);
  return NULL;
}

static const char *
add_claim (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->rows.trace;
  const bool is_start = trace->n_rounds == 0;

  if (r->last != EVENT_CLAIM
      && r->last != (is_start ? EVENT_SIMPLEX : EVENT_RETIRE))
    return "a claim comes at a wrong place";
  if (!is_standing (r, event->facet) || !is_distinct (r, event->site))
    return "no such facet or site";
  if (r->rows.claim_of[event->site] != INDEX_NONE
      || trace->inserted[event->site] != STEP_NEVER)
    return "the site is not free";
  trace_rows_add_claim (&r->rows, event->site, event->facet);
  if (is_start)
    trace->start_end = trace_rows_step (&r->rows);
  else
    round_in_hand (r)->end = trace_rows_step (&r->rows);
  return NULL;
}

static const char *
add_select (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->rows.trace;
  uint32_t claim;

  if (r->last != EVENT_CLAIM && r->last != EVENT_RETIRE)
    return "a round begins at a wrong place";
  if (r->rows.n_free > 0)
    return "a waiting site is in no outside set";
  if (!is_standing (r, event->facet) || !is_distinct (r, event->site))
    return "no such facet or site";
  claim = r->rows.claim_of[event->site];
  if (claim == INDEX_NONE || trace->claims[claim].facet != event->facet)
    return "the site is not in the facet's outside set";
  trace_rows_end_claim (&r->rows, claim);
  r->rows.n_free -= 1; /* it goes on the hull */

  if (trace->n_rounds == r->rounds_room)
    trace->rounds = memory_grow (trace->rounds, &r->rounds_room,
                                 trace->n_rounds + 1, sizeof *trace->rounds);
  trace->rounds[trace->n_rounds++]
      = (RoundRow){ .facet = event->facet,
                    .site = event->site,
                    .select = trace_rows_step (&r->rows) };
  r->n_visible = 0;
  r->n_horizon = 0;
  r->n_cone = 0;
  r->n_retired = 0;
  return NULL;
}

static const char *
add_visible (TraceRecorder *r, const Event *event)
{
  if (r->last != EVENT_SELECT && r->last != EVENT_VISIBLE)
    return "a visible facet comes at a wrong place";
  if (!is_standing (r, event->facet)
      || r->rows.trace->facets[event->facet].seen != STEP_NEVER)
    return "no such facet, or seen already";
  r->rows.trace->facets[event->facet].seen = trace_rows_step (&r->rows);
  if (r->n_visible++ == 0)
    round_in_hand (r)->first_visible = trace_rows_step (&r->rows);
  round_in_hand (r)->last_visible = trace_rows_step (&r->rows);
  return NULL;
}

/* Whether a ridge lies between a visible facet and one that is not. */
static bool
is_on_horizon (const TraceRecorder *r, const Event *event)
{
  const RidgeRow *row;
  uint32_t k, visible;

  if (!is_standing (r, event->facet)
      || r->rows.trace->facets[event->facet].seen != STEP_NEVER)
    return false;
  k = trace_rows_edge (&r->rows, event->facet, event->ridge[1],
                       event->ridge[0]);
  if (k == 3)
    return false;
  row = &r->rows.trace->ridges[r->rows.links[event->facet].ridge[k]];
  visible = row->facet[0] == event->facet ? row->facet[1] : row->facet[0];
  return r->rows.trace->facets[visible].seen != STEP_NEVER;
}

static const char *
add_horizon (TraceRecorder *r, const Event *event)
{
  if (r->last != EVENT_VISIBLE && r->last != EVENT_HORIZON)
    return "a horizon ridge comes at a wrong place";
  if (!is_on_horizon (r, event))
    return "the ridge is not on the horizon";
  if (r->n_horizon > 0
      && r->horizon[r->n_horizon - 1].ridge[1] != event->ridge[0])
    return "the horizon is not one loop";
  if (r->n_horizon == r->horizon_room)
    r->horizon = memory_grow (r->horizon, &r->horizon_room, r->n_horizon + 1,
                              sizeof *r->horizon);
  r->horizon[r->n_horizon] = *event;
  if (r->n_horizon++ == 0)
    round_in_hand (r)->first_horizon = trace_rows_step (&r->rows);
  round_in_hand (r)->last_horizon = trace_rows_step (&r->rows);
  return NULL;
}

/* Links a new cone facet to the facet beyond its ridge and to the cone. */
static void
link_cone (TraceRecorder *r, uint32_t facet)
{
  const Event *ridge = &r->horizon[r->n_cone];
  const uint32_t first = facet - r->n_cone;

  trace_rows_add_ridge (&r->rows, facet, 0, ridge->facet);
  if (r->n_cone > 0)
    trace_rows_add_ridge (&r->rows, facet, 2, facet - 1);
  if (r->n_cone == r->n_horizon - 1)
    trace_rows_add_ridge (&r->rows, facet, 1, first);
}

static const char *
add_cone (TraceRecorder *r, const Event *event)
{
  const Event *ridge;

  if (r->last != EVENT_HORIZON && r->last != EVENT_CONE)
    return "a cone facet comes at a wrong place";
  if (r->n_horizon < 3
      || r->horizon[r->n_horizon - 1].ridge[1] != r->horizon[0].ridge[0])
    return "the horizon is not one loop";
  if (r->n_cone == r->n_horizon || event->facet != r->rows.trace->n_facets)
    return "one cone facet for each ridge, numbered in order";
  ridge = &r->horizon[r->n_cone];
  if (event->ridge[0] != ridge->ridge[0] || event->ridge[1] != ridge->ridge[1]
      || event->site != round_in_hand (r)->site)
    return "the cone facet does not stand on its ridge";
  trace_rows_add_facet (&r->rows, event);
  link_cone (r, event->facet);
  if (r->n_cone++ == 0)
    round_in_hand (r)->first_cone = trace_rows_step (&r->rows);
  round_in_hand (r)->last_cone = trace_rows_step (&r->rows);
  return NULL;
}

static const char *
add_retire (TraceRecorder *r, const Event *event)
{
  if (r->last != EVENT_CONE && r->last != EVENT_RETIRE)
    return "a facet retires at a wrong place";
  if (r->n_cone != r->n_horizon)
    return "the cone is not complete";
  if (!is_standing (r, event->facet)
      || r->rows.trace->facets[event->facet].seen == STEP_NEVER)
    return "the facet is not visible";
  trace_rows_end_facet (&r->rows, event->facet);
  if (r->n_retired++ == 0)
    round_in_hand (r)->first_retire = trace_rows_step (&r->rows);
  round_in_hand (r)->last_retire = trace_rows_step (&r->rows);
  round_in_hand (r)->end = trace_rows_step (&r->rows);
  r->rows.trace->inserted[round_in_hand (r)->site] = trace_rows_step (&r->rows);
  return NULL;
}

static const char *
add_complete (TraceRecorder *r)
{
  uint32_t i;
  const bool is_start = r->last == EVENT_FLAT || r->last == EVENT_SIMPLEX;

  if (!is_start && r->last != EVENT_CLAIM && r->last != EVENT_RETIRE)
    return "complete comes at a wrong place";
  if (!r->rows.trace->is_flat && r->rows.trace->n_facets < 4)
    return "the simplex is not complete";
  for (i = 0; i < r->rows.trace->set->n_sites; i++)
    if (is_distinct (r, i) && r->rows.trace->inserted[i] == STEP_NEVER)
      return "a site is not on the hull";
  return NULL;
}

static const char *
dispatch (TraceRecorder *r, const Event *event)
{
  switch (event->kind) {
  case EVENT_DUPLICATE:
    return add_duplicate (r, event);
  case EVENT_FLAT:
    return add_flat (r);
  case EVENT_SIMPLEX:
    return add_simplex (r, event);
  case EVENT_CLAIM:
    return add_claim (r, event);
  case EVENT_SELECT:
    return add_select (r, event);
  case EVENT_VISIBLE:
    return add_visible (r, event);
  case EVENT_HORIZON:
    return add_horizon (r, event);
  case EVENT_CONE:
    return add_cone (r, event);
  case EVENT_RETIRE:
    return add_retire (r, event);
  case EVENT_COMPLETE:
    return add_complete (r);
  }
  return "no such event";
}

const char *
trace_recorder_add (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->rows.trace;
  const char *why;

  if (r->has_begun && r->last == EVENT_COMPLETE)
    return "nothing comes after complete";
  if (!r->has_begun && event->kind > EVENT_SIMPLEX)
    return "a trace begins with duplicates, flat or the simplex";
  if (r->last == EVENT_RETIRE && event->kind != EVENT_RETIRE
      && r->n_retired != r->n_visible)
    return "a visible facet has not retired";
  why = dispatch (r, event);
  if (why != NULL)
    return why;
  if (trace->n_events == r->events_room)
    trace->events = memory_grow (trace->events, &r->events_room,
                                 trace->n_events + 1, sizeof *trace->events);
  trace->events[trace->n_events++] = *event;
  r->last = event->kind;
  r->has_begun = true;
  return NULL;
}

void
trace_recorder_hook (const Event *event, void *recorder)
{
  const char *why = trace_recorder_add (recorder, event);

  assert (why == NULL);
  (void)why;
}

Trace *
trace_recorder_finish (TraceRecorder *r)
{
  Trace *trace = r->rows.trace;
  const bool is_whole = r->has_begun && r->last == EVENT_COMPLETE;

  trace_rows_clear (&r->rows);
  free (r->horizon);
  free (r);
  if (is_whole)
    return trace;
  trace_free (trace);
  return NULL;
}
