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
  ORDER_SEEDED,   /* a sample along a curve, then QuickHull */
  ORDER_HILBERT,  /* rounds of growing samples, each along a curve */
} OrderKind;

typedef struct Order {
  OrderKind kind;
  uint64_t seed; /* for ORDER_RANDOM */
} Order;

#define N_ORDERS (ORDER_HILBERT + 1)

/* The sites in the order of insertion: the first n_listed are inserted as
 * listed, the others as the hull decides, furthest first. */
typedef struct OrderList {
  uint32_t *sites; /* all of them; NULL: as they come; free with free() */
  uint32_t n_listed;
} OrderList;

OrderList order_list (const Order *order, const Site *sites, uint32_t n_sites);

/* Returns: "furthest", "input", "random", "seeded", "hilbert". */
const char *order_kind_name (OrderKind kind);

/* Returns: whether @name is an order's name; sets *@kind. */
bool order_kind_parse (const char *name, OrderKind *kind);

/* A random number generator that is the same everywhere.
 *
 * Source: Steele, Lea, Flood 2014, splitmix64. */
uint64_t order_random (uint64_t *state);

#endif
