#include "hull.h"

#include "hull-builder.h"
#include "hull-record.h"
#include "memory.h"

#include <stdlib.h>

/* Numbers for the cone: new ones, or in the batch build those of the visible
 * facets and two more. */
static void
number_cone (HullBuilder *b)
{
#ifdef HULL_BATCH
  const uint32_t n_new = b->n_horizon - b->n_visible;
  uint32_t i;

  for (i = 0; i < n_new; i++)
    b->visible[b->n_visible + i] = b->n_facets + i;
#else
  const uint32_t n_new = b->n_horizon;
#endif
  b->first_cone = b->n_facets;
  b->n_facets += n_new;
  if (b->n_facets > b->facets_room)
    b->facets = memory_grow (b->facets, &b->facets_room, b->n_facets,
                             sizeof *b->facets);
}

/* Joins every horizon ridge to the apex by a facet. The ridges come in loop
 * order, so neighbours in the cone follow each other. */
static void
build_cone (HullBuilder *b, uint32_t apex)
{
  const uint32_t n = b->n_horizon;
  uint32_t i;

  number_cone (b);
  for (i = 0; i < n; i++) {
    const HorizonRidge *ridge = &b->horizon[i];
    const uint32_t next = i + 1 < n ? i + 1 : 0;
    const uint32_t previous = i > 0 ? i - 1 : n - 1;
    const uint32_t head = b->horizon[next].tail;
    const uint32_t facet = hull_cone_facet (b, i);

    b->facets[facet]
        = (HullFacet){ { ridge->tail, head, apex },
                       { ridge->beyond, hull_cone_facet (b, next) << 2 | 2,
                         hull_cone_facet (b, previous) << 2 | 1 },
                       INDEX_NONE,
                       b->round };
    b->facets[ridge->beyond >> 2].across[ridge->beyond & 3] = facet << 2;
    hull_tell (b, (Event){ EVENT_CONE, facet, apex, { ridge->tail, head } });
  }
  b->near = hull_cone_facet (b, 0);
  b->counts.facets_created += n;
}

static void
retire_visible (HullBuilder *b, uint32_t apex)
{
  uint32_t i;

  for (i = 0; i < b->n_visible; i++)
    hull_tell (b, EVENT (EVENT_RETIRE, b->visible[i], apex));
}

/* Whether another round is wanted. */
static bool
wants_more (HullBuilder *b)
{
#ifdef HULL_BATCH
  (void)b;
  return true;
#else
  b->is_given_up = b->is_wanted != NULL && !b->is_wanted (b->user);
  return !b->is_given_up;
#endif
}

bool
hull_run (HullBuilder *b)
{
  uint32_t facet;

  if (!simplex_find (b))
    return false;
  simplex_build (b);
  outside_partition (b);

  while (wants_more (b) && (facet = outside_next_facet (b)) != INDEX_NONE) {
    const uint32_t apex = outside_select (b, facet);

    horizon_collect_visible (b, facet, apex);
    horizon_collect (b, apex);
    build_cone (b, apex);
    retire_visible (b, apex);
    hand_over (b, apex);
  }
  return true;
}

#ifndef HULL_PREFIX

void
hull_clear (HullBuilder *b)
{
  free (b->claimed_by);
  free (b->next_outside);
  free (b->queue);
  free (b->visible);
  free (b->pending);
  free (b->orphans);
  free (b->horizon);
  free (b->cone);
  free (b->cone_sets);
}

static bool
run (HullBuilder *b)
{
#ifdef HULL_HAS_AVX2
  if (__builtin_cpu_supports ("avx2"))
    return b->log != NULL ? record_avx2_hull_run (b) : avx2_hull_run (b);
#endif
  return b->log != NULL ? record_hull_run (b) : hull_run (b);
}

/* What is told outside the loop. */
static void
tell (const HullBuilder *b, EventKind kind, uint32_t site)
{
  const Event event = EVENT (kind, INDEX_NONE, site);

  if (b->log != NULL)
    trace_log_add (b->log, &event);
  else
    hull_tell (b, event);
}

static void
tell_duplicates (const HullBuilder *b)
{
  uint32_t site;

  for (site = 0; site < b->n_sites; site++)
    if (b->first[site] != site)
      tell (b, EVENT_DUPLICATE, site);
}

/* Room for a little more than the 5.6 facets a site that uniform ones have, so
 * that nothing is moved while it grows; of many sites, facets grow as they
 * come. */
static void
make_facets_room (HullBuilder *b)
{
  const uint32_t n = b->n_sites < 50000 ? b->n_sites : 50000;

  b->facets
      = memory_grow (NULL, &b->facets_room, 6 * n + 16, sizeof *b->facets);
}

/* From the first event to the last, with what is told by whom in @b.
 *
 * Returns: false when it was given up. */
static bool
build (HullBuilder *b, const SiteSet *set, const Order *order)
{
  OrderList list = order_list (order, set->sites, set->n_sites);

  b->sites = set->sites;
  b->n_sites = set->n_sites;
  b->first = set->first;
  b->n_young_max = UINT32_MAX;
  b->list = list.sites;
  b->n_listed = list.n_listed;
  make_facets_room (b);
  tell_duplicates (b);
  if (!run (b))
    tell (b, EVENT_FLAT, INDEX_NONE);
  if (!b->is_given_up)
    tell (b, EVENT_COMPLETE, INDEX_NONE);
  hull_clear (b);
  free (b->facets);
  free (list.sites);
  return !b->is_given_up;
}

void
hull_build (const SiteSet *set, const Order *order, const HullHook *hook)
{
  build (&(HullBuilder){ .hook = hook }, set, order);
}

bool
hull_build_while (const SiteSet *set,
                  const Order *order,
                  const HullHook *hook,
                  HullWanted is_wanted)
{
  HullBuilder b = { .hook = hook, .is_wanted = is_wanted, .user = hook->user };

  return build (&b, set, order);
}

bool
hull_record (const SiteSet *set,
             const Order *order,
             const HullWishes *wishes,
             TraceLog *log)
{
  HullBuilder b = { .log = log,
                    .choices = wishes->choices,
                    .is_wanted = wishes->is_wanted,
                    .user = wishes->user };

  return build (&b, set, order);
}

#endif
