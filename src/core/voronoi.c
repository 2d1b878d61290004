#include "voronoi.h"

#include "exact.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Whether the coordinate @value is right to a few units in the last place: its
 * rounding error is less than 8 DBL_EPSILON of @terms / |2 area|. */
static bool
is_settled (double value, double terms, double area)
{
  return terms <= 2 * fabs (value) * fabs (2 * area);
}

static Site
circumcentre (const Site *a, const Site *b, const Site *c)
{
  const double dx = b->x - a->x, dy = b->y - a->y;
  const double ex = c->x - a->x, ey = c->y - a->y;
  const double d = dx * dx + dy * dy, e = ex * ex + ey * ey;
  const double left = dx * ey, right = dy * ex;
  const double area = left - right;
  const double x_plus = d * ey, x_minus = e * dy;
  const double y_plus = e * dx, y_minus = d * ex;
  const double x = a->x + (x_plus - x_minus) / (2 * area);
  const double y = a->y + (y_plus - y_minus) / (2 * area);

  /* An area that cancels spoils all digits: only a stout triangle is
   * settled by doubles. */
  if (fabs (area) >= 0.25 * (fabs (left) + fabs (right))
      && is_settled (x, fabs (x_plus) + fabs (x_minus), area)
      && is_settled (y, fabs (y_plus) + fabs (y_minus), area))
    return (Site){ x, y };
  return exact_circumcentre (a, b, c);
}

/* Without branches, for nobody can guess which it is. */
static inline uint32_t
lowest_corner (const uint32_t site[3])
{
  const uint32_t k = site[1] < site[0];

  return site[2] < site[k] ? 2 : k;
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
    const uint32_t k = lowest_corner (site);

    /* The last bits must not tell which corner happens to be the first. */
    vertex->at
        = circumcentre (&sites[site[k]], &sites[site[k == 2 ? 0 : k + 1]],
                        &sites[site[k == 0 ? 2 : k - 1]]);
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
  /* Between its fields too: equal edges are equal bytes. */
  memset (row, 0, sizeof *row);
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

/* An edge of a site, and the site across it. */
typedef struct Incident {
  uint32_t edge, across;
} Incident;

/* Counts the edges of each site: start[s + 1] is where those of site s begin,
 * and then where its next one goes. */
static uint32_t *
count_incident (const Voronoi *voronoi)
{
  const uint32_t n = voronoi->delaunay->set->n_sites;
  uint32_t *start = memory_new ((size_t)n + 2, sizeof *start);
  uint32_t i;

  for (i = 0; i < voronoi->n_edges; i++) {
    start[voronoi->edges[i].site[0] + 2] += 1;
    start[voronoi->edges[i].site[1] + 2] += 1;
  }
  for (i = 2; i < n + 2; i++)
    start[i] += start[i - 1];
  return start;
}

/* Lists the edges of each site by counting.
 *
 * Returns: the lists; free with free(). */
static Incident *
list_incident (Voronoi *voronoi)
{
  uint32_t *start = count_incident (voronoi);
  Incident *incident
      = memory_room (2 * (size_t)voronoi->n_edges, sizeof *incident);
  uint32_t i;

  for (i = 0; i < voronoi->n_edges; i++) {
    const uint32_t *site = voronoi->edges[i].site;

    incident[start[site[0] + 1]++] = (Incident){ i, site[1] };
    incident[start[site[1] + 1]++] = (Incident){ i, site[0] };
  }
  voronoi->start = start;
  return incident;
}

/* Sorts them by the sites across, by going through all sites and putting their
 * edges into the lists of those across: so it does not matter to what is drawn
 * how edges are numbered. */
static void
add_incident (Voronoi *voronoi)
{
  const uint32_t n = voronoi->delaunay->set->n_sites;
  Incident *incident = list_incident (voronoi);
  uint32_t *next = memory_room ((size_t)n + 1, sizeof *next);
  uint32_t i;

  memcpy (next, voronoi->start, n * sizeof *next);
  voronoi->incident
      = memory_room (2 * (size_t)voronoi->n_edges, sizeof *voronoi->incident);
  for (i = 0; i < 2 * voronoi->n_edges; i++)
    voronoi->incident[next[incident[i].across]++] = incident[i].edge;
  free (incident);
  free (next);
}

void
voronoi_init (Voronoi *voronoi, const Delaunay *delaunay)
{
  uint32_t i;

  memset (voronoi, 0, sizeof *voronoi);
  voronoi->delaunay = delaunay;
  add_vertices (voronoi);
  voronoi->edges = memory_room (delaunay->n_edges, sizeof *voronoi->edges);
  for (i = 0; i < delaunay->n_edges; i++)
    add_edge (voronoi, i);
  add_incident (voronoi);
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
