/* The furthest-site diagrams, which the upper hull casts: its facets' shadows
 * are the furthest-site Delaunay triangulation, whose dual is the
 * furthest-site Voronoi diagram. Only strictly extreme sites have cells, and
 * all cells are unbounded: the ray of a hull edge runs inwards.
 *
 * The diagram is that of the triangulation shown in a frame, of sites in
 * units of the caller's choice, so that it can be drawn at any scale.
 */
#ifndef FURTHEST_H
#define FURTHEST_H

#include "frame.h"

/* A circle that holds all sites: of an upper facet, or of several that lie in
 * one plane. */
typedef struct FurthestVertex {
  Site at;
  uint32_t facet;   /* the lowest-numbered; of flat input, triangle 0 */
  uint32_t site[3]; /* on the circle, counter-clockwise */
} FurthestVertex;

/* Two vertices: a segment. One: a ray. None: a whole line. */
typedef struct FurthestEdge {
  uint32_t site[2];   /* tail and head, vertex[0] belongs to their left */
  uint32_t vertex[2]; /* INDEX_NONE where it does not end */
  uint32_t ridge;     /* row of Trace.ridges, or INDEX_NONE */
  bool is_free;       /* a diagonal of a circle: no Voronoi edge */
} FurthestEdge;

typedef struct Furthest {
  const Site *sites; /* borrowed; by site number */
  uint32_t *corners; /* sites with a cell: strictly extreme, ascending */
  uint32_t n_corners;
  FurthestVertex *vertices;
  uint32_t n_vertices;
  FurthestEdge *edges;
  uint32_t n_edges;
} Furthest;

/* Empty before the first simplex is complete. */
void furthest_init (Furthest *furthest, const Frame *frame, const Site *sites);
void furthest_clear (Furthest *furthest);

/* Clips the Voronoi edge of @edge to @box.
 *
 * Returns: false when no part of it lies inside, or it is free. */
bool furthest_clip_edge (const Furthest *furthest,
                         uint32_t edge,
                         const Box *box,
                         Site ends[2]);

/* The cell of corners[corner] clipped to @box: convex, counter-clockwise.
 *
 * Shape:   @room has room for n_edges + 4 corners.
 * Returns: the number of its corners, 0 when it misses the box. */
uint32_t furthest_clip_cell (const Furthest *furthest,
                             uint32_t corner,
                             const Box *box,
                             Site *room);

#endif
