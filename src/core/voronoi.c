#include "voronoi.h"

#include "exact.h"
#include "memory.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One coordinate of the circumcentre and a bound on its rounding error, from
 * the differences d, e of two corners to the corner at @origin. */
typedef struct Rounded {
  double value, doubt;
} Rounded;

static Rounded
centre_coordinate (double origin, double plus, double minus, double area)
{
  const double offset = (plus - minus) / (2 * area);
  const double spread = (fabs (plus) + fabs (minus)) / fabs (2 * area);

  return (Rounded){ origin + offset, 8 * DBL_EPSILON * spread };
}

/* Whether the value is right to a few units in the last place. */
static bool
is_settled (Rounded rounded)
{
  return rounded.doubt <= 16 * DBL_EPSILON * fabs (rounded.value);
}

static Site
circumcentre (const Site *a, const Site *b, const Site *c)
{
  const double dx = b->x - a->x, dy = b->y - a->y;
  const double ex = c->x - a->x, ey = c->y - a->y;
  const double d = dx * dx + dy * dy, e = ex * ex + ey * ey;
  const double left = dx * ey, right = dy * ex;
  const double area = left - right;
  const Rounded x = centre_coordinate (a->x, d * ey, e * dy, area);
  const Rounded y = centre_coordinate (a->y, e * dx, d * ex, area);

  /* An area that cancels spoils all digits: only a stout triangle is
   * settled by doubles. */
  if (fabs (area) >= 0.25 * (fabs (left) + fabs (right)) && is_settled (x)
      && is_settled (y))
    return (Site){ x.value, y.value };
  return exact_circumcentre (a, b, c);
}

static int
lowest_corner (const uint32_t site[3])
{
  if (site[0] < site[1])
    return site[0] < site[2] ? 0 : 2;
  return site[1] < site[2] ? 1 : 2;
}

static void
add_vertices (Voronoi *voronoi)
{
  const Delaunay *delaunay = voronoi->delaunay;
  const Site *sites = delaunay->set->sites;
  uint32_t i;

  voronoi->n_vertices = delaunay->n_groups;
  voronoi->vertices
      = memory_new (voronoi->n_vertices, sizeof *voronoi->vertices);
  for (i = delaunay->n_triangles; i-- > 0;) {
    const Triangle *triangle = &delaunay->triangles[i];

    voronoi->vertices[triangle->group].triangle = i;
  }
  for (i = 0; i < voronoi->n_vertices; i++) {
    VoronoiVertex *vertex = &voronoi->vertices[i];
    const uint32_t *site = delaunay->triangles[vertex->triangle].site;
    const int k = lowest_corner (site);

    /* The last bits must not tell which corner happens to be the first. */
    vertex->at = circumcentre (&sites[site[k]], &sites[site[(k + 1) % 3]],
                               &sites[site[(k + 2) % 3]]);
  }
}

static uint32_t
vertex_of (const Delaunay *delaunay, uint32_t triangle)
{
  return triangle == INDEX_NONE ? INDEX_NONE
                                : delaunay->triangles[triangle].group;
}

/* A Delaunay edge with a triangle on its left only lies on the hull: the
 * outward normal is to its right. */
static void
add_edge (Voronoi *voronoi, uint32_t edge)
{
  const Delaunay *delaunay = voronoi->delaunay;
  const DelaunayEdge *dual = &delaunay->edges[edge];
  const Site *tail = &delaunay->set->sites[dual->site[0]];
  const Site *head = &delaunay->set->sites[dual->site[1]];
  VoronoiEdge *row;

  if (dual->is_free)
    return;
  row = &voronoi->edges[voronoi->n_edges++];
  row->site[0] = dual->site[0];
  row->site[1] = dual->site[1];
  row->vertex[0] = vertex_of (delaunay, dual->triangle[0]);
  row->vertex[1] = vertex_of (delaunay, dual->triangle[1]);
  row->edge = edge;
  if (row->vertex[1] == INDEX_NONE) {
    row->direction = (Site){ head->y - tail->y, tail->x - head->x };
    row->through
        = (Site){ tail->x / 2 + head->x / 2, tail->y / 2 + head->y / 2 };
    voronoi->n_rays += row->vertex[0] != INDEX_NONE;
  }
}

/* Lists the edges of each site by counting. */
static void
add_incident (Voronoi *voronoi)
{
  const uint32_t n = voronoi->delaunay->set->n_sites;
  uint32_t *start = memory_new ((size_t)n + 2, sizeof *start);
  uint32_t i;

  /* start[s + 2] counts, then start[s + 1] is where site s's next goes. */
  for (i = 0; i < 2 * voronoi->n_edges; i++)
    start[voronoi->edges[i / 2].site[i % 2] + 2] += 1;
  for (i = 2; i < n + 2; i++)
    start[i] += start[i - 1];
  voronoi->incident
      = memory_new (2 * (size_t)voronoi->n_edges, sizeof (uint32_t));
  for (i = 0; i < 2 * voronoi->n_edges; i++) {
    uint32_t *next = &start[voronoi->edges[i / 2].site[i % 2] + 1];

    voronoi->incident[*next] = i / 2;
    *next += 1;
  }
  voronoi->start = start;
}

/* Lists them by the sites across: so it does not matter to what is drawn how
 * edges are numbered. */
static void
sort_incident (Voronoi *voronoi)
{
  const uint32_t n = voronoi->delaunay->set->n_sites;
  uint32_t *sorted = memory_new (2 * (size_t)voronoi->n_edges, sizeof *sorted);
  uint32_t *next = memory_new ((size_t)n + 1, sizeof *next);
  uint32_t site, i;

  memcpy (next, voronoi->start, n * sizeof *next);
  for (site = 0; site < n; site++)
    for (i = voronoi->start[site]; i < voronoi->start[site + 1]; i++) {
      const uint32_t edge = voronoi->incident[i];
      const uint32_t *ends = voronoi->edges[edge].site;

      sorted[next[ends[ends[0] == site]]++] = edge;
    }
  free (voronoi->incident);
  free (next);
  voronoi->incident = sorted;
}

void
voronoi_init (Voronoi *voronoi, const Delaunay *delaunay)
{
  uint32_t i;

  memset (voronoi, 0, sizeof *voronoi);
  voronoi->delaunay = delaunay;
  add_vertices (voronoi);
  voronoi->edges = memory_new (delaunay->n_edges, sizeof *voronoi->edges);
  for (i = 0; i < delaunay->n_edges; i++)
    add_edge (voronoi, i);
  add_incident (voronoi);
  sort_incident (voronoi);
}

void
voronoi_clear (Voronoi *voronoi)
{
  free (voronoi->vertices);
  free (voronoi->edges);
  free (voronoi->incident);
  free (voronoi->start);
  memset (voronoi, 0, sizeof *voronoi);
}
