#include "hull.h"

#include "hull-builder.h"
#include "memory.h"
#include "predicate.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

uint32_t
hull_add_facet (HullBuilder *b, const uint32_t site[3])
{
  const uint32_t facet = b->n_facets;
  HullFacet *row;

  if (facet == b->facets_room)
    b->facets = memory_grow (b->facets, &b->facets_room, facet + 1,
                             sizeof *b->facets);
  row = &b->facets[facet];
  memset (row, 0, sizeof *row);
  memcpy (row->site, site, sizeof row->site);
  row->outside = INDEX_NONE;
  row->outside_tail = INDEX_NONE;
  b->n_facets += 1;
  return facet;
}

bool
hull_sees (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  const Site *sites = b->set->sites;
  const uint32_t *corner = b->facets[facet].site;

  return lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      &sites[site])
         > 0;
}

void
hull_tell (const HullBuilder *b, EventKind kind, uint32_t facet, uint32_t site)
{
  const uint32_t no_ridge[2] = { INDEX_NONE, INDEX_NONE };

  hull_tell_ridge (b, kind, facet, site, no_ridge);
}

void
hull_tell_ridge (const HullBuilder *b,
                 EventKind kind,
                 uint32_t facet,
                 uint32_t site,
                 const uint32_t ridge[2])
{
  const Event event = { kind, facet, site, { ridge[0], ridge[1] } };

  if (b->hook != NULL)
    b->hook->on_event (&event, b->hook->user);
}

/* Joins every horizon ridge to the apex by a facet. The ridges come in loop
 * order, so neighbours in the cone have neighbouring numbers. */
static void
build_cone (HullBuilder *b, uint32_t apex)
{
  const uint32_t n = b->n_horizon;
  uint32_t i;

  b->first_cone = b->n_facets;
  for (i = 0; i < n; i++) {
    const HorizonRidge *ridge = &b->horizon[i];
    const uint32_t site[3] = { ridge->site[0], ridge->site[1], apex };
    const uint32_t facet = hull_add_facet (b, site);

    b->facets[facet].neighbour[0] = ridge->beyond;
    b->facets[facet].neighbour[1] = b->first_cone + (i + 1) % n;
    b->facets[facet].neighbour[2] = b->first_cone + (i + n - 1) % n;
    b->facets[ridge->beyond].neighbour[ridge->beyond_index] = facet;
    hull_tell_ridge (b, EVENT_CONE, facet, apex, ridge->site);
  }
}

static void
retire_visible (HullBuilder *b, uint32_t apex)
{
  uint32_t i;

  for (i = 0; i < b->n_visible; i++) {
    b->facets[b->visible[i]].is_retired = true;
    hull_tell (b, EVENT_RETIRE, b->visible[i], apex);
  }
}

static void
tell_duplicates (const HullBuilder *b)
{
  uint32_t site;

  for (site = 0; site < b->set->n_sites; site++)
    if (b->set->first[site] != site)
      hull_tell (b, EVENT_DUPLICATE, INDEX_NONE, site);
}

static void
build (HullBuilder *b)
{
  uint32_t facet;

  simplex_build (b);
  outside_partition (b);

  while ((facet = outside_next_facet (b)) != INDEX_NONE) {
    const uint32_t apex = outside_select (b, facet);

    horizon_collect_visible (b, facet, apex);
    horizon_collect (b, apex);
    build_cone (b, apex);
    retire_visible (b, apex);
    outside_redistribute (b);
  }
}

static void
clear (HullBuilder *b)
{
  free (b->facets);
  free (b->next_outside);
  free (b->claimed_by);
  free (b->list);
  free (b->visible);
  free (b->horizon);
}

void
hull_build (const SiteSet *set, const Order *order, const HullHook *hook)
{
  HullBuilder b = { .set = set, .hook = hook };

  b.next_outside = memory_new (set->n_sites, sizeof *b.next_outside);
  b.claimed_by = memory_new (set->n_sites, sizeof *b.claimed_by);
  b.list = order_list (order, set);

  tell_duplicates (&b);
  if (simplex_find (&b))
    build (&b);
  else
    hull_tell (&b, EVENT_FLAT, INDEX_NONE, INDEX_NONE);
  hull_tell (&b, EVENT_COMPLETE, INDEX_NONE, INDEX_NONE);
  clear (&b);
}
