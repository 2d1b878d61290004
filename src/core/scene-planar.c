#include "planar-frame.h"
#include "scene-builder.h"

#include <math.h>

#define NO_OBJECT ((Object){ OBJECT_NONE, 0 })

typedef struct PlanarScene {
  SceneBuilder builder;
  const PlanarFrame *frame;
} PlanarScene;

static Point3
at (const PlanarScene *planar, uint32_t site)
{
  return scene_point (planar->builder.look,
                      &planar->frame->trace->set->sites[site], false);
}

static const PlanarEdge *
row_of (const PlanarScene *planar, uint32_t edge)
{
  return &planar->frame->trace->edges[edge];
}

static void
add_edge (PlanarScene *planar, Role role, const uint32_t corner[2])
{
  const Point3 ends[2] = { at (planar, corner[0]), at (planar, corner[1]) };

  scene_add_segment (&planar->builder, role, NO_OBJECT, ends);
}

static void
add_area (PlanarScene *planar)
{
  const PlanarFrame *frame = planar->frame;
  uint32_t i;

  if (frame->n_corners < 3)
    return;
  scene_add (&planar->builder, SHAPE_POLYGON, ROLE_HULL_AREA, NO_OBJECT);
  for (i = 0; i < frame->n_corners; i++)
    scene_add_point (&planar->builder, at (planar, frame->corners[i]));
}

/* What the hull gains: a triangle from the corners of the horizon to the
 * current site, of which the hull hides what it has already. One for each
 * visible edge would be parted by seams. */
static void
add_gain (PlanarScene *planar)
{
  const PlanarFrame *frame = planar->frame;
  int k;

  if (frame->counts.cone < 2 || frame->base == frame->step)
    return;
  scene_add (&planar->builder, SHAPE_POLYGON, ROLE_CONE, NO_OBJECT);
  for (k = 0; k < 2; k++)
    scene_add_point (&planar->builder, at (planar, frame->horizon[k]));
  scene_add_point (&planar->builder,
                   at (planar, frame->trace->rounds[frame->round].site));
}

static Role
edge_role (uint32_t roles)
{
  if (roles & FACET_RETIRED)
    return ROLE_RETIRED;
  if (roles & FACET_VISIBLE)
    return ROLE_VISIBLE_EDGE;
  return roles & (FACET_CONE | FACET_NEW) ? ROLE_CONE_EDGE : ROLE_HULL_EDGE;
}

static void
add_edges (PlanarScene *planar)
{
  const PlanarFrame *frame = planar->frame;
  uint32_t i;

  for (i = 0; i < frame->n_edges; i++)
    add_edge (planar, edge_role (frame->edges[i].roles),
              row_of (planar, frame->edges[i].edge)->corner);
  if (frame->n_edges == 0 && frame->n_corners == 2)
    add_edge (planar, ROLE_HULL_EDGE, frame->corners);
}

/* The edge whose outer side the step is about, or INDEX_NONE. */
static uint32_t
current_edge (const PlanarFrame *frame)
{
  const Phase phase = frame->place.phase;

  return phase == PHASE_CHOOSE || phase == PHASE_SEE
             ? frame->trace->events[frame->step - 1].edge
             : INDEX_NONE;
}

/* Narrows span[0] … span[1], the part of a line that is shown, to where the
 * coordinate at + t by lies between low and high. */
static void
narrow (double at, double by, const double ends[2], double span[2])
{
  const double t[2] = { (ends[0] - at) / by, (ends[1] - at) / by };

  if (by == 0)
    return;
  span[0] = fmax (span[0], fmin (t[0], t[1]));
  span[1] = fmin (span[1], fmax (t[0], t[1]));
}

/* All along the line of an edge: what lies beyond it sees the edge. */
static void
add_line (PlanarScene *planar, uint32_t edge)
{
  const SceneLook *look = planar->builder.look;
  const uint32_t *corner = row_of (planar, edge)->corner;
  const Point3 a = at (planar, corner[0]), b = at (planar, corner[1]);
  const double dx = b.x - a.x, dy = b.y - a.y;
  double span[2] = { -HUGE_VAL, HUGE_VAL };

  narrow (a.x, dx, (const double[]){ look->low.x, look->high.x }, span);
  narrow (a.y, dy, (const double[]){ look->low.y, look->high.y }, span);
  if (!(span[0] < span[1]) || !isfinite (span[0]) || !isfinite (span[1]))
    return;
  scene_add_segment (
      &planar->builder, ROLE_EDGE_LINE, NO_OBJECT,
      (Point3[2]){ { a.x + span[0] * dx, a.y + span[0] * dy, 0 },
                   { a.x + span[1] * dx, a.y + span[1] * dy, 0 } });
}

/* The distance of an outside site from the edge, to its foot on the line. */
static void
add_drop (PlanarScene *planar, uint32_t edge, uint32_t site)
{
  const uint32_t *corner = row_of (planar, edge)->corner;
  const Point3 a = at (planar, corner[0]), b = at (planar, corner[1]);
  const Point3 p = at (planar, site);
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / square;
  const Point3 foot = { a.x + along * dx, a.y + along * dy, 0 };

  if (square > 0)
    scene_add_measure (&planar->builder, (Object){ OBJECT_SITE, site },
                       (Point3[2]){ p, foot }, (Point3){ dx, dy, 0 });
}

/* The choice: the current edge, and how far its outside sites are from it. */
static void
add_choice (PlanarScene *planar)
{
  const PlanarFrame *frame = planar->frame;
  const uint32_t edge = current_edge (frame);
  uint32_t i;

  if (edge == INDEX_NONE || frame->place.phase != PHASE_CHOOSE)
    return;
  for (i = 0; i < frame->n_sites; i++)
    if (frame->sites[i].state == SITE_OUTSIDE
        || frame->sites[i].state == SITE_APEX)
      add_drop (planar, edge, i);
  add_edge (planar, ROLE_SELECTED_FACET, row_of (planar, edge)->corner);
}

static void
add_horizon (PlanarScene *planar)
{
  const PlanarFrame *frame = planar->frame;
  uint32_t i;

  for (i = 0; i < frame->counts.horizon; i++)
    scene_add_mark (&planar->builder, ROLE_HORIZON_CORNER,
                    (Object){ OBJECT_SITE, frame->horizon[i] },
                    at (planar, frame->horizon[i]), NULL);
}

static void
add_site (PlanarScene *planar, uint32_t site)
{
  scene_add_mark (&planar->builder,
                  scene_site_role (planar->frame->sites[site].state),
                  (Object){ OBJECT_SITE, site }, at (planar, site),
                  scene_label (&planar->builder, 's', site));
}

/* The current site is drawn last, over all others. */
static void
add_sites (PlanarScene *planar)
{
  const PlanarFrame *frame = planar->frame;
  uint32_t i, apex = INDEX_NONE;

  for (i = 0; i < frame->n_sites; i++) {
    if (frame->sites[i].state == SITE_APEX)
      apex = i;
    else
      add_site (planar, i);
  }
  if (apex != INDEX_NONE)
    add_site (planar, apex);
}

/* The edge that the last event told of bears its name. */
static void
add_name (PlanarScene *planar)
{
  const PlanarFrame *frame = planar->frame;
  const uint32_t edge = frame->step > 0
                            ? frame->trace->events[frame->step - 1].edge
                            : INDEX_NONE;
  Point3 a, b;

  if (edge == INDEX_NONE)
    return;
  a = at (planar, row_of (planar, edge)->corner[0]);
  b = at (planar, row_of (planar, edge)->corner[1]);
  scene_add_mark (&planar->builder, ROLE_FACET_NAME, NO_OBJECT,
                  (Point3){ (a.x + b.x) / 2, (a.y + b.y) / 2, 0 },
                  scene_label (&planar->builder, 'e', edge));
}

void
scene_planar (Scene *scene, const PlanarFrame *frame, const SceneLook *look)
{
  PlanarScene planar = { .frame = frame };
  SceneBuilder *builder = &planar.builder;

  scene_builder_open (builder, scene, look, frame->n_sites + 1);
  if (frame->is_in_round)
    scene_builder_round (builder, frame->place.phase);
  scene->is_space = false;
  builder->pass = PASS_GROUND;
  scene_add_frame (builder);
  add_gain (&planar);
  add_area (&planar);
  if (current_edge (frame) != INDEX_NONE)
    add_line (&planar, current_edge (frame));
  add_edges (&planar);
  add_choice (&planar);
  builder->pass = PASS_MARKS;
  add_horizon (&planar);
  add_sites (&planar);
  add_name (&planar);
  scene_light (builder);
}
