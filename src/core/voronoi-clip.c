/* Clipping of Voronoi edges and cells to a rectangle, in doubles, so that a
 * vertex however far away never reaches a painter. */
#include "voronoi.h"

#include "predicate.h"

#include <math.h>

/* The bisector of two sites as middle + t · along, t growing to the left of
 * tail → head. */
typedef struct Bisector {
  Site middle, along;
} Bisector;

static Bisector
bisector_of (const Site *tail, const Site *head)
{
  return (Bisector){ { tail->x / 2 + head->x / 2, tail->y / 2 + head->y / 2 },
                     { tail->y - head->y, head->x - tail->x } };
}

/* A centre beyond the double range lies on the side of its triangle's third
 * corner just when the angle there is acute. */
static double
side_of_far_vertex (const Voronoi *voronoi,
                    uint32_t vertex,
                    const uint32_t edge[2])
{
  const Delaunay *delaunay = voronoi->delaunay;
  const Triangle *triangle
      = &delaunay->triangles[voronoi->vertices[vertex].triangle];
  const Site *sites = delaunay->set->sites;
  const Site *tail = &sites[edge[0]], *head = &sites[edge[1]];
  uint32_t k = 0;
  const Site *corner;
  double dot;

  while (triangle->site[k] == edge[0] || triangle->site[k] == edge[1])
    k++;
  corner = &sites[triangle->site[k]];
  dot = (tail->x - corner->x) * (head->x - corner->x)
        + (tail->y - corner->y) * (head->y - corner->y);
  return dot * orient (tail, head, corner) > 0 ? 1 : -1;
}

/* Where on the bisector a vertex lies. */
static double
parameter_of (const Voronoi *voronoi,
              const Bisector *line,
              uint32_t vertex,
              const uint32_t edge[2])
{
  const Site at = voronoi->vertices[vertex].at;
  const double length
      = line->along.x * line->along.x + line->along.y * line->along.y;
  const double t = ((at.x - line->middle.x) * line->along.x
                    + (at.y - line->middle.y) * line->along.y)
                   / length;

  if (isfinite (t))
    return t;
  return side_of_far_vertex (voronoi, vertex, edge) * INFINITY;
}

/* Narrows t[0] … t[1] to where low <= from + t · along <= high.
 *
 * Returns: false when nothing is left. */
static bool
narrow (double t[2], double from, double along, const double range[2])
{
  double enter, leave;

  if (along == 0)
    return range[0] <= from && from <= range[1];
  enter = (range[0] - from) / along;
  leave = (range[1] - from) / along;
  t[0] = fmax (t[0], fmin (enter, leave));
  t[1] = fmin (t[1], fmax (enter, leave));
  return t[0] < t[1];
}

static Site
point_at (const Bisector *line, double t)
{
  return (Site){ line->middle.x + t * line->along.x,
                 line->middle.y + t * line->along.y };
}

bool
voronoi_clip_edge (const Voronoi *voronoi,
                   uint32_t edge,
                   const Box *box,
                   Site ends[2])
{
  const VoronoiEdge *row = &voronoi->edges[edge];
  const Site *sites = voronoi->delaunay->set->sites;
  const Bisector line
      = bisector_of (&sites[row->site[0]], &sites[row->site[1]]);
  const double x[2] = { box->low.x, box->high.x };
  const double y[2] = { box->low.y, box->high.y };
  double whole[2] = { -INFINITY, INFINITY };
  double t[2];

  /* The left vertex lies to the left of the right one. */
  if (row->vertex[0] != INDEX_NONE)
    whole[1] = parameter_of (voronoi, &line, row->vertex[0], row->site);
  if (row->vertex[1] != INDEX_NONE)
    whole[0] = parameter_of (voronoi, &line, row->vertex[1], row->site);
  t[0] = whole[0];
  t[1] = whole[1];
  if (!narrow (t, line.middle.x, line.along.x, x)
      || !narrow (t, line.middle.y, line.along.y, y))
    return false;

  /* Edges that meet in the box meet in the very same point. */
  ends[0] = t[1] == whole[1] ? voronoi->vertices[row->vertex[0]].at
                             : point_at (&line, t[1]);
  ends[1] = t[0] == whole[0] ? voronoi->vertices[row->vertex[1]].at
                             : point_at (&line, t[0]);
  return true;
}

/* How far beyond the bisector a point lies, seen from its tail; only signs
 * and ratios count. */
static double
excess (const Site *point, const Bisector *line)
{
  return (point->x - line->middle.x) * line->along.y
         - (point->y - line->middle.y) * line->along.x;
}

/* Cuts away the part of a convex polygon that lies nearer to @other than to
 * @site. Works in place: one corner is read ahead, and at most one more is
 * written than read. */
static uint32_t
cut (Site *corners, uint32_t n, const Site *site, const Site *other)
{
  const Bisector line = bisector_of (site, other);
  const Site first = corners[0];
  Site last = corners[n - 1], here = first;
  uint32_t i, n_kept = 0;

  for (i = 0; i < n; i++) {
    const Site next = i + 1 < n ? corners[i + 1] : first;
    const double a = excess (&last, &line);
    const double b = excess (&here, &line);

    if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
      const double t = a / (a - b);

      corners[n_kept++] = (Site){ last.x + t * (here.x - last.x),
                                  last.y + t * (here.y - last.y) };
    }
    if (b <= 0)
      corners[n_kept++] = here;
    last = here;
    here = next;
  }
  return n_kept;
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

uint32_t
voronoi_clip_cell (const Voronoi *voronoi,
                   uint32_t site,
                   const Box *box,
                   Site *corners)
{
  const Site *sites = voronoi->delaunay->set->sites;
  uint32_t n = 4;
  uint32_t i;

  if (!is_active (voronoi->delaunay, site))
    return 0;
  corners[0] = box->low;
  corners[1] = (Site){ box->high.x, box->low.y };
  corners[2] = box->high;
  corners[3] = (Site){ box->low.x, box->high.y };
  for (i = voronoi->start[site]; i < voronoi->start[site + 1] && n > 0; i++) {
    const VoronoiEdge *edge = &voronoi->edges[voronoi->incident[i]];
    const uint32_t other = edge->site[edge->site[0] == site];

    n = cut (corners, n, &sites[site], &sites[other]);
  }
  return n < 3 ? 0 : n;
}
