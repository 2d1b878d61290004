#include "certify-mesh.h"

#include "exact.h"
#include "memory.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TOLERANCE 1e-9

static bool
is_near (double value, double truth)
{
  return fabs (value - truth) <= TOLERANCE * fabs (truth);
}

/* Whether @at is equally far from two sites, as far as its own digits tell. */
static bool
is_equally_far (const Site *at, const Site *p, const Site *q)
{
  const double to_p = hypot (at->x - p->x, at->y - p->y);
  const double to_q = hypot (at->x - q->x, at->y - q->y);
  const double last_digit = DBL_EPSILON * (fabs (at->x) + fabs (at->y));

  return fabs (to_p - to_q) <= TOLERANCE * to_p + 8 * last_digit;
}

static bool
check_centre (const Voronoi *voronoi, uint32_t triangle, char why[CERTIFY_ROOM])
{
  const Site *sites = voronoi->delaunay->set->sites;
  const Triangle *row = &voronoi->delaunay->triangles[triangle];
  const Site *a = &sites[row->site[0]];
  const Site *b = &sites[row->site[1]];
  const Site *c = &sites[row->site[2]];
  const Site *at = &voronoi->vertices[row->group].at;
  const Site centre = exact_circumcentre (a, b, c);

  if (!is_equally_far (at, a, b) || !is_equally_far (at, a, c)
      || !is_near (at->x, centre.x) || !is_near (at->y, centre.y))
    return certify_fault (why, "vertex %u is not the centre of triangle %u",
                          row->group, triangle);
  return true;
}

static bool
check_vertices (const Voronoi *voronoi, char why[CERTIFY_ROOM])
{
  const Delaunay *delaunay = voronoi->delaunay;

  if (voronoi->n_vertices != delaunay->n_groups)
    return certify_fault (why, "%u vertices for %u circle groups",
                          voronoi->n_vertices, delaunay->n_groups);
  for (uint32_t i = 0; i < voronoi->n_vertices; i += 1) {
    const uint32_t triangle = voronoi->vertices[i].triangle;

    if (triangle >= delaunay->n_triangles
        || delaunay->triangles[triangle].group != i)
      return certify_fault (why, "vertex %u has a wrong triangle", i);
  }
  for (uint32_t i = 0; i < delaunay->n_triangles; i += 1)
    if (!check_centre (voronoi, i, why))
      return false;
  return true;
}

static uint32_t
group_of (const Delaunay *delaunay, uint32_t triangle)
{
  return triangle == INDEX_NONE ? INDEX_NONE
                                : delaunay->triangles[triangle].group;
}

/* Checks that a ray or line runs at right angles to its Delaunay edge, a ray
 * to the right of it, which is outside. */
static bool
check_direction (const Voronoi *voronoi,
                 const VoronoiEdge *edge,
                 char why[CERTIFY_ROOM])
{
  const Site *sites = voronoi->delaunay->set->sites;
  const Site *tail = &sites[edge->site[0]], *head = &sites[edge->site[1]];
  const double x = head->x - tail->x, y = head->y - tail->y;
  const double along = edge->direction.x * x + edge->direction.y * y;
  const double right = edge->direction.x * y - edge->direction.y * x;
  const bool is_line = edge->vertex[0] == INDEX_NONE;

  if (!(fabs (along) <= TOLERANCE * fabs (right))
      || !(is_line ? right != 0 : right > 0))
    return certify_fault (why, "the dual of s%u s%u has a wrong direction",
                          edge->site[0], edge->site[1]);
  if (is_line && !is_equally_far (&edge->through, tail, head))
    return certify_fault (why, "the line between s%u and s%u is nearer to one",
                          edge->site[0], edge->site[1]);
  return true;
}

/* Two neighbouring triangles are in one group iff the edge between them is
 * free: a dual that is not free joins two vertices, it has a length. */
static bool
check_edge (const Voronoi *voronoi,
            const VoronoiEdge *edge,
            bool *is_seen,
            char why[CERTIFY_ROOM])
{
  const Delaunay *delaunay = voronoi->delaunay;
  const DelaunayEdge *dual;

  if (edge->edge >= delaunay->n_edges || is_seen[edge->edge])
    return certify_fault (why, "an edge has no dual of its own");
  is_seen[edge->edge] = true;
  dual = &delaunay->edges[edge->edge];
  if (dual->is_free || edge->site[0] != dual->site[0]
      || edge->site[1] != dual->site[1]
      || edge->vertex[0] != group_of (delaunay, dual->triangle[0])
      || edge->vertex[1] != group_of (delaunay, dual->triangle[1]))
    return certify_fault (why, "the edge between s%u and s%u is misplaced",
                          dual->site[0], dual->site[1]);
  return edge->vertex[1] != INDEX_NONE || check_direction (voronoi, edge, why);
}

static bool
check_edges (const Voronoi *voronoi, char why[CERTIFY_ROOM])
{
  const Delaunay *delaunay = voronoi->delaunay;
  bool *is_seen = memory_new (delaunay->n_edges, sizeof *is_seen);
  uint32_t n_edges = 0, n_rays = 0;
  bool is_good = true;

  for (uint32_t i = 0; i < delaunay->n_edges; i += 1)
    n_edges += delaunay->edges[i].is_free ? 0 : 1;
  for (uint32_t i = 0; i < voronoi->n_edges && is_good; i += 1) {
    const VoronoiEdge *edge = &voronoi->edges[i];

    is_good = check_edge (voronoi, edge, is_seen, why);
    if (edge->vertex[0] != INDEX_NONE && edge->vertex[1] == INDEX_NONE)
      n_rays += 1;
  }
  free (is_seen);
  if (is_good && (voronoi->n_edges != n_edges || voronoi->n_rays != n_rays))
    return certify_fault (why, "%u edges and %u rays instead of %u and %u",
                          voronoi->n_edges, voronoi->n_rays, n_edges, n_rays);
  return is_good;
}

/* @last has for each edge the last site that listed it. */
static bool
check_cell (const Voronoi *voronoi,
            uint32_t site,
            uint32_t *last,
            char why[CERTIFY_ROOM])
{
  for (uint32_t i = voronoi->start[site]; i < voronoi->start[site + 1];
       i += 1) {
    const uint32_t edge = voronoi->incident[i];

    if (edge >= voronoi->n_edges || last[edge] == site
        || (voronoi->edges[edge].site[0] != site
            && voronoi->edges[edge].site[1] != site))
      return certify_fault (why, "the cell of s%u lists a wrong edge", site);
    last[edge] = site;
  }
  return true;
}

/* An edge has two sites, so when no list has a wrong edge or one twice, lists
 * of twice the number of edges have all. */
static bool
check_cells (const Voronoi *voronoi, char why[CERTIFY_ROOM])
{
  const uint32_t n = voronoi->delaunay->set->n_sites;
  uint32_t *last;
  bool is_good = true;

  for (uint32_t i = 0; i < n; i += 1)
    is_good = is_good && voronoi->start[i] <= voronoi->start[i + 1];
  if (!is_good || voronoi->start[0] != 0
      || voronoi->start[n] != 2 * voronoi->n_edges)
    return certify_fault (why, "the cells list a wrong number of edges");

  last = memory_new (voronoi->n_edges, sizeof *last);
  memset (last, 0xff, voronoi->n_edges * sizeof *last);
  for (uint32_t i = 0; i < n && is_good; i += 1)
    is_good = check_cell (voronoi, i, last, why);
  free (last);
  return is_good;
}

bool
certify_voronoi (const Voronoi *voronoi, char why[CERTIFY_ROOM])
{
  return check_vertices (voronoi, why) && check_edges (voronoi, why)
         && check_cells (voronoi, why);
}
