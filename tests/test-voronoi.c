/* The diagram, clipped for drawing: judged by distances alone. */
#include "fixture.h"
#include "frame.h"

#include <math.h>

static double
distance (const Site *a, const Site *b)
{
  return hypot (a->x - b->x, a->y - b->y);
}

/* How much nearer than @site another active site comes to a point. */
static double
deficit (const Delaunay *delaunay, uint32_t site, const Site *point)
{
  const Site *sites = delaunay->set->sites;
  double nearest = INFINITY;

  for (uint32_t i = 0; i < delaunay->n_active; i++)
    nearest = fmin (nearest, distance (&sites[delaunay->active[i]], point));
  return distance (&sites[site], point) - nearest;
}

static double
area (const Site *corners, uint32_t n)
{
  double twice = 0;

  for (uint32_t i = 0; i < n; i++) {
    const Site *a = &corners[i], *b = &corners[(i + 1) % n];

    twice += a->x * b->y - a->y * b->x;
  }
  return twice / 2;
}

/* Every corner of a clipped cell is as near to its site as to any other, and
 * the cells fill the box. */
static void
check_cells (const Fixture *fixture)
{
  const Extent extent = site_set_extent (fixture->set);
  const double reach = 1.5 * extent.radius;
  const Box box = { { extent.centre.x - reach, extent.centre.y - reach },
                    { extent.centre.x + reach, extent.centre.y + reach } };
  const double tiny
      = 1e-9 * (reach + fabs (extent.centre.x) + fabs (extent.centre.y));
  double total = 0;
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  for (uint32_t i = 0; i < frame.delaunay.n_active; i++) {
    const uint32_t site = frame.delaunay.active[i];
    g_autofree Site *corners
        = g_new (Site, voronoi_cell_room (&frame.voronoi, site));
    const uint32_t n = voronoi_clip_cell (&frame.voronoi, site, &box, corners);

    g_assert_cmpuint (n, <=, voronoi_cell_room (&frame.voronoi, site));
    for (uint32_t k = 0; k < n; k++) {
      g_assert_cmpfloat (deficit (&frame.delaunay, site, &corners[k]), <, tiny);
      corners[k].x -= extent.centre.x;
      corners[k].y -= extent.centre.y;
    }
    total += area (corners, n);
  }
  g_assert_cmpfloat_with_epsilon (total, 4 * reach * reach,
                                  4e-6 * reach * (reach + tiny * 1e9));
  frame_clear (&frame);
}

static void
test_cells_fill_the_box (void)
{
  fixture_for_each (3, 20, ORDER_FURTHEST, check_cells);
}

/* Both ends of a clipped edge, and its middle, are equally near to its two
 * sites and nearer to no other. */
static void
check_edges (const Fixture *fixture)
{
  const Extent extent = site_set_extent (fixture->set);
  const double reach = 1.5 * extent.radius;
  const Box box = { { extent.centre.x - reach, extent.centre.y - reach },
                    { extent.centre.x + reach, extent.centre.y + reach } };
  const double tiny
      = 1e-9 * (reach + fabs (extent.centre.x) + fabs (extent.centre.y));
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  for (uint32_t i = 0; i < frame.voronoi.n_edges; i++) {
    Site ends[3];

    if (!voronoi_clip_edge (&frame.voronoi, i, &box, ends))
      continue;
    ends[2]
        = (Site){ (ends[0].x + ends[1].x) / 2, (ends[0].y + ends[1].y) / 2 };
    for (guint k = 0; k < 6; k++) {
      const Site *end = &ends[k / 2];

      g_assert_cmpfloat (fabs (end->x - extent.centre.x), <=, reach + tiny);
      g_assert_cmpfloat (fabs (end->y - extent.centre.y), <=, reach + tiny);
      g_assert_cmpfloat (
          deficit (&frame.delaunay, frame.voronoi.edges[i].site[k % 2], end), <,
          tiny);
    }
  }
  frame_clear (&frame);
}

static void
test_edges_keep_to_bisectors (void)
{
  fixture_for_each (3, 20, ORDER_FURTHEST, check_edges);
}

static void
test_far_vertex_never_leaves_the_box (void)
{
  /* Nearly collinear: centres lie some 1e15 away. */
  const Site sites[] = { { 0, 0 }, { 1, 0 }, { 2, 0x1p-52 }, { 1, 1 } };
  SiteSet *set = site_set_new (sites, G_N_ELEMENTS (sites));
  const Order order = { ORDER_FURTHEST, 0 };
  g_autoptr (Fixture) fixture = fixture_take (g_strdup ("far"), set, &order);

  check_cells (fixture);
  check_edges (fixture);
}

static void
test_square_has_one_vertex_and_four_rays (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("square4", ORDER_FURTHEST);
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  g_assert_cmpuint (frame.voronoi.n_vertices, ==, 1);
  g_assert_cmpuint (frame.voronoi.n_edges, ==, 4);
  g_assert_cmpuint (frame.voronoi.n_rays, ==, 4);
  g_assert_cmpfloat (frame.voronoi.vertices[0].at.x, ==, 0);
  g_assert_cmpfloat (frame.voronoi.vertices[0].at.y, ==, 0);
  frame_clear (&frame);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/voronoi/clipped-cells-fill-the-box-without-overlap",
                   test_cells_fill_the_box);
  g_test_add_func ("/voronoi/clipped-edges-keep-to-their-bisectors",
                   test_edges_keep_to_bisectors);
  g_test_add_func ("/voronoi/a-far-vertex-never-leaves-the-box",
                   test_far_vertex_never_leaves_the_box);
  g_test_add_func ("/voronoi/a-square-has-one-vertex-and-four-rays",
                   test_square_has_one_vertex_and_four_rays);
  return g_test_run ();
}
