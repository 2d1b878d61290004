/* Outside sets: each waiting site belongs to just one facet that it sees.
 * They are a partition, not the lists of all sites that see a facet. */
#include "hull-builder.h"
#include "memory.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* A facet to infinity is seen from the right of its edge. */
bool
hull_sees_exactly (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  const uint32_t *corner = b->facets[facet].site;
  const Site *sites = b->sites;
  const uint32_t k = hull_infinite_corner (b, corner);

  if (k < 3)
    return orient (&sites[corner[(k + 1) % 3]], &sites[corner[(k + 2) % 3]],
                   &sites[site])
           < 0;
  return lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      &sites[site])
         > 0;
}

bool
outside_is_further (const HullBuilder *b,
                    uint32_t site,
                    uint32_t other,
                    uint32_t facet)
{
  const uint32_t *corner = b->facets[facet].site;
  const Site *sites = b->sites;
  const Site plane[3]
      = { sites[corner[0]], sites[corner[1]], sites[corner[2]] };
  const int further = lift_further (plane, &sites[site], &sites[other]);

  return further > 0 || (further == 0 && site < other);
}

/* Moves the queue down to the stack: it has left its first places. */
static void
slide_queue (HullBuilder *b)
{
  const uint32_t n = b->queue_end - b->queue_head;

  if (b->queue_head > b->n_stacked)
    memmove (&b->queue[b->n_stacked], &b->queue[b->queue_head],
             n * sizeof *b->queue);
  b->queue_head = b->n_stacked;
  b->queue_end = b->n_stacked + n;
}

void
outside_make_room (HullBuilder *b, uint32_t n)
{
  if (b->queue_end + n < b->queue_room)
    return;
  slide_queue (b);
  /* Room for as much again, so that it is not moved too often. */
  if (b->queue_end + n >= b->queue_room / 2)
    b->queue = memory_grow (b->queue, &b->queue_room, b->queue_room + 2 * n,
                            sizeof *b->queue);
}

static bool
is_simplex_site (const HullBuilder *b, uint32_t site)
{
  const uint32_t *s = b->simplex;

  return site == s[0] || site == s[1] || site == s[2] || site == s[3];
}

/* The determinant of a site, or for a facet to infinity that of its edge and
 * the site, rounded. */
static inline double
front_of (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  const uint32_t *corner = b->facets[facet].site;
  const Site *p = &b->sites[site], *tail, *head;
  const uint32_t k = hull_infinite_corner (b, corner);

  if (k == 3)
    return hull_front (b, site, facet);
  tail = &b->sites[corner[(k + 1) % 3]];
  head = &b->sites[corner[(k + 2) % 3]];
  return (p->x - tail->x) * (head->y - tail->y)
         - (p->y - tail->y) * (head->x - tail->x);
}

/* Whether a site comes to the head of an outside set: with HULL_LOWER as
 * rounded, for which no hull depends on it. */
static inline bool
leads (HullBuilder *b, uint32_t site, uint32_t head, uint32_t facet)
{
  double front;

  if (!HULL_IS_LOWER)
    return head == INDEX_NONE || outside_is_further (b, site, head, facet);
  front = front_of (b, site, facet);
  if (head != INDEX_NONE && front <= b->head_fronts[facet])
    return false;
  b->head_fronts[facet] = front;
  return true;
}

/* Puts a site into the outside set of a facet that it sees, at its head when
 * it is the furthest there. */
static void
claim (HullBuilder *b, uint32_t site, uint32_t facet)
{
  uint32_t *head = &b->facets[facet].outside;

  if (leads (b, site, *head, facet)) {
    b->next_outside[site] = *head == INDEX_NONE ? b->n_sites : *head;
    *head = site;
  } else {
    b->next_outside[site] = b->next_outside[*head];
    b->next_outside[*head] = site;
  }
  if (b->claimed_by != NULL)
    b->claimed_by[site] = facet;
  b->counts.redistributions += 1;
  hull_tell (b, EVENT (EVENT_CLAIM, facet, site));
}

/* Hands every site but the simplex to the first of its facets that it sees. A
 * site that sees none equals one of the four. */
static void
partition_over_simplex (HullBuilder *b)
{
  uint32_t site, facet;

  for (site = 0; site < b->n_sites; site++) {
    if (b->claimed_by != NULL)
      b->claimed_by[site] = INDEX_NONE;
    if ((b->first != NULL && b->first[site] != site)
        || is_simplex_site (b, site))
      continue;
    facet = 0;
    while (facet < 4
           && !(hull_sees (b, site, facet) && hull_may_claim (b, site, facet)))
      facet++;
    assert (facet < 4 || b->first == NULL);
    if (facet < 4)
      claim (b, site, facet);
  }
}

/* Hands the sites after the listed ones to facets that they see, by walking:
 * they follow in spatial order. */
static void
partition_by_walking (HullBuilder *b)
{
  uint32_t site, facet;

  for (site = b->n_listed; site < b->n_sites; site++)
    if (!is_simplex_site (b, site) && (facet = walk_to (b, site)) != INDEX_NONE)
      claim (b, site, facet);
}

static void
enqueue_all (HullBuilder *b)
{
  uint32_t facet;

  outside_make_room (b, b->n_facets);
  for (facet = 0; facet < b->n_facets; facet++)
    outside_enqueue (b, facet);
}

/* Before sites are handed out, and after. */
static void
begin_partition (HullBuilder *b)
{
  if (HULL_IS_LOWER)
    b->head_fronts = memory_new (b->n_facets, sizeof *b->head_fronts);
}

static void
end_partition (HullBuilder *b)
{
  free (b->head_fronts);
  enqueue_all (b);
}

void
outside_partition (HullBuilder *b)
{
  if (b->walks)
    return;
  b->next_outside
      = memory_new ((size_t)b->n_sites + 1, sizeof *b->next_outside);
  if (b->n_listed > 0)
    b->claimed_by = memory_new (b->n_sites, sizeof *b->claimed_by);
  begin_partition (b);
  partition_over_simplex (b);
  end_partition (b);
}

/* Puts the young facets onto the stack when they are many, and goes on with
 * the youngest when there are none. */
static void
stay_local (HullBuilder *b)
{
  if (b->queue_end - b->queue_head > b->n_young_max) {
    slide_queue (b);
    b->n_stacked = b->queue_head = b->queue_end;
  }
  if (b->queue_head == b->queue_end && b->n_stacked > 0) {
    b->n_stacked -= 1;
    b->queue_head = b->n_stacked;
    b->queue_end = b->n_stacked + 1;
  }
}

/* Facets get their outside sets at birth and join the queue then, so the
 * oldest comes first; those that have retired are passed over. */
static uint32_t
oldest_facet (HullBuilder *b)
{
  for (;;) {
    const HullFacet *row;
    QueueEntry entry;

    stay_local (b);
    if (b->queue_head == b->queue_end)
      return INDEX_NONE;
    entry = b->queue[b->queue_head++];
    row = &b->facets[entry.facet];
    if (row->mark == entry.birth && row->outside != INDEX_NONE)
      return entry.facet;
  }
}

static uint32_t
listed (const HullBuilder *b, uint32_t position)
{
  return b->list != NULL ? b->list[position] : position;
}

/* A facet that the next listed site sees. */
static uint32_t
facet_of_next_listed (HullBuilder *b)
{
  for (; b->list_position < b->n_listed; b->list_position++) {
    const uint32_t site = listed (b, b->list_position);
    uint32_t facet = INDEX_NONE;

    if (!b->walks)
      facet = b->claimed_by[site];
    else if (!is_simplex_site (b, site))
      facet = walk_to (b, site);
    if (facet != INDEX_NONE)
      return facet;
  }
  return INDEX_NONE;
}

/* What was chosen for the next round, or NULL. */
static const HullChoice *
chosen (const HullBuilder *b)
{
#ifdef HULL_BATCH
  (void)b;
  return NULL;
#else
  return hull_choices_find (b->choices, EVENT_SELECT, b->round + 1, INDEX_NONE);
#endif
}

static bool
is_outside (const HullBuilder *b, uint32_t facet, uint32_t site)
{
  uint32_t at = b->facets[facet].outside;

  while (at != b->n_sites && at != site)
    at = b->next_outside[at];
  return at == site;
}

/* The facet that was chosen, or INDEX_NONE. */
static uint32_t
chosen_facet (const HullBuilder *b)
{
  const HullChoice *choice = chosen (b);

  if (choice == NULL)
    return INDEX_NONE;
  assert (choice->facet < b->n_facets
          && b->facets[choice->facet].outside != INDEX_NONE);
  return choice->facet;
}

uint32_t
outside_next_facet (HullBuilder *b)
{
  uint32_t facet = chosen_facet (b);

  if (facet != INDEX_NONE)
    return facet;
  facet = facet_of_next_listed (b);
  if (facet != INDEX_NONE)
    return facet;
  if (b->walks && b->n_listed < b->n_sites) {
    b->walks = false;
    b->next_outside
        = memory_new ((size_t)b->n_sites + 1, sizeof *b->next_outside);
    begin_partition (b);
    partition_by_walking (b);
    end_partition (b);
  }
  if (b->next_outside == NULL)
    return INDEX_NONE;
  return oldest_facet (b);
}

/* The site of the facet that comes next. */
static uint32_t
next_site (HullBuilder *b, uint32_t facet)
{
  const HullChoice *choice = chosen (b);

  if (choice != NULL && choice->site != INDEX_NONE) {
    assert (is_outside (b, facet, choice->site));
    return choice->site;
  }
  return b->list_position < b->n_listed ? listed (b, b->list_position++)
                                        : b->facets[facet].outside;
}

/* Takes the next site from the facet's outside set and begins a round. */
uint32_t
outside_select (HullBuilder *b, uint32_t facet)
{
  const uint32_t apex = next_site (b, facet);

  b->round += 1;
  if (b->claimed_by != NULL)
    b->claimed_by[apex] = INDEX_NONE;
  hull_tell (b, EVENT (EVENT_SELECT, facet, apex));
  return apex;
}
