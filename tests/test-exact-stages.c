#include "exact.h"

#include "exact-double-word.h"
#include "exact-integer.h"
#include "predicate.h"

#include "lift-judge.h"

#include <glib.h>
#include <math.h>

/* Who decides after the filter. */
typedef enum Stage { STAGE_INTEGER, STAGE_DOUBLE_WORD, STAGE_EXPANSION } Stage;

/* How often each has decided lift_orient() and lift_further(). */
typedef struct Tally {
  int side[3], further[3], n_ties;
} Tally;

static Stage
stage_of_side (const Site plane[3], const Site *d)
{
  const Vector v[3]
      = { vector_between (d, &plane[0]), vector_between (d, &plane[1]),
          vector_between (d, &plane[2]) };
  int sign;

  if (integer_incircle (v, &sign))
    return STAGE_INTEGER;
  return double_word_incircle (v, &sign) ? STAGE_DOUBLE_WORD : STAGE_EXPANSION;
}

static Stage
stage_of_further (const Site plane[3], const Site *p, const Site *q)
{
  Vector v[6];
  int sign;

  for (int i = 0; i < 3; i += 1) {
    v[i] = vector_between (p, &plane[i]);
    v[3 + i] = vector_between (q, &plane[i]);
  }
  if (integer_incircle_compare (v, &sign))
    return STAGE_INTEGER;
  return double_word_incircle_compare (v, &sign) ? STAGE_DOUBLE_WORD
                                                 : STAGE_EXPANSION;
}

static Stage
stage_of_orient (const Site *a, const Site *b, const Site *c)
{
  const Vector v[2] = { vector_between (c, a), vector_between (c, b) };
  int sign;

  if (integer_cross (v, &sign))
    return STAGE_INTEGER;
  return double_word_cross (v, &sign) ? STAGE_DOUBLE_WORD : STAGE_EXPANSION;
}

static void
assert_signs (const Site sites[5], Tally *tally)
{
  const Site *a = &sites[0], *b = &sites[1], *c = &sites[2];
  const Site *p = &sites[3], *q = &sites[4];
  const int side = lift_judge_side (sites, p);
  const int order = lift_judge_further (sites, p, q);

  g_assert_cmpint (lift_orient (a, b, c, p), ==, side);
  g_assert_cmpint (exact_lift_orient (a, b, c, p), ==, side);
  g_assert_cmpint (exact_lift_orient (b, a, c, p), ==, -side);
  g_assert_cmpint (lift_further (sites, p, q), ==, order);
  g_assert_cmpint (exact_lift_further (sites, p, q), ==, order);
  g_assert_cmpint (exact_lift_further (sites, q, p), ==, -order);
  g_assert_cmpint (exact_orient (a, b, c), ==, lift_judge_orient (a, b, c));
  tally->side[stage_of_side (sites, p)] += 1;
  tally->further[stage_of_further (sites, p, q)] += 1;
  tally->n_ties += side == 0;
}

static Stage
assert_orient (const Site *a, const Site *b, const Site *c)
{
  const int turn = lift_judge_orient (a, b, c);

  g_assert_cmpint (orient (a, b, c), ==, turn);
  g_assert_cmpint (exact_orient (a, b, c), ==, turn);
  g_assert_cmpint (exact_orient (b, a, c), ==, -turn);
  return stage_of_orient (a, b, c);
}

/* Three corners of a rectangle around the origin, then the fourth or another
 * site, then the mirror image of that: a tie, or two. */
static void
set_rectangle (Site sites[5], double x, double y, bool is_tie)
{
  const Site p = is_tie ? (Site){ x, -y } : (Site){ x / 2, 2 * y };

  sites[0] = (Site){ x, y };
  sites[1] = (Site){ -x, y };
  sites[2] = (Site){ -x, -y };
  sites[3] = p;
  sites[4] = (Site){ -p.x, p.y };
}

static double
nudged (GRand *random, double value)
{
  const int way = g_rand_int_range (random, -4, 5);

  if (ABS (way) != 1)
    return value;
  return nextafter (value, way * (double)INFINITY);
}

/* One draw after the other, whichever argument is evaluated first. */
static double
near_power (GRand *random, const int exponents[2])
{
  const int exponent
      = g_rand_int_range (random, exponents[0], exponents[1] + 1);

  return ldexp (g_rand_double_range (random, 1, 2), exponent);
}

/* @n rectangles whose half sides have exponents in @x and in @y, some of
 * their coordinates moved by an ulp. */
static Tally
nearly_tie (int n, const int x[2], const int y[2])
{
  GRand *random = g_rand_new_with_seed (31);
  Tally tally = { 0 };

  for (int i = 0; i < n; i += 1) {
    const double width = near_power (random, x);
    const double height = near_power (random, y);
    Site sites[5];

    set_rectangle (sites, width, height, g_rand_boolean (random));
    if (g_rand_boolean (random))
      for (int k = 0; k < 5; k += 1)
        sites[k].x = nudged (random, sites[k].x);
    if (g_rand_boolean (random))
      for (int k = 0; k < 5; k += 1)
        sites[k].y = nudged (random, sites[k].y);
    assert_signs (sites, &tally);
  }
  g_rand_free (random);
  return tally;
}

static void
test_integers_decide_doubles_of_one_magnitude (void)
{
  static const int same[][2] = { { 0, 3 }, { -144, -142 }, { 141, 143 } };

  for (size_t i = 0; i < G_N_ELEMENTS (same); i += 1) {
    const Tally tally = nearly_tie (4000, same[i], same[i]);

    g_assert_cmpint (tally.side[STAGE_INTEGER], ==, 4000);
    g_assert_cmpint (tally.further[STAGE_INTEGER], ==, 4000);
    g_assert_cmpint (tally.n_ties, >, 400);
  }
}

static void
test_double_words_decide_what_lies_on_no_grid (void)
{
  const Tally tally
      = nearly_tie (8000, (const int[2]){ -20, -14 }, (const int[2]){ 0, 0 });

  g_assert_cmpint (tally.side[STAGE_INTEGER], <, 400);
  g_assert_cmpint (tally.side[STAGE_DOUBLE_WORD], >, 2000);
  g_assert_cmpint (tally.side[STAGE_EXPANSION], >, 1000);
  g_assert_cmpint (tally.further[STAGE_DOUBLE_WORD], >, 2000);
  g_assert_cmpint (tally.further[STAGE_EXPANSION], >, 1000);
}

/* An ulp of the short side is less than 2^-150 of the determinant's terms. */
static void
test_expansions_decide_what_is_left (void)
{
  static const int narrow[][2] = { { -140, -50 }, { -144, -144 } };
  static const int tall[][2] = { { 0, 2 }, { 143, 143 } };

  for (size_t i = 0; i < G_N_ELEMENTS (narrow); i += 1) {
    const Tally tally = nearly_tie (4000, narrow[i], tall[i]);

    g_assert_cmpint (tally.side[STAGE_INTEGER], ==, 0);
    g_assert_cmpint (tally.side[STAGE_EXPANSION], >, 1000);
    g_assert_cmpint (tally.side[STAGE_EXPANSION] - tally.n_ties, >, 100);
    g_assert_cmpint (tally.further[STAGE_EXPANSION], >, 1000);
  }
}

/* The largest determinants that there are: the three sites in corners of the
 * square of half side @side, the others around its centre, in steps of
 * 2^exponent. */
static Tally
fill_the_room (double side, double step, int exponent)
{
  static const Site corner[4] = { { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } };
  Tally tally = { 0 };

  for (int i = 0; i < 4 * 81; i += 1) {
    const double x = (i % 3 - 1) * step, y = (i / 3 % 3 - 1) * step;
    const Site p = { (i / 9 % 3 - 1) * step, (i / 27 % 3 - 1) * step };
    Site sites[5];

    for (int k = 0; k < 3; k += 1)
      sites[k] = (Site){ side * corner[(k + i) % 4].x,
                         side * corner[(k + i) % 4].y };
    sites[0].x += x;
    sites[1].y += y;
    sites[3] = i < 162 ? p : (Site){ side + p.x, p.y - side };
    sites[4] = (Site){ -sites[3].y, sites[3].x };
    for (int k = 0; k < 5; k += 1)
      sites[k] = (Site){ ldexp (sites[k].x, exponent),
                         ldexp (sites[k].y, exponent) };
    assert_signs (sites, &tally);
  }
  return tally;
}

static void
test_squares_as_large_as_the_integers_are_right (void)
{
  static const double sides[]
      = { 0x1p29, 0x1p30 - 1, 0x1p30,     0x1p30 + 1,          0x1p31 - 1,
          0x1p31, 0x1p31 + 1, 0x1p32 - 1, 0x1.fffffffffffffp51 };
  static const int exponents[] = { -145, -30, 0, 90 };

  for (size_t i = 0; i < G_N_ELEMENTS (sides); i += 1)
    for (size_t k = 0; k < G_N_ELEMENTS (exponents); k += 1) {
      const Tally tally = fill_the_room (sides[i], 1, exponents[k]);

      g_assert_cmpint (tally.side[STAGE_INTEGER], ==, 324);
      g_assert_cmpint (tally.n_ties, >, 0);
    }
}

/* The last steps of 62 bits, and what needs 63: low words carry them. */
static void
test_squares_just_beyond_the_integers_are_right (void)
{
  static const double sides[] = { 0x1.fffffffffffffp60, 0x1.fffffffffffffp61,
                                  0x1p61, 0x1p62, 0x1.fffffffffffffp62 };
  int n_integer = 0, n_other = 0;

  for (size_t i = 0; i < G_N_ELEMENTS (sides); i += 1)
    for (int step = 1; step <= 512; step *= 2) {
      Tally tally = { 0 };
      Site sites[5];

      set_rectangle (sites, sides[i], sides[i], step % 3 == 1);
      sites[3] = (Site){ step, -step };
      sites[4] = (Site){ step, step - 1 };
      assert_signs (sites, &tally);
      n_integer += tally.side[STAGE_INTEGER];
      n_other += 1 - tally.side[STAGE_INTEGER];
    }
  g_assert_cmpint (n_integer, >, 0);
  g_assert_cmpint (n_other, >, 0);
  fill_the_room (0x1.fffffffffffffp61, 512, 0);
  fill_the_room (0x1.fffffffffffffp61, 1, 0);
  fill_the_room (0x1p62, 1024, 0);
}

static void
test_a_grid_far_from_the_origin_is_a_grid (void)
{
  GRand *random = g_rand_new_with_seed (8);
  Tally tally = { 0 };

  for (int i = 0; i < 4000; i += 1) {
    const double far = ldexp (1, g_rand_int_range (random, 20, 52));
    const int height = 2 * g_rand_int_range (random, 1, 9);
    const int width = 2 * g_rand_int_range (random, 1, 9);
    Site sites[5];

    set_rectangle (sites, width, height, i % 2 == 0);
    for (int k = 0; k < 5; k += 1)
      sites[k] = (Site){ sites[k].x + far, sites[k].y - 3 * far };
    assert_signs (sites, &tally);
  }
  g_assert_cmpint (tally.side[STAGE_INTEGER], ==, 4000);
  g_assert_cmpint (tally.n_ties, >=, 2000);
  g_rand_free (random);
}

/* (1 + ulp)² is more than 1 + 2 ulp by ulp². */
static void
test_orient_needs_every_stage (void)
{
  const double ulp = DBL_EPSILON;

  for (int exponent = 0; exponent >= -140; exponent -= 1) {
    const double flat = ldexp (1, exponent);
    const Site a = { 1 + ulp, flat * (1 + 2 * ulp) },
               b = { 1, flat * (1 + ulp) };
    const Site beside = { 1, flat * (1 + 2 * ulp) }, origin = { 0, 0 };
    const Site opposite = { -a.x, -a.y }, twice = { 2 * a.x, 2 * a.y };
    const bool is_grid = exponent >= -9, beside_is_grid = exponent >= -10;

    g_assert_cmpint (orient (&a, &b, &origin), ==, 1);
    g_assert_cmpint (assert_orient (&a, &b, &origin), ==,
                     is_grid ? STAGE_INTEGER : STAGE_EXPANSION);
    g_assert_cmpint (assert_orient (&a, &beside, &origin), ==,
                     beside_is_grid ? STAGE_INTEGER : STAGE_DOUBLE_WORD);
    g_assert_cmpint (orient (&a, &opposite, &twice), ==, 0);
    assert_orient (&a, &opposite, &twice);
  }
}

static void
test_equal_sites_are_a_tie (void)
{
  const Site sites[5] = { { 3, 4 }, { 3, 4 }, { 3, 4 }, { 3, 4 }, { 3, 4 } };
  Tally tally = { 0 };

  assert_signs (sites, &tally);
  g_assert_cmpint (tally.n_ties, ==, 1);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/exact-stages/integers-decide-doubles-of-one-magnitude",
                   test_integers_decide_doubles_of_one_magnitude);
  g_test_add_func ("/exact-stages/double-words-decide-what-lies-on-no-grid",
                   test_double_words_decide_what_lies_on_no_grid);
  g_test_add_func ("/exact-stages/expansions-decide-what-is-left",
                   test_expansions_decide_what_is_left);
  g_test_add_func ("/exact-stages/squares-as-large-as-the-integers-are-right",
                   test_squares_as_large_as_the_integers_are_right);
  g_test_add_func ("/exact-stages/squares-just-beyond-the-integers-are-right",
                   test_squares_just_beyond_the_integers_are_right);
  g_test_add_func ("/exact-stages/a-grid-far-from-the-origin-is-a-grid",
                   test_a_grid_far_from_the_origin_is_a_grid);
  g_test_add_func ("/exact-stages/orient-needs-every-stage",
                   test_orient_needs_every_stage);
  g_test_add_func ("/exact-stages/equal-sites-are-a-tie",
                   test_equal_sites_are_a_tie);
  return g_test_run ();
}
