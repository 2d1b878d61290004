#include "generator.h"
#include "judge.h"

#include <math.h>

static const guint counts[] = { 1, 2, 3, 4, 5, 7, 8, 12, 36, 100, 999, 2048 };

static Judge *
judge_of (const Site *sites, guint n, guint *n_distinct)
{
  SiteSet *set = site_set_new (sites, n);
  Judge *judge = judge_new (set);

  *n_distinct = set->n_distinct;
  site_set_free (set);
  return judge;
}

static void
assert_inside (const Site *sites, guint n)
{
  for (guint i = 0; i < n; i++) {
    g_assert_cmpfloat (fabs (sites[i].x), <=, 1);
    g_assert_cmpfloat (fabs (sites[i].y), <=, 1);
  }
}

static void
test_circles_are_exact (void)
{
  const guint32 circle[3] = { 0, 1, 2 };

  for (guint i = 0; i < G_N_ELEMENTS (counts); i++) {
    g_autofree Site *sites = generator_circle (counts[i], NULL);
    guint n_distinct;
    Judge *judge = judge_of (sites, counts[i], &n_distinct);

    g_assert_cmpuint (n_distinct, ==, counts[i]);
    for (guint j = 3; j < counts[i]; j++)
      g_assert_cmpint (judge_circle (judge, circle, j), ==, 0);
    assert_inside (sites, counts[i]);
    judge_free (judge);
  }
}

/* Even would be one n-th of the circle. */
static void
test_circles_are_well_spread (void)
{
  for (guint i = 2; i < G_N_ELEMENTS (counts); i++) {
    const guint n = counts[i];
    g_autofree Site *sites = generator_circle (n, NULL);

    for (guint j = 0; j < n; j++) {
      const Site a = sites[j], b = sites[(j + 1) % n];
      double gap = atan2 (b.y, b.x) - atan2 (a.y, a.x);

      gap += gap < 0 ? 2 * G_PI : 0;
      g_assert_cmpfloat (gap, >, 0);
      g_assert_cmpfloat (gap, <, 2.5 * 2 * G_PI / n);
    }
  }
}

static void
test_the_largest_circle_exists (void)
{
  g_autofree Site *sites = generator_circle (GENERATOR_CIRCLE_MAX, NULL);
  guint n_distinct;
  Judge *judge = judge_of (sites, GENERATOR_CIRCLE_MAX, &n_distinct);

  g_assert_cmpuint (n_distinct, ==, GENERATOR_CIRCLE_MAX);
  for (guint j = 3; j < GENERATOR_CIRCLE_MAX; j++)
    g_assert_cmpint (judge_circle (judge, (const guint32[]){ 0, 1, 2 }, j), ==,
                     0);
  judge_free (judge);
}

static void
test_lines_are_exact_not_level_not_even (void)
{
  for (guint i = 2; i < G_N_ELEMENTS (counts); i++) {
    g_autofree Site *sites = generator_line (counts[i], NULL);
    guint n_distinct;
    Judge *judge = judge_of (sites, counts[i], &n_distinct);

    g_assert_cmpuint (n_distinct, ==, counts[i]);
    for (guint j = 2; j < counts[i]; j++)
      g_assert_cmpint (judge_orient (judge, 0, 1, j), ==, 0);
    g_assert_cmpfloat (sites[0].y, !=, sites[1].y);
    g_assert_cmpfloat (sites[1].x - sites[0].x, !=, sites[2].x - sites[1].x);
    assert_inside (sites, counts[i]);
    judge_free (judge);
  }
}

static void
test_grids_go_by_rows_from_below (void)
{
  g_autofree Site *sites = generator_grid (3, 2, NULL);
  static const Site expected[] = {
    { -1, -0.5 }, { 0, -0.5 }, { 1, -0.5 }, { -1, 0.5 }, { 0, 0.5 }, { 1, 0.5 },
  };

  for (guint i = 0; i < G_N_ELEMENTS (expected); i++) {
    g_assert_cmpfloat (sites[i].x, ==, expected[i].x);
    g_assert_cmpfloat (sites[i].y, ==, expected[i].y);
  }
}

static void
test_random_sites_are_distinct_with_few_digits (void)
{
  static const guint few[] = { 1, 8, 200, 257, 20000 };
  static const int bits[] = { 6, 6, 6, 7, 10 };

  for (guint i = 0; i < G_N_ELEMENTS (few); i++) {
    g_autofree Site *sites = generator_random (few[i], 42, NULL);
    SiteSet *set = site_set_new (sites, few[i]);

    g_assert_cmpuint (set->n_distinct, ==, few[i]);
    for (guint j = 0; j < few[i]; j++) {
      g_assert_cmpfloat (fmod (ldexp (sites[j].x, bits[i]), 1), ==, 0);
      g_assert_cmpfloat (fmod (ldexp (sites[j].y, bits[i]), 1), ==, 0);
    }
    assert_inside (sites, few[i]);
    site_set_free (set);
  }
}

static void
test_random_sites_reach_every_quarter (void)
{
  g_autofree Site *sites = generator_random (400, 1, NULL);
  guint quarters[4] = { 0 };

  for (guint i = 0; i < 400; i++)
    quarters[(sites[i].x > 0 ? 1 : 0) + (sites[i].y > 0 ? 2 : 0)] += 1;
  for (guint i = 0; i < 4; i++)
    g_assert_cmpuint (quarters[i], >, 70);
}

static void
test_a_seed_gives_the_same_sites_for_ever (void)
{
  /* Lessons rely on these very sites. */
  static const Site expected[]
      = { { -0.21875, -0.96875 }, { 0.8125, 0.171875 }, { -0.09375, -0.5 } };
  g_autofree Site *sites = generator_random (3, 7, NULL);
  g_autofree Site *others = generator_random (3, 8, NULL);

  for (guint i = 0; i < G_N_ELEMENTS (expected); i++) {
    g_assert_cmpfloat (sites[i].x, ==, expected[i].x);
    g_assert_cmpfloat (sites[i].y, ==, expected[i].y);
  }
  g_assert_cmpfloat (sites[0].x, !=, others[0].x);
}

static void
assert_refused (Site *sites, GError **error, const char *nearest)
{
  g_assert_null (sites);
  g_assert_error (*error, GENERATOR_ERROR, GENERATOR_ERROR_COUNT);
  g_assert_true (g_str_has_suffix ((*error)->message, nearest));
  g_clear_error (error);
}

static void
test_sets_that_do_not_exist_name_the_nearest (void)
{
  GError *error = NULL;

  assert_refused (generator_circle (0, &error), &error, "the nearest has 1");
  assert_refused (generator_circle (8193, &error), &error,
                  "the nearest has 8192");
  assert_refused (generator_line (20001, &error), &error,
                  "the nearest has 20000");
  assert_refused (generator_grid (G_MAXUINT, G_MAXUINT, &error), &error,
                  "the nearest has 20000");
  assert_refused (generator_grid (0, 5, &error), &error, "the nearest has 1");
  assert_refused (generator_random (G_MAXUINT, 1, &error), &error,
                  "the nearest has 20000");
}

/* The sets that are no plain figures, by one name each. */
static Site *
make_spiral (guint n, guint64 seed, GError **error)
{
  (void)seed;
  return generator_spiral (n, error);
}

static Site *(*const scatters[]) (guint n, guint64 seed, GError **error) = {
  generator_clusters,
  generator_near_circle,
  generator_kuzmin,
  make_spiral,
};

static void
test_scattered_sites_are_distinct_grid_sites (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (scatters); i++)
    for (guint j = 0; j < G_N_ELEMENTS (counts); j++) {
      g_autofree Site *sites = scatters[i](counts[j], 3, NULL);
      g_autofree Site *again = scatters[i](counts[j], 3, NULL);
      SiteSet *set = site_set_new (sites, counts[j]);

      g_assert_cmpuint (set->n_distinct, ==, counts[j]);
      g_assert_cmpmem (sites, counts[j] * sizeof *sites, again,
                       counts[j] * sizeof *again);
      assert_inside (sites, counts[j]);
      for (guint k = 0; k < counts[j]; k++)
        g_assert_cmpfloat (fmod (ldexp (sites[k].x, 24), 1), ==, 0);
      site_set_free (set);
    }
}

static void
test_the_largest_scattered_sets_exist (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (scatters); i++) {
    g_autofree Site *sites = scatters[i](GENERATOR_MAX, 1, NULL);
    SiteSet *set = site_set_new (sites, GENERATOR_MAX);

    g_assert_cmpuint (set->n_distinct, ==, GENERATOR_MAX);
    site_set_free (set);
  }
}

/* The share of sites within @radius of the origin. */
static double
share_within (const Site *sites, guint n, double radius)
{
  guint n_within = 0;

  for (guint i = 0; i < n; i++)
    n_within += hypot (sites[i].x, sites[i].y) <= radius ? 1 : 0;
  return (double)n_within / n;
}

static void
test_kuzmin_crowds_in_the_middle (void)
{
  g_autofree Site *sites = generator_kuzmin (4000, 9, NULL);

  /* 1 - 1/√(1 + r²), r in 32nds, of those that are not cut off. */
  g_assert_cmpfloat (fabs (share_within (sites, 4000, 1 / 32.0) - 0.302), <,
                     0.03);
  g_assert_cmpfloat (fabs (share_within (sites, 4000, 8 / 32.0) - 0.90), <,
                     0.03);
}

static void
test_clusters_leave_most_of_the_square_empty (void)
{
  g_autofree Site *sites = generator_clusters (400, 2, NULL);
  guint n_squares = 0;
  gboolean taken[256] = { FALSE };

  for (guint i = 0; i < 400; i++) {
    const guint column = (guint)CLAMP (8 * (sites[i].x + 1), 0, 15);
    const guint row = (guint)CLAMP (8 * (sites[i].y + 1), 0, 15);

    n_squares += taken[16 * row + column] ? 0 : 1;
    taken[16 * row + column] = TRUE;
  }
  /* Of 256; sites all over the square reach four in five of them. */
  g_assert_cmpuint (n_squares, <, 110);
}

static void
test_near_circles_are_near_and_not_exact (void)
{
  const guint n = 64;
  g_autofree Site *sites = generator_near_circle (n, 5, NULL);
  guint n_distinct, n_on = 0;
  Judge *judge = judge_of (sites, n, &n_distinct);

  for (guint i = 0; i < n; i++)
    g_assert_cmpfloat (fabs (hypot (sites[i].x, sites[i].y) - 1), <, 0x1p-9);
  for (guint i = 3; i < n; i++)
    n_on
        += judge_circle (judge, (const guint32[]){ 0, 1, 2 }, i) == 0 ? 1u : 0u;
  g_assert_cmpuint (n_on, <, 4);
  judge_free (judge);
}

/* The distance to the next site is never much more than on average. */
static void
test_spirals_are_evenly_spaced (void)
{
  const guint n = 200;
  g_autofree Site *sites = generator_spiral (n, NULL);
  double least = 4, most = 0;

  for (guint i = 10; i + 1 < n; i++) {
    const double gap
        = hypot (sites[i + 1].x - sites[i].x, sites[i + 1].y - sites[i].y);

    g_assert_cmpfloat (hypot (sites[i].x, sites[i].y), <,
                       hypot (sites[i + 1].x, sites[i + 1].y) + 0.01);
    least = MIN (least, gap);
    most = MAX (most, gap);
  }
  g_assert_cmpfloat (most, <, 1.3 * least);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/generator/circles-are-exact", test_circles_are_exact },
  { "/generator/circles-are-well-spread", test_circles_are_well_spread },
  { "/generator/the-largest-circle-exists", test_the_largest_circle_exists },
  { "/generator/lines-are-exact-not-level-not-even",
    test_lines_are_exact_not_level_not_even },
  { "/generator/grids-go-by-rows-from-below",
    test_grids_go_by_rows_from_below },
  { "/generator/random-sites-are-distinct-with-few-digits",
    test_random_sites_are_distinct_with_few_digits },
  { "/generator/random-sites-reach-every-quarter",
    test_random_sites_reach_every_quarter },
  { "/generator/a-seed-gives-the-same-sites-for-ever",
    test_a_seed_gives_the_same_sites_for_ever },
  { "/generator/scattered-sites-are-distinct-grid-sites",
    test_scattered_sites_are_distinct_grid_sites },
  { "/generator/the-largest-scattered-sets-exist",
    test_the_largest_scattered_sets_exist },
  { "/generator/kuzmin-crowds-in-the-middle",
    test_kuzmin_crowds_in_the_middle },
  { "/generator/clusters-leave-most-of-the-square-empty",
    test_clusters_leave_most_of_the_square_empty },
  { "/generator/near-circles-are-near-and-not-exact",
    test_near_circles_are_near_and_not_exact },
  { "/generator/spirals-are-evenly-spaced", test_spirals_are_evenly_spaced },
  { "/generator/sets-that-do-not-exist-name-the-nearest",
    test_sets_that_do_not_exist_name_the_nearest },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
