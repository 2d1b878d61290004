/* The Voronoi diagram, dual of a Delaunay triangulation: one vertex for each
 * circle group, one edge for each Delaunay edge that is not free, one cell
 * for each site. */
#ifndef VORONOI_H
#define VORONOI_H

#include "bisector.h"
#include "delaunay.h"

typedef struct VoronoiVertex {
  Site at;           /* the common circumcentre, as SiteSet.sites */
  uint32_t triangle; /* one triangle of the group */
} VoronoiVertex;

/* Two vertices: a segment. One: a ray from it along direction. None: a whole
 * line through the point `through`. */
typedef struct VoronoiEdge {
  uint32_t site[2];   /* it is equally near to these two */
  uint32_t vertex[2]; /* INDEX_NONE where it does not end */
  Site direction;     /* outward normal of the hull edge site[0], site[1],
                         any length; rays and lines only */
  Site through;       /* lines only */
  uint32_t edge;      /* the Delaunay edge that is its dual */
} VoronoiEdge;

typedef struct Voronoi {
  const Delaunay *delaunay; /* borrowed */
  VoronoiVertex *vertices;  /* number = circle group */
  uint32_t n_vertices;
  VoronoiEdge *edges;
  uint32_t n_edges;
  uint32_t n_rays;
  uint32_t *incident; /* edges of site s: incident[start[s]] … */
  uint32_t *start;    /* … incident[start[s + 1] - 1], ascending by the site
                         across; n_sites + 1 */
} Voronoi;

void voronoi_init (Voronoi *voronoi, const Delaunay *delaunay);
void voronoi_clear (Voronoi *voronoi);

/* Clips a Voronoi edge to @box, in units of SiteSet.sites, in doubles, before
 * anything is drawn.
 *
 * Returns: false when no part of it lies inside. */
bool voronoi_clip_edge (const Voronoi *voronoi,
                        uint32_t edge,
                        const Box *box,
                        Site ends[2]);

/* The cell of @site clipped to @box: a convex polygon, counter-clockwise.
 * @corners has room for n_edges of the cell + 4; see voronoi_cell_room().
 *
 * Returns: the number of corners, 0 when the cell misses the box or the
 *          site is not active. */
uint32_t voronoi_clip_cell (const Voronoi *voronoi,
                            uint32_t site,
                            const Box *box,
                            Site *corners);
uint32_t voronoi_cell_room (const Voronoi *voronoi, uint32_t site);

#endif
