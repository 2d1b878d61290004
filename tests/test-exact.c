#include "exact.h"

#include "judge.h"
#include "predicate.h"
#include "site-file.h"

#include "fixture.h"

#include <math.h>

static double
some_double (GRand *random, int lowest, int highest)
{
  const double mantissa = g_rand_double_range (random, 1, 2);
  const int exponent = g_rand_int_range (random, lowest, highest + 1);

  return ldexp (g_rand_boolean (random) ? mantissa : -mantissa, exponent);
}

/* Whether |value - exact| <= 2^-50 |exact|: four units in the last place. */
static bool
is_near (double value, mpq_t exact)
{
  mpq_t error, bound;
  bool is_good;

  mpq_inits (error, bound, NULL);
  mpq_set_d (error, value);
  mpq_sub (error, error, exact);
  mpq_abs (error, error);
  mpq_abs (bound, exact);
  mpq_div_2exp (bound, bound, 50);
  is_good = mpq_cmp (error, bound) <= 0;
  mpq_clears (error, bound, NULL);
  return is_good;
}

/* ax x + ay y = a and so on: the bisectors of two sides, solved by Cramer. */
typedef struct Bisector {
  mpq_t x, y, right;
} Bisector;

/* 2 (q - p) · centre = q² - p² */
static void
bisector_init (Bisector *bisector, const Site *p, const Site *q)
{
  mpq_t px, py, qx, qy, square;

  mpq_inits (px, py, qx, qy, square, NULL);
  mpq_inits (bisector->x, bisector->y, bisector->right, NULL);
  mpq_set_d (px, p->x);
  mpq_set_d (py, p->y);
  mpq_set_d (qx, q->x);
  mpq_set_d (qy, q->y);
  mpq_sub (bisector->x, qx, px);
  mpq_mul_2exp (bisector->x, bisector->x, 1);
  mpq_sub (bisector->y, qy, py);
  mpq_mul_2exp (bisector->y, bisector->y, 1);
  mpq_mul (bisector->right, qx, qx);
  mpq_mul (square, qy, qy);
  mpq_add (bisector->right, bisector->right, square);
  mpq_mul (square, px, px);
  mpq_sub (bisector->right, bisector->right, square);
  mpq_mul (square, py, py);
  mpq_sub (bisector->right, bisector->right, square);
  mpq_clears (px, py, qx, qy, square, NULL);
}

static void
cross (mpq_t result, mpq_t a, mpq_t b, mpq_t c, mpq_t d)
{
  mpq_t right;

  mpq_init (right);
  mpq_mul (result, a, b);
  mpq_mul (right, c, d);
  mpq_sub (result, result, right);
  mpq_clear (right);
}

static void
assert_centre (const Site *a, const Site *b, const Site *c)
{
  const Site centre = exact_circumcentre (a, b, c);
  Bisector p, q;
  mpq_t determinant, x, y;

  bisector_init (&p, a, b);
  bisector_init (&q, a, c);
  mpq_inits (determinant, x, y, NULL);
  cross (determinant, p.x, q.y, p.y, q.x);
  if (mpq_sgn (determinant) != 0) {
    cross (x, p.right, q.y, p.y, q.right);
    cross (y, p.x, q.right, p.right, q.x);
    mpq_div (x, x, determinant);
    mpq_div (y, y, determinant);
    g_assert_true (is_near (centre.x, x));
    g_assert_true (is_near (centre.y, y));
  }
  mpq_clears (determinant, x, y, p.x, p.y, p.right, NULL);
  mpq_clears (q.x, q.y, q.right, NULL);
}

static void
test_centres_of_random_triangles_are_right (void)
{
  GRand *random = g_rand_new_with_seed (3);

  for (int i = 0; i < 20000; i++) {
    const int range = i % 2 == 0 ? 3 : SITE_RANGE;
    Site site[3];

    for (int k = 0; k < 3; k++)
      site[k] = (Site){ some_double (random, -range, range),
                        some_double (random, -range, range) };
    assert_centre (&site[0], &site[1], &site[2]);
  }
  g_rand_free (random);
}

/* Nearly collinear, and far from the origin: nothing may cancel. */
static void
test_centres_of_flat_triangles_are_right (void)
{
  GRand *random = g_rand_new_with_seed (4);

  for (int i = 0; i < 20000; i++) {
    const double far = ldexp (1, g_rand_int_range (random, 0, 60));
    Site site[3];

    for (int k = 0; k < 3; k++) {
      const double x = far + g_rand_double_range (random, -1, 1);

      site[k] = (Site){ x, nextafter (3 * x, g_rand_double (random)) };
    }
    assert_centre (&site[0], &site[1], &site[2]);
  }
  g_rand_free (random);
}

/* Nearly all of the numerator cancels. */
static void
test_centres_near_the_origin_are_right (void)
{
  GRand *random = g_rand_new_with_seed (5);

  for (int i = 0; i < 10000; i++) {
    const double radius = some_double (random, -40, 40);
    Site site[3];

    for (int k = 0; k < 3; k++) {
      const double angle = g_rand_double_range (random, 0, 2 * G_PI);
      const double squeeze = i % 4 == 0 ? 0x1p-30 : 1;

      site[k] = (Site){ radius * squeeze * cos (angle), radius * sin (angle) };
    }
    assert_centre (&site[0], &site[1], &site[2]);
  }
  g_rand_free (random);
}

/* The coordinate of the centre that is zero must come out as zero. */
static void
test_centre_at_the_origin_is_exact (void)
{
  const Site a = { 0.6 * 5, 0.8 * 5 }, b = { -0.6 * 5, 0.8 * 5 };
  const Site c = { 0.6 * 5, -0.8 * 5 };
  const Site centre = exact_circumcentre (&a, &b, &c);

  g_assert_cmpfloat (centre.x, ==, 0);
  g_assert_cmpfloat (centre.y, ==, 0);
}

static SiteSet *
load (const char *name)
{
  g_autofree char *path = fixture_path ("corpus", name, ".txt");
  g_autofree char *text = NULL;
  gsize length;
  SiteFileError fault;
  SiteSet *set;

  g_assert_true (g_file_get_contents (path, &text, &length, NULL));
  set = site_file_parse (text, length, &fault);
  g_assert_nonnull (set);
  return set;
}

static void
check_triples (const SiteSet *set, const Judge *judge)
{
  const uint32_t n = set->n_sites;

  for (uint32_t i = 0; i < n; i++)
    for (uint32_t j = 0; j < n; j++)
      for (uint32_t k = 0; k < n; k++) {
        const Site *a = &set->sites[i], *b = &set->sites[j];
        const int turn = judge_orient (judge, i, j, k);

        g_assert_cmpint (orient (a, b, &set->sites[k]), ==, turn);
        g_assert_cmpint (exact_orient (a, b, &set->sites[k]), ==, turn);
      }
}

static void
check_circles (const SiteSet *set, const Judge *judge, uint32_t n)
{
  for (uint32_t i = 0; i < n * n * n * n; i++) {
    const uint32_t at[] = { i % n, i / n % n, i / n / n % n };
    const uint32_t d = i / n / n / n;
    const int turn = judge_orient (judge, at[0], at[1], at[2]);
    const Site *sites = set->sites;

    if (turn == 0)
      continue;
    g_assert_cmpint (
        lift_orient (&sites[at[0]], &sites[at[1]], &sites[at[2]], &sites[d]),
        ==, turn * judge_circle (judge, at, d));
  }
}

static void
test_signs_hold_for_inputs_that_break_doubles (void)
{
  static const char *const names[]
      = { "kettner-a1",          "kettner-a1-global",    "kettner-a2",
          "kettner-a2-visible",  "kettner-b1",           "kettner-b2",
          "kettner-fig2-corner", "scipy-pathological-2", "d3-delaunay-141" };

  for (size_t i = 0; i < G_N_ELEMENTS (names); i++) {
    SiteSet *set = load (names[i]);
    Judge *judge = judge_new (set);

    check_triples (set, judge);
    check_circles (set, judge, MIN (set->n_sites, 12));
    judge_free (judge);
    site_set_free (set);
  }
}

/* Filters answer most questions; the exact way must answer the same. */
static void
test_exact_agrees_with_filters (void)
{
  GRand *random = g_rand_new_with_seed (6);

  for (int i = 0; i < 20000; i++) {
    Site s[5];

    for (int k = 0; k < 5; k++)
      s[k] = (Site){ some_double (random, -2, 2), some_double (random, -2, 2) };
    g_assert_cmpint (exact_orient (&s[0], &s[1], &s[2]), ==,
                     orient (&s[0], &s[1], &s[2]));
    g_assert_cmpint (exact_lift_orient (&s[0], &s[1], &s[2], &s[3]), ==,
                     lift_orient (&s[0], &s[1], &s[2], &s[3]));
    g_assert_cmpint (exact_lift_further (s, &s[3], &s[4]), ==,
                     lift_further (s, &s[3], &s[4]));
  }
  g_rand_free (random);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/exact/centres-of-random-triangles-are-right",
                   test_centres_of_random_triangles_are_right);
  g_test_add_func ("/exact/centres-of-flat-triangles-are-right",
                   test_centres_of_flat_triangles_are_right);
  g_test_add_func ("/exact/centres-near-the-origin-are-right",
                   test_centres_near_the_origin_are_right);
  g_test_add_func ("/exact/centre-at-the-origin-is-exact",
                   test_centre_at_the_origin_is_exact);
  g_test_add_func ("/exact/signs-hold-for-inputs-that-break-doubles",
                   test_signs_hold_for_inputs_that_break_doubles);
  g_test_add_func ("/exact/exact-agrees-with-filters",
                   test_exact_agrees_with_filters);
  return g_test_run ();
}
