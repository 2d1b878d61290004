/* Outside sets: each waiting site belongs to just one facet that it sees.
 * They are a partition, not the lists of all sites that see a facet. */
#include "hull-builder.h"
#include "predicate.h"

#include <assert.h>
#include <stddef.h>

static void
claim (HullBuilder *b, uint32_t site, uint32_t facet)
{
  HullFacet *row = &b->facets[facet];

  if (row->outside == INDEX_NONE)
    row->outside = site;
  else
    b->next_outside[row->outside_tail] = site;
  row->outside_tail = site;
  b->next_outside[site] = INDEX_NONE;
  b->claimed_by[site] = facet;
  hull_tell (b, EVENT_CLAIM, facet, site);
}

/* Gives the site to the first facet from @first on that it sees. Every lift
 * is extreme, so there is one: nothing is ever discarded. */
static void
claim_first_seen (HullBuilder *b, uint32_t site, uint32_t first)
{
  uint32_t facet = first;

  while (facet < b->n_facets && !hull_sees (b, site, facet))
    facet++;
  assert (facet < b->n_facets);
  claim (b, site, facet);
}

static bool
is_simplex_site (const HullBuilder *b, uint32_t site)
{
  const uint32_t *s = b->simplex;

  return site == s[0] || site == s[1] || site == s[2] || site == s[3];
}

/* Hands every site but the simplex to a facet of the simplex. */
void
outside_partition (HullBuilder *b)
{
  uint32_t site;

  for (site = 0; site < b->set->n_sites; site++) {
    b->claimed_by[site] = INDEX_NONE;
    if (b->set->first[site] == site && !is_simplex_site (b, site))
      claim_first_seen (b, site, 0);
  }
}

/* Facets get their outside sets at birth, so one that has none when its turn
 * comes never will: the oldest is found by going forwards only. */
static uint32_t
oldest_facet (HullBuilder *b)
{
  while (b->oldest < b->n_facets
         && (b->facets[b->oldest].is_retired
             || b->facets[b->oldest].outside == INDEX_NONE))
    b->oldest += 1;
  return b->oldest < b->n_facets ? b->oldest : INDEX_NONE;
}

static uint32_t
facet_of_next_listed (HullBuilder *b)
{
  while (b->list_position < b->set->n_sites) {
    const uint32_t site = b->list[b->list_position];

    if (b->claimed_by[site] != INDEX_NONE)
      return b->claimed_by[site];
    b->list_position += 1;
  }
  return INDEX_NONE;
}

uint32_t
outside_next_facet (HullBuilder *b)
{
  return b->list != NULL ? facet_of_next_listed (b) : oldest_facet (b);
}

static uint32_t
furthest (const HullBuilder *b, const HullFacet *row)
{
  const Site *sites = b->set->sites;
  const Site plane[3]
      = { sites[row->site[0]], sites[row->site[1]], sites[row->site[2]] };
  uint32_t best = row->outside;
  uint32_t site;

  for (site = b->next_outside[best]; site != INDEX_NONE;
       site = b->next_outside[site]) {
    const int further = lift_further (plane, &sites[site], &sites[best]);

    /* An exact tie goes to the lower index. */
    if (further > 0 || (further == 0 && site < best))
      best = site;
  }
  return best;
}

/* Takes the next site from the facet's outside set and begins a round. */
uint32_t
outside_select (HullBuilder *b, uint32_t facet)
{
  const uint32_t apex = b->list != NULL ? b->list[b->list_position]
                                        : furthest (b, &b->facets[facet]);

  b->round += 1;
  b->claimed_by[apex] = INDEX_NONE;
  hull_tell (b, EVENT_SELECT, facet, apex);
  return apex;
}

/* Hands each outside site of the retired facets to one cone facet that it
 * sees. */
void
outside_redistribute (HullBuilder *b)
{
  uint32_t i, site, next;

  for (i = 0; i < b->n_visible; i++)
    for (site = b->facets[b->visible[i]].outside; site != INDEX_NONE;
         site = next) {
      next = b->next_outside[site];
      if (b->claimed_by[site] != INDEX_NONE)
        claim_first_seen (b, site, b->first_cone);
    }
}
