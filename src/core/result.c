#include "result.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

static void
add_facet (Result *result, const uint32_t site[3])
{
  memcpy (result->facets[result->n_facets++], site, 3 * sizeof *site);
}

void
result_init (Result *result, const Trace *trace, uint32_t step)
{
  const uint32_t base = trace_base (trace, step);
  uint32_t facet;

  memset (result, 0, sizeof *result);
  result->set = trace->set;
  delaunay_init (&result->delaunay, trace, step);
  voronoi_init (&result->voronoi, &result->delaunay);
  result->facets = memory_new (trace->n_facets, sizeof *result->facets);
  for (facet = 0; facet < trace->n_facets; facet++)
    if (span_has (trace->facets[facet].span, base))
      add_facet (result, trace->facets[facet].site);
}

/* Duplicates were dropped wherever they stood: each site goes by the first
 * that equals it. */
static void
name_first (const SiteSet *set, Batch *batch)
{
  uint32_t i;

  for (i = 0; i < 3 * batch->n_facets; i++) {
    uint32_t *site = &batch->facets[i / 3].site[i % 3];

    *site = set->first[*site];
  }
}

void
result_init_batch (Result *result, const SiteSet *set, const Order *order)
{
  Batch *batch = batch_build (set->sites, set->n_sites, order, BATCH_LOCAL);
  uint32_t facet;

  batch_close (batch, set->sites, set->n_sites);
  name_first (set, batch);
  memset (result, 0, sizeof *result);
  result->set = set;
  delaunay_init_batch (&result->delaunay, set, batch);
  result->facets = memory_new (batch->n_facets, sizeof *result->facets);
  for (facet = 0; facet < batch->n_facets; facet++)
    add_facet (result, batch->facets[facet].site);
  batch_free (batch);
  voronoi_init (&result->voronoi, &result->delaunay);
}

void
result_clear (Result *result)
{
  free (result->facets);
  voronoi_clear (&result->voronoi);
  delaunay_clear (&result->delaunay);
  memset (result, 0, sizeof *result);
}
