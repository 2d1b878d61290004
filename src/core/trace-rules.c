#include "trace-rules.h"

#include <stddef.h>

/* The kinds that may come before the first event: none. */
#define NO_EVENT ((EventKind)N_EVENT_KINDS)

static EventKind
last_kind (const Trace *trace)
{
  return trace->n_events == 0 ? NO_EVENT
                              : trace->events[trace->n_events - 1].kind;
}

/* The last event must be one of two kinds. */
static bool
follows (const Trace *trace, EventKind one, EventKind other)
{
  return last_kind (trace) == one || last_kind (trace) == other;
}

static const RoundRow *
round_in_hand (const Trace *trace)
{
  return &trace->rounds[trace->n_rounds - 1];
}

/* How many steps first … last are; first is 0 before the first of them. */
static uint32_t
n_steps (uint32_t first, uint32_t last)
{
  return first == 0 ? 0 : last - first + 1;
}

static bool
is_distinct (const Trace *trace, uint32_t site)
{
  return site < trace->set->n_sites && trace->set->first[site] == site;
}

static bool
is_standing (const Trace *trace, uint32_t facet)
{
  return facet < trace->n_facets
         && trace->facets[facet].span.death == STEP_NEVER;
}

static bool
is_seen (const Trace *trace, uint32_t facet)
{
  return trace->facets[facet].seen != STEP_NEVER;
}

static const char *
check_duplicate (const Trace *trace, const Event *event)
{
  if (!follows (trace, NO_EVENT, EVENT_DUPLICATE))
    return "a duplicate comes too late";
  if (event->site >= trace->set->n_sites || is_distinct (trace, event->site))
    return "the site equals no earlier one";
  if (trace->n_events > 0
      && event->site <= trace->events[trace->n_events - 1].site)
    return "duplicates come in order";
  return NULL;
}

static bool
has_all_duplicates (const Trace *trace)
{
  return trace->n_events == trace->set->n_sites - trace->set->n_distinct;
}

static const char *
check_flat (const Trace *trace)
{
  if (!follows (trace, NO_EVENT, EVENT_DUPLICATE))
    return "flat comes too late";
  return has_all_duplicates (trace) ? NULL : "a duplicate is missing";
}

/* Whether three facets and a fourth close: each edge of each is met by the
 * same edge the other way in another, just once. */
static bool
closes (const Trace *trace, const Event *event)
{
  uint32_t site[4][3]
      = { [3] = { event->ridge[0], event->ridge[1], event->site } };
  uint32_t i, k, n_met = 0;

  for (i = 0; i < 9; i++)
    site[i / 3][i % 3] = trace->facets[i / 3].site[i % 3];
  for (i = 0; i < 12; i++)
    for (k = 0; k < 12; k++)
      n_met += site[i / 3][i % 3] == site[k / 3][(k + 1) % 3]
               && site[i / 3][(i + 1) % 3] == site[k / 3][k % 3];
  return n_met == 12;
}

static bool
has_three_sites (const Trace *trace, const Event *event)
{
  const uint32_t *ridge = event->ridge;

  return is_distinct (trace, event->site) && is_distinct (trace, ridge[0])
         && is_distinct (trace, ridge[1]) && ridge[0] != ridge[1]
         && ridge[0] != event->site && ridge[1] != event->site;
}

static const char *
check_simplex (const Trace *trace, const Event *event)
{
  if (trace->n_facets == 0 && !follows (trace, NO_EVENT, EVENT_DUPLICATE))
    return "a simplex facet comes too late";
  if (trace->n_facets == 0 && !has_all_duplicates (trace))
    return "a duplicate is missing";
  if (trace->n_facets > 0 && last_kind (trace) != EVENT_SIMPLEX)
    return "a simplex facet comes too late";
  if (trace->n_facets == 4)
    return "a simplex has four facets";
  if (event->facet != trace->n_facets)
    return "facets are numbered in the order of their birth";
  if (!has_three_sites (trace, event))
    return "a facet has three sites";
  if (trace->n_facets == 3 && !closes (trace, event))
    return "the four facets do not close";
  return NULL;
}

/* Whether all that was seen has retired, so that claims or a round may
 * follow. */
static bool
is_settled (const Trace *trace)
{
  const RoundRow *round;

  if (trace->n_rounds == 0)
    return trace->n_facets == 4;
  round = round_in_hand (trace);
  return n_steps (round->first_retire, round->last_retire)
         == n_steps (round->first_visible, round->last_visible);
}

static const char *
check_claim (const TraceRows *rows, const Event *event)
{
  const Trace *trace = rows->trace;

  if (!follows (trace, EVENT_CLAIM,
                trace->n_rounds == 0 ? EVENT_SIMPLEX : EVENT_RETIRE)
      || !is_settled (trace))
    return "a claim comes at a wrong place";
  if (!is_standing (trace, event->facet) || !is_distinct (trace, event->site))
    return "there is no such facet or site";
  if (trace_rows_is_claimed (rows, event->site)
      || trace->inserted[event->site] != STEP_NEVER)
    return "the site is not free";
  return NULL;
}

static const char *
check_select (const TraceRows *rows, const Event *event)
{
  const Trace *trace = rows->trace;
  uint32_t claim;

  if (!follows (trace, EVENT_CLAIM, EVENT_RETIRE) || !is_settled (trace))
    return "a round begins at a wrong place";
  if (rows->n_free > 0)
    return "a waiting site is in no outside set";
  if (!is_standing (trace, event->facet) || !is_distinct (trace, event->site))
    return "there is no such facet or site";
  claim = rows->claim_of[event->site];
  if (claim == INDEX_NONE || trace->claims[claim].facet != event->facet)
    return "the site is not in the facet's outside set";
  return NULL;
}

static const char *
check_visible (const Trace *trace, const Event *event)
{
  if (!follows (trace, EVENT_SELECT, EVENT_VISIBLE))
    return "a visible facet comes at a wrong place";
  if (!is_standing (trace, event->facet) || is_seen (trace, event->facet))
    return "there is no such facet, or it was seen already";
  return NULL;
}

/* Whether a ridge lies between a visible facet and one that is not. */
static bool
is_on_horizon (const TraceRows *rows, const Event *event)
{
  const Trace *trace = rows->trace;
  const RidgeRow *row;
  uint32_t k;

  if (!is_standing (trace, event->facet) || is_seen (trace, event->facet))
    return false;
  k = trace_rows_edge (rows, event->facet, event->ridge[1], event->ridge[0]);
  if (k == 3)
    return false;
  row = &trace->ridges[rows->links[event->facet].ridge[k]];
  return is_seen (trace, row->facet[row->facet[0] == event->facet]);
}

static const char *
check_horizon (const TraceRows *rows, const Event *event)
{
  const Trace *trace = rows->trace;

  if (!follows (trace, EVENT_VISIBLE, EVENT_HORIZON))
    return "a horizon ridge comes at a wrong place";
  if (!is_on_horizon (rows, event))
    return "the ridge is not on the horizon";
  if (last_kind (trace) == EVENT_HORIZON
      && trace->events[trace->n_events - 1].ridge[1] != event->ridge[0])
    return "the horizon is not one loop";
  return NULL;
}

static const char *
check_cone (const Trace *trace, const Event *event)
{
  const RoundRow *round;
  const Event *first, *ridge;
  uint32_t n_horizon, n_cone;

  if (!follows (trace, EVENT_HORIZON, EVENT_CONE))
    return "a cone facet comes at a wrong place";
  round = round_in_hand (trace);
  n_horizon = n_steps (round->first_horizon, round->last_horizon);
  n_cone = n_steps (round->first_cone, round->last_cone);
  first = &trace->events[round->first_horizon - 1];
  if (n_horizon < 3 || first[n_horizon - 1].ridge[1] != first->ridge[0])
    return "the horizon is not one loop";
  if (n_cone == n_horizon || event->facet != trace->n_facets)
    return "there is one cone facet for each ridge, numbered in order";
  ridge = &first[n_cone];
  if (event->ridge[0] != ridge->ridge[0] || event->ridge[1] != ridge->ridge[1]
      || event->site != round->site)
    return "the cone facet does not stand on its ridge";
  return NULL;
}

static const char *
check_retire (const Trace *trace, const Event *event)
{
  const RoundRow *round;

  if (!follows (trace, EVENT_CONE, EVENT_RETIRE))
    return "a facet retires at a wrong place";
  round = round_in_hand (trace);
  if (n_steps (round->first_cone, round->last_cone)
      != n_steps (round->first_horizon, round->last_horizon))
    return "the cone is not complete";
  if (!is_standing (trace, event->facet) || !is_seen (trace, event->facet))
    return "the facet is not visible";
  return NULL;
}

static const char *
check_complete (const Trace *trace)
{
  uint32_t site;

  if (last_kind (trace) == EVENT_FLAT)
    return NULL;
  if (!follows (trace, EVENT_SIMPLEX, EVENT_RETIRE) || !is_settled (trace))
    return "complete comes at a wrong place";
  for (site = 0; site < trace->set->n_sites; site++)
    if (is_distinct (trace, site) && trace->inserted[site] == STEP_NEVER)
      return "a site is not on the hull";
  return NULL;
}

const char *
trace_rules_check (const TraceRows *rows, const Event *event)
{
  const Trace *trace = rows->trace;

  switch (event->kind) {
  case EVENT_DUPLICATE:
    return check_duplicate (trace, event);
  case EVENT_FLAT:
    return check_flat (trace);
  case EVENT_SIMPLEX:
    return check_simplex (trace, event);
  case EVENT_CLAIM:
    return check_claim (rows, event);
  case EVENT_SELECT:
    return check_select (rows, event);
  case EVENT_VISIBLE:
    return check_visible (trace, event);
  case EVENT_HORIZON:
    return check_horizon (rows, event);
  case EVENT_CONE:
    return check_cone (trace, event);
  case EVENT_RETIRE:
    return check_retire (trace, event);
  case EVENT_COMPLETE:
    return check_complete (trace);
  }
  return "there is no such event";
}
