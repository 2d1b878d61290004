/* A result: triangulation, diagram and hull of sites, however it was come by.
 */
#ifndef RESULT_H
#define RESULT_H

#include "voronoi.h"

typedef struct Result {
  const SiteSet *set; /* borrowed */
  Delaunay delaunay;
  Voronoi voronoi;
  uint32_t (*facets)[3]; /* counter-clockwise seen from outside; none when the
                            input is flat */
  uint32_t n_facets;
} Result;

/* What stands at a step of a trace. */
void result_init (Result *result, const Trace *trace, uint32_t step);

/* Of the whole set, without a trace.
 *
 * Units: of @order, as batch_build(). */
void result_init_batch (Result *result, const SiteSet *set, const Order *order);
void result_clear (Result *result);

#endif
