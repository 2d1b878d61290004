/* Outside sets: each waiting site belongs to just one facet that it sees.
 * They are a partition, not the lists of all sites that see a facet. */
#include "hull-builder.h"
#include "memory.h"

#include <assert.h>
#include <stdlib.h>

void
outside_claim (HullBuilder *b, uint32_t site, uint32_t facet, bool is_furthest)
{
  HullFacet *row = &b->facets[facet];

  if (is_furthest) {
    b->next_outside[site] = row->outside;
    row->outside = site;
  } else {
    b->next_outside[site] = b->next_outside[row->outside];
    b->next_outside[row->outside] = site;
  }
  if (b->claimed_by != NULL)
    b->claimed_by[site] = facet;
  b->counts.redistributions += 1;
  hull_tell (b, EVENT (EVENT_CLAIM, facet, site));
}

bool
outside_is_further (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  const HullFacet *row = &b->facets[facet];
  const Site *sites = b->sites;
  const uint32_t head = row->outside;
  const Site plane[3]
      = { sites[row->site[0]], sites[row->site[1]], sites[row->site[2]] };
  const int further = lift_further (plane, &sites[site], &sites[head]);

  return further > 0 || (further == 0 && site < head);
}

static void
grow_queue (HullBuilder *b)
{
  const uint32_t room = b->queue_room == 0 ? 64 : 2 * b->queue_room;
  QueueEntry *queue = memory_new (room, sizeof *queue);
  uint32_t i;

  for (i = 0; i < b->n_queue; i++)
    queue[i] = b->queue[(b->queue_head + i) & (b->queue_room - 1)];
  free (b->queue);
  b->queue = queue;
  b->queue_head = 0;
  b->queue_room = room;
}

void
outside_enqueue (HullBuilder *b, uint32_t facet)
{
  if (b->facets[facet].outside == INDEX_NONE)
    return;
  if (b->n_queue == b->queue_room)
    grow_queue (b);
  b->queue[(b->queue_head + b->n_queue) & (b->queue_room - 1)]
      = (QueueEntry){ facet, b->facets[facet].mark };
  b->n_queue += 1;
}

static bool
is_simplex_site (const HullBuilder *b, uint32_t site)
{
  const uint32_t *s = b->simplex;

  return site == s[0] || site == s[1] || site == s[2] || site == s[3];
}

/* Gives a site to a facet that it sees, and may be the furthest to do so. */
static void
claim_one (HullBuilder *b, uint32_t site, uint32_t facet)
{
  outside_claim (b, site, facet,
                 b->facets[facet].outside == INDEX_NONE
                     || outside_is_further (b, site, facet));
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
    while (facet < 4 && !hull_sees (b, site, facet))
      facet++;
    assert (facet < 4 || b->first == NULL);
    if (facet < 4)
      claim_one (b, site, facet);
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
      claim_one (b, site, facet);
}

static void
enqueue_all (HullBuilder *b)
{
  uint32_t facet;

  for (facet = 0; facet < b->n_facets; facet++)
    outside_enqueue (b, facet);
}

void
outside_partition (HullBuilder *b)
{
  if (b->walks)
    return;
  b->next_outside = memory_new (b->n_sites, sizeof *b->next_outside);
  if (b->n_listed > 0)
    b->claimed_by = memory_new (b->n_sites, sizeof *b->claimed_by);
  partition_over_simplex (b);
  enqueue_all (b);
}

/* Facets get their outside sets at birth and join the queue then, so the
 * oldest comes first; those that have retired are passed over. */
static uint32_t
oldest_facet (HullBuilder *b)
{
  while (b->n_queue > 0) {
    const QueueEntry entry = b->queue[b->queue_head];
    const HullFacet *row = &b->facets[entry.facet];

    b->queue_head = (b->queue_head + 1) & (b->queue_room - 1);
    b->n_queue -= 1;
    if (row->mark == entry.birth && row->outside != INDEX_NONE)
      return entry.facet;
  }
  return INDEX_NONE;
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

uint32_t
outside_next_facet (HullBuilder *b)
{
  const uint32_t facet = facet_of_next_listed (b);

  if (facet != INDEX_NONE)
    return facet;
  if (b->walks && b->n_listed < b->n_sites) {
    b->walks = false;
    b->next_outside = memory_new (b->n_sites, sizeof *b->next_outside);
    partition_by_walking (b);
    enqueue_all (b);
  }
  return b->next_outside != NULL ? oldest_facet (b) : INDEX_NONE;
}

/* Takes the next site from the facet's outside set and begins a round. */
uint32_t
outside_select (HullBuilder *b, uint32_t facet)
{
  const uint32_t apex = b->list_position < b->n_listed
                            ? listed (b, b->list_position++)
                            : b->facets[facet].outside;

  b->round += 1;
  if (b->claimed_by != NULL)
    b->claimed_by[apex] = INDEX_NONE;
  hull_tell (b, EVENT (EVENT_SELECT, facet, apex));
  return apex;
}
