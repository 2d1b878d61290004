#include "delaunay.h"

#include "flat.h"
#include "memory.h"
#include "trace-ridges.h"

#include <stdlib.h>
#include <string.h>

static void
start (Delaunay *delaunay, const SiteSet *set)
{
  memset (delaunay, 0, sizeof *delaunay);
  delaunay->set = set;
  delaunay->dimension = -1;
  delaunay->lift_dimension = -1;
  delaunay->active = memory_new (set->n_sites, sizeof (uint32_t));
}

static void
make_room (Delaunay *delaunay)
{
  delaunay->triangles = memory_room (2 * (size_t)delaunay->n_active,
                                     sizeof *delaunay->triangles);
  delaunay->edges
      = memory_new (3 * (size_t)delaunay->n_active, sizeof *delaunay->edges);
}

/* Adds the shadow of a lower facet. Seen from outside, that is from below,
 * the facet turns counter-clockwise, so its shadow turns the other way.
 *
 * Returns: the triangle's number. */
static uint32_t
add_triangle (Delaunay *delaunay, const uint32_t site[3], uint32_t facet)
{
  delaunay->triangles[delaunay->n_triangles]
      = (Triangle){ { site[0], site[2], site[1] },
                    { INDEX_NONE, INDEX_NONE, INDEX_NONE },
                    INDEX_NONE,
                    facet };
  return delaunay->n_triangles++;
}

/* Of a facet that stands and is no lower one. */
#define NO_TRIANGLE (INDEX_NONE - 1)

/* Returns: for each facet its triangle, NO_TRIANGLE, or INDEX_NONE when it
 *          does not stand; free with free(). */
static uint32_t *
add_triangles (Delaunay *delaunay, const Trace *trace, uint32_t base)
{
  uint32_t *triangle_of = memory_room (trace->n_facets, sizeof *triangle_of);
  uint32_t facet;

  for (facet = 0; facet < trace->n_facets; facet++) {
    const FacetRow *row = &trace->facets[facet];

    if (!span_has (row->span, base))
      triangle_of[facet] = INDEX_NONE;
    else if (row->facing != FACING_LOWER)
      triangle_of[facet] = NO_TRIANGLE;
    else
      triangle_of[facet] = add_triangle (delaunay, row->site, facet);
  }
  return triangle_of;
}

/* The edge of a triangle that begins at one of its sites; without branches, for
 * nobody can guess which. */
static inline uint32_t
edge_from (const Triangle *triangle, uint32_t tail)
{
  return (uint32_t)(triangle->site[1] == tail)
         + 2 * (uint32_t)(triangle->site[2] == tail);
}

/* Links two triangles along an edge.
 *
 * Returns: whether they have one circumcircle. */
static bool
link_triangles (Delaunay *delaunay, const DelaunayEdge *edge)
{
  const Site *sites = delaunay->set->sites;
  Triangle *left = &delaunay->triangles[edge->triangle[0]];
  Triangle *right = &delaunay->triangles[edge->triangle[1]];
  const uint32_t k = edge_from (right, edge->site[1]);
  const uint32_t opposite = right->site[k == 0 ? 2 : k - 1];

  left->neighbour[edge_from (left, edge->site[0])] = edge->triangle[1];
  right->neighbour[k] = edge->triangle[0];
  return is_on_circle (&sites[left->site[0]], &sites[left->site[1]],
                       &sites[left->site[2]], &sites[opposite]);
}

static void
add_edge (Delaunay *delaunay, const uint32_t site[2], const uint32_t side[2])
{
  DelaunayEdge *edge = &delaunay->edges[delaunay->n_edges++];

  *edge = (DelaunayEdge){ { site[0], site[1] }, { side[0], side[1] }, false };
  if (side[1] != INDEX_NONE)
    edge->is_free = link_triangles (delaunay, edge);
}

/* Adds the shadow of a ridge, whose sites have facet[0] on their left from
 * outside, if it touches a lower facet. In the plane the shadow of the left
 * facet lies to its right. */
static void
add_ridge (Delaunay *delaunay,
           const uint32_t *triangle_of,
           const uint32_t site[2],
           const uint32_t facet[2])
{
  const uint32_t left = triangle_of[facet[1]];
  const uint32_t right = triangle_of[facet[0]];

  if (left != NO_TRIANGLE)
    add_edge (delaunay, site,
              (uint32_t[2]){ left, right == NO_TRIANGLE ? INDEX_NONE : right });
  else if (right != NO_TRIANGLE)
    add_edge (delaunay, (uint32_t[2]){ site[1], site[0] },
              (uint32_t[2]){ right, INDEX_NONE });
}

/* Follows the edges that have a triangle on their left only. */
static void
walk_boundary (Delaunay *delaunay)
{
  uint32_t *next = memory_room (delaunay->set->n_sites, sizeof *next);
  uint32_t first = INDEX_NONE;
  uint32_t i, site;

  for (i = 0; i < delaunay->n_edges; i++) {
    const DelaunayEdge *edge = &delaunay->edges[i];

    if (edge->triangle[1] != INDEX_NONE)
      continue;
    next[edge->site[0]] = edge->site[1];
    if (edge->site[0] < first)
      first = edge->site[0];
  }
  delaunay->boundary
      = memory_new (delaunay->n_active, sizeof *delaunay->boundary);
  site = first;
  do {
    delaunay->boundary[delaunay->n_boundary++] = site;
    site = next[site];
  } while (site != first && delaunay->n_boundary < delaunay->n_active);
  free (next);
}

/* Floods each circle group over its free edges from its first triangle. */
static void
number_groups (Delaunay *delaunay)
{
  const uint32_t n = delaunay->n_triangles;
  uint32_t *stack = memory_room (n, sizeof *stack);
  uint32_t *is_free = memory_new (n, sizeof *is_free); /* bits of its edges */
  uint32_t i, k;

  for (i = 0; i < delaunay->n_edges; i++) {
    const DelaunayEdge *edge = &delaunay->edges[i];

    for (k = 0; edge->is_free && k < 6; k++) {
      const uint32_t triangle = edge->triangle[k / 3];

      if (delaunay->triangles[triangle].neighbour[k % 3]
          == edge->triangle[1 - k / 3])
        is_free[triangle] |= 1U << (k % 3);
    }
  }
  for (i = 0; i < n; i++) {
    uint32_t n_stack = 0;

    if (delaunay->triangles[i].group != INDEX_NONE)
      continue;
    delaunay->triangles[i].group = delaunay->n_groups;
    stack[n_stack++] = i;
    while (n_stack > 0) {
      const uint32_t at = stack[--n_stack];

      for (k = 0; k < 3; k++) {
        const uint32_t to = delaunay->triangles[at].neighbour[k];

        if ((is_free[at] >> k & 1U) == 0
            || delaunay->triangles[to].group != INDEX_NONE)
          continue;
        delaunay->triangles[to].group = delaunay->n_groups;
        stack[n_stack++] = to;
      }
    }
    delaunay->n_groups += 1;
  }
  free (stack);
  free (is_free);
}

/* Sites on one circle: their hull, cut into a fan. */
static void
add_fan (Delaunay *delaunay)
{
  const uint32_t *corner = delaunay->boundary;
  const uint32_t n = delaunay->n_boundary;
  uint32_t i;

  delaunay->triangles = memory_room (n, sizeof *delaunay->triangles);
  delaunay->edges = memory_new (2 * (size_t)n, sizeof *delaunay->edges);
  for (i = 0; i + 2 < n; i++)
    delaunay->triangles[i]
        = (Triangle){ { corner[0], corner[i + 1], corner[i + 2] },
                      { INDEX_NONE, INDEX_NONE, INDEX_NONE },
                      INDEX_NONE,
                      i };
  delaunay->n_triangles = n - 2;
  for (i = 0; i < n; i++) {
    const uint32_t triangle = i == 0 ? 0 : (i == n - 1 ? n - 3 : i - 1);

    add_edge (delaunay, (uint32_t[2]){ corner[i], corner[(i + 1) % n] },
              (uint32_t[2]){ triangle, INDEX_NONE });
  }
  for (i = 0; i + 3 < n; i++)
    add_edge (delaunay, (uint32_t[2]){ corner[0], corner[i + 2] },
              (uint32_t[2]){ i + 1, i });
}

static void
add_segments (Delaunay *delaunay)
{
  const uint32_t none[2] = { INDEX_NONE, INDEX_NONE };
  uint32_t i;

  delaunay->edges = memory_new (delaunay->n_active, sizeof *delaunay->edges);
  for (i = 0; i + 1 < delaunay->n_boundary; i++)
    add_edge (delaunay, &delaunay->boundary[i], none);
}

static void
init_flat (Delaunay *delaunay)
{
  const uint32_t n = delaunay->n_active;

  delaunay->boundary = memory_new (n, sizeof *delaunay->boundary);
  memcpy (delaunay->boundary, delaunay->active, n * sizeof *delaunay->boundary);
  delaunay->n_boundary = n;
  delaunay->dimension = flat_sort (delaunay->set, delaunay->boundary, n);
  delaunay->lift_dimension = n > 3 ? 2 : (int)n - 1;
  if (delaunay->dimension == 2)
    add_fan (delaunay);
  else
    add_segments (delaunay);
}

/* Adds the ridges that were born with a facet and stand. */
static void
add_born (Delaunay *delaunay,
          const Trace *trace,
          const uint32_t *triangle_of,
          RidgeCursor *cursor,
          uint32_t facet)
{
  const uint32_t *site = trace->facets[facet].site;
  BornRidge born[3];
  const uint32_t n = trace_born_ridges (trace, cursor, facet, born);
  uint32_t i;

  for (i = 0; i < n; i++) {
    const uint32_t k = born[i].k;

    if (triangle_of[born[i].right] != INDEX_NONE)
      add_ridge (delaunay, triangle_of,
                 (uint32_t[2]){ site[k], site[k == 2 ? 0 : k + 1] },
                 (uint32_t[2]){ facet, born[i].right });
  }
}

static void
init_hull (Delaunay *delaunay, const Trace *trace, uint32_t base)
{
  RidgeCursor cursor = RIDGE_CURSOR;
  uint32_t *triangle_of;
  uint32_t facet;

  make_room (delaunay);
  triangle_of = add_triangles (delaunay, trace, base);
  for (facet = 0; facet < trace->n_facets; facet++)
    if (triangle_of[facet] != INDEX_NONE)
      add_born (delaunay, trace, triangle_of, &cursor, facet);
  free (triangle_of);
}

static void
init_batch (Delaunay *delaunay, const Batch *batch)
{
  const Site *sites = delaunay->set->sites;
  uint32_t *triangle_of = memory_new (batch->n_facets, sizeof *triangle_of);
  uint32_t i, k;

  make_room (delaunay);
  for (i = 0; i < batch->n_facets; i++) {
    const uint32_t *s = batch->facets[i].site;

    triangle_of[i] = NO_TRIANGLE;
    if (facing (&sites[s[0]], &sites[s[1]], &sites[s[2]]) == FACING_LOWER)
      triangle_of[i] = add_triangle (delaunay, s, i);
  }
  for (i = 0; i < batch->n_facets; i++)
    for (k = 0; k < 3; k++) {
      const HullFacet *row = &batch->facets[i];
      const uint32_t other = row->across[k] >> 2;

      /* Each ridge once, from the facet of the lower number. */
      if (i < other)
        add_ridge (delaunay, triangle_of,
                   (uint32_t[2]){ row->site[k], row->site[(k + 1) % 3] },
                   (uint32_t[2]){ i, other });
    }
  free (triangle_of);
}

bool
delaunay_is_extreme (const Delaunay *delaunay, uint32_t index)
{
  const Site *sites = delaunay->set->sites;
  const uint32_t n = delaunay->n_boundary;
  const uint32_t *site = delaunay->boundary;

  if (delaunay->dimension < 2)
    return index == 0 || index == n - 1;
  return orient (&sites[site[(index + n - 1) % n]], &sites[site[index]],
                 &sites[site[(index + 1) % n]])
         != 0;
}

/* What follows from triangles and edges. */
static void
finish (Delaunay *delaunay, bool is_flat)
{
  uint32_t i;

  if (!is_flat) {
    delaunay->dimension = 2;
    delaunay->lift_dimension = 3;
    walk_boundary (delaunay);
  }
  number_groups (delaunay);
  for (i = 0; i < delaunay->n_boundary; i++)
    delaunay->n_extreme += delaunay_is_extreme (delaunay, i);
}

void
delaunay_init (Delaunay *delaunay, const Trace *trace, uint32_t step)
{
  const uint32_t base = trace_base (trace, step);
  uint32_t site;

  start (delaunay, trace->set);
  if (step < trace->simplex_end)
    return;
  for (site = 0; site < trace->set->n_sites; site++)
    if (trace->inserted[site] <= base)
      delaunay->active[delaunay->n_active++] = site;
  if (trace->is_flat)
    init_flat (delaunay);
  else
    init_hull (delaunay, trace, base);
  finish (delaunay, trace->is_flat);
}

void
delaunay_init_batch (Delaunay *delaunay, const SiteSet *set, const Batch *batch)
{
  uint32_t site;

  start (delaunay, set);
  for (site = 0; site < set->n_sites; site++)
    if (set->first[site] == site)
      delaunay->active[delaunay->n_active++] = site;
  if (batch->n_facets == 0)
    init_flat (delaunay);
  else
    init_batch (delaunay, batch);
  finish (delaunay, batch->n_facets == 0);
}

void
delaunay_clear (Delaunay *delaunay)
{
  free (delaunay->active);
  free (delaunay->triangles);
  free (delaunay->edges);
  free (delaunay->boundary);
  memset (delaunay, 0, sizeof *delaunay);
}
