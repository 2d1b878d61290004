#include "predicate.h"

#include "exact.h"

#include "fixture.h"
#include "lift-judge.h"

#include <glib.h>
#include <math.h>

static void
assert_orient (const Site *a, const Site *b, const Site *c)
{
  const int sign = lift_judge_orient (a, b, c);

  g_assert_cmpint (orient (a, b, c), ==, sign);
  g_assert_cmpint (exact_orient (a, b, c), ==, sign);
  g_assert_cmpint (orient (b, c, a), ==, sign);
  g_assert_cmpint (orient (b, a, c), ==, -sign);
}

static void
assert_lift_orient (const Site plane[3], const Site *d)
{
  const Site *a = &plane[0], *b = &plane[1], *c = &plane[2];
  const int sign = lift_judge_side (plane, d);

  g_assert_cmpint (lift_orient (a, b, c, d), ==, sign);
  g_assert_cmpint (exact_lift_orient (a, b, c, d), ==, sign);
  g_assert_cmpint (lift_orient (c, a, b, d), ==, sign);
  g_assert_cmpint (lift_orient (b, a, c, d), ==, -sign);
}

static void
assert_lift_further (const Site plane[3], const Site *p, const Site *q)
{
  const int order = lift_judge_further (plane, p, q);

  g_assert_cmpint (lift_further (plane, p, q), ==, order);
  g_assert_cmpint (exact_lift_further (plane, p, q), ==, order);
  g_assert_cmpint (lift_further (plane, q, p), ==, -order);
}

static void
assert_all (const Site sites[5])
{
  assert_orient (&sites[0], &sites[1], &sites[2]);
  assert_lift_orient (sites, &sites[3]);
  assert_lift_further (sites, &sites[3], &sites[4]);
}

static const Site left_turn[3] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };

static void
test_sign_of_a_left_turn (void)
{
  const Site *t = left_turn;

  g_assert_cmpint (orient (&t[0], &t[1], &t[2]), ==, 1);
  g_assert_cmpint (orient (&t[0], &t[2], &t[1]), ==, -1);
  g_assert_cmpint (orient (&t[0], &t[1], &(Site){ -7, 0 }), ==, 0);
}

static void
test_upper_facet_is_seen_from_outside_its_circle (void)
{
  const Site *t = left_turn;

  g_assert_cmpint (lift_orient (&t[0], &t[1], &t[2], &(Site){ 2, 2 }), ==, 1);
  g_assert_cmpint (lift_orient (&t[0], &t[1], &t[2], &(Site){ 0.5, 0.5 }), ==,
                   -1);
  g_assert_cmpint (lift_orient (&t[0], &t[1], &t[2], &(Site){ 1, 1 }), ==, 0);
}

static void
test_furthest_from_a_lower_facet_is_nearest_to_its_centre (void)
{
  const Site lower[3] = { { 0, 0 }, { 0, 1 }, { 1, 0 } };

  g_assert_cmpint (
      lift_further (lower, &(Site){ 0.5, 0.5 }, &(Site){ 0.5, 0.75 }), ==, 1);
  g_assert_cmpint (
      lift_further (lower, &(Site){ 0.25, 0.5 }, &(Site){ 0.5, 0.75 }), ==, 0);
}

static void
test_facing_is_where_the_normal_points (void)
{
  const Site *t = left_turn;

  g_assert_cmpint (facing (&t[0], &t[1], &t[2]), ==, FACING_UPPER);
  g_assert_cmpint (facing (&t[0], &t[2], &t[1]), ==, FACING_LOWER);
  g_assert_cmpint (facing (&t[0], &t[1], &(Site){ 3, 0 }), ==, FACING_VERTICAL);
}

/* @n steps of one ulp away from @from. */
static double
ulps (double from, int n)
{
  for (; n > 0; n -= 1)
    from = nextafter (from, (double)INFINITY);
  return from;
}

/* Every site of a grid of 256 by 256 ulps around a corner of a flat triangle.
 * Source: Kettner, Mehlhorn, Pion, Schirra, Yap 2008, figure 2. */
static void
test_orient_tells_one_ulp_from_a_line (void)
{
  static const Site corners[][3] = {
    { { 0.5, 0.5 }, { 12, 12 }, { 24, 24 } },
    { { 0.50000000000002531, 0.5000000000000171 },
      { 17.300000000000001, 17.300000000000001 },
      { 24.00000000000005, 24.0000000000000517765 } },
    { { 0.5, 0.5 },
      { 8.8000000000000007, 8.8000000000000007 },
      { 12.1, 12.1 } },
  };

  for (guint i = 0; i < 3 * 256 * 256; i += 1) {
    const Site *corner = corners[i / 65536];
    const Site p = { ulps (corner[0].x, (int)(i / 256 % 256)),
                     ulps (corner[0].y, (int)(i % 256)) };

    assert_orient (&p, &corner[1], &corner[2]);
  }
}

/* HULL2VD_SOAK multiplies the number of tuples: a million with ./dev soak. */
enum { N_TUPLES = 20000 };

static int
n_tuples (void)
{
  return (int)MIN (fixture_n_seeds (N_TUPLES), N_TUPLES * 1000);
}

/* Every site of a grid of 256 by 256 ulps around the fourth corner of three
 * on a circle or line; without HULL2VD_SOAK every eighth row and column. */
static void
test_lift_orient_tells_one_ulp_from_a_circle (void)
{
  static const struct {
    Site plane[3], fourth;
  } grids[] = {
    { { { 17, 0 }, { 8, 15 }, { -15, 8 } }, { 8, -15 } },
    { { { 0.1, 0.7 }, { 0.7, 0.1 }, { -0.5, -0.5 } }, { -0.1, 0.7 } },
    { { { 12, 12 }, { 24, 24 }, { 0.5, 0.5 } }, { 17.3, 17.3 } },
  };
  const int stride = n_tuples () >= N_TUPLES * 50 ? 1 : 8;

  for (guint g = 0; g < G_N_ELEMENTS (grids); g += 1) {
    const double x = grids[g].fourth.x, y = grids[g].fourth.y;

    for (int i = -128; i < 128; i += stride)
      for (int j = -128; j < 128; j += stride) {
        const Site d = { x + i * (nextafter (x, 100) - x),
                         y + j * (nextafter (y, 100) - y) };

        assert_lift_orient (grids[g].plane, &d);
      }
  }
}

static double
random_double (GRand *random, int lowest, int highest)
{
  const double mantissa = g_rand_double_range (random, 1, 2);
  const int exponent = g_rand_int_range (random, lowest, highest + 1);

  return ldexp (g_rand_boolean (random) ? mantissa : -mantissa, exponent);
}

static void
test_signs_hold_for_every_exponent (void)
{
  GRand *random = g_rand_new_with_seed (145);

  for (int i = n_tuples (); i > 0; i -= 1) {
    Site sites[5];

    for (int j = 0; j < 5; j += 1)
      sites[j] = (Site){ random_double (random, -SITE_RANGE, SITE_RANGE),
                         random_double (random, -SITE_RANGE, SITE_RANGE) };
    assert_all (sites);
  }
  g_rand_free (random);
}

/* Sites nearly on one line or circle: small integers times a power of two,
 * some of them moved by a few ulps. */
static void
test_signs_hold_for_near_degenerate_tuples (void)
{
  static const Site circle[]
      = { { 25, 0 },   { 24, 7 },   { 20, 15 }, { 15, 20 },
          { 7, 24 },   { 0, 25 },   { -7, 24 }, { -15, 20 },
          { -20, 15 }, { -24, -7 }, { 7, -24 }, { 20, -15 } };
  GRand *random = g_rand_new_with_seed (1999);

  for (int i = n_tuples (); i > 0; i -= 1) {
    const int exponent = g_rand_int_range (random, -SITE_RANGE, SITE_RANGE - 6);
    const double shift = g_rand_boolean (random) ? 0 : 1000;
    Site sites[5];

    for (int j = 0; j < 5; j += 1) {
      Site s = circle[g_rand_int_range (random, 0, G_N_ELEMENTS (circle))];

      s.x = ulps (s.x + shift, MAX (0, g_rand_int_range (random, -6, 3)));
      s.y = ulps (s.y - shift, MAX (0, g_rand_int_range (random, -6, 3)));
      if (fabs (s.x) < 1e-10)
        s.x = 0;
      if (fabs (s.y) < 1e-10)
        s.y = 0;
      sites[j] = (Site){ ldexp (s.x, exponent), ldexp (s.y, exponent) };
    }
    assert_all (sites);
  }
  g_rand_free (random);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/predicate/orient-is-positive-for-a-left-turn",
                   test_sign_of_a_left_turn);
  g_test_add_func ("/predicate/upper-facet-is-seen-from-outside-its-circle",
                   test_upper_facet_is_seen_from_outside_its_circle);
  g_test_add_func (
      "/predicate/furthest-of-lower-facet-is-nearest-to-its-centre",
      test_furthest_from_a_lower_facet_is_nearest_to_its_centre);
  g_test_add_func ("/predicate/facing-is-where-the-normal-points",
                   test_facing_is_where_the_normal_points);
  g_test_add_func ("/predicate/orient-tells-one-ulp-from-a-line",
                   test_orient_tells_one_ulp_from_a_line);
  g_test_add_func ("/predicate/lift-orient-tells-one-ulp-from-a-circle",
                   test_lift_orient_tells_one_ulp_from_a_circle);
  g_test_add_func ("/predicate/signs-hold-for-every-exponent",
                   test_signs_hold_for_every_exponent);
  g_test_add_func ("/predicate/signs-hold-for-near-degenerate-tuples",
                   test_signs_hold_for_near_degenerate_tuples);
  return g_test_run ();
}
