/* The Delaunay triangulation at a step: the shadows of the lower facets.
 *
 * A circle group is a maximal set of neighbouring triangles with one common
 * circumcircle; the edges inside it are free: any other diagonals would be
 * Delaunay too.
 */
#ifndef DELAUNAY_H
#define DELAUNAY_H

#include "batch.h"
#include "trace.h"

typedef struct Triangle {
  uint32_t site[3];      /* counter-clockwise in the plane */
  uint32_t neighbour[3]; /* across site[i], site[i+1]; INDEX_NONE outside */
  uint32_t group;        /* its circle group */
  uint32_t facet;        /* the lower facet whose shadow it is; its own index
                            when the input is flat */
} Triangle;

typedef struct DelaunayEdge {
  uint32_t site[2];     /* tail and head */
  uint32_t triangle[2]; /* left, right; right INDEX_NONE on the boundary;
                           both INDEX_NONE in dimension 1 */
  bool is_free;         /* inside a circle group */
} DelaunayEdge;

typedef struct Delaunay {
  const SiteSet *set;
  int dimension;      /* of the active sites: -1 none, 0, 1 a line, 2 */
  int lift_dimension; /* of their lifts: -1 … 3 */
  uint32_t *active;   /* sites inserted, ascending */
  uint32_t n_active;
  Triangle *triangles;
  uint32_t n_triangles;
  DelaunayEdge *edges;
  uint32_t n_edges;
  uint32_t *boundary; /* all sites on the boundary of the 2-d hull, counter-
                         clockwise; dimension 1: all sites along the line */
  uint32_t n_boundary;
  uint32_t n_extreme; /* strictly extreme sites among them */
  uint32_t n_groups;
} Delaunay;

/* The triangulation after the last retired round at @step. Before the first
 * simplex is complete nothing is active.
 *
 * Cost: O(n log n) in the facets ever born up to @step.
 */
void delaunay_init (Delaunay *delaunay, const Trace *trace, uint32_t step);

/* The triangulation of a whole set from the batch engine, whose sites were
 * SiteSet.sites. A triangle's facet is its number in @batch. */
void delaunay_init_batch (Delaunay *delaunay,
                          const SiteSet *set,
                          const Batch *batch);
void delaunay_clear (Delaunay *delaunay);

/* Returns: whether the boundary site at @index is a corner of the hull. */
bool delaunay_is_extreme (const Delaunay *delaunay, uint32_t index);

#endif
