#include "batch.h"

#include "hilbert.h"
#include "hull-builder.h"
#include "memory.h"

#include <stdlib.h>

/* The sites as the builder sees them: in an order that keeps neighbours near
 * each other in memory, which is worth more than any other saving. */
typedef struct Arrangement {
  Site *sites;
  uint32_t *names; /* of the sites as given */
  uint32_t *list;  /* for orders whose insertion is not the arrangement's */
  uint32_t n_listed;
} Arrangement;

/* Where the listed sites have gone: list[i] as given becomes its new place. */
static void
rename_list (Arrangement *arrangement, uint32_t *given, uint32_t n)
{
  uint32_t *place = memory_new (n, sizeof *place);
  uint32_t i;

  for (i = 0; i < n; i++)
    place[arrangement->names[i]] = i;
  arrangement->list = memory_new (n, sizeof *arrangement->list);
  for (i = 0; i < n; i++)
    arrangement->list[i] = place[given != NULL ? given[i] : i];
  free (place);
  free (given);
}

static void
swap_places (Arrangement *arrangement, uint32_t i, uint32_t k)
{
  const Site site = arrangement->sites[i];
  const uint32_t name = arrangement->names[i];

  arrangement->sites[i] = arrangement->sites[k];
  arrangement->names[i] = arrangement->names[k];
  arrangement->sites[k] = site;
  arrangement->names[k] = name;
}

#define N_EXTREMES 4

/* Puts the leftmost, rightmost, lowest and highest sites first, where the
 * first simplex is looked for: a wide one leaves few sites outside the hull
 * in the plane. */
static void
put_extremes_first (Arrangement *arrangement, uint32_t n)
{
  const Site *sites = arrangement->sites;
  uint32_t extreme[N_EXTREMES] = { 0, 0, 0, 0 };
  uint32_t i, k;

  for (i = 1; i < n; i++) {
    if (sites[i].x < sites[extreme[0]].x)
      extreme[0] = i;
    if (sites[i].x > sites[extreme[1]].x)
      extreme[1] = i;
    if (sites[i].y < sites[extreme[2]].y)
      extreme[2] = i;
    if (sites[i].y > sites[extreme[3]].y)
      extreme[3] = i;
  }
  for (k = 0; k < N_EXTREMES; k++) {
    swap_places (arrangement, k, extreme[k]);
    /* What was at k is now where the extreme was. */
    for (i = k + 1; i < N_EXTREMES; i++)
      if (extreme[i] == k)
        extreme[i] = extreme[k];
      else if (extreme[i] == extreme[k])
        extreme[i] = k;
  }
}

static void
arrange (Arrangement *arrangement,
         const Site *sites,
         uint32_t n,
         const Order *order)
{
  OrderList list = order_list (order, sites, n);
  const bool is_spatial
      = order->kind == ORDER_HILBERT || order->kind == ORDER_SEEDED;
  uint32_t i;

  *arrangement
      = (Arrangement){ .names = list.sites, .n_listed = list.n_listed };
  if (!is_spatial) {
    arrangement->names = memory_new (n, sizeof *arrangement->names);
    hilbert_sort (sites, n, arrangement->names);
  }
  arrangement->sites = memory_new (n, sizeof *arrangement->sites);
  memory_use_large_pages (arrangement->sites, n * sizeof (Site));
  for (i = 0; i < n; i++)
    arrangement->sites[i] = sites[arrangement->names[i]];
  if (!is_spatial)
    put_extremes_first (arrangement, n);
  if (!is_spatial && list.n_listed > 0)
    rename_list (arrangement, list.sites, n);
}

/* Gives the facets' sites the names that they were given by. */
static void
name_sites (HullBuilder *b, const uint32_t *names)
{
  uint32_t facet, k;

  for (facet = 0; facet < b->n_facets; facet++)
    for (k = 0; k < 3; k++) {
      uint32_t *site = &b->facets[facet].site[k];

      *site = *site < b->n_sites ? names[*site] : INDEX_NONE;
    }
}

/* Measured, ns a site and facets a site at 100 000 uniform ones: 8 421 and 6.8,
 * 16 420 and 6.6, 32 451 and 6.2, 256 528 and 5.8, all (always the oldest) 620
 * and 5.6. Few make thin cones of sites near a line: 11.3, 8.4, 6.5, 5.1 and
 * 4.3 facets a site. */
#define N_YOUNG_MAX 16

static bool is_avx2_used = true;

void
batch_use_avx2 (bool is_used)
{
  is_avx2_used = is_used;
}

static bool
run (HullBuilder *b, BatchTurn turn)
{
  if (turn == BATCH_OLDEST)
    return lesson_hull_run (b);
#ifdef HULL_HAS_AVX2
  if (is_avx2_used && __builtin_cpu_supports ("avx2"))
    return batch_avx2_hull_run (b);
#endif
  return batch_hull_run (b);
}

/* How sites are chosen and located. Locally, QuickHull begins with the hull of
 * the extremes, and all other sites are walked to: they lie beside each other,
 * and no lift is asked for. */
static void
set_order (HullBuilder *b,
           const Arrangement *arrangement,
           OrderKind kind,
           BatchTurn turn)
{
  const bool begins_with_extremes
      = kind == ORDER_FURTHEST && turn == BATCH_LOCAL;

  b->list = arrangement->list;
  b->n_listed = begins_with_extremes ? N_EXTREMES : arrangement->n_listed;
  b->walks
      = kind == ORDER_HILBERT || kind == ORDER_SEEDED || begins_with_extremes;
  b->n_young_max = turn == BATCH_LOCAL ? N_YOUNG_MAX : UINT32_MAX;
}

Batch *
batch_build (const Site *sites,
             uint32_t n_sites,
             const Order *order,
             BatchTurn turn)
{
  Batch *batch = memory_new (1, sizeof *batch);
  HullBuilder b = { .n_sites = n_sites };
  Arrangement arrangement;

  if (n_sites < 4)
    return batch;
  arrange (&arrangement, sites, n_sites, order);
  b.sites = arrangement.sites;
  set_order (&b, &arrangement, order->kind, turn);
  /* n vertices make 2n - 4 facets; one more may be at infinity. */
  b.facets = memory_grow (NULL, &b.facets_room, 2 * n_sites, sizeof *b.facets);
  memory_use_large_pages (b.facets, b.facets_room * sizeof *b.facets);
  run (&b, turn);
  name_sites (&b, arrangement.names);
  batch->facets = b.facets;
  batch->n_facets = b.n_facets;
  batch->is_whole = turn == BATCH_OLDEST;
  batch->counts = b.counts;
  hull_clear (&b);
  free (arrangement.sites);
  free (arrangement.names);
  free (arrangement.list);
  return batch;
}

void
batch_free (Batch *batch)
{
  if (batch == NULL)
    return;
  free (batch->facets);
  free (batch);
}
