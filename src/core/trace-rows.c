#include "trace-rows.h"

#include "memory.h"

#include <assert.h>
#include <stdlib.h>

/* Beyond, rows grow as they come. */
#define ROOM_MAX 50000

/* Room for what QuickHull says of so many uniform sites, so that nothing is
 * moved while it grows: a little more than 5.6 facets a site, two ridges a
 * facet, and 15 to 18 claims. */
static void
make_room (TraceRows *rows, uint32_t n_sites)
{
  const uint32_t n = n_sites < ROOM_MAX ? n_sites : ROOM_MAX;
  Trace *trace = rows->trace;

  trace->facets = memory_grow (NULL, &rows->facets_room, 6 * n + 16,
                               sizeof *trace->facets);
  rows->links
      = memory_grow (NULL, &rows->links_room, 6 * n + 16, sizeof *rows->links);
  trace->ridges = memory_grow (NULL, &rows->ridges_room, 12 * n + 32,
                               sizeof *trace->ridges);
  trace->claims = memory_grow (NULL, &rows->claims_room, 20 * n + 16,
                               sizeof *trace->claims);
  trace->events = memory_grow (NULL, &rows->events_room, 38 * n + 64,
                               sizeof *trace->events);
}

void
trace_rows_init (TraceRows *rows, const SiteSet *set, const Order *order)
{
  uint32_t site;

  rows->trace = memory_new (1, sizeof *rows->trace);
  rows->trace->set = set;
  rows->trace->order = *order;
  rows->trace->inserted = memory_new (set->n_sites, sizeof (uint32_t));
  rows->claim_of = memory_new (set->n_sites, sizeof (uint32_t));
  rows->n_free = set->n_distinct;
  make_room (rows, set->n_sites);
  for (site = 0; site < set->n_sites; site++) {
    rows->trace->inserted[site] = STEP_NEVER;
    rows->claim_of[site] = INDEX_NONE;
  }
}

void
trace_rows_clear (TraceRows *rows)
{
  free (rows->links);
  free (rows->claim_of);
}

void
trace_rows_add_facet (TraceRows *rows, const Event *event)
{
  Trace *trace = rows->trace;
  const Site *sites = trace->set->sites;
  const uint32_t facet = trace->n_facets++;
  FacetRow *row;

  if (facet >= rows->facets_room)
    trace->facets = memory_grow (trace->facets, &rows->facets_room, facet + 1,
                                 sizeof *trace->facets);
  if (facet >= rows->links_room)
    rows->links = memory_grow (rows->links, &rows->links_room, facet + 1,
                               sizeof *rows->links);
  row = &trace->facets[facet];
  row->site[0] = event->ridge[0];
  row->site[1] = event->ridge[1];
  row->site[2] = event->site;
  row->round = trace->n_rounds;
  row->seen = STEP_NEVER;
  row->facing = facing (&sites[row->site[0]], &sites[row->site[1]],
                        &sites[row->site[2]]);
  row->span = (Span){ trace_rows_step (rows), STEP_NEVER };
  rows->links[facet].n_waiting = 0;
}

uint32_t
trace_rows_edge (const TraceRows *rows,
                 uint32_t facet,
                 uint32_t tail,
                 uint32_t head)
{
  const uint32_t *site = rows->trace->facets[facet].site;
  uint32_t k = 0;

  while (k < 3 && (site[k] != tail || site[(k + 1) % 3] != head))
    k++;
  return k;
}

void
trace_rows_add_ridge (TraceRows *rows,
                      uint32_t left,
                      uint32_t k,
                      uint32_t right,
                      uint32_t right_k)
{
  Trace *trace = rows->trace;
  const uint32_t ridge = trace->n_ridges++;
  const uint32_t tail = trace->facets[left].site[k];
  const uint32_t head = trace->facets[left].site[(k + 1) % 3];

  assert (trace->facets[right].site[right_k] == head);
  if (ridge >= rows->ridges_room)
    trace->ridges = memory_grow (trace->ridges, &rows->ridges_room, ridge + 1,
                                 sizeof *trace->ridges);
  trace->ridges[ridge] = (RidgeRow){ { tail, head },
                                     { left, right },
                                     { trace_rows_step (rows), STEP_NEVER } };
  rows->links[left].ridge[k] = ridge;
  rows->links[right].ridge[right_k] = ridge;
}

void
trace_rows_add_claim (TraceRows *rows, uint32_t site, uint32_t facet)
{
  Trace *trace = rows->trace;
  const uint32_t claim = trace->n_claims++;

  if (claim >= rows->claims_room)
    trace->claims = memory_grow (trace->claims, &rows->claims_room, claim + 1,
                                 sizeof *trace->claims);
  trace->claims[claim]
      = (ClaimRow){ site, facet, { trace_rows_step (rows), STEP_NEVER } };
  rows->links[facet].n_waiting += 1;
  rows->claim_of[site] = claim;
  rows->n_free -= 1;
}

bool
trace_rows_is_claimed (const TraceRows *rows, uint32_t site)
{
  const Trace *trace = rows->trace;
  const uint32_t claim = rows->claim_of[site];

  return claim != INDEX_NONE && trace->inserted[site] == STEP_NEVER
         && trace->facets[trace->claims[claim].facet].span.death == STEP_NEVER;
}

void
trace_rows_end_claim (TraceRows *rows, uint32_t facet)
{
  rows->links[facet].n_waiting -= 1;
}

void
trace_rows_end_facet (TraceRows *rows, uint32_t facet)
{
  const FacetLinks *links = &rows->links[facet];
  const uint32_t step = trace_rows_step (rows);
  uint32_t k;

  rows->trace->facets[facet].span.death = step;
  for (k = 0; k < 3; k++) {
    Span *span = &rows->trace->ridges[links->ridge[k]].span;

    if (span->death == STEP_NEVER)
      span->death = step;
  }
  rows->n_free += links->n_waiting;
}

void
trace_rows_end_claims (TraceRows *rows)
{
  const Trace *trace = rows->trace;
  uint32_t i;

  for (i = 0; i < trace->n_claims; i++)
    trace->claims[i].span.death
        = trace->facets[trace->claims[i].facet].span.death;
  for (i = 0; i < trace->n_rounds; i++)
    trace->claims[rows->claim_of[trace->rounds[i].site]].span.death
        = trace->rounds[i].select;
}
