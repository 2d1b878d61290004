#include "trace-rows.h"

#include "memory.h"

#include <assert.h>
#include <stdlib.h>

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
  for (site = 0; site < set->n_sites; site++) {
    rows->trace->inserted[site] = STEP_NEVER;
    rows->claim_of[site] = INDEX_NONE;
  }
}

void
trace_rows_clear (TraceRows *rows)
{
  free (rows->links);
  free (rows->previous_claim);
  free (rows->claim_of);
}

uint32_t
trace_rows_step (const TraceRows *rows)
{
  return rows->trace->n_events + 1;
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
  rows->links[facet].last_claim = INDEX_NONE;
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
                      uint32_t right)
{
  Trace *trace = rows->trace;
  const uint32_t ridge = trace->n_ridges++;
  const uint32_t tail = trace->facets[left].site[k];
  const uint32_t head = trace->facets[left].site[(k + 1) % 3];
  const uint32_t right_k = trace_rows_edge (rows, right, head, tail);

  assert (right_k < 3);
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
  if (claim >= rows->claim_links_room)
    rows->previous_claim
        = memory_grow (rows->previous_claim, &rows->claim_links_room, claim + 1,
                       sizeof *rows->previous_claim);
  trace->claims[claim]
      = (ClaimRow){ site, facet, { trace_rows_step (rows), STEP_NEVER } };
  rows->previous_claim[claim] = rows->links[facet].last_claim;
  rows->links[facet].last_claim = claim;
  rows->claim_of[site] = claim;
  rows->n_free -= 1;
}

void
trace_rows_end_claim (TraceRows *rows, uint32_t claim)
{
  ClaimRow *row = &rows->trace->claims[claim];

  row->span.death = trace_rows_step (rows);
  rows->claim_of[row->site] = INDEX_NONE;
  rows->n_free += 1;
}

void
trace_rows_end_facet (TraceRows *rows, uint32_t facet)
{
  const FacetLinks *links = &rows->links[facet];
  uint32_t claim, k;

  rows->trace->facets[facet].span.death = trace_rows_step (rows);
  for (k = 0; k < 3; k++) {
    Span *span = &rows->trace->ridges[links->ridge[k]].span;

    if (span->death == STEP_NEVER)
      span->death = trace_rows_step (rows);
  }
  for (claim = links->last_claim; claim != INDEX_NONE;
       claim = rows->previous_claim[claim])
    if (rows->trace->claims[claim].span.death == STEP_NEVER)
      trace_rows_end_claim (rows, claim);
}
