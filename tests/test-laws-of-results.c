/* The laws of the finished hull and of its diagrams. */
#include "frame.h"
#include "standing.h"

/* A maximal set of sites on the circle of one facet, as text: "1 4 7". */
static char *
name_of_cell (const Judge *judge, const SiteSet *set, const uint32_t *circle)
{
  GString *name = g_string_new (NULL);

  for (uint32_t i = 0; i < set->n_sites; i++)
    if (set->first[i] == i && judge_circle (judge, circle, i) == 0)
      g_string_append_printf (name, "%u ", i);
  return g_string_free (name, FALSE);
}

/* The lower and upper facets, those on one circle merged. */
static GHashTable *
cells_of (const Fixture *fixture, const Judge *judge)
{
  const Trace *trace = fixture->trace;
  GHashTable *cells
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);

  for (uint32_t i = 0; i < trace->n_facets; i++) {
    const FacetRow *facet = &trace->facets[i];

    if (span_has (facet->span, trace->n_events)
        && facet->facing != FACING_VERTICAL)
      g_hash_table_add (cells, name_of_cell (judge, fixture->set, facet->site));
  }
  return cells;
}

static bool
are_equal_sets (GHashTable *a, GHashTable *b)
{
  GHashTableIter iter;
  gpointer key;

  g_hash_table_iter_init (&iter, a);
  while (g_hash_table_iter_next (&iter, &key, NULL))
    if (!g_hash_table_contains (b, key))
      return false;
  return g_hash_table_size (a) == g_hash_table_size (b);
}

static void
check_order_does_not_matter (const Fixture *fixture)
{
  static const Order orders[] = { { ORDER_INPUT, 0 },
                                  { ORDER_RANDOM, 1 },
                                  { ORDER_RANDOM, 2 },
                                  { ORDER_RANDOM, 3 } };
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (GHashTable) cells = cells_of (fixture, judge);

  for (guint i = 0; i < G_N_ELEMENTS (orders); i++) {
    Trace *trace = trace_record (fixture->set, &orders[i]);
    const Fixture other = { fixture->name, fixture->set, trace };
    g_autoptr (GHashTable) other_cells = cells_of (&other, judge);

    if (!are_equal_sets (cells, other_cells))
      g_error ("%s: order %u leads to other facets", fixture->name, i);
    trace_free (trace);
  }
}

static void
test_order_does_not_matter (void)
{
  fixture_for_each (20, 16, ORDER_FURTHEST, check_order_does_not_matter);
}

/* A move of the plane that doubles carry out exactly on the sets used. */
typedef Site (*Move) (Site site);

static Site
translate (Site site)
{
  return (Site){ site.x + 4096, site.y - 77 };
}

static Site
enlarge (Site site)
{
  return (Site){ site.x * 1024, site.y * 1024 };
}

static Site
treble (Site site)
{
  return (Site){ site.x * 3, site.y * 3 };
}

static Site
turn (Site site)
{
  return (Site){ -site.y, site.x };
}

static Fixture *
moved (const Fixture *fixture, Move move)
{
  const SiteSet *set = fixture->set;
  g_autofree Site *sites = g_new (Site, set->n_sites + 1);

  for (uint32_t i = 0; i < set->n_sites; i++)
    sites[i] = move (site_set_given (set, i));
  return fixture_take (g_strdup (fixture->name),
                       site_set_new (sites, set->n_sites),
                       &(Order){ ORDER_FURTHEST, 0 });
}

static void
assert_same_events (const Trace *a, const Trace *b, const char *name)
{
  if (a->n_events != b->n_events)
    g_error ("%s: %u events became %u", name, a->n_events, b->n_events);
  for (uint32_t i = 0; i < a->n_events; i++) {
    const Event p = trace_event (a, i), q = trace_event (b, i);

    if (p.kind != q.kind || p.facet != q.facet || p.site != q.site
        || p.ridge[0] != q.ridge[0] || p.ridge[1] != q.ridge[1])
      g_error ("%s: event %u differs", name, i);
  }
}

static void
test_moving_the_plane (gconstpointer data)
{
  const Move move = *(const Move *)data;
  static const Family families[]
      = { FAMILY_RANDOM, FAMILY_TIES, FAMILY_GRID, FAMILY_CIRCLE, FAMILY_LINE };

  for (guint i = 0; i < G_N_ELEMENTS (families) * 20; i++) {
    g_autoptr (Fixture) fixture
        = fixture_new (families[i % 5], i, 24, ORDER_FURTHEST);
    g_autoptr (Fixture) other = moved (fixture, move);

    assert_same_events (fixture->trace, other->trace, fixture->name);
  }
}

/* The orders of six things are numbered from 0 to 719. */
static void
order_of_number (guint number, Site sites[6])
{
  for (guint i = 6; i > 1; i--) {
    const guint j = number % i;
    const Site site = sites[j];

    sites[j] = sites[i - 1];
    sites[i - 1] = site;
    number /= i;
  }
}

/* Over all orders of six sites the 5th insertion's cone has 18/5 facets on
 * average and the 6th's 4: 6 - 12/k. */
static void
test_mean_cone (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("obtuse6", ORDER_INPUT);
  guint sum[2] = { 0, 0 };

  for (guint number = 0; number < 720; number++) {
    g_autoptr (Fixture) other = NULL;
    Site sites[6];

    memcpy (sites, fixture->set->sites, sizeof sites);
    order_of_number (number, sites);
    other = fixture_take (g_strdup ("permuted"), site_set_new (sites, 6),
                          &(Order){ ORDER_INPUT, 0 });
    for (guint i = 0; i < 2; i++) {
      const RoundRow *row = &other->trace->rounds[i];

      g_assert_cmpuint (row->site, ==, 4 + i);
      sum[i] += row->last_cone - row->first_cone + 1;
    }
  }
  g_assert_cmpuint (sum[0] * 5, ==, 720 * 18);
  g_assert_cmpuint (sum[1], ==, 720 * 4);
}

static guint
count_rays (const Voronoi *voronoi, uint32_t site)
{
  guint n = 0;

  for (uint32_t i = voronoi->start[site]; i < voronoi->start[site + 1]; i++)
    n += voronoi->edges[voronoi->incident[i]].vertex[1] == INDEX_NONE;
  return n;
}

/* Two rays bound the cell of every site on the border of the hull; none
 * bounds another's. */
static void
check_unbounded_cells (const Fixture *fixture)
{
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (Standing) standing
      = standing_new (fixture, judge, fixture->trace->n_events);
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  if (standing->n_corners > 2) {
    standing_assert (standing, frame.voronoi.n_rays == standing->n_boundary);
    for (uint32_t i = 0; i < standing->n_active; i++) {
      const uint32_t site = standing->active[i];
      const bool is_inner
          = judge_inside (judge, standing->corners, standing->n_corners, site)
            > 0;

      standing_assert (standing,
                       count_rays (&frame.voronoi, site) == (is_inner ? 0 : 2));
    }
  }
  frame_clear (&frame);
}

static void
test_unbounded_cells (void)
{
  fixture_for_each (30, 20, ORDER_FURTHEST, check_unbounded_cells);
}

/* On a line: d - 1 Delaunay edges between neighbours, d - 1 Voronoi lines. */
static void
test_line (void)
{
  for (uint32_t d = 2; d < 30; d++) {
    g_autoptr (Fixture) fixture = NULL;
    Site sites[30];
    Frame frame;

    for (uint32_t i = 0; i < d; i++) /* 31 is prime: all differ */
      sites[i] = (Site){ 3.0 * (7 * i % 31) + 1, 2.0 * (7 * i % 31) };
    fixture
        = fixture_take (g_strdup_printf ("line %u", d), site_set_new (sites, d),
                        &(Order){ ORDER_FURTHEST, 0 });
    frame_init (&frame, fixture->trace, fixture->trace->n_events);
    g_assert_cmpint (frame.delaunay.dimension, ==, 1);
    g_assert_cmpuint (frame.delaunay.n_edges, ==, d - 1);
    g_assert_cmpuint (frame.voronoi.n_edges, ==, d - 1);
    for (uint32_t i = 0; i < d - 1; i++)
      g_assert_cmpuint (frame.voronoi.edges[i].vertex[0], ==, INDEX_NONE);
    frame_clear (&frame);
  }
}

int
main (int argc, char **argv)
{
  static const struct {
    const char *name;
    Move move;
  } moves[] = { { "translating-the-plane", translate },
                { "scaling-by-1024", enlarge },
                { "scaling-by-3", treble },
                { "turning-by-90-degrees", turn } };

  g_test_init (&argc, &argv, NULL);
  g_test_add_func (
      "/laws/facets-do-not-depend-on-order-once-circles-are-merged",
      test_order_does_not_matter);
  for (guint i = 0; i < G_N_ELEMENTS (moves); i++) {
    g_autofree char *path
        = g_strdup_printf ("/laws/%s-changes-no-event", moves[i].name);

    g_test_add_data_func (path, &moves[i].move, test_moving_the_plane);
  }
  g_test_add_func ("/laws/the-mean-cone-over-all-orders-is-6-minus-12-over-k",
                   test_mean_cone);
  g_test_add_func ("/laws/a-cell-is-unbounded-iff-its-site-is-on-the-border",
                   test_unbounded_cells);
  g_test_add_func ("/laws/sites-on-a-line-have-one-voronoi-line-fewer",
                   test_line);
  return g_test_run ();
}
