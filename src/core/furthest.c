#include "furthest.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The upper facets that stand, with the circle of each. */
typedef struct Upper {
  const Frame *frame;
  uint32_t *facets; /* ascending */
  uint32_t *group;  /* per facet: the first facet of its circle, by index */
  uint32_t n;
} Upper;

static void
upper_init (Upper *upper, const Frame *frame)
{
  uint32_t i;

  upper->frame = frame;
  upper->facets = memory_new (frame->n_facets, sizeof *upper->facets);
  upper->group = memory_new (frame->n_facets, sizeof *upper->group);
  upper->n = 0;
  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t facet = frame->facets[i].facet;

    if (!(frame->facets[i].roles & FACET_STANDS)
        || frame->trace->facets[facet].facing != FACING_UPPER)
      continue;
    upper->facets[upper->n] = facet;
    upper->group[upper->n] = upper->n;
    upper->n += 1;
  }
}

/* Returns: the index of an upper facet, or INDEX_NONE. */
static uint32_t
upper_find (const Upper *upper, uint32_t facet)
{
  uint32_t low = 0, high = upper->n;

  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;

    if (upper->facets[middle] < facet)
      low = middle + 1;
    else
      high = middle;
  }
  return low < upper->n && upper->facets[low] == facet ? low : INDEX_NONE;
}

static uint32_t
root_of (const Upper *upper, uint32_t index)
{
  while (upper->group[index] != index)
    index = upper->group[index];
  return index;
}

/* Facets in one plane become one group, named by its lowest. */
static void
upper_join (Upper *upper, uint32_t a, uint32_t b)
{
  const uint32_t p = root_of (upper, a), q = root_of (upper, b);

  upper->group[p > q ? p : q] = p > q ? q : p;
}

static void
find_groups (Upper *upper)
{
  const Frame *frame = upper->frame;
  uint32_t i;

  for (i = 0; i < frame->n_ridges; i++) {
    const FrameRidge *row = &frame->ridges[i];
    const uint32_t a = upper_find (upper, row->facet[0]);
    const uint32_t b = upper_find (upper, row->facet[1]);

    if (row->is_coplanar && a != INDEX_NONE && b != INDEX_NONE)
      upper_join (upper, a, b);
  }
}

static Site
centre_of (const Site *sites, const uint32_t site[3])
{
  const Site *a = &sites[site[0]], *b = &sites[site[1]], *c = &sites[site[2]];
  const double dx = b->x - a->x, dy = b->y - a->y;
  const double ex = c->x - a->x, ey = c->y - a->y;
  const double d = dx * dx + dy * dy, e = ex * ex + ey * ey;
  const double area = dx * ey - dy * ex;

  return (Site){ a->x + (d * ey - e * dy) / (2 * area),
                 a->y + (e * dx - d * ex) / (2 * area) };
}

static void
add_vertex (Furthest *furthest, uint32_t facet, const uint32_t site[3])
{
  FurthestVertex *vertex = &furthest->vertices[furthest->n_vertices++];

  *vertex = (FurthestVertex){ .at = centre_of (furthest->sites, site),
                              .facet = facet };
  memcpy (vertex->site, site, sizeof vertex->site);
}

/* Replaces the group of each facet by the number of its vertex. A root comes
 * before all that point to it. */
static void
add_vertices (Furthest *furthest, Upper *upper)
{
  uint32_t i;

  furthest->vertices = memory_new (upper->n, sizeof *furthest->vertices);
  for (i = 0; i < upper->n; i++) {
    const uint32_t facet = upper->facets[i];

    if (upper->group[i] != i) {
      upper->group[i] = upper->group[upper->group[i]];
      continue;
    }
    upper->group[i] = furthest->n_vertices;
    add_vertex (furthest, facet, upper->frame->trace->facets[facet].site);
  }
}

static void
add_edge (Furthest *furthest, const Upper *upper, const FrameRidge *ridge)
{
  const uint32_t left = upper_find (upper, ridge->facet[0]);
  const uint32_t right = upper_find (upper, ridge->facet[1]);
  const bool is_turned = left == INDEX_NONE;
  FurthestEdge *edge;

  if (left == INDEX_NONE && right == INDEX_NONE)
    return;
  edge = &furthest->edges[furthest->n_edges++];
  *edge = (FurthestEdge){
    .site = { ridge->site[is_turned ? 1 : 0], ridge->site[is_turned ? 0 : 1] },
    .vertex = { upper->group[is_turned ? right : left], INDEX_NONE },
    .ridge = ridge->ridge
  };
  if (left == INDEX_NONE || right == INDEX_NONE)
    return;
  edge->vertex[1] = upper->group[right];
  edge->is_free = edge->vertex[0] == edge->vertex[1];
}

/* The corners are the tails of the edges on the hull. */
static void
add_corners (Furthest *furthest, uint32_t n_sites)
{
  bool *is_corner = memory_new (n_sites, sizeof *is_corner);
  uint32_t i;

  for (i = 0; i < furthest->n_edges; i++)
    is_corner[furthest->edges[i].site[0]]
        = is_corner[furthest->edges[i].site[1]] = true;
  furthest->corners = memory_new (n_sites, sizeof *furthest->corners);
  for (i = 0; i < n_sites; i++)
    if (is_corner[i])
      furthest->corners[furthest->n_corners++] = i;
  free (is_corner);
}

static void
add_hull (Furthest *furthest, const Frame *frame)
{
  Upper upper;
  uint32_t i;

  upper_init (&upper, frame);
  find_groups (&upper);
  /* Every path to a root is one step long from here on. */
  for (i = 0; i < upper.n; i++)
    upper.group[i] = root_of (&upper, i);
  add_vertices (furthest, &upper);
  furthest->edges = memory_new (frame->n_ridges, sizeof *furthest->edges);
  for (i = 0; i < frame->n_ridges; i++)
    add_edge (furthest, &upper, &frame->ridges[i]);
  add_corners (furthest, frame->n_sites);
  free (upper.facets);
  free (upper.group);
}

/* All on one circle: its centre is the only vertex, as in the nearest-site
 * diagram. All on one line: the two ends share the plane. */
static void
add_flat (Furthest *furthest, const Frame *frame)
{
  const Delaunay *delaunay = &frame->delaunay;
  const uint32_t n = delaunay->n_boundary;
  const uint32_t n_edges = delaunay->dimension == 2 ? n : 1;
  uint32_t i;

  furthest->vertices = memory_new (1, sizeof *furthest->vertices);
  furthest->edges = memory_new (n_edges, sizeof *furthest->edges);
  if (delaunay->dimension == 2)
    add_vertex (furthest, 0, delaunay->triangles[0].site);
  for (i = 0; delaunay->dimension >= 1 && i < n_edges; i++)
    furthest->edges[furthest->n_edges++] = (FurthestEdge){
      .site = { delaunay->boundary[i],
                delaunay->boundary[n_edges == 1 ? n - 1 : (i + 1) % n] },
      .vertex = { delaunay->dimension == 2 ? 0 : INDEX_NONE, INDEX_NONE },
      .ridge = INDEX_NONE
    };
  add_corners (furthest, frame->n_sites);
  if (delaunay->dimension == 0)
    furthest->corners[furthest->n_corners++] = delaunay->active[0];
}

void
furthest_init (Furthest *furthest, const Frame *frame, const Site *sites)
{
  memset (furthest, 0, sizeof *furthest);
  furthest->sites = sites;
  if (frame->trace->is_flat)
    add_flat (furthest, frame);
  else if (frame->n_ridges > 0)
    add_hull (furthest, frame);
}

void
furthest_clear (Furthest *furthest)
{
  free (furthest->corners);
  free (furthest->vertices);
  free (furthest->edges);
  memset (furthest, 0, sizeof *furthest);
}

/* Where on the bisector of an edge a vertex lies. */
static double
parameter_of (const Furthest *furthest,
              const Bisector *line,
              const FurthestEdge *edge,
              uint32_t vertex)
{
  const FurthestVertex *row = &furthest->vertices[vertex];
  const double t = bisector_parameter (line, &row->at);
  uint32_t k = 0;

  if (isfinite (t))
    return t;
  while (k < 2
         && (row->site[k] == edge->site[0] || row->site[k] == edge->site[1]))
    k++;
  return (double)bisector_side (&furthest->sites[edge->site[0]],
                                &furthest->sites[edge->site[1]],
                                &furthest->sites[row->site[k]])
         * (double)INFINITY;
}

/* Against the nearest-site diagram, the left vertex lies to the right of the
 * right one, and a ray runs to the left: inwards. */
bool
furthest_clip_edge (const Furthest *furthest,
                    uint32_t edge,
                    const Box *box,
                    Site ends[2])
{
  const FurthestEdge *row = &furthest->edges[edge];
  const Bisector line = bisector_of (&furthest->sites[row->site[0]],
                                     &furthest->sites[row->site[1]]);
  double t[2] = { -INFINITY, INFINITY };

  if (row->is_free)
    return false;
  if (row->vertex[0] != INDEX_NONE)
    t[0] = parameter_of (furthest, &line, row, row->vertex[0]);
  if (row->vertex[1] != INDEX_NONE)
    t[1] = parameter_of (furthest, &line, row, row->vertex[1]);
  if (!bisector_clip (&line, box, t))
    return false;
  ends[0] = bisector_at (&line, t[0]);
  ends[1] = bisector_at (&line, t[1]);
  return true;
}

uint32_t
furthest_clip_cell (const Furthest *furthest,
                    uint32_t corner,
                    const Box *box,
                    Site *room)
{
  const uint32_t site = furthest->corners[corner];
  uint32_t i, n = 4;

  box_corners (box, room);
  for (i = 0; i < furthest->n_edges && n > 0; i++) {
    const uint32_t *ends = furthest->edges[i].site;

    /* What is nearer to this site than to its neighbour goes. */
    if (ends[0] == site || ends[1] == site)
      n = bisector_cut (room, n, &furthest->sites[ends[ends[0] == site]],
                        &furthest->sites[site]);
  }
  return n < 3 ? 0 : n;
}
