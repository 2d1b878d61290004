/* After every round, the facets and circle groups against all triples of
 * sites, in integers of any length. A cell is the set of all sites on one
 * circle or line, one bit each. */
#include "frame.h"
#include "standing.h"

#include <string.h>

#define MAX_SITES 64

static int
compare_cells (gconstpointer a, gconstpointer b)
{
  const guint64 *p = a, *q = b;

  return (*p > *q) - (*p < *q);
}

static GArray *
cells_new (void)
{
  return g_array_new (FALSE, FALSE, sizeof (guint64));
}

/* Sorts the cells and leaves out those that come again. */
static void
cells_unite (GArray *cells)
{
  const guint64 *cell = (const guint64 *)(void *)cells->data;
  guint n = 0;

  g_array_sort (cells, compare_cells);
  for (guint i = 0; i < cells->len; i++)
    if (i == 0 || cell[i] != cell[i - 1])
      g_array_index (cells, guint64, n++) = cell[i];
  g_array_set_size (cells, n);
}

static bool
cells_are_equal (GArray *a, GArray *b)
{
  cells_unite (a);
  cells_unite (b);
  return a->len == b->len
         && (a->len == 0
             || memcmp (a->data, b->data, a->len * sizeof (guint64)) == 0);
}

/* Returns: the sites on the circle of three, 0 when they are collinear or
 *          when one lies on its wrong side: -1 inside, +1 outside. */
static guint64
cell_of_circle (const Standing *standing, const uint32_t site[3], int wrong)
{
  guint64 cell = 0;

  for (uint32_t i = 0; i < standing->n_active; i++) {
    const uint32_t other = standing->active[i];
    const int side = judge_circle (standing->judge, site, other);

    if (side == wrong)
      return 0;
    if (side == 0)
      cell |= G_GUINT64_CONSTANT (1) << other;
  }
  return cell;
}

/* Returns: the sites on the line of two when they are three or more and no
 *          site lies to its right, else 0. */
static guint64
cell_of_line (const Standing *standing, uint32_t tail, uint32_t head)
{
  guint64 cell = 0;
  uint32_t n = 0;

  for (uint32_t i = 0; i < standing->n_active; i++) {
    const uint32_t other = standing->active[i];
    const int turn = judge_orient (standing->judge, tail, head, other);

    if (turn < 0)
      return 0;
    if (turn == 0) {
      cell |= G_GUINT64_CONSTANT (1) << other;
      n += 1;
    }
  }
  return n >= 3 ? cell : 0;
}

static void
add_cell (GArray *cells, guint64 cell)
{
  if (cell != 0)
    g_array_append_val (cells, cell);
}

/* All circles through three active sites that have no site on the wrong side.
 */
static GArray *
all_circles (const Standing *standing, int wrong)
{
  GArray *cells = cells_new ();
  const uint32_t n = standing->n_active;
  const uint32_t *at = standing->active;

  for (uint32_t i = 0; i < n; i++)
    for (uint32_t j = 0; j < i; j++)
      for (uint32_t k = 0; k < j; k++) {
        const uint32_t site[3] = { at[i], at[j], at[k] };

        if (judge_orient (standing->judge, at[i], at[j], at[k]) != 0)
          add_cell (cells, cell_of_circle (standing, site, wrong));
      }
  return cells;
}

static GArray *
all_lines (const Standing *standing)
{
  GArray *cells = cells_new ();
  const uint32_t n = standing->n_active;

  for (uint32_t i = 0; i < n; i++)
    for (uint32_t j = 0; j < n; j++)
      if (i != j)
        add_cell (cells, cell_of_line (standing, standing->active[i],
                                       standing->active[j]));
  return cells;
}

static GArray *
cells_of_facets (const Standing *standing, Facing part)
{
  GArray *cells = cells_new ();

  for (uint32_t i = 0; i < standing->n_facets; i++) {
    const FacetRow *row
        = &standing->fixture->trace->facets[standing->facets[i]];
    const uint32_t *site = row->site;

    if (row->facing != part)
      continue;
    if (part != FACING_VERTICAL)
      add_cell (cells,
                cell_of_circle (standing, site, part == FACING_LOWER ? -1 : 1));
    else
      for (uint32_t k = 0; k < 3; k++)
        add_cell (cells, cell_of_line (standing, site[k], site[(k + 1) % 3]));
  }
  return cells;
}

/* The sites of the triangles of each circle group. */
static GArray *
cells_of_groups (const Delaunay *delaunay)
{
  GArray *cells = cells_new ();

  g_array_set_size (cells, delaunay->n_groups);
  for (uint32_t i = 0; i < delaunay->n_groups; i++)
    g_array_index (cells, guint64, i) = 0;
  for (uint32_t i = 0; i < delaunay->n_triangles * 3; i++) {
    const Triangle *triangle = &delaunay->triangles[i / 3];

    g_array_index (cells, guint64, triangle->group) |= G_GUINT64_CONSTANT (1)
                                                       << triangle->site[i % 3];
  }
  return cells;
}

static void
check_groups (const Standing *standing)
{
  g_autoptr (GArray) expected = all_circles (standing, -1);
  g_autoptr (GArray) found = NULL;
  Frame frame;

  frame_init (&frame, standing->fixture->trace, standing->step);
  found = cells_of_groups (&frame.delaunay);
  standing_assert (standing, cells_are_equal (found, expected));
  standing_assert (standing, frame.voronoi.n_vertices == expected->len);
  frame_clear (&frame);
}

static void
check_facets (const Standing *standing)
{
  g_autoptr (GArray) lower = cells_of_facets (standing, FACING_LOWER);
  g_autoptr (GArray) upper = cells_of_facets (standing, FACING_UPPER);
  g_autoptr (GArray) vertical = cells_of_facets (standing, FACING_VERTICAL);
  g_autoptr (GArray) empty_circles = all_circles (standing, -1);
  g_autoptr (GArray) full_circles = all_circles (standing, 1);
  g_autoptr (GArray) lines = all_lines (standing);

  standing_assert (standing, cells_are_equal (lower, empty_circles));
  standing_assert (standing, cells_are_equal (upper, full_circles));
  standing_assert (standing, cells_are_equal (vertical, lines));
}

static void
check_rounds (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  g_autoptr (Judge) judge = judge_new (fixture->set);
  uint32_t step = trace->start_end;

  g_assert_cmpuint (fixture->set->n_sites, <=, MAX_SITES);
  for (;;) {
    g_autoptr (Standing) standing = standing_new (fixture, judge, step);

    check_groups (standing);
    if (!trace->is_flat)
      check_facets (standing);
    if (step == trace->n_events)
      return;
    step = timeline_next (trace, step, GRAIN_ROUND);
  }
}

static void
test_furthest (void)
{
  fixture_for_each (10, 12, ORDER_FURTHEST, check_rounds);
}

static void
test_input (void)
{
  fixture_for_each (5, 12, ORDER_INPUT, check_rounds);
}

static void
test_random (void)
{
  fixture_for_each (5, 12, ORDER_RANDOM, check_rounds);
}

static void
test_curated (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    check_rounds (fixture);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/brute/curated-sets-have-all-empty-circles", test_curated);
  g_test_add_func ("/brute/furthest-first-has-all-empty-circles",
                   test_furthest);
  g_test_add_func ("/brute/input-order-has-all-empty-circles", test_input);
  g_test_add_func ("/brute/random-order-has-all-empty-circles", test_random);
  return g_test_run ();
}
