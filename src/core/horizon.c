/* The facets that a site sees, and the horizon: their boundary. The batch
 * build finds both at once (cavity.c). */
#include "hull-builder.h"
#include "memory.h"

#include <assert.h>

/* Takes the outside set from a facet that will retire. */
static void
add_orphans (HullBuilder *b, HullFacet *row)
{
  /* The hand-over ends the list. */
  if (b->n_orphans + 1 >= b->orphans_room)
    b->orphans = memory_grow (b->orphans, &b->orphans_room, b->n_orphans + 2,
                              sizeof *b->orphans);
  b->orphans[b->n_orphans++] = row->outside;
  row->outside = INDEX_NONE;
}

static void
add_visible (HullBuilder *b, uint32_t facet, uint32_t apex)
{
  HullFacet *row = &b->facets[facet];

  if (b->n_visible == b->visible_room)
    b->visible = memory_grow (b->visible, &b->visible_room, b->n_visible + 1,
                              sizeof *b->visible);
  b->visible[b->n_visible++] = facet;
  row->mark = b->round;
  if (row->outside != INDEX_NONE)
    add_orphans (b, row);
  hull_tell (b, EVENT (EVENT_VISIBLE, facet, apex));
}

static inline bool
is_visible (const HullBuilder *b, uint32_t facet)
{
  return b->facets[facet].mark == b->round;
}

/* Finds the visible facets breadth first from one of them: they are
 * connected. */
void
horizon_collect_visible (HullBuilder *b, uint32_t facet, uint32_t apex)
{
  uint32_t i, k;

  b->n_visible = 0;
  b->n_orphans = 0;
  add_visible (b, facet, apex);
  for (i = 0; i < b->n_visible; i++)
    for (k = 0; k < 3; k++) {
      const uint32_t neighbour = b->facets[b->visible[i]].across[k] >> 2;

      if (is_visible (b, neighbour))
        continue;
      b->counts.visibility_tests += 1;
      if (hull_sees (b, apex, neighbour))
        add_visible (b, neighbour, apex);
    }
}

/* Finds a first horizon ridge: an edge of a visible facet. */
static HullEdge
first_on_horizon (const HullBuilder *b)
{
  uint32_t i, k;

  for (i = 0; i < b->n_visible; i++)
    for (k = 0; k < 3; k++)
      if (!is_visible (b, b->facets[b->visible[i]].across[k] >> 2))
        return b->visible[i] << 2 | k;
  assert (false && "a site never sees the whole hull");
  return 0;
}

/* Walks once round the visible facets, which lie on the left: at the head of
 * each horizon ridge, turns through the visible facets there until the next
 * ridge of the horizon. */
void
horizon_collect (HullBuilder *b, uint32_t apex)
{
  const HullEdge first = first_on_horizon (b);
  HullEdge edge = first;
  uint32_t n_turns = 0;

  /* One loop round a disc of triangles whose vertices all stay: n + 2. */
  if (b->n_visible + 2 > b->horizon_room)
    b->horizon = memory_grow (b->horizon, &b->horizon_room, b->n_visible + 2,
                              sizeof *b->horizon);
#ifdef HULL_BATCH
  /* The numbers of its cone. */
  if (b->n_visible + 2 > b->visible_room)
    b->visible = memory_grow (b->visible, &b->visible_room, b->n_visible + 2,
                              sizeof *b->visible);
#endif
  b->n_horizon = 0;
  do {
    const uint32_t *site = b->facets[edge >> 2].site;
    const uint32_t tail = site[edge & 3];
    const uint32_t head = site[hull_next_edge (edge) & 3];
    HullEdge beyond = b->facets[edge >> 2].across[edge & 3];

    assert (b->n_horizon < b->n_visible + 2);
    b->horizon[b->n_horizon++] = (HorizonRidge){ tail, beyond };
    hull_tell (b, (Event){ EVENT_HORIZON, beyond >> 2, apex, { tail, head } });
    edge = hull_next_edge (edge);
    beyond = b->facets[edge >> 2].across[edge & 3];
    while (is_visible (b, beyond >> 2)) {
      /* Each side of a visible facet is passed once. */
      assert (n_turns < 3 * b->n_visible && "the horizon is one loop");
      n_turns++;
      edge = hull_next_edge (beyond);
      beyond = b->facets[edge >> 2].across[edge & 3];
    }
  } while (edge != first);
}

void
horizon_planes (HullBuilder *b, uint32_t apex)
{
  const Site at = b->sites[apex];
  const uint32_t n = b->n_horizon;
  const Offset first = offset_of (&b->sites[b->horizon[0].tail], &at);
  Offset tail = first;
  uint32_t i;

  hull_make_cone_room (b, n);
  for (i = 0; i < n; i++) {
    const Offset head = i + 1 < n
                            ? offset_of (&b->sites[b->horizon[i + 1].tail], &at)
                            : first;
    const ConePlane plane = cone_plane (&tail, &head);

    hull_set_plane (b, i, &plane, tail.square);
    tail = head;
  }
}
