/* A preview against the real insertion: another set, another hull. */
#include "preview.h"

#include "fixture.h"
#include "frame.h"
#include "judge.h"

#include <math.h>

/* A set, and the same with one site more. */
typedef struct Pair {
  Fixture *before, *after;
  Frame frames[2];
  Preview preview;
  Site at;
  Box box;
} Pair;

static bool
is_new (const SiteSet *set, Site at)
{
  uint32_t i;

  for (i = 0; i < set->n_sites; i++)
    if (set->sites[i].x == at.x && set->sites[i].y == at.y)
      return false;
  return true;
}

static Pair *
pair_new (Fixture *before, Site at)
{
  const SiteSet *set = before->set;
  const Order order = { ORDER_FURTHEST, 0 };
  const Extent extent = site_set_extent (set);
  g_autofree Site *sites = g_new (Site, set->n_sites + 1);
  Pair *pair = g_new0 (Pair, 1);
  uint32_t i;

  for (i = 0; i < set->n_sites; i++)
    sites[i] = set->sites[i];
  sites[set->n_sites] = at;
  pair->before = before;
  pair->after = fixture_take (g_strdup ("after"),
                              site_set_new (sites, set->n_sites + 1), &order);
  pair->at = at;
  pair->box = (Box){ { extent.centre.x - 2 * extent.radius,
                       extent.centre.y - 2 * extent.radius },
                     { extent.centre.x + 2 * extent.radius,
                       extent.centre.y + 2 * extent.radius } };
  frame_init (&pair->frames[0], before->trace, before->trace->n_events);
  frame_init (&pair->frames[1], pair->after->trace,
              pair->after->trace->n_events);
  preview_init (&pair->preview, set, at, &pair->frames[0].voronoi, at,
                &pair->box);
  return pair;
}

static void
pair_free (Pair *pair)
{
  preview_clear (&pair->preview);
  frame_clear (&pair->frames[0]);
  frame_clear (&pair->frames[1]);
  fixture_free (pair->after);
  g_free (pair);
}

static bool
has_triangle (const Delaunay *delaunay, const uint32_t site[3])
{
  uint32_t i, k;

  for (i = 0; i < delaunay->n_triangles; i++)
    for (k = 0; k < 3; k++) {
      const uint32_t *other = delaunay->triangles[i].site;

      if (other[k] == site[0] && other[(k + 1) % 3] == site[1]
          && other[(k + 2) % 3] == site[2])
        return true;
    }
  return false;
}

static double
area_of (const Site *corners, uint32_t n)
{
  double area = 0;
  uint32_t i;

  for (i = 1; i + 1 < n; i++)
    area += (corners[i].x - corners[0].x) * (corners[i + 1].y - corners[0].y)
            - (corners[i].y - corners[0].y) * (corners[i + 1].x - corners[0].x);
  return area / 2;
}

static double
cell_area (const Pair *pair, int which, uint32_t site)
{
  const Voronoi *voronoi = &pair->frames[which].voronoi;
  g_autofree Site *corners = g_new (Site, voronoi_cell_room (voronoi, site));

  return area_of (corners,
                  voronoi_clip_cell (voronoi, site, &pair->box, corners));
}

/* What dies is what is no more: in general position exactly. */
static void
check_triangles (const Pair *pair)
{
  const Delaunay *before = &pair->frames[0].delaunay;
  const Delaunay *after = &pair->frames[1].delaunay;
  uint32_t i, n_dying = 0, n_edges = 0;

  for (i = 0; i < before->n_triangles; i++) {
    const bool is_dying
        = n_dying < pair->preview.n_dying && pair->preview.dying[n_dying] == i;

    n_dying += is_dying;
    g_assert_true (has_triangle (after, before->triangles[i].site) != is_dying);
  }
  g_assert_cmpuint (n_dying, ==, pair->preview.n_dying);
  for (i = 0; i < after->n_edges; i++)
    n_edges += after->edges[i].site[0] == pair->before->set->n_sites
               || after->edges[i].site[1] == pair->before->set->n_sites;
  g_assert_cmpuint (n_edges, ==, pair->preview.n_neighbours);
}

/* The cell is that of the insertion, and what is taken from each cell is what
 * it has lost. */
static void
check_cells (const Pair *pair)
{
  const Preview *preview = &pair->preview;
  const double whole
      = area_of ((Site[]){ pair->box.low,
                           { pair->box.high.x, pair->box.low.y },
                           pair->box.high,
                           { pair->box.low.x, pair->box.high.y } },
                 4);
  const uint32_t n_sites = pair->before->set->n_sites;
  g_autofree double *lost = g_new0 (double, n_sites);
  uint32_t i;

  g_assert_cmpfloat (fabs (area_of (preview->cell, preview->n_cell)
                           - cell_area (pair, 1, n_sites)),
                     <, 1e-6 * whole);
  for (i = 0; i < preview->n_pieces; i++)
    lost[preview->pieces[i].site] += area_of (
        &preview->corners[preview->pieces[i].first], preview->pieces[i].n);
  for (i = 0; i < n_sites; i++)
    if (pair->before->set->first[i] == i)
      g_assert_cmpfloat (
          fabs (cell_area (pair, 0, i) - cell_area (pair, 1, i) - lost[i]), <,
          1e-6 * whole);
}

static void
test_general (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (8);
  guint32 seed;

  for (seed = 1; seed <= 20; seed++) {
    g_autoptr (Fixture) fixture
        = fixture_new (FAMILY_RANDOM, seed, 25, ORDER_FURTHEST);
    const Extent extent = site_set_extent (fixture->set);
    int i;

    for (i = 0; i < 10; i++) {
      const double reach = 1.6 * extent.radius;
      const Site at
          = { extent.centre.x + g_rand_double_range (rand, -reach, reach),
              extent.centre.y + g_rand_double_range (rand, -reach, reach) };
      Pair *pair = pair_new (fixture, at);

      check_triangles (pair);
      check_cells (pair);
      pair_free (pair);
    }
  }
}

/* With ties diagonals may fall otherwise, but cells are the same; also on
 * lines, and where the new site makes the first triangle. What dies is what
 * the judge finds the site strictly inside of. */
static void
check_ties (const Fixture *fixture)
{
  const SiteSet *set = fixture->set;
  uint32_t i;

  for (i = 0; i + 1 < set->n_sites && i < 12; i++) {
    const Site at = { (set->sites[i].x + set->sites[i + 1].x) / 2,
                      (set->sites[i].y + set->sites[i + 1].y) / 2 };
    Judge *judge;
    uint32_t k, n_dying = 0;
    Pair *pair;

    if (!is_new (set, at))
      continue;
    pair = pair_new ((Fixture *)fixture, at);
    judge = judge_new (pair->after->set);
    check_cells (pair);
    for (k = 0; k < pair->frames[0].delaunay.n_triangles; k++)
      n_dying
          += judge_circle (judge, pair->frames[0].delaunay.triangles[k].site,
                           set->n_sites)
             < 0;
    g_assert_cmpuint (n_dying, ==, pair->preview.n_dying);
    judge_free (judge);
    pair_free (pair);
  }
}

static void
test_ties (void)
{
  const char *const names[]
      = { "square4", "square5", "grid9", "line4", "vertical5", "point1" };
  size_t i;

  for (i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autoptr (Fixture) fixture = fixture_load (names[i], ORDER_FURTHEST);

    check_ties (fixture);
  }
  fixture_for_each (1, 14, ORDER_FURTHEST, check_ties);
}

static void
test_taken (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  Pair *pair = pair_new (fixture, fixture->set->sites[3]);

  g_assert_cmpuint (pair->preview.n_neighbours, ==, 0);
  g_assert_cmpuint (pair->preview.n_dying, ==, 0);
  g_assert_cmpuint (pair->preview.n_cell, ==, 0);
  pair_free (pair);
}

/* A view may reach farther than sites can lie. */
static void
test_too_far (void)
{
  const Site places[] = {
    { INFINITY, 1 }, { 0, -INFINITY }, { NAN, 0 },
    { 1e300, 0.5 },  { 0.5, 1e-300 },
  };
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const Box box = { { -1, -1 }, { 1, 1 } };
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  for (size_t i = 0; i < G_N_ELEMENTS (places); i++) {
    Preview preview;

    preview_init (&preview, fixture->set, places[i], &frame.voronoi, places[i],
                  &box);
    g_assert_cmpuint (preview.n_neighbours + preview.n_cell, ==, 0);
    preview_clear (&preview);
  }
  frame_clear (&frame);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/preview/it-is-what-the-insertion-does", test_general);
  g_test_add_func ("/preview/with-ties-its-cell-is-that-of-the-insertion",
                   test_ties);
  g_test_add_func ("/preview/where-a-site-is-nothing-changes", test_taken);
  g_test_add_func ("/preview/where-no-site-can-be-nothing-changes",
                   test_too_far);
  return g_test_run ();
}
