#include "fault.h"

#include <math.h>

static void
move_vertex (Frame *frame)
{
  frame->voronoi.vertices[0].at.x += 1e-7;
}

static void
lose_centre (Frame *frame)
{
  frame->voronoi.vertices[0].at.y = (double)NAN;
}

static void
lose_vertex (Frame *frame)
{
  frame->voronoi.n_vertices -= 1;
}

static void
give_vertex_other_triangle (Frame *frame)
{
  frame->voronoi.vertices[0].triangle = frame->voronoi.vertices[1].triangle;
}

static VoronoiEdge *
some_edge (Frame *frame, bool is_ray)
{
  VoronoiEdge *edge = frame->voronoi.edges;

  while ((edge->vertex[1] == INDEX_NONE) != is_ray)
    edge += 1;
  return edge;
}

static void
swap_ends (Frame *frame)
{
  VoronoiEdge *edge = some_edge (frame, false);

  fault_swap (&edge->vertex[0], &edge->vertex[1]);
}

static void
draw_edge_of_no_length (Frame *frame)
{
  VoronoiEdge *edge = some_edge (frame, false);

  edge->vertex[1] = edge->vertex[0];
}

static void
turn_ray_inwards (Frame *frame)
{
  VoronoiEdge *edge = some_edge (frame, true);

  edge->direction.x *= -1;
  edge->direction.y *= -1;
}

static void
bend_ray (Frame *frame)
{
  VoronoiEdge *edge = some_edge (frame, true);

  edge->direction.x += 1e-6;
  edge->direction.y += 2e-6;
}

static void
lose_direction (Frame *frame)
{
  some_edge (frame, true)->direction = (Site){ 0, 0 };
}

static void
shift_line (Frame *frame)
{
  some_edge (frame, true)->through.x += 1e-3;
}

static void
repeat_dual (Frame *frame)
{
  frame->voronoi.edges[1] = frame->voronoi.edges[0];
}

static void
lose_voronoi_edge (Frame *frame)
{
  frame->voronoi.n_edges -= 1;
}

static void
invent_ray (Frame *frame)
{
  frame->voronoi.n_rays += 1;
}

static void
list_edge_twice (Frame *frame)
{
  frame->voronoi.incident[1] = frame->voronoi.incident[0];
}

static void
list_edge_of_another_cell (Frame *frame)
{
  const Voronoi *voronoi = &frame->voronoi;

  fault_swap (&voronoi->incident[0],
              &voronoi->incident[2 * voronoi->n_edges - 1]);
}

static void
shift_cells (Frame *frame)
{
  frame->voronoi.start[1] += 1;
}

static void
lengthen_cells (Frame *frame)
{
  frame->voronoi.start[frame->n_sites] += 2;
}

static const Fault faults[] = {
  { "cells-too-long", "mixed8", "wrong number", lengthen_cells },
  { "vertex-moved", "mixed8", "centre", move_vertex },
  { "vertex-not-a-number", "mixed8", "centre", lose_centre },
  { "vertex-missing", "mixed8", "vertices", lose_vertex },
  { "vertex-of-another-triangle", "mixed8", "triangle",
    give_vertex_other_triangle },
  { "ends-swapped", "mixed8", "misplaced", swap_ends },
  { "edge-of-no-length", "mixed8", "", draw_edge_of_no_length },
  { "ray-inwards", "mixed8", "direction", turn_ray_inwards },
  { "ray-bent", "mixed8", "direction", bend_ray },
  { "ray-without-direction", "mixed8", "direction", lose_direction },
  { "line-bent", "line4", "direction", bend_ray },
  { "line-shifted", "line4", "nearer", shift_line },
  { "dual-twice", "mixed8", "dual", repeat_dual },
  { "voronoi-edge-missing", "mixed8", "edges", lose_voronoi_edge },
  { "ray-invented", "mixed8", "rays", invent_ray },
  { "cell-lists-edge-twice", "mixed8", "cell", list_edge_twice },
  { "cell-lists-edge-of-another", "mixed8", "cell", list_edge_of_another_cell },
  { "cells-shifted", "mixed8", "cell", shift_cells },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  fault_add_tests (faults, G_N_ELEMENTS (faults));
  return g_test_run ();
}
