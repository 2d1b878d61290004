/* The cavity in one pass, for the batch build: the visible facets, their
 * horizon in loop order and the planes of its cone, where horizon.c takes a
 * pass for each so that they can be told one after the other.
 *
 * The visible facets form a tree: their boundary is one loop through all their
 * vertices, for every vertex stays on the hull. Depth first, always to the
 * next edge, the horizon comes in its order round the apex, each ridge begins
 * where the last one ended, and no facet is met twice from within.
 *
 * A facet beyond an edge is visible just when its third site lies in front of
 * the plane through edge and apex. If it is not, that plane is the cone's. */
#include "hull-builder.h"
#include "memory.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Makes all lists longer: they have the same room, of which a cavity of n
 * facets needs n + 3, for the numbers of its cone and an end. */
static void
make_room (HullBuilder *b)
{
  const uint32_t n = b->visible_room + 8 * CONE_LANES;
  uint32_t room[3] = { b->visible_room, b->visible_room, b->visible_room };

  /* Each facet is met once: the search ends. */
  assert (b->n_visible < b->n_facets && "the visible facets are a tree");
  b->pending = memory_grow (b->pending, &room[0], n, sizeof *b->pending);
  b->orphans = memory_grow (b->orphans, &room[1], n, sizeof *b->orphans);
  b->horizon = memory_grow (b->horizon, &room[2], n, sizeof *b->horizon);
  b->visible
      = memory_grow (b->visible, &b->visible_room, n, sizeof *b->visible);
  hull_make_cone_room (b, b->visible_room);
}

static inline void
add_visible (HullBuilder *b, uint32_t facet)
{
  const uint32_t outside = b->facets[facet].outside;

  if (b->n_visible + 4 > b->visible_room)
    make_room (b);
  b->visible[b->n_visible++] = facet;
  b->orphans[b->n_orphans] = outside;
  b->n_orphans += outside != INDEX_NONE;
}

static inline Offset
offset_to (const HullBuilder *b, uint32_t site, const Site *apex)
{
  if (hull_is_infinite (b, site))
    return (Offset){ 0, 0, b->height };
  return offset_of (&b->sites[site], apex);
}

static inline double
larger (double a, double b)
{
  return a > b ? a : b;
}

/* The corners of the first visible facet. The height of the site at infinity
 * is free; for the filters' sake it is a squared distance like others. */
static inline void
first_corners (HullBuilder *b,
               const uint32_t corner[3],
               const Site *apex,
               Offset at[3])
{
  b->height = 0;
  at[0] = offset_to (b, corner[0], apex);
  at[1] = offset_to (b, corner[1], apex);
  at[2] = offset_to (b, corner[2], apex);
  b->height = larger (larger (at[0].square, at[1].square), at[2].square);
  at[0].square = at[0].square > 0 ? at[0].square : b->height;
  at[1].square = at[1].square > 0 ? at[1].square : b->height;
  at[2].square = at[2].square > 0 ? at[2].square : b->height;
}

/* Whether the apex sees the facet that has a site in front of the plane on a
 * ridge, or if rounding leaves that open, exactly. The determinant is a sum of
 * six products that are at most reach⁴, each off by less than 14 half ulps.
 * The bound on reach² is the sum of the three squares. */
static inline bool
is_visible (const HullBuilder *b,
            const ConePlane *plane,
            double squares,
            const Offset *at,
            uint32_t facet,
            uint32_t apex)
{
  const double front = cone_front (plane, at);
  const double reach = squares + at->square;
  const double doubt = 6 * 16 * (DBL_EPSILON / 2) * reach * reach + DBL_MIN;

  if (fabs (front) > doubt || b->is_whole)
    return front > 0;
  return hull_sees_exactly (b, apex, facet);
}

void
horizon_collect_visible (HullBuilder *b, uint32_t facet, uint32_t apex)
{
  const Site at = b->sites[apex];
  Offset corner[3], tail, head;
  HullEdge edge = facet << 2;
  uint32_t n_pending = 2, n_horizon = 0, n_tests = 0;

  first_corners (b, b->facets[facet].site, &at, corner);
  tail = corner[0];
  head = corner[1];
  b->n_visible = 0;
  b->n_orphans = 0;
  add_visible (b, facet);
  b->pending[0] = (PendingEdge){ tail, edge + 2 };
  b->pending[1] = (PendingEdge){ corner[2], edge + 1 };
  for (;;) {
    const HullFacet *row = &b->facets[edge >> 2];
    const HullEdge beyond = row->across[edge & 3];
    const HullEdge third = hull_next_edge (hull_next_edge (beyond));
    const Offset site
        = offset_to (b, b->facets[third >> 2].site[third & 3], &at);
    const ConePlane plane = cone_plane (&tail, &head);

    n_tests += 1;
    if (is_visible (b, &plane, tail.square + head.square, &site, beyond >> 2,
                    apex)) {
      add_visible (b, beyond >> 2);
      b->pending[n_pending++] = (PendingEdge){ head, third };
      edge = hull_next_edge (beyond);
      head = site;
      continue;
    }
    b->horizon[n_horizon] = (HorizonRidge){ row->site[edge & 3], beyond };
    if (b->next_outside != NULL)
      hull_set_plane (b, n_horizon, &plane, tail.square);
    n_horizon += 1;
    if (n_pending == 0)
      break;
    tail = head;
    n_pending -= 1;
    edge = b->pending[n_pending].edge;
    head = b->pending[n_pending].head;
  }
  b->n_horizon = n_horizon;
  b->counts.visibility_tests += n_tests;
}

/* It is there. */
void
horizon_collect (HullBuilder *b, uint32_t apex)
{
  (void)b;
  (void)apex;
}

void
horizon_planes (HullBuilder *b, uint32_t apex)
{
  (void)b;
  (void)apex;
}
