/* Clipping of Voronoi edges and cells to a rectangle, in doubles, so that a
 * vertex however far away never reaches a painter. */
#include "voronoi.h"

#include <math.h>

/* The end of the edge towards which a centre beyond the double range lies. */
static int
side_of_far_vertex (const Voronoi *voronoi,
                    uint32_t vertex,
                    const uint32_t edge[2])
{
  const Delaunay *delaunay = voronoi->delaunay;
  const Triangle *triangle
      = &delaunay->triangles[voronoi->vertices[vertex].triangle];
  const Site *sites = delaunay->set->sites;
  uint32_t k = 0;

  while (triangle->site[k] == edge[0] || triangle->site[k] == edge[1])
    k++;
  return bisector_side (&sites[edge[0]], &sites[edge[1]],
                        &sites[triangle->site[k]]);
}

/* Where on the bisector a vertex lies. */
static double
parameter_of (const Voronoi *voronoi,
              const Bisector *line,
              uint32_t vertex,
              const uint32_t edge[2])
{
  const double t = bisector_parameter (line, &voronoi->vertices[vertex].at);

  if (isfinite (t))
    return t;
  return (double)side_of_far_vertex (voronoi, vertex, edge) * (double)INFINITY;
}

static bool
is_in (const Box *box, const Site *at)
{
  return box->low.x <= at->x && at->x <= box->high.x && box->low.y <= at->y
         && at->y <= box->high.y;
}

/* Returns: whether it ends in the box at both ends, which most edges do; then
 *          they are in @ends, the left one first. */
static bool
ends_in_box (const Voronoi *voronoi,
             const VoronoiEdge *edge,
             const Box *box,
             Site ends[2])
{
  int i;

  for (i = 0; i < 2; i++) {
    if (edge->vertex[i] == INDEX_NONE)
      return false;
    ends[i] = voronoi->vertices[edge->vertex[i]].at;
  }
  return is_in (box, &ends[0]) && is_in (box, &ends[1]);
}

bool
voronoi_clip_edge (const Voronoi *voronoi,
                   uint32_t edge,
                   const Box *box,
                   Site ends[2])
{
  const VoronoiEdge *row = &voronoi->edges[edge];
  const Site *sites = voronoi->delaunay->set->sites;
  double whole[2] = { -INFINITY, INFINITY };
  Bisector line;
  double t[2];

  if (ends_in_box (voronoi, row, box, ends))
    return ends[0].x != ends[1].x || ends[0].y != ends[1].y;
  line = bisector_of (&sites[row->site[0]], &sites[row->site[1]]);
  /* The left vertex lies to the left of the right one. */
  if (row->vertex[0] != INDEX_NONE)
    whole[1] = parameter_of (voronoi, &line, row->vertex[0], row->site);
  if (row->vertex[1] != INDEX_NONE)
    whole[0] = parameter_of (voronoi, &line, row->vertex[1], row->site);
  t[0] = whole[0];
  t[1] = whole[1];
  if (!bisector_clip (&line, box, t))
    return false;

  /* Edges that meet in the box meet in the very same point. */
  ends[0] = t[1] == whole[1] ? voronoi->vertices[row->vertex[0]].at
                             : bisector_at (&line, t[1]);
  ends[1] = t[0] == whole[0] ? voronoi->vertices[row->vertex[1]].at
                             : bisector_at (&line, t[0]);
  return true;
}

uint32_t
voronoi_cell_room (const Voronoi *voronoi, uint32_t site)
{
  return voronoi->start[site + 1] - voronoi->start[site] + 4;
}

static bool
is_active (const Delaunay *delaunay, uint32_t site)
{
  uint32_t low = 0, high = delaunay->n_active;

  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;

    if (delaunay->active[middle] < site)
      low = middle + 1;
    else
      high = middle;
  }
  return low < delaunay->n_active && delaunay->active[low] == site;
}

#define N_SIDES 16 /* of a cell that is walked round, at most */

/* Goes round a cell, counter-clockwise, whose vertices all lie in the box.
 *
 * Returns: the number of corners, 0 when it is not such a cell. */
static uint32_t
walk_round (const Voronoi *voronoi,
            uint32_t site,
            const Box *box,
            Site *corners)
{
  const uint32_t *incident = &voronoi->incident[voronoi->start[site]];
  const uint32_t n = voronoi->start[site + 1] - voronoi->start[site];
  uint32_t tails[N_SIDES], heads[N_SIDES];
  uint32_t i, k, at;

  if (n < 3 || n > N_SIDES)
    return 0;
  for (i = 0; i < n; i++) {
    const VoronoiEdge *edge = &voronoi->edges[incident[i]];
    const int is_tail = edge->site[0] == site;

    tails[i] = edge->vertex[is_tail];
    heads[i] = edge->vertex[!is_tail];
    if (tails[i] == INDEX_NONE || !is_in (box, &voronoi->vertices[tails[i]].at))
      return 0;
  }
  for (i = 0, at = tails[0]; i < n; i++) {
    corners[i] = voronoi->vertices[at].at;
    for (k = 0; k < n && tails[k] != at; k++)
      continue;
    if (k == n)
      return 0;
    at = heads[k];
  }
  return n;
}

uint32_t
voronoi_clip_cell (const Voronoi *voronoi,
                   uint32_t site,
                   const Box *box,
                   Site *corners)
{
  const Site *sites = voronoi->delaunay->set->sites;
  uint32_t n = walk_round (voronoi, site, box, corners);
  uint32_t i;

  if (n > 0)
    return n;
  if (!is_active (voronoi->delaunay, site))
    return 0;
  n = 4;
  box_corners (box, corners);
  for (i = voronoi->start[site]; i < voronoi->start[site + 1] && n > 0; i++) {
    const VoronoiEdge *edge = &voronoi->edges[voronoi->incident[i]];
    const uint32_t other = edge->site[edge->site[0] == site];

    n = bisector_cut (corners, n, &sites[site], &sites[other]);
  }
  return n < 3 ? 0 : n;
}
