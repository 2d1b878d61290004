#include "trace-state.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

void
trace_state_init (TraceState *state, const SiteSet *set)
{
  uint32_t site;

  memset (state, 0, sizeof *state);
  state->set = set;
  state->waits_at = memory_new (set->n_sites, sizeof *state->waits_at);
  state->is_inserted = memory_new (set->n_sites, sizeof *state->is_inserted);
  state->n_free = set->n_distinct;
  for (site = 0; site < set->n_sites; site++)
    state->waits_at[site] = INDEX_NONE;
}

void
trace_state_clear (TraceState *state)
{
  free (state->facets);
  free (state->waits_at);
  free (state->is_inserted);
  free (state->horizon);
}

uint32_t
trace_state_edge (const TraceState *state,
                  uint32_t facet,
                  uint32_t tail,
                  uint32_t head)
{
  const uint32_t *site = state->facets[facet].site;
  uint32_t k = 0;

  while (k < 3 && (site[k] != tail || site[(k + 1) % 3] != head))
    k++;
  return k;
}

static void
add_facet (TraceState *state, const Event *event)
{
  const uint32_t facet = state->n_facets++;

  if (facet >= state->facets_room)
    state->facets = memory_grow (state->facets, &state->facets_room, facet + 1,
                                 sizeof *state->facets);
  state->facets[facet]
      = (StateFacet){ .site = { event->ridge[0], event->ridge[1], event->site },
                      .round = state->round };
}

/* Joins the four facets along their six common edges. */
static void
link_simplex (TraceState *state)
{
  uint32_t a, b, k;

  for (a = 0; a < 4; a++)
    for (k = 0; k < 3; k++)
      for (b = 0; b < 4; b++) {
        const uint32_t *site = state->facets[a].site;

        if (b != a
            && trace_state_edge (state, b, site[(k + 1) % 3], site[k]) < 3)
          state->facets[a].neighbour[k] = b;
      }
}

static void
take_simplex (TraceState *state, const Event *event)
{
  uint32_t i;

  add_facet (state, event);
  if (state->n_facets < 4)
    return;
  link_simplex (state);
  for (i = 0; i < 12; i++)
    state->is_inserted[state->facets[i / 3].site[i % 3]] = true;
  state->n_free -= 4;
}

static void
take_claim (TraceState *state, const Event *event)
{
  state->facets[event->facet].n_waiting += 1;
  state->waits_at[event->site] = event->facet;
  state->n_free -= 1;
}

static void
take_select (TraceState *state, const Event *event)
{
  state->facets[event->facet].n_waiting -= 1;
  state->round += 1;
  state->apex = event->site;
  state->n_visible = state->n_horizon = state->n_cone = state->n_retired = 0;
}

static void
take_horizon (TraceState *state, const Event *event)
{
  if (state->n_horizon == state->horizon_room)
    state->horizon = memory_grow (state->horizon, &state->horizon_room,
                                  state->n_horizon + 1, sizeof *state->horizon);
  state->horizon[state->n_horizon++] = *event;
}

/* Joins the new facet to the one beyond its ridge and to the cone. */
static void
take_cone (TraceState *state, const Event *event)
{
  const uint32_t i = state->n_cone++;
  const Event *ridge = &state->horizon[i];
  const uint32_t facet = event->facet, beyond = ridge->facet;
  const uint32_t k
      = trace_state_edge (state, beyond, ridge->ridge[1], ridge->ridge[0]);
  const uint32_t first = facet - i;

  add_facet (state, event);
  state->facets[facet].neighbour[0] = beyond;
  state->facets[beyond].neighbour[k] = facet;
  if (i > 0) {
    state->facets[facet].neighbour[2] = facet - 1;
    state->facets[facet - 1].neighbour[1] = facet;
  }
  state->facets[facet].neighbour[1] = first;
  state->facets[first].neighbour[2] = facet;
}

static void
take_retire (TraceState *state, const Event *event)
{
  state->n_retired += 1;
  state->facets[event->facet].is_retired = true;
  state->n_free += state->facets[event->facet].n_waiting;
  state->is_inserted[state->apex] = true;
}

void
trace_state_take (TraceState *state, const Event *event)
{
  switch (event->kind) {
  case EVENT_DUPLICATE:
  case EVENT_COMPLETE:
    break;
  case EVENT_FLAT:
    state->n_free = 0;
    break;
  case EVENT_SIMPLEX:
    take_simplex (state, event);
    break;
  case EVENT_CLAIM:
    take_claim (state, event);
    break;
  case EVENT_SELECT:
    take_select (state, event);
    break;
  case EVENT_VISIBLE:
    state->n_visible += 1;
    state->facets[event->facet].is_seen = true;
    break;
  case EVENT_HORIZON:
    take_horizon (state, event);
    break;
  case EVENT_CONE:
    take_cone (state, event);
    break;
  case EVENT_RETIRE:
    take_retire (state, event);
    break;
  }
  state->last = *event;
  state->n_events += 1;
}
