#include "hull.h"

#include "hull-builder.h"
#include "memory.h"
#include "predicate.h"

#include <assert.h>
#include <float.h>
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
  memcpy (row->site, site, sizeof row->site);
  row->outside = INDEX_NONE;
  row->mark = b->round;
  b->n_facets += 1;
  return facet;
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
    const uint32_t tail = b->horizon[i].tail;
    const uint32_t head = b->horizon[i + 1 < n ? i + 1 : 0].tail;
    const HullEdge beyond = b->horizon[i].beyond;
    const uint32_t facet
        = hull_add_facet (b, (uint32_t[3]){ tail, head, apex });
    HullFacet *row = &b->facets[facet];

    row->across[0] = beyond;
    row->across[1] = (b->first_cone + (i + 1 < n ? i + 1 : 0)) << 2 | 2;
    row->across[2] = (b->first_cone + (i > 0 ? i - 1 : n - 1)) << 2 | 1;
    b->facets[beyond >> 2].across[beyond & 3] = facet << 2;
    hull_tell (b, (Event){ EVENT_CONE, facet, apex, { tail, head } });
  }
}

static void
retire_visible (HullBuilder *b, uint32_t apex)
{
  uint32_t i;

  for (i = 0; i < b->n_visible; i++) {
    hull_tell (b, EVENT (EVENT_RETIRE, b->visible[i], apex));
  }
}

static void
tell_duplicates (const HullBuilder *b)
{
  uint32_t site;

  for (site = 0; site < b->set->n_sites; site++)
    if (b->set->first[site] != site)
      hull_tell (b, EVENT (EVENT_DUPLICATE, INDEX_NONE, site));
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
    outside_redistribute (b, apex);
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
  free (b->queue);
  free (b->planes);
}

/* Shewchuk 1997, iccerrboundA, is 10 half ulps and a little of the sum of the
 * terms' magnitudes, which is at most 12 side⁴. DBL_MIN is more than underflow
 * can take away. */
static double
doubt_of (const SiteSet *set)
{
  const double side = 2 * site_set_extent (set).radius;

  return 16 * (DBL_EPSILON / 2) * 12 * side * side * side * side + DBL_MIN;
}

void
hull_build (const SiteSet *set, const Order *order, const HullHook *hook)
{
  HullBuilder b = { .set = set, .sites = set->sites, .hook = hook };

  b.doubt = doubt_of (set);
  b.next_outside = memory_new (set->n_sites, sizeof *b.next_outside);
  b.list = order_list (order, set);
  if (b.list != NULL)
    b.claimed_by = memory_new (set->n_sites, sizeof *b.claimed_by);

  tell_duplicates (&b);
  if (simplex_find (&b))
    build (&b);
  else
    hull_tell (&b, EVENT (EVENT_FLAT, INDEX_NONE, INDEX_NONE));
  hull_tell (&b, EVENT (EVENT_COMPLETE, INDEX_NONE, INDEX_NONE));
  clear (&b);
}
