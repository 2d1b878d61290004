/* Upper and vertical facets have all their corners on the border of the hull
 * in the plane, in the order of which lower facets meet them. So the hull of
 * the border's sites alone has just the same ones; its lower facets go. */
#include "batch.h"
#include "memory.h"
#include "predicate.h"

#include <assert.h>
#include <stdlib.h>

/* The border, clockwise, as the shadows of lower facets turn. */
typedef struct Border {
  uint32_t *names; /* of its sites, as given */
  Site *sites;
  HullEdge *edges; /* the edge of a lower facet that begins at each */
  uint32_t n;
} Border;

static bool
is_lower (const HullFacet *facet, const Site *sites)
{
  const uint32_t *s = facet->site;

  return s[0] != INDEX_NONE && s[1] != INDEX_NONE && s[2] != INDEX_NONE
         && facing (&sites[s[0]], &sites[s[1]], &sites[s[2]]) == FACING_LOWER;
}

/* Keeps lower facets, or all others. Edges that led to what goes lead to
 * INDEX_NONE.
 *
 * Returns: the number of these edges. */
static uint32_t
keep (HullFacet *facets,
      uint32_t *n_facets,
      const Site *sites,
      bool keeps_lower)
{
  uint32_t *number = memory_new (*n_facets, sizeof *number);
  uint32_t n_open = 0, n = 0;
  uint32_t i, k;

  for (i = 0; i < *n_facets; i++)
    number[i] = is_lower (&facets[i], sites) == keeps_lower ? n++ : INDEX_NONE;
  for (i = 0; i < *n_facets; i++) {
    if (number[i] == INDEX_NONE)
      continue;
    facets[number[i]] = facets[i];
    for (k = 0; k < 3; k++) {
      HullEdge *across = &facets[number[i]].across[k];
      const uint32_t to = number[*across >> 2];

      *across = to == INDEX_NONE ? INDEX_NONE : to << 2 | (*across & 3);
      n_open += to == INDEX_NONE;
    }
  }
  *n_facets = n;
  free (number);
  return n_open;
}

/* For each site the open edge that begins there; free with free(). */
static HullEdge *
open_edges (const Batch *batch, uint32_t n_sites)
{
  HullEdge *edges = memory_new (n_sites, sizeof *edges);
  uint32_t i, k;

  for (i = 0; i < batch->n_facets; i++)
    for (k = 0; k < 3; k++)
      if (batch->facets[i].across[k] == INDEX_NONE)
        edges[batch->facets[i].site[k]] = i << 2 | k;
  return edges;
}

static void
border_init (Border *border,
             const Batch *lower,
             const Site *sites,
             uint32_t n_sites,
             uint32_t n)
{
  HullEdge *begins_at = open_edges (lower, n_sites);
  uint32_t site, i;

  border->names = memory_new (n, sizeof *border->names);
  border->sites = memory_new (n, sizeof *border->sites);
  border->edges = memory_new (n, sizeof *border->edges);
  border->n = n;
  for (i = 0; lower->facets[i / 3].across[i % 3] != INDEX_NONE; i++)
    ;
  site = lower->facets[i / 3].site[i % 3];
  for (i = 0; i < n; i++) {
    const HullEdge edge = begins_at[site];

    border->names[i] = site;
    border->sites[i] = sites[site];
    border->edges[i] = edge;
    site = lower->facets[edge >> 2].site[hull_next_edge (edge) & 3];
  }
  free (begins_at);
}

static void
border_clear (Border *border)
{
  free (border->names);
  free (border->sites);
  free (border->edges);
}

/* The upper facets of sites on one circle, of which there is no hull: a fan
 * round the first. */
static void
make_fan (Batch *fan, uint32_t n_corners)
{
  const uint32_t n = n_corners - 2;
  uint32_t i;

  free (fan->facets);
  fan->facets = memory_new (n, sizeof *fan->facets);
  fan->n_facets = n;
  for (i = 0; i < n; i++)
    fan->facets[i]
        = (HullFacet){ { 0, i + 2, i + 1 },
                       { i + 1 < n ? (i + 1) << 2 | 2 : INDEX_NONE, INDEX_NONE,
                         i > 0 ? (i - 1) << 2 : INDEX_NONE },
                       INDEX_NONE,
                       0 };
}

/* Adds the facets above to those below. An edge of the border belongs to one of
 * either, which go along it in opposite directions. There is room: the site at
 * infinity made two facets more than there are now. */
static void
join (Batch *lower, const Batch *upper, const Border *border)
{
  const uint32_t first = lower->n_facets;
  uint32_t i, k;

  lower->n_facets += upper->n_facets;
  for (i = 0; i < upper->n_facets; i++) {
    HullFacet *row = &lower->facets[first + i];

    *row = upper->facets[i];
    for (k = 0; k < 3; k++) {
      const uint32_t head = upper->facets[i].site[(k + 1) % 3];
      const HullEdge below = border->edges[head];

      row->site[k] = border->names[row->site[k]];
      if (row->across[k] != INDEX_NONE) {
        row->across[k] += first << 2;
        continue;
      }
      row->across[k] = below;
      lower->facets[below >> 2].across[below & 3] = (first + i) << 2 | k;
    }
  }
}

void
batch_close (Batch *batch, const Site *sites, uint32_t n_sites)
{
  const Order order = { ORDER_HILBERT, 0 };
  const uint32_t room = batch->n_facets;
  Border border;
  Batch *upper;
  uint32_t n;

  if (batch->n_facets == 0 || batch->is_whole)
    return;
  n = keep (batch->facets, &batch->n_facets, sites, true);
  border_init (&border, batch, sites, n_sites, n);
  upper = batch_build (border.sites, n, &order, BATCH_OLDEST);
  if (upper->n_facets == 0)
    make_fan (upper, n);
  else
    keep (upper->facets, &upper->n_facets, border.sites, false);
  assert (batch->n_facets + upper->n_facets + 2 == room);
  join (batch, upper, &border);
  batch->is_whole = true;
  batch_free (upper);
  border_clear (&border);
}
