#include "order.h"

#include "memory.h"

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

uint32_t *
order_list (const Order *order, const SiteSet *set)
{
  uint32_t *list;

  if (order->kind == ORDER_FURTHEST)
    return NULL;
  list = memory_new (set->n_sites, sizeof *list);
  for (uint32_t i = 0; i < set->n_sites; i += 1)
    list[i] = i;
  if (order->kind == ORDER_RANDOM)
    shuffle (list, set->n_sites, order->seed);
  return list;
}

bool
order_kind_parse (const char *name, OrderKind *kind)
{
  static const char *const names[] = {
    [ORDER_FURTHEST] = "furthest",
    [ORDER_INPUT] = "input",
    [ORDER_RANDOM] = "random",
  };

  for (uint32_t i = 0; i < sizeof names / sizeof *names; i += 1) {
    if (strcmp (name, names[i]) == 0) {
      *kind = (OrderKind)i;
      return true;
    }
  }
  return false;
}
