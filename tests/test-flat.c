#include "flat.h"

#include <glib.h>
#include <math.h>

static void
test_none_and_one_have_their_dimension (void)
{
  SiteSet *set = site_set_new (&(Site){ 3, 4 }, 1);
  uint32_t active[] = { 0 };

  g_assert_cmpint (flat_sort (set, active, 0), ==, -1);
  g_assert_cmpint (flat_sort (set, active, 1), ==, 0);
  site_set_free (set);
}

static void
assert_order (const Site *sites,
              uint32_t n_sites,
              int dimension,
              const uint32_t *expected)
{
  SiteSet *set = site_set_new (sites, n_sites);
  g_autofree uint32_t *active = g_new (uint32_t, n_sites);

  for (uint32_t i = 0; i < n_sites; i += 1)
    active[i] = n_sites - 1 - i;
  g_assert_cmpint (flat_sort (set, active, n_sites), ==, dimension);
  for (uint32_t i = 0; i < n_sites; i += 1)
    g_assert_cmpuint (active[i], ==, expected[i]);
  site_set_free (set);
}

static void
test_line_is_sorted_along_itself (void)
{
  const Site slanted[] = { { 2, 4 }, { 0, 0 }, { 3, 6 }, { 1, 2 } };
  const Site upright[] = { { 7, 4 }, { 7, -1 }, { 7, 5 } };

  assert_order (slanted, 4, 1, (uint32_t[]){ 1, 3, 0, 2 });
  assert_order (upright, 3, 1, (uint32_t[]){ 1, 0, 2 });
}

static void
test_circle_is_sorted_counter_clockwise (void)
{
  const Site square[] = { { 1, 1 }, { -1, -1 }, { 1, -1 }, { -1, 1 } };
  const Site round[] = { { 4, 3 },  { -4, 3 }, { 3, -4 }, { 0, 5 },
                         { -5, 0 }, { 5, 0 },  { 0, -5 }, { -3, 4 } };

  assert_order (square, 4, 2, (uint32_t[]){ 1, 2, 0, 3 });
  assert_order (round, 8, 2, (uint32_t[]){ 4, 6, 2, 5, 0, 3, 7, 1 });
}

static void
test_triangle_is_sorted_counter_clockwise (void)
{
  const Site left[] = { { 0, 0 }, { 5, 1 }, { 2, 9 } };
  const Site right[] = { { 0, 0 }, { 2, 9 }, { 5, 1 } };

  assert_order (left, 3, 2, (uint32_t[]){ 0, 1, 2 });
  assert_order (right, 3, 2, (uint32_t[]){ 0, 2, 1 });
}

/* A ulp off the line is off the line. */
static void
test_dimension_is_exact (void)
{
  const Site near_line[] = { { 0, 0 }, { 0.1, nextafter (0.1, 1) }, { 2, 2 } };

  assert_order (near_line, 3, 2, (uint32_t[]){ 0, 2, 1 });
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/flat/none-and-one-have-their-dimension",
                   test_none_and_one_have_their_dimension);
  g_test_add_func ("/flat/line-is-sorted-along-itself",
                   test_line_is_sorted_along_itself);
  g_test_add_func ("/flat/circle-is-sorted-counter-clockwise",
                   test_circle_is_sorted_counter_clockwise);
  g_test_add_func ("/flat/triangle-is-sorted-counter-clockwise",
                   test_triangle_is_sorted_counter_clockwise);
  g_test_add_func ("/flat/dimension-is-exact", test_dimension_is_exact);
  return g_test_run ();
}
