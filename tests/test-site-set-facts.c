/* What the curated site sets are curated for. The numbers were worked out in
 * rational arithmetic before the engine was written. */
#include "frame.h"
#include "moment.h"

#include <math.h>

/* Returns: the facet with these three corners, or INDEX_NONE. */
static uint32_t
facet_at (const Trace *trace, uint32_t a, uint32_t b, uint32_t c)
{
  for (uint32_t i = 0; i < trace->n_facets; i++) {
    const uint32_t *site = trace->facets[i].site;
    guint n = 0;

    for (guint k = 0; k < 3; k++)
      n += site[k] == a || site[k] == b || site[k] == c;
    if (n == 3)
      return i;
  }
  return INDEX_NONE;
}

static bool
stands_at_end (const Trace *trace, uint32_t a, uint32_t b, uint32_t c)
{
  const uint32_t facet = facet_at (trace, a, b, c);

  return facet != INDEX_NONE
         && span_has (trace->facets[facet].span, trace->n_events);
}

/* The waiting site's facets at the first partition, as text: "0 1". */
static char *
facets_seen_at_start (const Fixture *fixture, uint32_t site)
{
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (Moment) moment
      = moment_new (fixture, judge, fixture->trace->start_end);
  GString *text = g_string_new (NULL);

  for (uint32_t i = 0; i < moment->n_facets; i++)
    if (moment_sees (moment, moment->facets[i], site))
      g_string_append_printf (text, "%s%u", text->len > 0 ? " " : "",
                              moment->facets[i]);
  return g_string_free (text, FALSE);
}

static uint32_t
claimed_by (const Trace *trace, uint32_t site, uint32_t step)
{
  for (uint32_t i = 0; i < trace->n_claims; i++)
    if (trace->claims[i].site == site && span_has (trace->claims[i].span, step))
      return trace->claims[i].facet;
  return INDEX_NONE;
}

static void
test_lecture8_is_a_partition (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  static const guint n_moved[] = { 3, 0, 1, 0 };

  for (uint32_t site = 4; site < 8; site++) {
    g_autofree char *seen = facets_seen_at_start (fixture, site);

    g_assert_cmpstr (seen, ==, "0 1");
    g_assert_cmpuint (
        claimed_by (fixture->trace, site, fixture->trace->start_end), ==, 0);
  }
  for (guint i = 0; i < 4; i++) {
    const RoundRow *row = &fixture->trace->rounds[i];

    g_assert_cmpuint (row->end - row->last_retire, ==, n_moved[i]);
  }
}

/* The distance between the lifts of a site and the facet's plane. */
typedef struct Distance {
  double gap, perpendicular; /* vertical; along the normal */
} Distance;

static Distance
distance_to (const Fixture *fixture, uint32_t facet, uint32_t site)
{
  const uint32_t *corner = fixture->trace->facets[facet].site;
  const Site *a = &fixture->set->sites[corner[0]];
  const Site *b = &fixture->set->sites[corner[1]];
  const Site *c = &fixture->set->sites[corner[2]];
  const Site *p = &fixture->set->sites[site];
  const double ux = b->x - a->x, uy = b->y - a->y;
  const double vx = c->x - a->x, vy = c->y - a->y;
  const double uz = ux * (b->x + a->x) + uy * (b->y + a->y);
  const double vz = vx * (c->x + a->x) + vy * (c->y + a->y);
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz;
  const double nz = ux * vy - uy * vx;
  const double pz = p->x * p->x + p->y * p->y - a->x * a->x - a->y * a->y;
  const double front = nx * (p->x - a->x) + ny * (p->y - a->y) + nz * pz;

  return (Distance){ fabs (front / nz),
                     front / sqrt (nx * nx + ny * ny + nz * nz) };
}

#define assert_near(value, expected)                                           \
  g_assert_cmpfloat_with_epsilon ((value), (expected), 0.0006)

static void
test_near_far6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("near-far6", ORDER_FURTHEST);
  const uint32_t facet = facet_at (fixture->trace, 2, 3, 0);
  g_autofree char *seen = facets_seen_at_start (fixture, 4);
  g_autofree char *seen_by_5 = facets_seen_at_start (fixture, 5);
  g_autofree char *name = g_strdup_printf ("%u", facet);

  g_assert_cmpstr (seen, ==, name);
  g_assert_cmpstr (seen_by_5, ==, name);
  assert_near (distance_to (fixture, facet, 4).perpendicular, 0.2542);
  assert_near (distance_to (fixture, facet, 5).perpendicular, 0.1508);
  g_assert_cmpuint (fixture->trace->rounds[0].site, ==, 4);
}

static void
test_gap6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("gap6", ORDER_FURTHEST);
  const uint32_t first = facet_at (fixture->trace, 2, 3, 1);
  const uint32_t second = facet_at (fixture->trace, 1, 3, 0);
  g_autofree char *seen = facets_seen_at_start (fixture, 4);
  g_autofree char *seen_by_5 = facets_seen_at_start (fixture, 5);

  g_assert_cmpuint (first, ==, 2);
  g_assert_cmpuint (second, ==, 3);
  g_assert_cmpstr (seen, ==, "2");
  g_assert_cmpstr (seen_by_5, ==, "3");
  assert_near (distance_to (fixture, first, 4).gap, 1.676);
  assert_near (distance_to (fixture, first, 4).perpendicular, 0.210);
  assert_near (distance_to (fixture, second, 5).gap, 0.614);
  assert_near (distance_to (fixture, second, 5).perpendicular, 0.432);
  g_assert_cmpuint (fixture->trace->rounds[0].site, ==, 4);
}

static void
test_tie6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("tie6", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  const Site *sites = fixture->set->sites;
  const uint32_t facet = facet_at (trace, 0, 3, 1);
  const uint32_t *corner = trace->facets[facet].site;
  const Site plane[3]
      = { sites[corner[0]], sites[corner[1]], sites[corner[2]] };
  g_autoptr (Judge) judge = judge_new (fixture->set);

  g_assert_cmpuint (claimed_by (trace, 4, trace->start_end), ==, facet);
  g_assert_cmpuint (claimed_by (trace, 5, trace->start_end), ==, facet);
  g_assert_cmpint (lift_further (plane, &sites[4], &sites[5]), ==, 0);
  assert_near (distance_to (fixture, facet, 4).gap, 137.0 / 448);
  assert_near (distance_to (fixture, facet, 5).gap, 137.0 / 448);
  g_assert_cmpuint (trace->rounds[0].site, ==, 4);
  g_assert_cmpint (judge_circle (judge, (uint32_t[3]){ 0, 1, 4 }, 5), ==, 0);
}

static void
test_cross5 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("cross5", ORDER_FURTHEST);
  g_autoptr (Judge) judge = judge_new (fixture->set);
  const Trace *trace = fixture->trace;
  const RoundRow *row = &trace->rounds[0];
  static const uint32_t loop[] = { 2, 3, 0, 1 };
  guint start = 0;

  g_assert_cmpuint (trace->facets[facet_at (trace, 1, 2, 3)].seen, !=,
                    STEP_NEVER);
  g_assert_cmpuint (trace->facets[facet_at (trace, 0, 1, 3)].seen, !=,
                    STEP_NEVER);
  while (loop[start] != trace->events[row->first_horizon - 1].ridge[0])
    start += 1;
  for (guint i = 0; i < 4; i++) {
    const Event *event = &trace->events[row->first_horizon - 1 + i];
    const guint tail = event->ridge[0], head = event->ridge[1];

    g_assert_true (
        (tail == loop[(start + i) % 4] && head == loop[(start + i + 1) % 4])
        || (tail == loop[(start + 4 - i) % 4]
            && head == loop[(start + 3 - i) % 4]));
  }
  g_assert_true (
      judge_cross (judge, (uint32_t[2]){ 2, 3 }, (uint32_t[2]){ 0, 1 }));
}

static void
test_square (void)
{
  g_autoptr (Fixture) four = fixture_load ("square4", ORDER_FURTHEST);
  g_autoptr (Fixture) five = fixture_load ("square5", ORDER_FURTHEST);
  const Trace *trace = five->trace;
  Frame frame;

  g_assert_true (four->trace->is_flat);
  g_assert_false (trace->is_flat);
  for (uint32_t i = 0; i < 4; i++) /* of the first simplex */
    for (uint32_t k = 0; k < 3; k++)
      g_assert_cmpuint (trace->facets[i].site[k], !=, 3);
  g_assert_true (stands_at_end (trace, 0, 1, 4));
  g_assert_true (stands_at_end (trace, 1, 2, 4));
  g_assert_true (stands_at_end (trace, 2, 3, 4));
  g_assert_true (stands_at_end (trace, 3, 0, 4));
  frame_init (&frame, trace, trace->n_events);
  g_assert_cmpuint (frame.delaunay.n_groups, ==, 4);
  frame_clear (&frame);
}

static void
test_flip5 (void)
{
  g_autoptr (Fixture) in = fixture_load ("flip5-in", ORDER_FURTHEST);
  g_autoptr (Fixture) tie = fixture_load ("flip5-tie", ORDER_FURTHEST);
  g_autoptr (Fixture) out = fixture_load ("flip5-out", ORDER_FURTHEST);
  Frame frame;

  g_assert_true (stands_at_end (in->trace, 0, 1, 3));
  g_assert_true (stands_at_end (in->trace, 1, 2, 3));
  g_assert_true (stands_at_end (out->trace, 0, 1, 2));
  g_assert_true (stands_at_end (out->trace, 0, 2, 3));
  frame_init (&frame, tie->trace, tie->trace->n_events);
  g_assert_cmpuint (frame.delaunay.n_triangles, ==, 3);
  g_assert_cmpuint (frame.delaunay.n_groups, ==, 2);
  frame_clear (&frame);
}

static void
test_mwt4 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mwt4", ORDER_FURTHEST);
  const Site *s = fixture->set->sites;

  g_assert_true (stands_at_end (fixture->trace, 0, 1, 3));
  g_assert_true (stands_at_end (fixture->trace, 1, 2, 3));
  assert_near (hypot (s[1].x - s[3].x, s[1].y - s[3].y), 1.288);
  assert_near (hypot (s[0].x - s[2].x, s[0].y - s[2].y), 0.760);
}

static void
test_grid9 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("grid9", ORDER_FURTHEST);
  static const guint n_vertical[] = { 1, 3, 2, 3, 4 };
  Frame frame;

  for (guint i = 0; i < 5; i++) {
    frame_init (&frame, fixture->trace, fixture->trace->rounds[i].end);
    g_assert_cmpuint (frame.counts.vertical, ==, n_vertical[i]);
    frame_clear (&frame);
  }
  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  g_assert_cmpuint (frame.counts.facets, ==, 14);
  g_assert_cmpuint (frame.delaunay.n_groups, ==, 4);
  frame_clear (&frame);
}

static void
test_furthest8 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("furthest8", ORDER_FURTHEST);
  g_autoptr (Judge) judge = judge_new (fixture->set);
  static const uint32_t upper[3][3] = { { 0, 1, 2 }, { 0, 2, 4 }, { 2, 3, 4 } };

  for (guint i = 0; i < 3; i++) {
    const uint32_t facet
        = facet_at (fixture->trace, upper[i][0], upper[i][1], upper[i][2]);

    g_assert_true (
        stands_at_end (fixture->trace, upper[i][0], upper[i][1], upper[i][2]));
    g_assert_cmpint (fixture->trace->facets[facet].facing, ==, FACING_UPPER);
    for (uint32_t site = 0; site < 8; site++)
      g_assert_cmpint (judge_circle (judge, upper[i], site), <=, 0);
  }
}

/* Returns: the Voronoi vertex of the triangle with these corners. */
static Site
centre_of (const Frame *frame, uint32_t a, uint32_t b, uint32_t c)
{
  const uint32_t facet = facet_at (frame->trace, a, b, c);

  for (uint32_t i = 0; i < frame->delaunay.n_triangles; i++)
    if (frame->delaunay.triangles[i].facet == facet)
      return frame->voronoi.vertices[frame->delaunay.triangles[i].group].at;
  g_error ("no triangle %u %u %u", a, b, c);
}

static bool
is_in_triangle (const Site *p, const Site *a, const Site *b, const Site *c)
{
  const int turn = orient (a, b, c);

  return orient (a, b, p) == turn && orient (b, c, p) == turn
         && orient (c, a, p) == turn;
}

static void
test_obtuse6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("obtuse6", ORDER_FURTHEST);
  const Site *s = fixture->set->sites;
  Site inner, outer, left, right, centre;
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  inner = centre_of (&frame, 0, 1, 5);
  outer = centre_of (&frame, 1, 4, 5);
  right = centre_of (&frame, 2, 3, 4);
  left = centre_of (&frame, 3, 4, 5);
  centre = centre_of (&frame, 1, 2, 4);
  frame_clear (&frame);

  g_assert_true (is_in_triangle (&inner, &s[0], &s[1], &s[5]));
  g_assert_true (is_in_triangle (&centre, &s[1], &s[2], &s[4]));
  g_assert_true (is_in_triangle (&outer, &s[0], &s[1], &s[5]));
  assert_near (outer.x, -0.158);
  assert_near (outer.y, 0.137);
  assert_near (right.x, 0.406);
  assert_near (right.y, -0.656);
  assert_near (left.x, -0.427);
  assert_near (left.y, -0.537);
  /* Both beyond a hull edge; and the Voronoi edge of s1 s5 stays on one side
   * of it. */
  g_assert_cmpint (orient (&s[3], &s[2], &right), <, 0);
  g_assert_cmpint (orient (&s[5], &s[3], &left), <, 0);
  g_assert_cmpint (orient (&s[1], &s[5], &inner), ==,
                   orient (&s[1], &s[5], &outer));
}

static void
test_wheel8 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("wheel8", ORDER_INPUT);
  static const guint n_visible[] = { 1, 2, 2, 5 };

  for (guint i = 0; i < 4; i++) {
    const RoundRow *row = &fixture->trace->rounds[i];
    const uint32_t facet = fixture->trace->events[row->first_visible - 1].facet;

    g_assert_cmpuint (row->site, ==, 4 + i);
    g_assert_cmpuint (row->last_visible - row->first_visible + 1, ==,
                      n_visible[i]);
    g_assert_cmpint (fixture->trace->facets[facet].facing, ==,
                     i < 3 ? FACING_UPPER : FACING_LOWER);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
#define ADD(name, test) g_test_add_func ("/site-sets/" name, test)
  ADD ("lecture8-claims-each-site-once-though-it-sees-two-facets",
       test_lecture8_is_a_partition);
  ADD ("near-far6-takes-the-furthest-from-the-facet", test_near_far6);
  ADD ("gap6-has-a-wide-gap-and-a-short-perpendicular", test_gap6);
  ADD ("tie6-ties-exactly-and-takes-the-lower-index", test_tie6);
  ADD ("cross5-has-a-horizon-whose-shadow-crosses-itself", test_cross5);
  ADD ("square4-is-flat-and-square5-is-not", test_square);
  ADD ("flip5-flips-through-a-tie", test_flip5);
  ADD ("mwt4-takes-the-longer-diagonal", test_mwt4);
  ADD ("grid9-makes-and-loses-vertical-facets", test_grid9);
  ADD ("furthest8-has-three-circles-round-all-sites", test_furthest8);
  ADD ("obtuse6-has-centres-outside-their-triangles", test_obtuse6);
  ADD ("wheel8-by-input-ends-with-five-lower-facets-seen", test_wheel8);
  return g_test_run ();
}
