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

/* Puts the leftmost, rightmost, lowest and highest sites first, where the
 * first simplex is looked for: a wide one leaves few sites outside the hull
 * in the plane. */
static void
put_extremes_first (const Site *sites, uint32_t n, uint32_t *names)
{
  uint32_t k, i;

  for (k = 0; k < 4; k++) {
    const double sign = k % 2 == 0 ? 1 : -1;
    uint32_t best = k;

    for (i = k + 1; i < n; i++) {
      const Site *a = &sites[names[i]], *b = &sites[names[best]];

      if (k < 2 ? sign * a->x < sign * b->x : sign * a->y < sign * b->y)
        best = i;
    }
    i = names[k];
    names[k] = names[best];
    names[best] = i;
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
    put_extremes_first (sites, n, arrangement->names);
    if (list.n_listed > 0)
      rename_list (arrangement, list.sites, n);
  }
  arrangement->sites = memory_new (n, sizeof *arrangement->sites);
  for (i = 0; i < n; i++)
    arrangement->sites[i] = sites[arrangement->names[i]];
}

Batch *
batch_build (const Site *sites, uint32_t n_sites, const Order *order)
{
  Batch *batch = memory_new (1, sizeof *batch);
  HullBuilder b = { .n_sites = n_sites };
  Arrangement arrangement;
  uint32_t i;

  if (n_sites < 4)
    return batch;
  arrange (&arrangement, sites, n_sites, order);
  b.sites = arrangement.sites;
  b.list = arrangement.list;
  b.n_listed = arrangement.n_listed;
  b.walks = order->kind == ORDER_HILBERT || order->kind == ORDER_SEEDED;
  /* n vertices make 2n - 4 facets. */
  b.facets = memory_grow (NULL, &b.facets_room, 2 * n_sites, sizeof *b.facets);
  hull_run (&b);
  for (i = 0; i < 3 * b.n_facets; i++)
    b.facets[i / 3].site[i % 3]
        = arrangement.names[b.facets[i / 3].site[i % 3]];
  batch->facets = b.facets;
  batch->n_facets = b.n_facets;
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
