/* Everything to show at one step of a trace, in flat arrays. A frame is a
 * pure function of (trace, step): the same step gives the same bytes,
 * whichever way it was reached.
 *
 *   Frame frame;
 *
 *   frame_init (&frame, trace, step);
 *   … frame.facets[i] …
 *   frame_clear (&frame);
 */
#ifndef FRAME_H
#define FRAME_H

#include "object.h"
#include "timeline.h"
#include "voronoi.h"

typedef enum SiteState {
  SITE_WAITING,   /* not on the hull yet */
  SITE_OUTSIDE,   /* waiting, in the outside set of the selected facet */
  SITE_APEX,      /* the site of the current round */
  SITE_INSERTED,  /* a vertex of the hull */
  SITE_DUPLICATE, /* equals an earlier site and is done */
  SITE_IGNORED,   /* lies inside a hull in the plane; never on lifts */
} SiteState;

typedef struct FrameSite {
  uint32_t site;
  SiteState state;
  bool is_changed; /* lies on the horizon: its cell changes in this round */
} FrameSite;

/* What a facet is at this step; a facet may be several things. */
typedef enum FacetRole {
  FACET_STANDS = 1,   /* belongs to the triangulation shown */
  FACET_SELECTED = 2, /* its outside set gave the current site */
  FACET_VISIBLE = 4,  /* seen by the current site; will go */
  FACET_CONE = 8,     /* born in the current round, an overlay until the
                         last visible facet is retired */
  FACET_RETIRED = 16, /* visible and gone from the hull, still part of the
                         triangulation shown */
  FACET_NEW = 32,     /* born in the current round, which is retired */
} FacetRole;

typedef struct FrameFacet {
  uint32_t facet; /* row of Trace.facets */
  uint32_t roles; /* FacetRole bits */
} FrameFacet;

typedef struct FrameRidge {
  uint32_t ridge;   /* its number in the trace */
  uint32_t site[2]; /* as of RidgeRow */
  uint32_t facet[2];
  bool is_coplanar; /* its two facets lie in one plane: a free diagonal, or a
                       line across a vertical or upper polygon */
} FrameRidge;

typedef struct FrameHorizon {
  uint32_t site[2]; /* tail and head, visible side on the left */
  uint32_t beyond;  /* facet on the other side */
} FrameHorizon;

typedef struct FrameCounts {
  uint32_t n_inserted;                      /* distinct sites on the hull */
  uint32_t facets, lower, upper, vertical;  /* of the triangulation shown */
  uint32_t visible, horizon, cone, retired; /* of the current round so far */
  uint32_t waiting;      /* distinct sites in outside sets, or current */
  uint32_t outside_sets; /* facets whose outside set is not empty */
  uint32_t triangles, delaunay_edges;
  uint32_t voronoi_vertices, voronoi_edges, rays;
} FrameCounts;

typedef struct Frame {
  const Trace *trace;  /* borrowed */
  uint32_t step, base; /* base: see trace_base() */
  Place place;
  uint32_t round;   /* index into Trace.rounds, INDEX_NONE before */
  FrameSite *sites; /* one for each site of the set, in order */
  uint32_t n_sites;
  FrameFacet *facets; /* ascending facet number */
  uint32_t n_facets;
  FrameRidge *ridges; /* of the hull at the base; ascending */
  uint32_t n_ridges;
  FrameHorizon *horizon; /* so far, in loop order */
  uint32_t n_horizon;
  bool *is_dying;    /* per Voronoi vertex: its circle contains the current
                        site, as far as found */
  Delaunay delaunay; /* at the base */
  Voronoi voronoi;
  FrameCounts counts;
} Frame;

void frame_init (Frame *frame, const Trace *trace, uint32_t step);

/* The same in pieces, one after the other, but that the hull and the diagrams
 * may be added by two threads at once. */
void frame_begin (Frame *frame, const Trace *trace, uint32_t step);
void frame_add_hull (Frame *frame);
void frame_add_diagrams (Frame *frame);
void frame_end (Frame *frame);

void frame_clear (Frame *frame);

/* Returns: a hash of all that the frame shows; equal frames, equal hashes. */
uint64_t frame_hash (const Frame *frame);

/* Returns: the roles of @facet, 0 when it is not in the frame. */
uint32_t frame_facet_roles (const Frame *frame, uint32_t facet);

#endif
