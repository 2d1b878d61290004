/* The demonstration of rounding against big integers and the paper's facts. */
#include "fixture.h"
#include "judge.h"
#include "rounding.h"

#include <string.h>

/* The sign of the turn p q r by rationals of any size. */
static int
big_turn (const Site *p, const Site *q, const Site *r)
{
  mpq_t a, b, c, d, left, right;
  int sign;

  mpq_inits (a, b, c, d, left, right, NULL);
  mpq_set_d (a, q->x);
  mpq_set_d (left, p->x);
  mpq_sub (a, a, left);
  mpq_set_d (b, r->y);
  mpq_set_d (left, p->y);
  mpq_sub (b, b, left);
  mpq_set_d (c, q->y);
  mpq_sub (c, c, left);
  mpq_set_d (d, r->x);
  mpq_set_d (left, p->x);
  mpq_sub (d, d, left);
  mpq_mul (left, a, b);
  mpq_mul (right, c, d);
  sign = mpq_cmp (left, right);
  mpq_clears (a, b, c, d, left, right, NULL);
  return (sign > 0) - (sign < 0);
}

/* Fig. 2a of the paper: its first node is (0.5, 0.5). */
static void
init_figure (SignMap *map)
{
  const double half = 128 * 0x1p-53;

  g_assert_true (sign_map_init (map, &(Site){ 0.5 + half, 0.5 + half },
                                &(Site){ 12, 12 }, &(Site){ 24, 24 }));
}

static void
test_every_true_sign_is_that_of_big_integers (void)
{
  g_autofree SignMap *map = g_new (SignMap, 1);

  init_figure (map);
  g_assert_cmpfloat (map->corner.x, ==, 0.5);
  g_assert_cmpfloat (map->step, ==, 0x1p-53);
  for (guint row = 0; row < SIGN_MAP_SIDE; row++)
    for (guint column = 0; column < SIGN_MAP_SIDE; column++) {
      const Site p = sign_map_site (map, column, row);

      if (map->exact[row][column] != big_turn (&p, &map->q, &map->r))
        g_error ("column %u, row %u", column, row);
    }
}

/* The true line is the diagonal; rounding leaves it, on both sides. */
static void
test_figure_2a_is_wrong_on_both_sides_of_the_line (void)
{
  g_autofree SignMap *map = g_new (SignMap, 1);
  guint n_wrong = 0, n_left_as_right = 0, n_as_line = 0;

  init_figure (map);
  for (guint row = 0; row < SIGN_MAP_SIDE; row++)
    for (guint column = 0; column < SIGN_MAP_SIDE; column++) {
      const signed char rounded = map->rounded[row][column];
      const signed char exact = map->exact[row][column];

      g_assert_true (exact == (row > column) - (row < column));
      n_wrong += rounded != exact;
      n_left_as_right += rounded * exact < 0;
      n_as_line += rounded == 0 && exact != 0;
    }
  g_assert_cmpuint (map->n_wrong, ==, n_wrong);
  g_assert_cmpuint (n_left_as_right, >, 0);
  g_assert_cmpuint (n_as_line, >, 1000);
}

static void
test_far_from_the_line_rounding_does_no_harm (void)
{
  g_assert_cmpint (
      rounded_orient (&(Site){ 0, 0 }, &(Site){ 1, 0 }, &(Site){ 0, 1 }), ==,
      1);
  g_assert_cmpint (
      rounded_orient (&(Site){ 0, 0 }, &(Site){ 0, 1 }, &(Site){ 1, 0 }), ==,
      -1);
}

static void
test_a_grid_that_is_too_fine_is_refused (void)
{
  g_autofree SignMap *map = g_new (SignMap, 1);

  g_assert_false (sign_map_init (map, &(Site){ 0x1p-140, 0 },
                                 &(Site){ 0x1p-140, 0x1p-140 },
                                 &(Site){ 0, 0x1p-140 }));
}

static guint
count_wrong (const RoundedHull *hull, RoundedKind *kind)
{
  guint n = 0;

  for (guint i = 0; i < hull->n_steps; i++) {
    n += hull->steps[i].n_wrong;
    if (hull->steps[i].n_wrong > 0)
      *kind = hull->steps[i].kind;
  }
  return n;
}

/* With the first site as pivot each of these has one wrong sign, and what it
 * does is what the paper says. */
static void
test_each_failure_has_one_wrong_sign (void)
{
  static const struct {
    const char *name;
    RoundedKind kind;
  } failures[] = { { "kettner-a1", ROUNDED_INSIDE },
                   { "kettner-a2", ROUNDED_INSERT },
                   { "kettner-b1", ROUNDED_STUCK } };

  for (guint i = 0; i < G_N_ELEMENTS (failures); i++) {
    SiteSet *set = fixture_corpus_set (failures[i].name);
    RoundedHull hull;
    RoundedKind kind = ROUNDED_TRIANGLE;

    rounded_hull_init (&hull, set, 2);
    g_assert_cmpuint (count_wrong (&hull, &kind), ==, 1);
    g_assert_cmpint (kind, ==, failures[i].kind);
    rounded_hull_clear (&hull);
    site_set_free (set);
  }
}

static void
test_a1_loses_a_clear_corner (void)
{
  SiteSet *set = fixture_corpus_set ("kettner-a1");
  RoundedHull hull;
  char text[NARRATION_ROOM];

  rounded_hull_init (&hull, set, 2);
  rounded_narration_write (&hull, NULL, text);
  g_assert_nonnull (strstr (text, "s3 seems to see no edge"));
  rounded_hull_clear (&hull);
  rounded_hull_init (&hull, set, UINT32_MAX);
  g_assert_cmpuint (hull.n_steps, ==, 7);
  g_assert_cmpuint (hull.n_lost, ==, 1);
  g_assert_true (rounded_hull_has_lost (&hull, 3));
  rounded_hull_clear (&hull);
  site_set_free (set);
}

static void
test_a2_is_told_in_the_singular (void)
{
  SiteSet *set = fixture_corpus_set ("kettner-a2");
  RoundedHull hull;
  char text[NARRATION_ROOM];

  rounded_hull_init (&hull, set, 2);
  g_assert_cmpuint (hull.steps[hull.n_steps - 1].n_seen, ==, 1);
  rounded_narration_write (&hull, NULL, text);
  g_assert_nonnull (strstr (text, "the one edge that it seems to see"));
  rounded_hull_clear (&hull);
  site_set_free (set);
}

/* On sites in general position rounding does no harm, so that the algorithm
 * is right but for its signs; the true hull is the judge's on any sites. */
static void
check_hulls (const Fixture *fixture)
{
  Judge *judge = judge_new (fixture->set);
  g_autofree uint32_t *active = g_new (uint32_t, fixture->set->n_sites + 1);
  g_autofree uint32_t *corners = g_new (uint32_t, fixture->set->n_sites + 2);
  guint n_active = 0;
  RoundedHull hull;
  guint n;

  for (guint i = 0; i < fixture->set->n_sites; i++)
    if (fixture->set->first[i] == i)
      active[n_active++] = i;
  rounded_hull_init (&hull, fixture->set, UINT32_MAX);
  n = judge_hull (judge, active, n_active, corners);
  if (hull.n_steps + 2 == n_active && n >= 3) {
    g_assert_cmpuint (hull.n_true, ==, n);
    if (g_str_has_prefix (fixture->name, "random")) {
      g_assert_cmpuint (hull.n_corners, ==, n);
      g_assert_cmpuint (hull.n_lost, ==, 0);
    }
  }
  rounded_hull_clear (&hull);
  judge_free (judge);
}

static void
test_only_signs_are_wrong (void)
{
  fixture_for_each (6, 24, ORDER_FURTHEST, check_hulls);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/rounding/every-true-sign-is-that-of-big-integers",
                   test_every_true_sign_is_that_of_big_integers);
  g_test_add_func ("/rounding/figure-2a-is-wrong-on-both-sides-of-the-line",
                   test_figure_2a_is_wrong_on_both_sides_of_the_line);
  g_test_add_func ("/rounding/far-from-the-line-rounding-does-no-harm",
                   test_far_from_the_line_rounding_does_no_harm);
  g_test_add_func ("/rounding/a-grid-that-is-too-fine-is-refused",
                   test_a_grid_that_is_too_fine_is_refused);
  g_test_add_func ("/rounding/each-failure-has-one-wrong-sign",
                   test_each_failure_has_one_wrong_sign);
  g_test_add_func ("/rounding/a1-loses-a-clear-corner",
                   test_a1_loses_a_clear_corner);
  g_test_add_func ("/rounding/one-edge-is-told-in-the-singular",
                   test_a2_is_told_in_the_singular);
  g_test_add_func ("/rounding/only-signs-are-wrong", test_only_signs_are_wrong);
  return g_test_run ();
}
