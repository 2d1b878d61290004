/* The facets that a site sees, and the horizon: their boundary. */
#include "hull-builder.h"
#include "memory.h"

#include <assert.h>

static void
add_visible (HullBuilder *b, uint32_t facet, uint32_t apex)
{
  if (b->n_visible == b->visible_room)
    b->visible = memory_grow (b->visible, &b->visible_room, b->n_visible + 1,
                              sizeof *b->visible);
  b->visible[b->n_visible++] = facet;
  b->facets[facet].tested = b->round;
  b->facets[facet].is_visible = true;
  hull_tell (b, EVENT_VISIBLE, facet, apex);
}

static bool
is_visible (const HullBuilder *b, uint32_t facet)
{
  return b->facets[facet].tested == b->round && b->facets[facet].is_visible;
}

/* Finds the visible facets breadth first from one of them: they are
 * connected. Each facet is tested once. */
void
horizon_collect_visible (HullBuilder *b, uint32_t facet, uint32_t apex)
{
  uint32_t i, k;

  b->n_visible = 0;
  add_visible (b, facet, apex);
  for (i = 0; i < b->n_visible; i++)
    for (k = 0; k < 3; k++) {
      const uint32_t neighbour = b->facets[b->visible[i]].neighbour[k];

      if (b->facets[neighbour].tested == b->round)
        continue;
      b->facets[neighbour].tested = b->round;
      b->facets[neighbour].is_visible = false;
      if (hull_sees (b, apex, neighbour))
        add_visible (b, neighbour, apex);
    }
}

static uint32_t
index_of_neighbour (const HullFacet *row, uint32_t facet)
{
  uint32_t k = 0;

  while (row->neighbour[k] != facet) {
    k++;
    assert (k < 3);
  }
  return k;
}

static void
add_horizon (HullBuilder *b, uint32_t facet, uint32_t k, uint32_t apex)
{
  const HullFacet *row = &b->facets[facet];
  HorizonRidge *ridge;

  if (b->n_horizon == b->horizon_room)
    b->horizon = memory_grow (b->horizon, &b->horizon_room, b->n_horizon + 1,
                              sizeof *b->horizon);
  ridge = &b->horizon[b->n_horizon++];
  ridge->site[0] = row->site[k];
  ridge->site[1] = row->site[(k + 1) % 3];
  ridge->beyond = row->neighbour[k];
  ridge->beyond_index = index_of_neighbour (&b->facets[ridge->beyond], facet);
  hull_tell_ridge (b, EVENT_HORIZON, ridge->beyond, apex, ridge->site);
}

/* Finds a first horizon ridge: edge *@k of the returned visible facet. */
static uint32_t
first_on_horizon (const HullBuilder *b, uint32_t *k)
{
  uint32_t i;

  for (i = 0; i < b->n_visible; i++)
    for (*k = 0; *k < 3; *k += 1)
      if (!is_visible (b, b->facets[b->visible[i]].neighbour[*k]))
        return b->visible[i];
  assert (false && "a site never sees the whole hull");
  return INDEX_NONE;
}

/* Walks once round the visible facets, which lie on the left: at the head of
 * each horizon ridge, turns through the visible facets there until the next
 * ridge of the horizon. */
void
horizon_collect (HullBuilder *b, uint32_t apex)
{
  uint32_t first_k, k;
  const uint32_t first = first_on_horizon (b, &first_k);
  uint32_t facet = first;

  b->n_horizon = 0;
  k = first_k;
  do {
    add_horizon (b, facet, k, apex);
    k = (k + 1) % 3;
    while (is_visible (b, b->facets[facet].neighbour[k])) {
      const uint32_t next = b->facets[facet].neighbour[k];

      k = (index_of_neighbour (&b->facets[next], facet) + 1) % 3;
      facet = next;
    }
    /* One loop round a disc of triangles whose vertices all stay: n + 2. */
    assert (b->n_horizon <= b->n_visible + 2);
  } while (facet != first || k != first_k);
}
