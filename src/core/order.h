/* Orders of insertion: which site comes next. Cavity, horizon and cone are
 * the same for all. */
#ifndef ORDER_H
#define ORDER_H

#include "site.h"

typedef enum OrderKind {
  ORDER_FURTHEST, /* QuickHull: the furthest site of the oldest facet that
                     has an outside set */
  ORDER_INPUT,    /* the sites as they come */
  ORDER_RANDOM,   /* a shuffle that the seed decides */
} OrderKind;

typedef struct Order {
  OrderKind kind;
  uint64_t seed; /* for ORDER_RANDOM */
} Order;

/* Returns: all sites of the set in the order of insertion, for the orders
 *          that do not look at the hull; free with free(). NULL for
 *          ORDER_FURTHEST. */
uint32_t *order_list (const Order *order, const SiteSet *set);

/* Returns: whether @name is an order's name ("furthest", "input", "random");
 *          sets *@kind. */
bool order_kind_parse (const char *name, OrderKind *kind);

/* A random number generator that is the same everywhere.
 *
 * Source: Steele, Lea, Flood 2014, splitmix64. */
uint64_t order_random (uint64_t *state);

#endif
