#include "order.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

static SiteSet *
row_of_sites (uint32_t n)
{
  g_autofree Site *sites = g_new0 (Site, n);

  for (uint32_t i = 0; i < n; i += 1)
    sites[i].x = i;
  return site_set_new (sites, n);
}

/* The first numbers of the published generator for seed 1234567. */
static void
test_random_numbers_are_those_of_splitmix64 (void)
{
  uint64_t state = 1234567;

  g_assert_cmpuint (order_random (&state), ==, 6457827717110365317u);
  g_assert_cmpuint (order_random (&state), ==, 3203168211198807973u);
  g_assert_cmpuint (order_random (&state), ==, 9817491932198370423u);
}

static void
test_furthest_has_no_list (void)
{
  SiteSet *set = row_of_sites (5);

  g_assert_cmpuint (
      order_list (&(Order){ ORDER_FURTHEST, 0 }, set->sites, set->n_sites)
          .n_listed,
      ==, 0);
  site_set_free (set);
}

static void
test_input_order_is_the_order_of_input (void)
{
  SiteSet *set = row_of_sites (5);
  const OrderList list
      = order_list (&(Order){ ORDER_INPUT, 7 }, set->sites, set->n_sites);

  g_assert_null (list.sites);
  g_assert_cmpuint (list.n_listed, ==, 5);
  site_set_free (set);
}

static void
test_shuffle_has_every_site_once (void)
{
  SiteSet *set = row_of_sites (1000);
  uint32_t *list
      = order_list (&(Order){ ORDER_RANDOM, 7 }, set->sites, set->n_sites)
            .sites;
  g_autofree bool *is_there = g_new0 (bool, 1000);
  uint32_t n_fixed = 0;

  for (uint32_t i = 0; i < 1000; i += 1) {
    g_assert_cmpuint (list[i], <, 1000);
    g_assert_false (is_there[list[i]]);
    is_there[list[i]] = true;
    n_fixed += list[i] == i ? 1 : 0;
  }
  g_assert_cmpuint (n_fixed, <, 10);
  free (list);
  site_set_free (set);
}

static void
test_seed_decides_the_shuffle (void)
{
  SiteSet *set = row_of_sites (100);
  uint32_t *a
      = order_list (&(Order){ ORDER_RANDOM, 7 }, set->sites, set->n_sites)
            .sites;
  uint32_t *b
      = order_list (&(Order){ ORDER_RANDOM, 7 }, set->sites, set->n_sites)
            .sites;
  uint32_t *c
      = order_list (&(Order){ ORDER_RANDOM, 8 }, set->sites, set->n_sites)
            .sites;

  g_assert_cmpmem (a, 100 * sizeof *a, b, 100 * sizeof *b);
  g_assert_cmpint (memcmp (a, c, 100 * sizeof *a), !=, 0);
  free (a);
  free (b);
  free (c);
  site_set_free (set);
}

static void
test_every_shuffle_of_three_is_about_as_frequent (void)
{
  SiteSet *set = row_of_sites (3);
  int count[3][3] = { { 0 } };

  for (uint64_t seed = 0; seed < 6000; seed += 1) {
    uint32_t *list
        = order_list (&(Order){ ORDER_RANDOM, seed }, set->sites, set->n_sites)
              .sites;

    count[list[0]][list[1]] += 1;
    free (list);
  }
  for (int i = 0; i < 3; i += 1) {
    for (int j = 0; j < 3; j += 1) {
      g_assert_cmpint (count[i][j], >=, i == j ? 0 : 850);
      g_assert_cmpint (count[i][j], <=, i == j ? 0 : 1150);
    }
  }
  site_set_free (set);
}

static void
test_names_of_orders_are_known (void)
{
  OrderKind kind = ORDER_FURTHEST;

  g_assert_true (order_kind_parse ("random", &kind));
  g_assert_cmpint (kind, ==, ORDER_RANDOM);
  g_assert_true (order_kind_parse ("input", &kind));
  g_assert_cmpint (kind, ==, ORDER_INPUT);
  g_assert_true (order_kind_parse ("furthest", &kind));
  g_assert_cmpint (kind, ==, ORDER_FURTHEST);
  g_assert_false (order_kind_parse ("nearest", &kind));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/order/random-numbers-are-those-of-splitmix64",
                   test_random_numbers_are_those_of_splitmix64);
  g_test_add_func ("/order/furthest-has-no-list", test_furthest_has_no_list);
  g_test_add_func ("/order/input-order-is-the-order-of-input",
                   test_input_order_is_the_order_of_input);
  g_test_add_func ("/order/shuffle-has-every-site-once",
                   test_shuffle_has_every_site_once);
  g_test_add_func ("/order/seed-decides-the-shuffle",
                   test_seed_decides_the_shuffle);
  g_test_add_func ("/order/every-shuffle-of-three-is-about-as-frequent",
                   test_every_shuffle_of_three_is_about_as_frequent);
  g_test_add_func ("/order/names-of-orders-are-known",
                   test_names_of_orders_are_known);
  return g_test_run ();
}
