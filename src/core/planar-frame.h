/* Everything to show of a planar hull at one step: a pure function of
 * (trace, step), as frame.h. */
#ifndef PLANAR_FRAME_H
#define PLANAR_FRAME_H

#include "frame.h"
#include "planar-trace.h"
#include "scene.h"

typedef struct PlanarFrameEdge {
  uint32_t edge;
  uint32_t roles; /* FacetRole bits */
} PlanarFrameEdge;

typedef struct PlanarCounts {
  uint32_t corners; /* of the hull shown */
  uint32_t inside;  /* distinct sites ignored so far */
  uint32_t waiting; /* distinct sites in outside sets, or current */
  uint32_t outside_sets;
  uint32_t visible, horizon, cone, retired; /* of the current round so far */
} PlanarCounts;

typedef struct PlanarFrame {
  const PlanarTrace *trace; /* borrowed */
  uint32_t step, base;
  Place place;
  uint32_t round;   /* index into rounds, INDEX_NONE before */
  bool is_in_round; /* the round has not ended before this step */
  FrameSite *sites; /* one for each site of the set, in order */
  uint32_t n_sites;
  PlanarFrameEdge *edges; /* ascending number */
  uint32_t n_edges;
  uint32_t *corners; /* of the hull shown, counter-clockwise; of sites on
                        one line the two ends, or the only site */
  uint32_t n_corners;
  uint32_t horizon[2]; /* corners found so far */
  PlanarCounts counts;
} PlanarFrame;

void
planar_frame_init (PlanarFrame *frame, const PlanarTrace *trace, uint32_t step);
void planar_frame_clear (PlanarFrame *frame);

/* Fills @scene with the hull in the plane; for the plane view. */
void
scene_planar (Scene *scene, const PlanarFrame *frame, const SceneLook *look);

#endif
