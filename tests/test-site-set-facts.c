/* What the curated site sets are curated for. The facts were worked out in
 * rational arithmetic before the engine was written. */
#include "frame.h"
#include "standing.h"

/* The corners of the hull in the plane at the end, as text: "3 4 5". */
static char *
corners_at_end (const Fixture *fixture)
{
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (Standing) standing
      = standing_new (fixture, judge, fixture->trace->n_events);
  GString *text = g_string_new (NULL);

  for (uint32_t site = 0; site < fixture->set->n_sites; site++)
    for (uint32_t i = 0; i < standing->n_corners; i++)
      if (standing->corners[i] == site)
        g_string_append_printf (text, "%s%u", text->len > 0 ? " " : "", site);
  return g_string_free (text, FALSE);
}

static void
test_corners (void)
{
  static const char *const facts[][2] = { { "mixed8", "3 4 5 7" },
                                          { "cross5", "0 2 3 4" },
                                          { "furthest8", "0 1 2 3 4" } };

  for (guint i = 0; i < G_N_ELEMENTS (facts); i++) {
    g_autoptr (Fixture) fixture = fixture_load (facts[i][0], ORDER_FURTHEST);
    g_autofree char *corners = corners_at_end (fixture);

    g_assert_cmpstr (corners, ==, facts[i][1]);
  }
}

static uint32_t
claimed_by (const Trace *trace, uint32_t site, uint32_t step)
{
  for (uint32_t i = 0; i < trace->n_claims; i++)
    if (trace_claim (trace, i).site == site
        && span_has (trace_claim (trace, i).span, step))
      return trace_claim (trace, i).facet;
  return INDEX_NONE;
}

static void
test_lecture8_is_a_partition (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (Standing) standing
      = standing_new (fixture, judge, fixture->trace->start_end);
  static const guint n_moved[] = { 3, 0, 1, 0 };

  for (uint32_t site = 4; site < 8; site++) {
    g_autofree char *seen = standing_seen (standing, site);

    g_assert_cmpstr (seen, ==, "0 1");
    g_assert_cmpuint (
        claimed_by (fixture->trace, site, fixture->trace->start_end), ==, 0);
  }
  for (guint i = 0; i < 4; i++) {
    const RoundRow *row = &fixture->trace->rounds[i];

    g_assert_cmpuint (row->end - row->last_retire, ==, n_moved[i]);
  }
}

static void
test_tie6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("tie6", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  const Site *sites = fixture->set->sites;
  const uint32_t facet = fixture_facet (fixture, 0, 3, 1);
  const uint32_t *corner = trace->facets[facet].site;
  const Site plane[3]
      = { sites[corner[0]], sites[corner[1]], sites[corner[2]] };
  g_autoptr (Judge) judge = judge_new (fixture->set);

  g_assert_cmpuint (claimed_by (trace, 4, trace->start_end), ==, facet);
  g_assert_cmpuint (claimed_by (trace, 5, trace->start_end), ==, facet);
  g_assert_cmpint (lift_further (plane, &sites[4], &sites[5]), ==, 0);
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

  g_assert_cmpuint (trace->facets[fixture_facet (fixture, 1, 2, 3)].seen, !=,
                    STEP_NEVER);
  g_assert_cmpuint (trace->facets[fixture_facet (fixture, 0, 1, 3)].seen, !=,
                    STEP_NEVER);
  while (loop[start] != trace_event (trace, row->first_horizon - 1).ridge[0])
    start += 1;
  for (guint i = 0; i < 4; i++) {
    const Event event = trace_event (trace, row->first_horizon - 1 + i);
    const guint tail = event.ridge[0], head = event.ridge[1];

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
  g_assert_true (fixture_ends_with (five, 0, 1, 4));
  g_assert_true (fixture_ends_with (five, 1, 2, 4));
  g_assert_true (fixture_ends_with (five, 2, 3, 4));
  g_assert_true (fixture_ends_with (five, 3, 0, 4));
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

  g_assert_true (fixture_ends_with (in, 0, 1, 3));
  g_assert_true (fixture_ends_with (in, 1, 2, 3));
  g_assert_true (fixture_ends_with (out, 0, 1, 2));
  g_assert_true (fixture_ends_with (out, 0, 2, 3));
  frame_init (&frame, tie->trace, tie->trace->n_events);
  g_assert_cmpuint (frame.delaunay.n_triangles, ==, 3);
  g_assert_cmpuint (frame.delaunay.n_groups, ==, 2);
  frame_clear (&frame);
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
        = fixture_facet (fixture, upper[i][0], upper[i][1], upper[i][2]);

    g_assert_true (
        fixture_ends_with (fixture, upper[i][0], upper[i][1], upper[i][2]));
    g_assert_cmpint (fixture->trace->facets[facet].facing, ==, FACING_UPPER);
    for (uint32_t site = 0; site < 8; site++)
      g_assert_cmpint (judge_circle (judge, upper[i], site), <=, 0);
  }
}

static void
test_wheel8 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("wheel8", ORDER_INPUT);
  static const guint n_visible[] = { 1, 2, 2, 5 };

  for (guint i = 0; i < 4; i++) {
    const RoundRow *row = &fixture->trace->rounds[i];
    const uint32_t facet
        = trace_event (fixture->trace, row->first_visible - 1).facet;

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
  ADD ("the-corners-of-the-hulls-are-known", test_corners);
  ADD ("lecture8-claims-each-site-once-though-it-sees-two-facets",
       test_lecture8_is_a_partition);
  ADD ("tie6-ties-exactly-and-takes-the-lower-index", test_tie6);
  ADD ("cross5-has-a-horizon-whose-shadow-crosses-itself", test_cross5);
  ADD ("square4-is-flat-and-square5-is-not", test_square);
  ADD ("flip5-flips-through-a-tie", test_flip5);
  ADD ("grid9-makes-and-loses-vertical-facets", test_grid9);
  ADD ("furthest8-has-three-circles-round-all-sites", test_furthest8);
  ADD ("wheel8-by-input-ends-with-five-lower-facets-seen", test_wheel8);
  return g_test_run ();
}
