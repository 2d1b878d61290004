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

/* Gives a ridge between facets of one facing, not coplanar, to the other
 * diagonal: the hull stays closed but is dented there. */
static void
flip_ridge (Frame *frame, Facing part)
{
  Trace *trace = (Trace *)frame->trace;

  for (uint32_t i = 0; i < frame->n_ridges; i += 1) {
    const RidgeRow *row = &trace->ridges[frame->ridges[i].ridge];
    FacetRow *left = &trace->facets[row->facet[0]];
    FacetRow *right = &trace->facets[row->facet[1]];
    const uint32_t tail = row->site[0], head = row->site[1];
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

/* Counts. */

static void
miscount_lower (Frame *frame)
{
  frame->counts.lower += 1;
  frame->counts.upper -= 1;
}

static void
miscount_rays (Frame *frame)
{
  frame->counts.rays += 1;
}

static void
miscount_sites (Frame *frame)
{
  frame->counts.n_inserted -= 1;
}

static void
point_triangle_to_other_facet (Frame *frame)
{
  frame->delaunay.triangles[0].facet = frame->delaunay.triangles[1].facet;
}

static const Fault faults[] = {
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
  { "lower-facets-miscounted", "mixed8", "lower", miscount_lower },
  { "rays-miscounted", "mixed8", "rays", miscount_rays },
  { "sites-miscounted", "mixed8", "sites", miscount_sites },
  { "shadow-of-another-facet", "mixed8", "shadow",
    point_triangle_to_other_facet },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  fault_add_tests (faults, G_N_ELEMENTS (faults));
  return g_test_run ();
}
