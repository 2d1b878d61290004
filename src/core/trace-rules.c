#include "trace-rules.h"

#include "memory.h"
#include "trace-state.h"

#include <stddef.h>
#include <stdlib.h>

struct TraceRules {
  TraceState state;
};

/* The kinds that may come before the first event: none. */
#define NO_EVENT ((EventKind)N_EVENT_KINDS)

static EventKind
last_kind (const TraceState *state)
{
  return state->n_events == 0 ? NO_EVENT : state->last.kind;
}

/* The last event must be one of two kinds. */
static bool
follows (const TraceState *state, EventKind one, EventKind other)
{
  return last_kind (state) == one || last_kind (state) == other;
}

static bool
is_distinct (const TraceState *state, uint32_t site)
{
  return site < state->set->n_sites && state->set->first[site] == site;
}

static bool
is_standing (const TraceState *state, uint32_t facet)
{
  return facet < state->n_facets && !state->facets[facet].is_retired;
}

static bool
is_seen (const TraceState *state, uint32_t facet)
{
  return state->facets[facet].is_seen;
}

static const char *
check_duplicate (const TraceState *state, const Event *event)
{
  if (!follows (state, NO_EVENT, EVENT_DUPLICATE))
    return "a duplicate comes too late";
  if (event->site >= state->set->n_sites || is_distinct (state, event->site))
    return "the site equals no earlier one";
  if (state->n_events > 0 && event->site <= state->last.site)
    return "duplicates come in order";
  return NULL;
}

static bool
has_all_duplicates (const TraceState *state)
{
  return state->n_events == state->set->n_sites - state->set->n_distinct;
}

static const char *
check_flat (const TraceState *state)
{
  if (!follows (state, NO_EVENT, EVENT_DUPLICATE))
    return "flat comes too late";
  return has_all_duplicates (state) ? NULL : "a duplicate is missing";
}

/* Whether three facets and a fourth close: each edge of each is met by the
 * same edge the other way in another, just once. */
static bool
closes (const TraceState *state, const Event *event)
{
  uint32_t site[4][3]
      = { [3] = { event->ridge[0], event->ridge[1], event->site } };
  uint32_t i, k, n_met = 0;

  for (i = 0; i < 9; i++)
    site[i / 3][i % 3] = state->facets[i / 3].site[i % 3];
  for (i = 0; i < 12; i++)
    for (k = 0; k < 12; k++)
      n_met += site[i / 3][i % 3] == site[k / 3][(k + 1) % 3]
               && site[i / 3][(i + 1) % 3] == site[k / 3][k % 3];
  return n_met == 12;
}

static bool
has_three_sites (const TraceState *state, const Event *event)
{
  const uint32_t *ridge = event->ridge;

  return is_distinct (state, event->site) && is_distinct (state, ridge[0])
         && is_distinct (state, ridge[1]) && ridge[0] != ridge[1]
         && ridge[0] != event->site && ridge[1] != event->site;
}

static const char *
check_simplex (const TraceState *state, const Event *event)
{
  if (state->n_facets == 0 && !follows (state, NO_EVENT, EVENT_DUPLICATE))
    return "a simplex facet comes too late";
  if (state->n_facets == 0 && !has_all_duplicates (state))
    return "a duplicate is missing";
  if (state->n_facets > 0 && last_kind (state) != EVENT_SIMPLEX)
    return "a simplex facet comes too late";
  if (state->n_facets == 4)
    return "a simplex has four facets";
  if (event->facet != state->n_facets)
    return "facets are numbered in the order of their birth";
  if (!has_three_sites (state, event))
    return "a facet has three sites";
  if (state->n_facets == 3 && !closes (state, event))
    return "the four facets do not close";
  return NULL;
}

/* Whether all that was seen has retired, so that claims or a round may
 * follow. */
static bool
is_settled (const TraceState *state)
{
  if (state->round == 0)
    return state->n_facets == 4;
  return state->n_retired == state->n_visible;
}

/* Whether the site waits at a facet that stands. */
static bool
is_claimed (const TraceState *state, uint32_t site)
{
  const uint32_t facet = state->waits_at[site];

  return facet != INDEX_NONE && is_standing (state, facet);
}

static const char *
check_claim (const TraceState *state, const Event *event)
{
  if (!follows (state, EVENT_CLAIM,
                state->round == 0 ? EVENT_SIMPLEX : EVENT_RETIRE)
      || !is_settled (state))
    return "a claim comes at a wrong place";
  if (!is_standing (state, event->facet) || !is_distinct (state, event->site))
    return "there is no such facet or site";
  if (state->is_inserted[event->site] || is_claimed (state, event->site))
    return "the site is not free";
  if (state->facets[event->facet].round != state->round)
    return "a site goes to a facet that is new";
  return NULL;
}

static const char *
check_select (const TraceState *state, const Event *event)
{
  if (!follows (state, EVENT_CLAIM, EVENT_RETIRE) || !is_settled (state))
    return "a round begins at a wrong place";
  if (state->n_free > 0)
    return "a waiting site is in no outside set";
  if (!is_standing (state, event->facet) || !is_distinct (state, event->site))
    return "there is no such facet or site";
  if (state->waits_at[event->site] != event->facet)
    return "the site is not in the facet's outside set";
  return NULL;
}

static const char *
check_visible (const TraceState *state, const Event *event)
{
  if (!follows (state, EVENT_SELECT, EVENT_VISIBLE))
    return "a visible facet comes at a wrong place";
  if (!is_standing (state, event->facet) || is_seen (state, event->facet))
    return "there is no such facet, or it was seen already";
  if (last_kind (state) == EVENT_SELECT && event->facet != state->last.facet)
    return "the first visible facet is the one that was selected";
  return NULL;
}

/* Whether a ridge lies between a visible facet and one that is not. */
static bool
is_on_horizon (const TraceState *state, const Event *event)
{
  uint32_t k;

  if (!is_standing (state, event->facet) || is_seen (state, event->facet))
    return false;
  k = trace_state_edge (state, event->facet, event->ridge[1], event->ridge[0]);
  return k < 3 && is_seen (state, state->facets[event->facet].neighbour[k]);
}

static const char *
check_horizon (const TraceState *state, const Event *event)
{
  if (!follows (state, EVENT_VISIBLE, EVENT_HORIZON))
    return "a horizon ridge comes at a wrong place";
  if (!is_on_horizon (state, event))
    return "the ridge is not on the horizon";
  if (last_kind (state) == EVENT_HORIZON
      && state->last.ridge[1] != event->ridge[0])
    return "the horizon is not one loop";
  return NULL;
}

static const char *
check_cone (const TraceState *state, const Event *event)
{
  const uint32_t n = state->n_horizon;
  const Event *ridge;

  if (!follows (state, EVENT_HORIZON, EVENT_CONE))
    return "a cone facet comes at a wrong place";
  if (n < 3 || state->horizon[n - 1].ridge[1] != state->horizon[0].ridge[0])
    return "the horizon is not one loop";
  if (state->n_cone == n || event->facet != state->n_facets)
    return "there is one cone facet for each ridge, numbered in order";
  ridge = &state->horizon[state->n_cone];
  if (event->ridge[0] != ridge->ridge[0] || event->ridge[1] != ridge->ridge[1]
      || event->site != state->apex)
    return "the cone facet does not stand on its ridge";
  return NULL;
}

static const char *
check_retire (const TraceState *state, const Event *event)
{
  if (!follows (state, EVENT_CONE, EVENT_RETIRE))
    return "a facet retires at a wrong place";
  if (state->n_cone != state->n_horizon)
    return "the cone is not complete";
  if (!is_standing (state, event->facet) || !is_seen (state, event->facet))
    return "the facet is not visible";
  return NULL;
}

static const char *
check_complete (const TraceState *state)
{
  uint32_t site;

  if (last_kind (state) == EVENT_FLAT)
    return NULL;
  if (!follows (state, EVENT_SIMPLEX, EVENT_RETIRE) || !is_settled (state))
    return "complete comes at a wrong place";
  for (site = 0; site < state->set->n_sites; site++)
    if (is_distinct (state, site) && !state->is_inserted[site])
      return "a site is not on the hull";
  return NULL;
}

static const char *
check (const TraceState *state, const Event *event)
{
  switch (event->kind) {
  case EVENT_DUPLICATE:
    return check_duplicate (state, event);
  case EVENT_FLAT:
    return check_flat (state);
  case EVENT_SIMPLEX:
    return check_simplex (state, event);
  case EVENT_CLAIM:
    return check_claim (state, event);
  case EVENT_SELECT:
    return check_select (state, event);
  case EVENT_VISIBLE:
    return check_visible (state, event);
  case EVENT_HORIZON:
    return check_horizon (state, event);
  case EVENT_CONE:
    return check_cone (state, event);
  case EVENT_RETIRE:
    return check_retire (state, event);
  case EVENT_COMPLETE:
    return check_complete (state);
  }
  return "there is no such event";
}

/* Whether the event speaks of the site of another round. */
static bool
is_of_another (const TraceState *state, const Event *event)
{
  return (event->kind == EVENT_VISIBLE || event->kind == EVENT_HORIZON
          || event->kind == EVENT_RETIRE)
         && event->site != state->apex;
}

TraceRules *
trace_rules_new (const SiteSet *set)
{
  TraceRules *rules = memory_new (1, sizeof *rules);

  trace_state_init (&rules->state, set);
  return rules;
}

void
trace_rules_free (TraceRules *rules)
{
  if (rules == NULL)
    return;
  trace_state_clear (&rules->state);
  free (rules);
}

const char *
trace_rules_take (TraceRules *rules, const Event *event)
{
  const char *why = check (&rules->state, event);

  if (why == NULL && is_of_another (&rules->state, event))
    why = "the round is another site's";
  if (why == NULL)
    trace_state_take (&rules->state, event);
  return why;
}
