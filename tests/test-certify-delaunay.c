#include "certify.h"

#include "fault.h"

#include <string.h>

static void
turn_triangle (Frame *frame)
{
  uint32_t *site = frame->delaunay.triangles[0].site;

  fault_swap (&site[0], &site[1]);
}

static void
lose_triangle (Frame *frame)
{
  frame->delaunay.n_triangles -= 1;
}

static void
repeat_triangle (Frame *frame)
{
  frame->delaunay.triangles[1] = frame->delaunay.triangles[0];
}

/* Gives the one inner edge of two triangles its other, wrong diagonal, and
 * all else that goes with it. */
static void
flip_edge (Frame *frame)
{
  Delaunay *delaunay = &frame->delaunay;
  Triangle *left, *right;
  DelaunayEdge *edge = delaunay->edges;
  uint32_t l, r, tail, head;

  g_assert_cmpuint (delaunay->n_triangles, ==, 2);
  while (edge->triangle[1] == INDEX_NONE)
    edge += 1;
  tail = edge->site[0];
  head = edge->site[1];
  left = &delaunay->triangles[edge->triangle[0]];
  right = &delaunay->triangles[edge->triangle[1]];
  g_assert_true (fault_has_edge (left->site, tail, head, &l));
  g_assert_true (fault_has_edge (right->site, head, tail, &r));
  *left = (Triangle){
    { r, l, tail }, { edge->triangle[1], INDEX_NONE, INDEX_NONE }, 0, 0
  };
  *right = (Triangle){
    { l, r, head }, { edge->triangle[0], INDEX_NONE, INDEX_NONE }, 1, 1
  };
}

/* Takes the last triangle away and all traces of it in the others. */
static void
cut_out_triangle (Frame *frame)
{
  Delaunay *delaunay = &frame->delaunay;
  const uint32_t last = delaunay->n_triangles - 1;

  for (uint32_t i = 0; i < 3 * last; i += 1) {
    uint32_t *neighbour = &delaunay->triangles[i / 3].neighbour[i % 3];

    if (*neighbour == last)
      *neighbour = INDEX_NONE;
  }
  delaunay->n_triangles = last;
}

static void
forget_site (Frame *frame)
{
  frame->delaunay.n_active -= 1;
}

static void
activate_duplicate (Frame *frame)
{
  frame->delaunay.active[frame->delaunay.n_active - 1]
      = frame->trace->set->n_sites - 1;
}

static void
forget_neighbour (Frame *frame)
{
  uint32_t *neighbour = frame->delaunay.triangles[0].neighbour;

  neighbour[0] = neighbour[0] == INDEX_NONE ? 1 : INDEX_NONE;
}

static void
split_group (Frame *frame)
{
  Delaunay *delaunay = &frame->delaunay;

  delaunay->triangles[delaunay->n_triangles - 1].group = delaunay->n_groups;
  delaunay->n_groups += 1;
}

static void
merge_groups (Frame *frame)
{
  Delaunay *delaunay = &frame->delaunay;

  for (uint32_t i = 0; i < delaunay->n_triangles; i += 1)
    if (delaunay->triangles[i].group == delaunay->n_groups - 1)
      delaunay->triangles[i].group = 0;
}

static void
invent_group (Frame *frame)
{
  frame->delaunay.n_groups += 1;
}

static void
free_edge (Frame *frame)
{
  frame->delaunay.edges[0].is_free ^= true;
}

static void
swap_sides_of_edge (Frame *frame)
{
  uint32_t *side = frame->delaunay.edges[0].triangle;

  fault_swap (&side[0], &side[1]);
}

static void
repeat_edge (Frame *frame)
{
  frame->delaunay.edges[1] = frame->delaunay.edges[0];
}

static void
swap_on_boundary (Frame *frame)
{
  fault_swap (&frame->delaunay.boundary[0], &frame->delaunay.boundary[1]);
}

static void
shorten_boundary (Frame *frame)
{
  frame->delaunay.n_boundary -= 1;
}

static void
miscount_extreme (Frame *frame)
{
  frame->delaunay.n_extreme -= 1;
}

static void
raise_lift_dimension (Frame *frame)
{
  frame->delaunay.lift_dimension = 5 - frame->delaunay.lift_dimension;
}

static void
lower_dimension (Frame *frame)
{
  frame->delaunay.dimension -= 1;
}

static void
lose_edge (Frame *frame)
{
  frame->delaunay.n_edges -= 1;
}

static void
swap_segments (Frame *frame)
{
  const DelaunayEdge first = frame->delaunay.edges[0];

  frame->delaunay.edges[0] = frame->delaunay.edges[1];
  frame->delaunay.edges[1] = first;
}

static void
swap_active (Frame *frame)
{
  fault_swap (&frame->delaunay.active[0], &frame->delaunay.active[1]);
}

static void
turn_all_triangles (Frame *frame)
{
  for (uint32_t i = 0; i < frame->delaunay.n_triangles; i += 1) {
    Triangle *triangle = &frame->delaunay.triangles[i];

    fault_swap (&triangle->site[0], &triangle->site[1]);
    fault_swap (&triangle->neighbour[1], &triangle->neighbour[2]);
  }
}

static void
put_triangle_beyond_groups (Frame *frame)
{
  frame->delaunay.triangles[0].group = 1000000;
}

static void
swap_sides_of_inner_edge (Frame *frame)
{
  DelaunayEdge *edge = frame->delaunay.edges;

  while (edge->triangle[1] == INDEX_NONE)
    edge += 1;
  fault_swap (&edge->triangle[0], &edge->triangle[1]);
}

static void
put_boundary_beyond_sites (Frame *frame)
{
  frame->delaunay.boundary[0] = 1000000;
}

static void
give_segment_triangle (Frame *frame)
{
  frame->delaunay.edges[0].triangle[0] = 0;
}

static const Fault faults[] = {
  { "active-sites-disordered", "lecture8", "ascend", swap_active },
  { "all-triangles-turned", "lecture8", "turn left", turn_all_triangles },
  { "circle-group-beyond", "lecture8", "group", put_triangle_beyond_groups },
  { "inner-edge-swapped", "lecture8", "misplaced", swap_sides_of_inner_edge },
  { "line-beyond-sites", "line4", "none", put_boundary_beyond_sites },
  { "line-with-triangle", "line4", "triangle", give_segment_triangle },
  { "line-called-solid", "line4", "lifts", raise_lift_dimension },
  { "line-with-circle-group", "line4", "groups", invent_group },
  { "line-extreme-miscounted", "line4", "extreme", miscount_extreme },
  { "triangle-turned", "lecture8", "", turn_triangle },
  { "triangle-missing", "lecture8", "", lose_triangle },
  { "triangle-twice", "lecture8", "one side", repeat_triangle },
  { "diagonal-flipped", "mwt4", "contains", flip_edge },
  { "notch-in-the-border", "inner4", "turns right", cut_out_triangle },
  { "active-site-missing", "mixed8", "corners", forget_site },
  { "duplicate-active", "duplicates", "duplicate", activate_duplicate },
  { "neighbour-wrong", "lecture8", "neighbour", forget_neighbour },
  { "circle-group-split", "square4", "circle groups", split_group },
  { "circle-groups-merged", "lecture8", "circle groups", merge_groups },
  { "circle-group-invented", "lecture8", "circle groups", invent_group },
  { "edge-wrongly-free", "lecture8", "free", free_edge },
  { "edge-sides-swapped", "lecture8", "", swap_sides_of_edge },
  { "edge-twice", "lecture8", "twice", repeat_edge },
  { "edge-missing", "lecture8", "edges", lose_edge },
  { "boundary-disordered", "lecture8", "boundary", swap_on_boundary },
  { "boundary-short", "lecture8", "boundary", shorten_boundary },
  { "extreme-miscounted", "grid9", "extreme", miscount_extreme },
  { "flat-lifts-called-solid", "square4", "lifts", raise_lift_dimension },
  { "solid-lifts-called-flat", "mixed8", "lifts", raise_lift_dimension },
  { "plane-called-line", "square4", "triangles", lower_dimension },
  { "line-called-point", "line4", "dimension", lower_dimension },
  { "line-disordered", "line4", "line", swap_on_boundary },
  { "segment-missing", "line4", "segments", lose_edge },
  { "segments-swapped", "line4", "segment", swap_segments },
};

/* Five triangles round the middle of a pentagon that join every second corner
 * are locally Delaunay and have a border without right turns; but they cover
 * the plane twice. */
static void
test_finds_double_cover (void)
{
  const Site pentagram[] = { { 0, 0 },    { 100, 0 }, { -81, 59 },
                             { 31, -95 }, { 31, 95 }, { -81, -59 } };
  SiteSet *set = site_set_new (pentagram, 6);
  Triangle triangles[5];
  char why[CERTIFY_ROOM];
  Delaunay delaunay = { .set = set,
                        .dimension = 2,
                        .lift_dimension = 3,
                        .active = (uint32_t[]){ 0, 1, 2, 3, 4, 5 },
                        .n_active = 6,
                        .triangles = triangles,
                        .n_triangles = 5,
                        .n_groups = 5 };

  for (uint32_t i = 0; i < 5; i += 1)
    triangles[i] = (Triangle){ { 0, i + 1, (i + 1) % 5 + 1 },
                               { (i + 4) % 5, INDEX_NONE, (i + 1) % 5 },
                               i,
                               i };
  g_assert_false (certify_delaunay (&delaunay, why));
  g_assert_cmpstr (why, ==, "the border winds more than once");
  site_set_free (set);
}

/* Checks that a triangulation of @sites made by hand is refused. */
static void
assert_refused (Delaunay *delaunay,
                const Site *sites,
                uint32_t n_sites,
                const char *expected)
{
  SiteSet *set = site_set_new (sites, n_sites);
  char why[CERTIFY_ROOM];

  delaunay->set = set;
  g_assert_false (certify_delaunay (delaunay, why));
  g_assert_cmpstr (why, ==, expected);
  site_set_free (set);
}

static void
test_finds_two_islands (void)
{
  const Site sites[]
      = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 9, 0 }, { 10, 0 }, { 9, 1 } };
  Triangle triangles[] = {
    { { 0, 1, 2 }, { INDEX_NONE, INDEX_NONE, INDEX_NONE }, 0, 0 },
    { { 3, 4, 5 }, { INDEX_NONE, INDEX_NONE, INDEX_NONE }, 1, 1 },
  };
  Delaunay delaunay = { .dimension = 2,
                        .lift_dimension = 3,
                        .active = (uint32_t[]){ 0, 1, 2, 3, 4, 5 },
                        .n_active = 6,
                        .triangles = triangles,
                        .n_triangles = 2,
                        .n_groups = 2 };

  assert_refused (&delaunay, sites, 6, "the border is not one loop");
}

/* Two segments along a boundary of three, said to be sites 0, 1, 2. */
static Delaunay
line_by_hand (uint32_t *boundary, DelaunayEdge *edges)
{
  static uint32_t active[] = { 0, 1, 2 };

  for (uint32_t i = 0; i < 2; i += 1)
    edges[i] = (DelaunayEdge){ { boundary[i], boundary[i + 1] },
                               { INDEX_NONE, INDEX_NONE },
                               false };
  return (Delaunay){ .dimension = 1,
                     .lift_dimension = 2,
                     .active = active,
                     .n_active = 3,
                     .boundary = boundary,
                     .n_boundary = 3,
                     .n_extreme = 2,
                     .edges = edges,
                     .n_edges = 2 };
}

static void
test_finds_bent_line (void)
{
  const Site sites[] = { { 0, 0 }, { 1, 0.125 }, { 2, 0 } };
  uint32_t boundary[] = { 0, 1, 2 };
  DelaunayEdge edges[2];
  Delaunay delaunay = line_by_hand (boundary, edges);

  assert_refused (&delaunay, sites, 3, "s1 is not on the line");
}

static void
test_finds_line_of_other_sites (void)
{
  const Site sites[] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 } };
  uint32_t boundary[] = { 0, 1, 3 };
  DelaunayEdge edges[2];
  Delaunay delaunay = line_by_hand (boundary, edges);

  assert_refused (&delaunay, sites, 4, "s2 is not on the line");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/certify/finds/double-cover", test_finds_double_cover);
  g_test_add_func ("/certify/finds/two-islands", test_finds_two_islands);
  g_test_add_func ("/certify/finds/bent-line", test_finds_bent_line);
  g_test_add_func ("/certify/finds/line-of-other-sites",
                   test_finds_line_of_other_sites);
  fault_add_tests (faults, G_N_ELEMENTS (faults));
  return g_test_run ();
}
