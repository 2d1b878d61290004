#include "merged.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* An edge of a facet as a number: 3 · facet + the index of its tail. */
typedef uint32_t Side;

static Side
next_side (Side side)
{
  return side % 3 == 2 ? side - 2 : side + 1;
}

static Side
previous_side (Side side)
{
  return side % 3 == 0 ? side + 2 : side - 1;
}

typedef struct Merger {
  const Result *result;
  Side *twins;      /* per side: the same edge in the neighbour */
  uint32_t *parent; /* per facet: a forest of those in one plane */
  uint32_t *heads;  /* per site: its follower in the current polygon */
} Merger;

static uint32_t
tail_of (const Merger *merger, Side side)
{
  return merger->result->facets[side / 3][side % 3];
}

/* Lists the sides by their tails.
 *
 * Returns: for each site where its sides begin, n_sites + 1 numbers. */
static uint32_t *
list_by_tail (const Merger *merger, Side *sides)
{
  const uint32_t n_sites = merger->result->set->n_sites;
  const uint32_t n = 3 * merger->result->n_facets;
  uint32_t *start = memory_new ((size_t)n_sites + 2, sizeof *start);

  /* start[s + 2] counts, then start[s + 1] is where site s's next goes. */
  for (Side side = 0; side < n; side += 1)
    start[tail_of (merger, side) + 2] += 1;
  for (uint32_t i = 2; i < n_sites + 2; i += 1)
    start[i] += start[i - 1];
  for (Side side = 0; side < n; side += 1) {
    uint32_t *place = &start[tail_of (merger, side) + 1];

    sides[*place] = side;
    *place += 1;
  }
  return start;
}

/* The sides that leave a site, and those that enter it before them, pair off
 * by their other ends. */
static void
find_twins (Merger *merger)
{
  const uint32_t n_sites = merger->result->set->n_sites;
  const uint32_t n = 3 * merger->result->n_facets;
  Side *sides = memory_new (n, sizeof *sides);
  uint32_t *start = list_by_tail (merger, sides);
  Side *to = memory_new (n_sites, sizeof *to);

  for (uint32_t site = 0; site < n_sites; site += 1) {
    for (uint32_t i = start[site]; i < start[site + 1]; i += 1)
      to[tail_of (merger, next_side (sides[i]))] = sides[i];
    for (uint32_t i = start[site]; i < start[site + 1]; i += 1) {
      const Side entering = previous_side (sides[i]);

      merger->twins[entering] = to[tail_of (merger, entering)];
    }
  }
  free (to);
  free (start);
  free (sides);
}

static uint32_t
root_of (uint32_t *parent, uint32_t facet)
{
  while (parent[facet] != facet) {
    parent[facet] = parent[parent[facet]];
    facet = parent[facet];
  }
  return facet;
}

/* Whether both facets at a side lie in one plane. */
static bool
is_flat (const Merger *merger, Side side)
{
  const Site *sites = merger->result->set->sites;
  const uint32_t *corner = merger->result->facets[side / 3];
  const Side opposite = previous_side (merger->twins[side]);

  return lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      &sites[tail_of (merger, opposite)])
         == 0;
}

static void
join_planes (Merger *merger)
{
  const uint32_t n = merger->result->n_facets;

  for (uint32_t i = 0; i < n; i += 1)
    merger->parent[i] = i;
  for (Side side = 0; side < 3 * n; side += 1)
    if (side < merger->twins[side] && is_flat (merger, side))
      merger->parent[root_of (merger->parent, side / 3)]
          = root_of (merger->parent, merger->twins[side] / 3);
}

static void
add_polygon (Merged *merged, Facing facing)
{
  merged->polygons[merged->n_polygons]
      = (Polygon){ merged->n_sites, 0, facing };
  merged->n_polygons += 1;
}

static void
add_site (Merged *merged, uint32_t site)
{
  merged->sites[merged->n_sites] = site;
  merged->n_sites += 1;
  merged->polygons[merged->n_polygons - 1].n_sites += 1;
}

/* Lists the facets by their planes: @order has them, those of plane p from
 * start[p] on, where p is the plane's root. */
static uint32_t *
list_by_plane (Merger *merger, uint32_t *order)
{
  const uint32_t n = merger->result->n_facets;
  uint32_t *start = memory_new ((size_t)n + 2, sizeof *start);

  for (uint32_t i = 0; i < n; i += 1)
    start[root_of (merger->parent, i) + 2] += 1;
  for (uint32_t i = 2; i < n + 2; i += 1)
    start[i] += start[i - 1];
  for (uint32_t i = 0; i < n; i += 1) {
    uint32_t *place = &start[root_of (merger->parent, i) + 1];

    order[*place] = i;
    *place += 1;
  }
  return start;
}

/* Every lift is extreme, so all sites of a polygon are on its border, each
 * once: the followers of its sites are a loop. */
static void
walk_border (const Merger *merger, uint32_t first, Merged *merged)
{
  const uint32_t room = 3 * merger->result->n_facets;
  uint32_t site = first;

  do {
    add_site (merged, site);
    site = merger->heads[site];
  } while (site != first && merged->n_sites < room);
}

static void
add_plane (Merger *merger, const uint32_t *facets, uint32_t n, Merged *merged)
{
  const Site *sites = merger->result->set->sites;
  const uint32_t *corner = merger->result->facets[facets[0]];
  const uint32_t plane = root_of (merger->parent, facets[0]);
  uint32_t lowest = INDEX_NONE;

  for (uint32_t i = 0; i < 3 * n; i += 1) {
    const Side side = 3 * facets[i / 3] + i % 3;
    const uint32_t tail = tail_of (merger, side);

    if (root_of (merger->parent, merger->twins[side] / 3) == plane)
      continue;
    merger->heads[tail] = tail_of (merger, next_side (side));
    if (tail < lowest)
      lowest = tail;
  }
  add_polygon (
      merged, facing (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]]));
  walk_border (merger, lowest, merged);
}

static void
add_planes (Merger *merger, Merged *merged)
{
  const uint32_t n = merger->result->n_facets;
  uint32_t *order = memory_new (n, sizeof *order);
  uint32_t *start = list_by_plane (merger, order);

  for (uint32_t i = 0; i < n; i += 1)
    if (start[i] < start[i + 1])
      add_plane (merger, order + start[i], start[i + 1] - start[i], merged);
  free (start);
  free (order);
}

static void
merge (const Result *result, Merged *merged)
{
  const uint32_t n = result->n_facets;
  Merger merger = { .result = result };

  merger.twins = memory_new (3 * (size_t)n, sizeof *merger.twins);
  merger.parent = memory_new (n, sizeof *merger.parent);
  merger.heads = memory_new (result->set->n_sites, sizeof *merger.heads);
  find_twins (&merger);
  join_planes (&merger);
  add_planes (&merger, merged);
  free (merger.twins);
  free (merger.parent);
  free (merger.heads);
}

/* The two sides of the polygon whose corners are all sites. Its lower side is
 * seen from below, where it turns the other way. */
static void
add_two_sides (const Delaunay *delaunay, Merged *merged)
{
  const uint32_t n = delaunay->n_boundary;
  uint32_t lowest = 0;

  for (uint32_t i = 1; i < n; i += 1)
    if (delaunay->boundary[i] < delaunay->boundary[lowest])
      lowest = i;
  add_polygon (merged, FACING_LOWER);
  for (uint32_t i = 0; i < n; i += 1)
    add_site (merged, delaunay->boundary[(lowest + n - i) % n]);
  add_polygon (merged, FACING_UPPER);
  for (uint32_t i = 0; i < n; i += 1)
    add_site (merged, delaunay->boundary[(lowest + i) % n]);
}

void
merged_init (Merged *merged, const Result *result)
{
  const Delaunay *delaunay = &result->delaunay;
  const uint32_t n_facets = result->n_facets;

  *merged = (Merged){ NULL, 0, NULL, 0 };
  merged->polygons = memory_new (n_facets + 2, sizeof *merged->polygons);
  merged->sites
      = memory_new (3 * (size_t)n_facets + 2 * (size_t)delaunay->n_boundary,
                    sizeof *merged->sites);
  if (n_facets > 0)
    merge (result, merged);
  else if (delaunay->dimension == 2)
    add_two_sides (delaunay, merged);
}

void
merged_clear (Merged *merged)
{
  free (merged->polygons);
  free (merged->sites);
  memset (merged, 0, sizeof *merged);
}
