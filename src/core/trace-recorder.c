#include "trace-recorder.h"

#include "memory.h"

#include <assert.h>
#include <stdlib.h>

/* What a facet's birth, its neighbours and its end need to know of it. */
typedef struct FacetLinks {
  uint32_t ridge[3];   /* rows of the pairs across its three edges */
  uint32_t last_claim; /* head of its claims, linked by previous_claim */
} FacetLinks;

struct TraceRecorder {
  Trace *trace;
  uint32_t facets_room, links_room, ridges_room, claims_room, claim_links_room,
      rounds_room, events_room;
  FacetLinks *links;
  uint32_t *previous_claim; /* per claim: the facet's claim before it */
  uint32_t *claim_of;       /* per site: its standing claim, or INDEX_NONE */
  Event *horizon;           /* of the round in hand */
  uint32_t n_horizon, horizon_room;
  uint32_t n_visible, n_retired, n_cone; /* of the round in hand */
  EventKind last;                        /* kind of the last event */
  bool has_begun;
};

TraceRecorder *
trace_recorder_new (const SiteSet *set, const Order *order)
{
  TraceRecorder *r = memory_new (1, sizeof *r);
  uint32_t site;

  r->trace = memory_new (1, sizeof *r->trace);
  r->trace->set = set;
  r->trace->order = *order;
  r->trace->inserted = memory_new (set->n_sites, sizeof (uint32_t));
  r->claim_of = memory_new (set->n_sites, sizeof (uint32_t));
  for (site = 0; site < set->n_sites; site++) {
    r->trace->inserted[site] = STEP_NEVER;
    r->claim_of[site] = INDEX_NONE;
  }
  return r;
}

/* The step after the event in hand, which is added to the list last. */
static uint32_t
step_of (const TraceRecorder *r)
{
  return r->trace->n_events + 1;
}

static RoundRow *
round_in_hand (TraceRecorder *r)
{
  return &r->trace->rounds[r->trace->n_rounds - 1];
}

static bool
is_distinct (const TraceRecorder *r, uint32_t site)
{
  return site < r->trace->set->n_sites && r->trace->set->first[site] == site;
}

static bool
is_standing (const TraceRecorder *r, uint32_t facet)
{
  return facet < r->trace->n_facets
         && r->trace->facets[facet].span.death == STEP_NEVER;
}

static void
add_facet (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->trace;
  const Site *sites = trace->set->sites;
  const uint32_t facet = trace->n_facets++;
  FacetRow *row;

  if (facet >= r->facets_room)
    trace->facets = memory_grow (trace->facets, &r->facets_room, facet + 1,
                                 sizeof *trace->facets);
  if (facet >= r->links_room)
    r->links
        = memory_grow (r->links, &r->links_room, facet + 1, sizeof *r->links);
  row = &trace->facets[facet];
  row->site[0] = event->ridge[0];
  row->site[1] = event->ridge[1];
  row->site[2] = event->site;
  row->round = trace->n_rounds;
  row->seen = STEP_NEVER;
  row->facing = facing (&sites[row->site[0]], &sites[row->site[1]],
                        &sites[row->site[2]]);
  row->span = (Span){ step_of (r), STEP_NEVER };
  r->links[facet].last_claim = INDEX_NONE;
}

/* The index of the edge tail → head in a facet, or 3. */
static uint32_t
edge_index (const TraceRecorder *r,
            uint32_t facet,
            uint32_t tail,
            uint32_t head)
{
  const uint32_t *site = r->trace->facets[facet].site;
  uint32_t k = 0;

  while (k < 3 && (site[k] != tail || site[(k + 1) % 3] != head))
    k++;
  return k;
}

/* Joins edge @k of @left to @right, which has the same edge the other way. */
static void
add_ridge (TraceRecorder *r, uint32_t left, uint32_t k, uint32_t right)
{
  Trace *trace = r->trace;
  const uint32_t ridge = trace->n_ridges++;
  const uint32_t tail = trace->facets[left].site[k];
  const uint32_t head = trace->facets[left].site[(k + 1) % 3];
  const uint32_t right_k = edge_index (r, right, head, tail);

  assert (right_k < 3);
  if (ridge >= r->ridges_room)
    trace->ridges = memory_grow (trace->ridges, &r->ridges_room, ridge + 1,
                                 sizeof *trace->ridges);
  trace->ridges[ridge] = (RidgeRow){ { tail, head },
                                     { left, right },
                                     { step_of (r), STEP_NEVER } };
  r->links[left].ridge[k] = ridge;
  r->links[right].ridge[right_k] = ridge;
}

static const char *
add_duplicate (TraceRecorder *r, const Event *event)
{
  if (r->has_begun && r->last != EVENT_DUPLICATE)
    return "a duplicate comes too late";
  if (event->site >= r->trace->set->n_sites || is_distinct (r, event->site))
    return "the site equals no earlier one";
  return NULL;
}

static const char *
add_flat (TraceRecorder *r)
{
  uint32_t site;

  if (r->has_begun && r->last != EVENT_DUPLICATE)
    return "flat comes too late";
  for (site = 0; site < r->trace->set->n_sites; site++)
    if (is_distinct (r, site))
      r->trace->inserted[site] = step_of (r);
  r->trace->is_flat = true;
  r->trace->simplex_end = step_of (r);
  r->trace->start_end = step_of (r);
  return NULL;
}

/* Whether the last facet of the simplex closes it: 4 sites, each edge of each
 * facet met by the same edge the other way. */
static bool
link_simplex (TraceRecorder *r)
{
  const FacetRow *facets = r->trace->facets;
  uint32_t a, b, k, n = 0;

  for (a = 0; a < 4; a++)
    for (k = 0; k < 3; k++)
      for (b = 0; b < 4; b++)
        if (b != a
            && edge_index (r, b, facets[a].site[(k + 1) % 3], facets[a].site[k])
                   < 3) {
          n++;
          if (a < b)
            add_ridge (r, a, k, b);
        }
  return n == 12;
}

static const char *
add_simplex (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->trace;
  uint32_t i;

  if (r->has_begun && r->last != EVENT_DUPLICATE && r->last != EVENT_SIMPLEX)
    return "a simplex facet comes too late";
  if (trace->n_facets == 4)
    return "a simplex has four facets";
  if (event->facet != trace->n_facets)
    return "facets are numbered in the order of their birth";
  if (!is_distinct (r, event->site) || !is_distinct (r, event->ridge[0])
      || !is_distinct (r, event->ridge[1]))
    return "no such site";
  add_facet (r, event);
  if (trace->n_facets < 4)
    return NULL;
  if (!link_simplex (r))
    return "the four facets do not close";
  for (i = 0; i < 12; i++)
    trace->inserted[trace->facets[i / 3].site[i % 3]] = step_of (r);
  trace->simplex_end = step_of (r);
  trace->start_end = step_of (r);
  return NULL;
}

static const char *
add_claim (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->trace;
  const uint32_t claim = trace->n_claims;
  const bool is_start = trace->n_rounds == 0;

  if (r->last != EVENT_CLAIM
      && r->last != (is_start ? EVENT_SIMPLEX : EVENT_RETIRE))
    return "a claim comes at a wrong place";
  if (!is_standing (r, event->facet) || !is_distinct (r, event->site))
    return "no such facet or site";
  if (r->claim_of[event->site] != INDEX_NONE
      || trace->inserted[event->site] != STEP_NEVER)
    return "the site is not free";
  if (claim >= r->claims_room)
    trace->claims = memory_grow (trace->claims, &r->claims_room, claim + 1,
                                 sizeof *trace->claims);
  if (claim >= r->claim_links_room)
    r->previous_claim = memory_grow (r->previous_claim, &r->claim_links_room,
                                     claim + 1, sizeof *r->previous_claim);
  trace->claims[claim]
      = (ClaimRow){ event->site, event->facet, { step_of (r), STEP_NEVER } };
  trace->n_claims += 1;
  r->previous_claim[claim] = r->links[event->facet].last_claim;
  r->links[event->facet].last_claim = claim;
  r->claim_of[event->site] = claim;
  if (is_start)
    trace->start_end = step_of (r);
  else
    round_in_hand (r)->end = step_of (r);
  return NULL;
}

static const char *
add_select (TraceRecorder *r, const Event *event)
{
  Trace *trace = r->trace;
  uint32_t claim;

  if (r->last != EVENT_CLAIM && r->last != EVENT_RETIRE)
    return "a round begins at a wrong place";
  if (!is_standing (r, event->facet) || !is_distinct (r, event->site))
    return "no such facet or site";
  claim = r->claim_of[event->site];
  if (claim == INDEX_NONE || trace->claims[claim].facet != event->facet)
    return "the site is not in the facet's outside set";
  trace->claims[claim].span.death = step_of (r);
  r->claim_of[event->site] = INDEX_NONE;

  if (trace->n_rounds == r->rounds_room)
    trace->rounds = memory_grow (trace->rounds, &r->rounds_room,
                                 trace->n_rounds + 1, sizeof *trace->rounds);
  trace->rounds[trace->n_rounds++] = (RoundRow){ .facet = event->facet,
                                                 .site = event->site,
                                                 .select = step_of (r) };
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
      || r->trace->facets[event->facet].seen != STEP_NEVER)
    return "no such facet, or seen already";
  r->trace->facets[event->facet].seen = step_of (r);
  if (r->n_visible++ == 0)
    round_in_hand (r)->first_visible = step_of (r);
  round_in_hand (r)->last_visible = step_of (r);
  return NULL;
}

/* Whether a ridge lies between a visible facet and one that is not. */
static bool
is_on_horizon (const TraceRecorder *r, const Event *event)
{
  const RidgeRow *row;
  uint32_t k, visible;

  if (!is_standing (r, event->facet)
      || r->trace->facets[event->facet].seen != STEP_NEVER)
    return false;
  k = edge_index (r, event->facet, event->ridge[1], event->ridge[0]);
  if (k == 3)
    return false;
  row = &r->trace->ridges[r->links[event->facet].ridge[k]];
  visible = row->facet[0] == event->facet ? row->facet[1] : row->facet[0];
  return r->trace->facets[visible].seen != STEP_NEVER;
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
    round_in_hand (r)->first_horizon = step_of (r);
  round_in_hand (r)->last_horizon = step_of (r);
  return NULL;
}

/* Links a new cone facet to the facet beyond its ridge and to the cone. */
static void
link_cone (TraceRecorder *r, uint32_t facet)
{
  const Event *ridge = &r->horizon[r->n_cone];
  const uint32_t first = facet - r->n_cone;

  add_ridge (r, facet, 0, ridge->facet);
  if (r->n_cone > 0)
    add_ridge (r, facet, 2, facet - 1);
  if (r->n_cone == r->n_horizon - 1)
    add_ridge (r, facet, 1, first);
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
  if (r->n_cone == r->n_horizon || event->facet != r->trace->n_facets)
    return "one cone facet for each ridge, numbered in order";
  ridge = &r->horizon[r->n_cone];
  if (event->ridge[0] != ridge->ridge[0] || event->ridge[1] != ridge->ridge[1]
      || event->site != round_in_hand (r)->site)
    return "the cone facet does not stand on its ridge";
  add_facet (r, event);
  link_cone (r, event->facet);
  if (r->n_cone++ == 0)
    round_in_hand (r)->first_cone = step_of (r);
  round_in_hand (r)->last_cone = step_of (r);
  return NULL;
}

static void
end_ridges (TraceRecorder *r, uint32_t facet)
{
  uint32_t k;

  for (k = 0; k < 3; k++) {
    Span *span = &r->trace->ridges[r->links[facet].ridge[k]].span;

    if (span->death == STEP_NEVER)
      span->death = step_of (r);
  }
}

static void
end_claims (TraceRecorder *r, uint32_t facet)
{
  uint32_t claim;

  for (claim = r->links[facet].last_claim; claim != INDEX_NONE;
       claim = r->previous_claim[claim]) {
    ClaimRow *row = &r->trace->claims[claim];

    if (row->span.death != STEP_NEVER)
      continue;
    row->span.death = step_of (r);
    r->claim_of[row->site] = INDEX_NONE;
  }
}

static const char *
add_retire (TraceRecorder *r, const Event *event)
{
  if (r->last != EVENT_CONE && r->last != EVENT_RETIRE)
    return "a facet retires at a wrong place";
  if (r->n_cone != r->n_horizon)
    return "the cone is not complete";
  if (!is_standing (r, event->facet)
      || r->trace->facets[event->facet].seen == STEP_NEVER)
    return "the facet is not visible";
  r->trace->facets[event->facet].span.death = step_of (r);
  end_ridges (r, event->facet);
  end_claims (r, event->facet);
  if (r->n_retired++ == 0)
    round_in_hand (r)->first_retire = step_of (r);
  round_in_hand (r)->last_retire = step_of (r);
  round_in_hand (r)->end = step_of (r);
  r->trace->inserted[round_in_hand (r)->site] = step_of (r);
  return NULL;
}

static const char *
add_complete (TraceRecorder *r)
{
  const bool is_start = r->last == EVENT_FLAT || r->last == EVENT_SIMPLEX;

  if (!is_start && r->last != EVENT_CLAIM && r->last != EVENT_RETIRE)
    return "complete comes at a wrong place";
  if (!r->trace->is_flat && r->trace->n_facets < 4)
    return "the simplex is not complete";
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
  Trace *trace = r->trace;
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
  Trace *trace = r->trace;
  const bool is_whole = r->has_begun && r->last == EVENT_COMPLETE;

  free (r->links);
  free (r->previous_claim);
  free (r->claim_of);
  free (r->horizon);
  free (r);
  if (is_whole)
    return trace;
  trace_free (trace);
  return NULL;
}
