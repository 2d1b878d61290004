#include "certify.h"

#include "fault.h"

#include <string.h>

static uint32_t *
standing_sites (Frame *frame, Facing facing)
{
  FacetRow *row = frame->trace->facets;

  while (row->span.death != STEP_NEVER || row->facing != facing)
    row += 1;
  return row->site;
}

static void
turn_lower_facet (Frame *frame)
{
  uint32_t *site = standing_sites (frame, FACING_LOWER);

  fault_swap (&site[0], &site[1]);
}

static void
turn_vertical_facet (Frame *frame)
{
  uint32_t *site = standing_sites (frame, FACING_VERTICAL);

  fault_swap (&site[1], &site[2]);
}

static void
turn_hull_inside_out (Frame *frame)
{
  for (uint32_t i = 0; i < frame->trace->n_facets; i += 1)
    fault_swap (&frame->trace->facets[i].site[0],
                &frame->trace->facets[i].site[1]);
}

static void
lose_facet (Frame *frame)
{
  frame->facets[0].roles = 0;
}

static void
repeat_facet (Frame *frame)
{
  frame->facets[1].facet = frame->facets[0].facet;
}

static void
put_facet_beyond_sites (Frame *frame)
{
  standing_sites (frame, FACING_UPPER)[0] = frame->trace->set->n_sites;
}

static void
put_facet_on_one_site_twice (Frame *frame)
{
  uint32_t *site = standing_sites (frame, FACING_UPPER);

  site[0] = site[1];
}

static bool
is_joined (const Frame *frame, uint32_t a, uint32_t b)
{
  for (uint32_t i = 0; i < frame->n_ridges; i += 1) {
    const uint32_t *site
        = trace_ridge (frame->trace, frame->ridges[i].ridge).site;

    if ((site[0] == a && site[1] == b) || (site[0] == b && site[1] == a))
      return true;
  }
  return false;
}

/* Moves a corner of the facet to a site that no ridge joins to the others. */
static void
tear_facet (Frame *frame)
{
  uint32_t *site = standing_sites (frame, FACING_LOWER);
  uint32_t far = 0;

  while (far == site[0] || far == site[1] || is_joined (frame, far, site[0])
         || is_joined (frame, far, site[1]))
    far += 1;
  g_assert_cmpuint (far, <, frame->trace->set->n_sites);
  site[2] = far;
}

/* Gives a ridge between facets of one facing, not coplanar, to the other
 * diagonal: the hull stays closed but is dented there. */
static void
flip_ridge (Frame *frame, Facing part)
{
  Trace *trace = (Trace *)frame->trace;

  for (uint32_t i = 0; i < frame->n_ridges; i += 1) {
    const RidgeRow row = trace_ridge (trace, frame->ridges[i].ridge);
    FacetRow *left = &trace->facets[row.facet[0]];
    FacetRow *right = &trace->facets[row.facet[1]];
    const uint32_t tail = row.site[0], head = row.site[1];
    uint32_t l, r;

    if (frame->ridges[i].is_coplanar || left->facing != part
        || right->facing != part)
      continue;
    g_assert_true (fault_has_edge (left->site, tail, head, &l));
    g_assert_true (fault_has_edge (right->site, head, tail, &r));
    memcpy (left->site, (uint32_t[]){ l, tail, r }, sizeof left->site);
    memcpy (right->site, (uint32_t[]){ l, r, head }, sizeof right->site);
    return;
  }
  g_assert_not_reached ();
}

static void
dent_lower_hull (Frame *frame)
{
  flip_ridge (frame, FACING_LOWER);
}

static void
dent_upper_hull (Frame *frame)
{
  flip_ridge (frame, FACING_UPPER);
}

static void
name_wrong_facing (Frame *frame)
{
  ((Trace *)frame->trace)->facets[frame->facets[0].facet].facing
      = FACING_VERTICAL;
}

static void
point_triangle_to_other_facet (Frame *frame)
{
  frame->delaunay.triangles[0].facet = frame->delaunay.triangles[1].facet;
}

static void
give_flat_triangle_facet (Frame *frame)
{
  frame->delaunay.triangles[0].facet = 1;
}

static const Fault faults[] = {
  { "flat-triangle-with-facet", "square4", "facet", give_flat_triangle_facet },
  { "hull-torn", "lecture8", "open", tear_facet },
  { "lower-facet-turned", "mixed8", "", turn_lower_facet },
  { "vertical-facet-turned", "grid9", "", turn_vertical_facet },
  { "hull-inside-out", "mixed8", "", turn_hull_inside_out },
  { "facet-missing", "mixed8", "cannot have 11 facets", lose_facet },
  { "facet-twice", "mixed8", "one side", repeat_facet },
  { "facet-beyond-sites", "mixed8", "none", put_facet_beyond_sites },
  { "facet-on-one-site-twice", "mixed8", "twice", put_facet_on_one_site_twice },
  { "lower-hull-dented", "lecture8", "dented", dent_lower_hull },
  { "upper-hull-dented", "furthest8", "dented", dent_upper_hull },
  { "facing-wrong", "mixed8", "faces elsewhere", name_wrong_facing },
  { "shadow-of-another-facet", "mixed8", "shadow",
    point_triangle_to_other_facet },
};

/* Every count that a person can compare with what is seen. */
static void
test_finds_every_miscount (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("grid9", ORDER_FURTHEST);
  Frame frame;
  FrameCounts *counts = &frame.counts;
  uint32_t *const certified[]
      = { &counts->n_inserted,    &counts->facets,
          &counts->lower,         &counts->upper,
          &counts->vertical,      &counts->triangles,
          &counts->rays,          &counts->delaunay_edges,
          &counts->voronoi_edges, &counts->voronoi_vertices };
  char why[CERTIFY_ROOM] = "";

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  for (size_t i = 0; i < G_N_ELEMENTS (certified); i += 1) {
    *certified[i] += 1;
    g_assert_false (certify_frame (&frame, why));
    g_assert_nonnull (strstr (why, "counted"));
    *certified[i] -= 1;
  }
  g_assert_true (certify_frame (&frame, why));
  frame_clear (&frame);
}

/* One facet of grid9 counted for another. */
static void
test_finds_facets_counted_for_others (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("grid9", ORDER_FURTHEST);
  char why[CERTIFY_ROOM] = "";
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  frame.counts.upper += 1;
  frame.counts.vertical -= 1;
  g_assert_false (certify_frame (&frame, why));
  frame_clear (&frame);
}

/* The hull of a whole fixture, in arrays that can be spoiled. */
static void
assert_active_refused (uint32_t index, uint32_t site, const char *words)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  uint32_t active[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  uint32_t facets[12][3], n = 0;
  char why[CERTIFY_ROOM] = "";

  for (uint32_t i = 0; i < trace->n_facets; i += 1)
    if (trace->facets[i].span.death == STEP_NEVER)
      memcpy (facets[n++], trace->facets[i].site, sizeof facets[0]);
  g_assert_true (certify_hull (fixture->set, (const uint32_t (*)[3])facets, 12,
                               active, 8, why));
  active[index] = site;
  g_assert_false (certify_hull (fixture->set, (const uint32_t (*)[3])facets, 12,
                                active, 8, why));
  g_assert_nonnull (strstr (why, words));
}

static void
test_finds_active_sites_that_are_not (void)
{
  assert_active_refused (0, 7, "not distinct");
  assert_active_refused (3, 8, "not distinct");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/certify/finds/every-miscount", test_finds_every_miscount);
  g_test_add_func ("/certify/finds/facets-counted-for-others",
                   test_finds_facets_counted_for_others);
  g_test_add_func ("/certify/finds/active-sites-that-are-not",
                   test_finds_active_sites_that_are_not);
  fault_add_tests (faults, G_N_ELEMENTS (faults));
  return g_test_run ();
}
