/* Furthest-site diagrams against brute force: distances to every site. */
#include "furthest.h"

#include "fixture.h"
#include "judge.h"

#include <math.h>

typedef struct Case {
  const Fixture *fixture;
  Frame frame;
  Furthest furthest;
  Extent extent;
} Case;

static void
case_init (Case *c, const Fixture *fixture, uint32_t step)
{
  c->fixture = fixture;
  frame_init (&c->frame, fixture->trace, step);
  furthest_init (&c->furthest, &c->frame, fixture->set->sites);
  c->extent = site_set_extent (fixture->set);
}

static void
case_clear (Case *c)
{
  furthest_clear (&c->furthest);
  frame_clear (&c->frame);
}

static double
distance (const Case *c, uint32_t site, Site at)
{
  const Site *p = &c->fixture->set->sites[site];

  return hypot (p->x - at.x, p->y - at.y);
}

/* Over the sites that are on the hull. */
static double
most_distance (const Case *c, Site at)
{
  double most = 0;
  uint32_t i;

  for (i = 0; i < c->frame.delaunay.n_active; i++)
    most = fmax (most, distance (c, c->frame.delaunay.active[i], at));
  return most;
}

static bool
is_in_polygon (const Site *corners, uint32_t n, Site at)
{
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Site *a = &corners[i], *b = &corners[(i + 1) % n];

    if ((b->x - a->x) * (at.y - a->y) - (b->y - a->y) * (at.x - a->x) < 0)
      return false;
  }
  return n > 0;
}

/* A point lies in the cells of sites that no other is further than; and in at
 * least one. */
static void
check_cells (const Fixture *fixture)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (4);
  g_autofree Site *corners = NULL;
  const double tolerance = 1e-7;
  Case c;
  Box box;
  int i;

  case_init (&c, fixture, fixture->trace->n_events);
  box = (Box){ { c.extent.centre.x - 3 * c.extent.radius,
                 c.extent.centre.y - 3 * c.extent.radius },
               { c.extent.centre.x + 3 * c.extent.radius,
                 c.extent.centre.y + 3 * c.extent.radius } };
  corners = g_new (Site, c.furthest.n_edges + 5);
  for (i = 0; i < 60; i++) {
    const Site at = { g_rand_double_range (rand, box.low.x, box.high.x),
                      g_rand_double_range (rand, box.low.y, box.high.y) };
    const double most = most_distance (&c, at);
    bool is_in_any = false;
    uint32_t k;

    for (k = 0; k < c.furthest.n_corners; k++) {
      const uint32_t n = furthest_clip_cell (&c.furthest, k, &box, corners);
      const double here = distance (&c, c.furthest.corners[k], at);
      const bool is_in = is_in_polygon (corners, n, at);

      is_in_any = is_in_any || is_in
                  || fabs (here - most) < tolerance * c.extent.radius;
      if (is_in && here < most - tolerance * c.extent.radius)
        g_error ("%s: s%u is not furthest from %g, %g", fixture->name,
                 c.furthest.corners[k], at.x, at.y);
    }
    g_assert_true (is_in_any || c.furthest.n_corners == 0);
  }
  case_clear (&c);
}

static void
test_cells (void)
{
  const char *const *name;

  for (name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    check_cells (fixture);
  }
  fixture_for_each (2, 20, ORDER_FURTHEST, check_cells);
}

/* At every step: a cell for each strictly extreme site, as the judge counts
 * them, and for no other. */
static void
check_corners (const Fixture *fixture)
{
  Judge *judge = judge_new (fixture->set);
  g_autofree uint32_t *hull = g_new (uint32_t, fixture->set->n_sites + 1);
  uint32_t step, k, n;

  for (step = fixture->trace->start_end; step <= fixture->trace->n_events;
       step += 7) {
    Case c;

    case_init (&c, fixture, step);
    n = judge_hull (judge, c.frame.delaunay.active, c.frame.delaunay.n_active,
                    hull);
    g_assert_cmpuint (c.furthest.n_corners, ==, n);
    for (k = 0; k < n; k++) {
      uint32_t i = 0;

      while (i < n && hull[i] != c.furthest.corners[k])
        i++;
      g_assert_cmpuint (i, <, n);
    }
    case_clear (&c);
  }
  judge_free (judge);
}

static void
test_corners (void)
{
  fixture_for_each (2, 16, ORDER_FURTHEST, check_corners);
}

/* In general position h cells have h - 2 vertices, h - 3 edges between them
 * and h rays; every circle passes three sites and holds all. */
static void
test_counts (void)
{
  guint32 seed;

  for (seed = 1; seed <= 12; seed++) {
    g_autoptr (Fixture) fixture
        = fixture_new (FAMILY_RANDOM, seed, 30, ORDER_FURTHEST);
    Judge *judge = judge_new (fixture->set);
    uint32_t i, k, n_rays = 0, n_segments = 0;
    Case c;

    case_init (&c, fixture, fixture->trace->n_events);
    for (i = 0; i < c.furthest.n_edges; i++) {
      n_rays += c.furthest.edges[i].vertex[1] == INDEX_NONE;
      n_segments += c.furthest.edges[i].vertex[1] != INDEX_NONE;
    }
    g_assert_cmpuint (c.furthest.n_vertices, ==, c.furthest.n_corners - 2);
    g_assert_cmpuint (n_segments, ==, c.furthest.n_corners - 3);
    g_assert_cmpuint (n_rays, ==, c.furthest.n_corners);
    for (i = 0; i < c.furthest.n_vertices; i++)
      for (k = 0; k < fixture->set->n_sites; k++)
        g_assert_cmpint (judge_circle (judge, c.furthest.vertices[i].site, k),
                         <=, 0);
    case_clear (&c);
    judge_free (judge);
  }
}

/* A ray runs away from its hull edge to where both its sites are furthest:
 * far out, on the other side of all sites. */
static void
test_rays (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("furthest8", ORDER_FURTHEST);
  const Box box = { { -1e4, -1e4 }, { 1e4, 1e4 } };
  uint32_t i, n_rays = 0;
  Case c;

  case_init (&c, fixture, fixture->trace->n_events);
  for (i = 0; i < c.furthest.n_edges; i++) {
    const FurthestEdge *edge = &c.furthest.edges[i];
    Site ends[2];

    if (edge->vertex[1] != INDEX_NONE)
      continue;
    n_rays++;
    g_assert_true (furthest_clip_edge (&c.furthest, i, &box, ends));
    g_assert_cmpfloat (fabs (distance (&c, edge->site[0], ends[1])
                             - most_distance (&c, ends[1])),
                       <, 1e-6);
    g_assert_cmpfloat (fabs (distance (&c, edge->site[1], ends[1])
                             - most_distance (&c, ends[1])),
                       <, 1e-6);
  }
  g_assert_cmpuint (n_rays, ==, 5);
  case_clear (&c);
}

/* Four sites on one circle have one vertex with four rays; three on a line
 * share the plane among the outer two. */
static void
test_ties (void)
{
  g_autoptr (Fixture) square = fixture_load ("square4", ORDER_FURTHEST);
  g_autoptr (Fixture) line = fixture_load ("line4", ORDER_FURTHEST);
  g_autoptr (Fixture) grid = fixture_load ("grid9", ORDER_FURTHEST);
  Case c;

  case_init (&c, square, square->trace->n_events);
  g_assert_cmpuint (c.furthest.n_vertices, ==, 1);
  g_assert_cmpuint (c.furthest.n_corners, ==, 4);
  case_clear (&c);
  case_init (&c, line, line->trace->n_events);
  g_assert_cmpuint (c.furthest.n_vertices, ==, 0);
  g_assert_cmpuint (c.furthest.n_corners, ==, 2);
  g_assert_cmpuint (c.furthest.n_edges, ==, 1);
  case_clear (&c);
  case_init (&c, grid, grid->trace->n_events);
  g_assert_cmpuint (c.furthest.n_vertices, ==, 1);
  g_assert_cmpuint (c.furthest.n_corners, ==, 4);
  case_clear (&c);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/furthest/a-cell-holds-what-is-furthest-from-its-site",
                   test_cells);
  g_test_add_func ("/furthest/strictly-extreme-sites-alone-have-cells",
                   test_corners);
  g_test_add_func ("/furthest/h-cells-have-h-minus-2-vertices", test_counts);
  g_test_add_func ("/furthest/rays-run-to-where-both-sites-are-furthest",
                   test_rays);
  g_test_add_func ("/furthest/ties-are-one-vertex", test_ties);
  return g_test_run ();
}
