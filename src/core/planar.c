#include "planar.h"

#include "exact.h"
#include "memory.h"
#include "predicate.h"

#include <stdlib.h>

typedef struct Edge {
  uint32_t corner[2];
  uint32_t next, previous; /* round the hull, counter-clockwise */
  uint32_t outside;        /* first site of its outside set, or INDEX_NONE */
} Edge;

typedef struct Builder {
  const SiteSet *set;
  const PlanarHook *hook;
  Edge *edges;
  uint32_t n_edges, room;
  uint32_t *next_outside; /* per site: the next one in its outside set */
  uint32_t oldest;        /* edges before it have empty outside sets */
  uint32_t chain[2];      /* first and last visible edge */
} Builder;

static void
tell (const Builder *builder, PlanarKind kind, uint32_t edge, uint32_t site)
{
  const PlanarEvent event = { kind, edge, site, { INDEX_NONE, INDEX_NONE } };

  builder->hook->on_event (&event, builder->hook->user);
}

static bool
is_right_of (const Builder *builder, uint32_t edge, uint32_t site)
{
  const Site *sites = builder->set->sites;
  const uint32_t *corner = builder->edges[edge].corner;

  return orient (&sites[corner[0]], &sites[corner[1]], &sites[site]) < 0;
}

static bool
sees (const Builder *builder, uint32_t edge, uint32_t site)
{
  const Site *sites = builder->set->sites, *p = &sites[site];
  const uint32_t *corner = builder->edges[edge].corner;
  const Site *tail = &sites[corner[0]], *head = &sites[corner[1]];
  const int turn = orient (tail, head, p);

  if (turn != 0)
    return turn < 0;
  /* On the line: beyond one of its ends. */
  return site_compare (p, tail) == site_compare (p, head)
         && site_compare (p, tail) != 0;
}

static uint32_t
add_edge (Builder *builder,
          PlanarKind kind,
          const uint32_t corner[2],
          uint32_t apex)
{
  const uint32_t edge = builder->n_edges++;
  const PlanarEvent event = { kind, edge, apex, { corner[0], corner[1] } };

  if (edge == builder->room)
    builder->edges = memory_grow (builder->edges, &builder->room, edge + 1,
                                  sizeof *builder->edges);
  builder->edges[edge]
      = (Edge){ .corner = { corner[0], corner[1] }, .outside = INDEX_NONE };
  builder->hook->on_event (&event, builder->hook->user);
  return edge;
}

static void
join (Builder *builder, uint32_t edge, uint32_t next)
{
  builder->edges[edge].next = next;
  builder->edges[next].previous = edge;
}

/* Gives @site to the first of the edges @first … @end - 1 that it lies to the
 * right of. Whoever lies outside lies to the right of one: of the first
 * triangle's, and later of the cone's, if it did so of a visible edge. */
static void
claim (Builder *builder, uint32_t first, uint32_t end, uint32_t site)
{
  uint32_t edge;

  for (edge = first; edge < end; edge++)
    if (is_right_of (builder, edge, site)) {
      builder->next_outside[site] = builder->edges[edge].outside;
      builder->edges[edge].outside = site;
      tell (builder, PLANAR_CLAIM, edge, site);
      return;
    }
  tell (builder, PLANAR_IGNORE, INDEX_NONE, site);
}

/* The first three distinct sites that are not on one line, turning left.
 *
 * Returns: false when there are none. */
static bool
find_triangle (const SiteSet *set, uint32_t corner[3])
{
  uint32_t site, n = 0;

  for (site = 0; site < set->n_sites; site++) {
    int turn;

    if (set->first[site] != site)
      continue;
    if (n < 2) {
      corner[n++] = site;
      continue;
    }
    turn = orient (&set->sites[corner[0]], &set->sites[corner[1]],
                   &set->sites[site]);
    if (turn == 0)
      continue;
    corner[2] = turn > 0 ? site : corner[1];
    corner[1] = turn > 0 ? corner[1] : site;
    return true;
  }
  return false;
}

static void
build_simplex (Builder *builder, const uint32_t corner[3])
{
  const SiteSet *set = builder->set;
  uint32_t i, site;

  for (i = 0; i < 3; i++) {
    const uint32_t ends[2] = { corner[i], corner[(i + 1) % 3] };

    add_edge (builder, PLANAR_SIMPLEX, ends, INDEX_NONE);
  }
  for (i = 0; i < 3; i++)
    join (builder, i, (i + 1) % 3);
  for (site = 0; site < set->n_sites; site++)
    if (set->first[site] == site && site != corner[0] && site != corner[1]
        && site != corner[2])
      claim (builder, 0, 3, site);
}

/* The oldest edge that has an outside set, or INDEX_NONE. */
static uint32_t
next_edge (Builder *builder)
{
  while (builder->oldest < builder->n_edges
         && builder->edges[builder->oldest].outside == INDEX_NONE)
    builder->oldest++;
  return builder->oldest < builder->n_edges ? builder->oldest : INDEX_NONE;
}

/* Takes the furthest site out of the outside set of @edge; of sites equally
 * far the one of the lowest number. */
static uint32_t
select_furthest (Builder *builder, uint32_t edge)
{
  const Site *sites = builder->set->sites;
  const uint32_t *corner = builder->edges[edge].corner;
  uint32_t *next = builder->next_outside;
  uint32_t furthest = builder->edges[edge].outside;
  uint32_t *link, site;

  for (site = next[furthest]; site != INDEX_NONE; site = next[site]) {
    const int further = exact_further_right (
        &sites[corner[0]], &sites[corner[1]], &sites[site], &sites[furthest]);

    if (further > 0 || (further == 0 && site < furthest))
      furthest = site;
  }
  link = &builder->edges[edge].outside;
  while (*link != furthest)
    link = &next[*link];
  *link = next[furthest];
  tell (builder, PLANAR_SELECT, edge, furthest);
  return furthest;
}

/* The visible edges are one chain, and @edge is one of them. */
static void
collect_visible (Builder *builder, uint32_t edge, uint32_t apex)
{
  const Edge *edges = builder->edges;
  uint32_t *chain = builder->chain;

  tell (builder, PLANAR_VISIBLE, edge, apex);
  chain[0] = chain[1] = edge;
  while (sees (builder, edges[chain[1]].next, apex)) {
    chain[1] = edges[chain[1]].next;
    tell (builder, PLANAR_VISIBLE, chain[1], apex);
  }
  while (sees (builder, edges[chain[0]].previous, apex)) {
    chain[0] = edges[chain[0]].previous;
    tell (builder, PLANAR_VISIBLE, chain[0], apex);
  }
}

static void
tell_horizon (const Builder *builder,
              uint32_t beyond,
              uint32_t corner,
              uint32_t apex)
{
  const PlanarEvent event
      = { PLANAR_HORIZON, beyond, apex, { corner, INDEX_NONE } };

  builder->hook->on_event (&event, builder->hook->user);
}

/* Two corners bound the chain; an edge is born from each to the apex. */
static uint32_t
build_cone (Builder *builder, uint32_t apex)
{
  const uint32_t *chain = builder->chain;
  const uint32_t before = builder->edges[chain[0]].previous;
  const uint32_t after = builder->edges[chain[1]].next;
  const uint32_t from = builder->edges[chain[0]].corner[0];
  const uint32_t to = builder->edges[chain[1]].corner[1];
  uint32_t first, second;

  tell_horizon (builder, before, from, apex);
  tell_horizon (builder, after, to, apex);
  first = add_edge (builder, PLANAR_CONE, (uint32_t[]){ from, apex }, apex);
  second = add_edge (builder, PLANAR_CONE, (uint32_t[]){ apex, to }, apex);
  join (builder, before, first);
  join (builder, first, second);
  join (builder, second, after);
  return first;
}

/* Hands the outside set of a retired edge over to the cone, lowest number
 * first: the list holds the latest claim first. */
static void
hand_over (Builder *builder, uint32_t edge, uint32_t cone)
{
  uint32_t site = builder->edges[edge].outside, reversed = INDEX_NONE;

  while (site != INDEX_NONE) {
    const uint32_t next = builder->next_outside[site];

    builder->next_outside[site] = reversed;
    reversed = site;
    site = next;
  }
  while (reversed != INDEX_NONE) {
    site = reversed;
    reversed = builder->next_outside[site];
    claim (builder, cone, cone + 2, site);
  }
  builder->edges[edge].outside = INDEX_NONE;
}

/* The corners between two visible edges lie inside now. */
static void
retire_visible (Builder *builder, uint32_t cone)
{
  const uint32_t first = builder->chain[0], last = builder->chain[1];
  uint32_t edge;

  for (edge = first;; edge = builder->edges[edge].next) {
    tell (builder, PLANAR_RETIRE, edge, INDEX_NONE);
    if (edge == last)
      break;
    tell (builder, PLANAR_IGNORE, INDEX_NONE, builder->edges[edge].corner[1]);
  }
  for (edge = first;; edge = builder->edges[edge].next) {
    hand_over (builder, edge, cone);
    if (edge == last)
      break;
  }
}

static void
build_hull (Builder *builder)
{
  uint32_t edge;

  while ((edge = next_edge (builder)) != INDEX_NONE) {
    const uint32_t apex = select_furthest (builder, edge);

    collect_visible (builder, edge, apex);
    retire_visible (builder, build_cone (builder, apex));
  }
}

void
planar_build (const SiteSet *set, const PlanarHook *hook)
{
  Builder builder = { .set = set, .hook = hook };
  uint32_t corner[3], site;

  builder.next_outside
      = memory_new (set->n_sites, sizeof *builder.next_outside);
  for (site = 0; site < set->n_sites; site++)
    if (set->first[site] != site)
      tell (&builder, PLANAR_DUPLICATE, INDEX_NONE, site);
  if (find_triangle (set, corner)) {
    build_simplex (&builder, corner);
    build_hull (&builder);
  } else {
    tell (&builder, PLANAR_FLAT, INDEX_NONE, INDEX_NONE);
  }
  tell (&builder, PLANAR_COMPLETE, INDEX_NONE, INDEX_NONE);
  free (builder.edges);
  free (builder.next_outside);
}
