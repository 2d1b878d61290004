#include "order.h"

#include "hilbert.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

uint64_t
order_random (uint64_t *state)
{
  uint64_t z;

  *state += UINT64_C (0x9e3779b97f4a7c15);
  z = *state;
  z = (z ^ (z >> 30)) * UINT64_C (0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C (0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/* Fisher and Yates. The remainder of 64 random bits favours no place by more
 * than one part in 2^32. */
static void
shuffle (uint32_t *list, uint32_t n, uint64_t seed)
{
  for (uint32_t i = n; i > 1; i -= 1) {
    const uint32_t j = (uint32_t)(order_random (&seed) % i);
    const uint32_t last = list[i - 1];

    list[i - 1] = list[j];
    list[j] = last;
  }
}

/* Every sixteenth site along the curve is enough to spread the outside sets,
 * and few enough to cost little. */
#define SAMPLE 16

static uint32_t
list_sample_first (const Site *sites, uint32_t n, uint32_t *list)
{
  uint32_t *curve = memory_new (n, sizeof *curve);
  uint32_t n_listed = 0, next, i;

  hilbert_sort (sites, n, curve);
  for (i = 0; i < n; i += SAMPLE)
    list[n_listed++] = curve[i];
  next = n_listed;
  for (i = 0; i < n; i++)
    if (i % SAMPLE != 0)
      list[next++] = curve[i];
  free (curve);
  return n_listed;
}

OrderList
order_list (const Order *order, const Site *sites, uint32_t n_sites)
{
  OrderList list = { NULL, n_sites };
  uint32_t i;

  switch (order->kind) {
  case ORDER_FURTHEST:
    list.n_listed = 0;
    return list;
  case ORDER_INPUT:
    return list;
  case ORDER_RANDOM:
  case ORDER_SEEDED:
  case ORDER_HILBERT:
    break;
  }
  list.sites = memory_new (n_sites, sizeof *list.sites);
  if (order->kind == ORDER_HILBERT) {
    hilbert_brio (sites, n_sites, list.sites);
  } else if (order->kind == ORDER_SEEDED) {
    list.n_listed = list_sample_first (sites, n_sites, list.sites);
  } else {
    for (i = 0; i < n_sites; i++)
      list.sites[i] = i;
    shuffle (list.sites, n_sites, order->seed);
  }
  return list;
}

static const char *const kind_names[N_ORDERS] = {
  [ORDER_FURTHEST] = "furthest", [ORDER_INPUT] = "input",
  [ORDER_RANDOM] = "random",     [ORDER_SEEDED] = "seeded",
  [ORDER_HILBERT] = "hilbert",
};

const char *
order_kind_name (OrderKind kind)
{
  return kind_names[kind];
}

bool
order_kind_parse (const char *name, OrderKind *kind)
{
  OrderKind i;

  for (i = 0; i < N_ORDERS; i++)
    if (strcmp (name, kind_names[i]) == 0) {
      *kind = i;
      return true;
    }
  return false;
}
