#include "site.h"

#include <float.h>
#include <glib.h>
#include <math.h>

static void
test_duplicates_name_the_first_of_the_equals (void)
{
  const Site sites[]
      = { { 0, 0 }, { 1, 0 }, { -0.0, 0 }, { 1, 0 }, { 1, -0.0 }, { 0, 1 } };
  SiteSet *set = site_set_new (sites, 6);
  const uint32_t first[] = { 0, 1, 0, 1, 1, 5 };

  g_assert_cmpuint (set->n_sites, ==, 6);
  g_assert_cmpuint (set->n_distinct, ==, 3);
  for (int i = 0; i < 6; i += 1)
    g_assert_cmpuint (set->first[i], ==, first[i]);
  site_set_free (set);
}

static void
test_negative_zero_becomes_zero (void)
{
  SiteSet *set = site_set_new (&(Site){ -0.0, -0.0 }, 1);

  g_assert_false (signbit (set->sites[0].x));
  g_assert_false (signbit (set->sites[0].y));
  site_set_free (set);
}

static void
test_duplicates_agree_with_comparing_all_pairs (void)
{
  GRand *random = g_rand_new_with_seed (5);
  Site sites[300];
  SiteSet *set;

  for (int i = 0; i < 300; i += 1)
    sites[i] = (Site){ g_rand_int_range (random, -6, 7),
                       g_rand_int_range (random, -6, 7) };
  set = site_set_new (sites, 300);
  for (uint32_t i = 0; i < 300; i += 1) {
    uint32_t first = 0;

    while (sites[first].x != sites[i].x || sites[first].y != sites[i].y)
      first += 1;
    g_assert_cmpuint (set->first[i], ==, first);
  }
  site_set_free (set);
  g_rand_free (random);
}

static void
test_ordinary_coordinates_are_not_scaled (void)
{
  const Site sites[] = { { ldexp (1, 145), 0.1 }, { ldexp (-1, -145), 3 } };
  SiteSet *set = site_set_new (sites, 2);

  g_assert_cmpint (set->exponent, ==, 0);
  g_assert_cmpfloat (set->sites[0].x, ==, sites[0].x);
  g_assert_cmpfloat (set->sites[0].y, ==, sites[0].y);
  g_assert_cmpfloat (set->sites[1].x, ==, sites[1].x);
  site_set_free (set);
}

/* Extreme sites must come into the range and go back bit for bit. */
static void
assert_scales (const Site *sites, uint32_t n_sites)
{
  SiteSet *set = site_set_new (sites, n_sites);

  g_assert_nonnull (set);
  g_assert_cmpint (set->exponent, !=, 0);
  for (uint32_t i = 0; i < n_sites; i += 1) {
    const Site given = site_set_given (set, i);
    const double x = fabs (set->sites[i].x);

    g_assert_cmpfloat (given.x, ==, sites[i].x);
    g_assert_cmpfloat (given.y, ==, sites[i].y);
    g_assert_true (x == 0 || x >= ldexp (1, -SITE_RANGE));
    g_assert_cmpfloat (x, <, ldexp (1, SITE_RANGE + 1));
  }
  site_set_free (set);
}

static void
test_extreme_coordinates_are_scaled_exactly (void)
{
  const Site large[] = { { DBL_MAX, -DBL_MAX }, { 0, 1e300 }, { 1e250, 0 } };
  const Site subnormal[]
      = { { DBL_TRUE_MIN, 0 }, { 0, 3 * DBL_TRUE_MIN }, { 1e-310, 1e-300 } };

  assert_scales (large, 3);
  assert_scales (subnormal, 3);
}

static void
test_spread_that_no_scaling_fits_is_refused (void)
{
  const Site sites[] = { { 1e300, 0 }, { 1, 1e-300 } };
  SiteRange range = SITE_RANGE_INIT;

  g_assert_null (site_set_new (sites, 2));
  g_assert_true (site_range_add (&range, &sites[0]));
  g_assert_false (site_range_add (&range, &sites[1]));
}

static void
test_limit_of_the_spread_is_the_range_twice (void)
{
  const Site within[] = { { ldexp (1.9, 500), 0 }, { 0, ldexp (1, 210) } };
  const Site beyond[] = { { ldexp (1, 500), 0 }, { ldexp (1.9, 209), 0 } };
  SiteSet *set = site_set_new (within, 2);

  g_assert_nonnull (set);
  g_assert_null (site_set_new (beyond, 2));
  site_set_free (set);
}

static void
test_coordinates_that_are_not_finite_are_refused (void)
{
  g_assert_null (site_set_new (&(Site){ (double)NAN, 0 }, 1));
  g_assert_null (site_set_new (&(Site){ 0, (double)-INFINITY }, 1));
}

static void
test_extent_is_the_smallest_square (void)
{
  const Site sites[] = { { -1, 10 }, { 3, 11 }, { 0, 12 } };
  SiteSet *set = site_set_new (sites, 3);
  const Extent extent = site_set_extent (set);

  g_assert_cmpfloat (extent.centre.x, ==, 1);
  g_assert_cmpfloat (extent.centre.y, ==, 11);
  g_assert_cmpfloat (extent.radius, ==, 2);
  site_set_free (set);
}

static void
test_extent_is_never_empty (void)
{
  const Site twice[] = { { 5, 6 }, { 5, 6 } };
  SiteSet *none = site_set_new (NULL, 0), *lone = site_set_new (twice, 2);

  g_assert_cmpfloat (site_set_extent (none).centre.x, ==, 0);
  g_assert_cmpfloat (site_set_extent (none).radius, ==, 1);
  g_assert_cmpfloat (site_set_extent (lone).centre.y, ==, 6);
  g_assert_cmpfloat (site_set_extent (lone).radius, ==, 1);
  site_set_free (none);
  site_set_free (lone);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/site/duplicates-name-the-first-of-the-equals",
                   test_duplicates_name_the_first_of_the_equals);
  g_test_add_func ("/site/negative-zero-becomes-zero",
                   test_negative_zero_becomes_zero);
  g_test_add_func ("/site/duplicates-agree-with-comparing-all-pairs",
                   test_duplicates_agree_with_comparing_all_pairs);
  g_test_add_func ("/site/ordinary-coordinates-are-not-scaled",
                   test_ordinary_coordinates_are_not_scaled);
  g_test_add_func ("/site/extreme-coordinates-are-scaled-exactly",
                   test_extreme_coordinates_are_scaled_exactly);
  g_test_add_func ("/site/spread-that-no-scaling-fits-is-refused",
                   test_spread_that_no_scaling_fits_is_refused);
  g_test_add_func ("/site/limit-of-the-spread-is-the-range-twice",
                   test_limit_of_the_spread_is_the_range_twice);
  g_test_add_func ("/site/coordinates-that-are-not-finite-are-refused",
                   test_coordinates_that_are_not_finite_are_refused);
  g_test_add_func ("/site/extent-is-the-smallest-square",
                   test_extent_is_the_smallest_square);
  g_test_add_func ("/site/extent-is-never-empty", test_extent_is_never_empty);
  return g_test_run ();
}
