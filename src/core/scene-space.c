#include "clip.h"
#include "memory.h"
#include "scene-builder.h"

#include <math.h>
#include <stdlib.h>

/* The paraboloid is drawn a little beyond the outermost site. */
#define RIM_MARGIN 1.05
#define RIM_LEAST 1.2
#define N_RINGS 5
#define N_MERIDIANS 12
#define MERIDIANS_DOWN 3 /* every third one goes down to the bottom */
#define N_ROUND 96       /* points of a ring */
#define N_UP 24          /* points of a meridian */
#define TURN 6.28318530717958647692

static const Object no_object = { OBJECT_NONE, 0 };

/* The ground's outline is drawn over the cells that it holds. */
static void
add_ground (SceneBuilder *builder, SceneShape shape)
{
  const double g = CAMERA_GROUND;
  const Point3 corners[4]
      = { { -g, -g, 0 }, { g, -g, 0 }, { g, g, 0 }, { -g, g, 0 } };
  const int n = shape == SHAPE_PATH ? 5 : 4;
  int i;

  scene_add (builder, shape, ROLE_GROUND, no_object);
  for (i = 0; i < n; i++)
    scene_add_point (builder, corners[i % 4]);
}

/* Sites that leave the square, while they are dragged, have no foot on the
 * ground that is shown; they keep their lift. */
static void
add_feet (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i;

  for (i = 0; i < frame->n_sites; i++) {
    const SiteState state = frame->sites[i].state;

    if (state != SITE_DUPLICATE)
      scene_add_mark (builder, state == SITE_APEX ? ROLE_FOOT_APEX : ROLE_FOOT,
                      (Object){ OBJECT_SITE, i }, scene_at (builder, i, false),
                      NULL);
  }
}

/* What of the plane is shown. */
static const Point3 box[2] = { { -CAMERA_GROUND, -CAMERA_GROUND, 0 },
                               { CAMERA_GROUND, CAMERA_GROUND, 0 } };

static void
add_plane (SceneBuilder *builder)
{
  SceneDiagram *diagram = scene_diagram_new (builder, box);

  builder->pass = PASS_GROUND;
  add_ground (builder, SHAPE_POLYGON);
  if (scene_has_layer (builder, LAYER_VORONOI))
    scene_add_cells (diagram);
  scene_add_furthest_cells (builder, box);
  add_ground (builder, SHAPE_PATH);
  scene_add_triangles (builder);
  if (scene_has_layer (builder, LAYER_VORONOI))
    scene_add_voronoi_edges (diagram);
  scene_add_circles (builder, box, false);
  scene_add_cone_shadow (builder);
  scene_add_delaunay_edges (builder);
  scene_add_seen_edges (builder);
  scene_add_furthest (builder, box);
  scene_add_circles (builder, box, true);
  scene_add_cone_edges (builder, false);
  scene_add_selected_facet (builder, false);
  scene_add_horizon (builder, false);
  scene_add_voronoi_vertices (diagram);
  add_feet (builder);
  scene_add_dying_vertices (diagram);
  builder->pass = PASS_OUTER;
  if (scene_has_layer (builder, LAYER_TANGENTS))
    scene_add_tangents (builder, diagram);
  scene_diagram_free (diagram);
}

double
scene_rim (const SceneBuilder *builder)
{
  double squared = 0;
  uint32_t i;

  for (i = 0; i < builder->frame->n_sites; i++) {
    const Point3 at = scene_at (builder, i, false);
    const double distance = at.x * at.x + at.y * at.y;

    squared = distance > squared ? distance : squared;
  }
  return fmax (RIM_LEAST, RIM_MARGIN * sqrt (squared));
}

static Pixel
direction_at (double angle)
{
  return (Pixel){ cos (angle), sin (angle) };
}

static void
add_sheet_point (SceneBuilder *builder, double radius, Pixel direction)
{
  scene_add_point (builder,
                   (Point3){ radius * direction.x, radius * direction.y,
                             builder->look->raise + radius * radius });
}

static void
add_ring (SceneBuilder *builder,
          Role role,
          double radius,
          const Pixel directions[N_ROUND])
{
  int i;

  scene_add (builder, SHAPE_PATH, role, no_object);
  for (i = 0; i <= N_ROUND; i++)
    add_sheet_point (builder, radius, directions[i % N_ROUND]);
}

/* All of them would meet in a speck at the bottom: most end at the first
 * ring. */
static void
add_meridian (SceneBuilder *builder, double rim, int number, Pixel direction)
{
  const double first = number % MERIDIANS_DOWN == 0 ? 0 : sqrt (1.0 / N_RINGS);
  int i = (int)(first * N_UP) + 1;

  scene_add (builder, SHAPE_PATH, ROLE_SHEET, no_object);
  add_sheet_point (builder, rim * first, direction);
  for (; i <= N_UP; i++)
    add_sheet_point (builder, rim * i / N_UP, direction);
}

/* Rings at equal heights. */
static void
add_sheet (SceneBuilder *builder)
{
  const double rim = scene_rim (builder);
  Pixel directions[N_ROUND];
  int i;

  for (i = 0; i < N_ROUND; i++)
    directions[i] = direction_at (TURN * i / N_ROUND);
  builder->pass = PASS_SHEET_FAR;
  for (i = 1; i < N_RINGS; i++)
    add_ring (builder, ROLE_SHEET, rim * sqrt ((double)i / N_RINGS),
              directions);
  for (i = 0; i < N_MERIDIANS; i++)
    add_meridian (builder, rim, i, direction_at (TURN * i / N_MERIDIANS));
  add_ring (builder, ROLE_RIM, rim, directions);
}

static const uint32_t *
facet_corners (const SceneBuilder *builder, uint32_t position)
{
  const Frame *frame = builder->frame;

  return frame->trace->facets[frame->facets[position].facet].site;
}

/* Returns: for each facet of the frame, by its number in the trace, the item
 *          of its polygon; free with free(). */
static uint32_t *
add_facets (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t *item_of = memory_room (frame->trace->n_facets, sizeof *item_of);
  uint32_t *order = scene_order (builder, frame->n_facets, 3, facet_corners);
  uint32_t i;

  for (i = 0; i < frame->n_facets; i++) {
    const FrameFacet *facet = &frame->facets[order[i]];
    const Role role = scene_facet_role (builder, facet->facet, facet->roles);

    item_of[facet->facet] = builder->scene->n_items;
    scene_add_polygon (builder, role, facet->facet, true);
  }
  free (order);
  return item_of;
}

static Role
ridge_role (const SceneBuilder *builder, const FrameRidge *ridge)
{
  const uint32_t left = scene_roles (builder, ridge->facet[0]);
  const uint32_t right = scene_roles (builder, ridge->facet[1]);

  if (left & right & FACET_RETIRED)
    return ROLE_RETIRED;
  if (((left & FACET_VISIBLE) && !(left & FACET_RETIRED))
      || ((right & FACET_VISIBLE) && !(right & FACET_RETIRED)))
    return ROLE_VISIBLE_EDGE;
  if (ridge->is_coplanar)
    return ROLE_FREE_EDGE;
  if (scene_is_new_apex (builder, ridge->site[0])
      || scene_is_new_apex (builder, ridge->site[1]))
    return ROLE_CONE_EDGE;
  return ROLE_RIDGE;
}

static bool
is_lower (const Frame *frame, uint32_t facet)
{
  return frame->trace->facets[facet].facing == FACING_LOWER;
}

static const uint32_t *
ridge_corners (const SceneBuilder *builder, uint32_t position)
{
  const Frame *frame = builder->frame;

  return frame->ridges[position].site;
}

static void
add_ridges (SceneBuilder *builder, const uint32_t *item_of)
{
  const Frame *frame = builder->frame;
  uint32_t *order = scene_order (builder, frame->n_ridges, 2, ridge_corners);
  uint32_t i;

  for (i = 0; i < frame->n_ridges; i++) {
    const FrameRidge *row = &frame->ridges[order[i]];
    SceneItem *item;

    scene_add_edge (builder, ridge_role (builder, row),
                    (Object){ OBJECT_RIDGE, row->ridge }, row->site, true);
    item = &builder->scene->items[builder->scene->n_items - 1];
    item->beside[0] = item_of[row->facet[0]];
    item->beside[1] = item_of[row->facet[1]];
    if (!is_lower (frame, row->facet[0]) && !is_lower (frame, row->facet[1]))
      item->fade = 1 - (1 - item->fade) * builder->look->lift;
  }
  free (order);
}

/* Ridges come in pairs of facets; while the first simplex is being made, the
 * outlines of its facets stand for them. */
static void
add_outlines (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i;
  int k;

  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t *site = scene_facet_sites (builder, frame->facets[i].facet);

    for (k = 0; k < 3; k++)
      scene_add_edge (builder, ROLE_RIDGE, no_object,
                      (uint32_t[2]){ site[k], site[(k + 1) % 3] }, true);
  }
}

static void
add_hull (SceneBuilder *builder)
{
  const bool is_whole
      = builder->frame->step >= builder->frame->trace->simplex_end;
  uint32_t *item_of = add_facets (builder);

  if (is_whole)
    add_ridges (builder, item_of);
  else
    add_outlines (builder);
  free (item_of);
}

/* The lifts of flat input lie in one plane: on a circle they make a polygon
 * cut into triangles, on a line a polygon in an upright plane. */
static void
add_flat (SceneBuilder *builder)
{
  const Delaunay *delaunay = &builder->frame->delaunay;
  uint32_t i;

  for (i = 0; i < delaunay->n_triangles; i++)
    scene_add_polygon (builder, ROLE_LOWER, i, true)->is_two_sided = true;
  if (delaunay->dimension == 1 && delaunay->n_boundary > 2) {
    scene_add (builder, SHAPE_POLYGON, ROLE_VERTICAL, no_object)->is_two_sided
        = true;
    for (i = 0; i < delaunay->n_boundary; i++)
      scene_add_point (builder,
                       scene_at (builder, delaunay->boundary[i], true));
  }
  for (i = 0; i < delaunay->n_edges; i++)
    scene_add_edge (builder,
                    delaunay->edges[i].is_free ? ROLE_FREE_EDGE : ROLE_RIDGE,
                    (Object){ OBJECT_RIDGE, i }, delaunay->edges[i].site, true);
}

static Role
lift_role (SiteState state)
{
  if (state == SITE_APEX)
    return ROLE_LIFT_APEX;
  return state == SITE_OUTSIDE ? ROLE_LIFT_OUTSIDE : ROLE_LIFT;
}

static void
add_lifts (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i;

  for (i = 0; i < frame->n_sites; i++) {
    const SiteState state = frame->sites[i].state;
    const Point3 ends[2]
        = { scene_at (builder, i, false), scene_at (builder, i, true) };

    if (state != SITE_DUPLICATE
        && (state == SITE_APEX || scene_has_layer (builder, LAYER_LIFTS)))
      scene_add_segment (builder, lift_role (state), (Object){ OBJECT_SITE, i },
                         ends);
  }
}

static Point3
normal_of (const Point3 corners[3])
{
  const Point3 a = corners[0], b = corners[1], c = corners[2];
  const Point3 d = { b.x - a.x, b.y - a.y, b.z - a.z };
  const Point3 e = { c.x - a.x, c.y - a.y, c.z - a.z };

  return (Point3){ d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z,
                   d.x * e.y - d.y * e.x };
}

/* The foot of the perpendicular from @lift on the plane with a corner @a and a
 * normal: distances to one facet order the sites as QuickHull does. */
static Point3
drop_foot (Point3 a, Point3 normal, Point3 lift)
{
  const double gap = (lift.x - a.x) * normal.x + (lift.y - a.y) * normal.y
                     + (lift.z - a.z) * normal.z;
  const double part
      = gap / (normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);

  return (Point3){ lift.x - part * normal.x, lift.y - part * normal.y,
                   lift.z - part * normal.z };
}

/* Where there are more sites than this, their marks are small, and what lies
 * beside one could be another's. */
#define FEW_SITES 40

/* The way to the eye, at home. */
static const Point3 home = { 0.325, -0.894, 0.309 };

/* Ticks lie in the plane, and are seen in full from home, upright on what they
 * are ticks of. */
static Point3
across_of (Point3 normal)
{
  return (Point3){ normal.y * home.z - normal.z * home.y,
                   normal.z * home.x - normal.x * home.z,
                   normal.x * home.y - normal.y * home.x };
}

/* Of several measures one that is put aside could meet another. */
static void
add_drop (SceneBuilder *builder, uint32_t facet, uint32_t site, bool is_only)
{
  const uint32_t *corner = scene_facet_sites (builder, facet);
  const Point3 corners[3] = { scene_at (builder, corner[0], true),
                              scene_at (builder, corner[1], true),
                              scene_at (builder, corner[2], true) };
  const Point3 lift = scene_at (builder, site, true);
  const Point3 normal = normal_of (corners);
  const Point3 foot = drop_foot (corners[0], normal, lift);
  Point3 ends[2] = { lift, foot };

  if (!isfinite (foot.x) || !isfinite (foot.y) || !isfinite (foot.z))
    return;
  if (is_only && builder->frame->n_sites <= FEW_SITES)
    scene_put_aside (ends, across_of (normal), home);
  scene_add_measure (builder, no_object, ends, across_of (normal));
}

static bool
has_drop (const SceneBuilder *builder, uint32_t site)
{
  const SiteState state = builder->frame->sites[site].state;

  return state == SITE_OUTSIDE || state == SITE_APEX;
}

static void
add_drops (SceneBuilder *builder)
{
  const uint32_t facet = scene_selected_facet (builder);
  const Frame *frame = builder->frame;
  uint32_t i, n = 0;

  if (facet == INDEX_NONE)
    return;
  if (builder->event->kind == EVENT_CLAIM) {
    add_drop (builder, facet, builder->event->site, true);
    return;
  }
  for (i = 0; i < frame->n_sites; i++)
    n += has_drop (builder, i);
  for (i = 0; i < frame->n_sites; i++)
    if (has_drop (builder, i))
      add_drop (builder, facet, i, n == 1);
}

static void
add_marks (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i, k;

  /* The current site is drawn last, over all others. */
  for (k = 0; k < 2; k++)
    for (i = 0; i < frame->n_sites; i++) {
      const SiteState state = frame->sites[i].state;

      if (state != SITE_DUPLICATE && (state == SITE_APEX) == (k == 1))
        scene_add_site (builder, i, true);
    }
}

void
scene_add_pointed_space (SceneBuilder *builder)
{
  builder->pass = PASS_GROUND;
  scene_add_lit_circles (builder, box);
  scene_add_lit_facets (builder, false);
  scene_add_preview (builder, box);
  builder->pass = PASS_OUTER;
  scene_add_why_plane (builder);
  builder->pass = PASS_LINES;
  scene_add_lit_facets (builder, true);
  scene_add_why (builder, true);
  scene_add_preview_lift (builder);
  builder->pass = PASS_MARKS;
  scene_add_selected_name (builder, true);
}

void
scene_space (Scene *scene, const Frame *frame, const SceneLook *look)
{
  SceneBuilder builder;

  scene_builder_init (&builder, scene, frame, look);
  scene->is_space = true;
  add_plane (&builder);
  if (scene_has_layer (&builder, LAYER_PARABOLOID))
    add_sheet (&builder);
  builder.pass = PASS_HULL;
  if (scene_has_layer (&builder, LAYER_HULL)) {
    if (frame->trace->is_flat)
      add_flat (&builder);
    else
      add_hull (&builder);
  }
  builder.pass = PASS_LINES;
  add_lifts (&builder);
  add_drops (&builder);
  scene_add_cone_edges (&builder, true);
  scene_add_selected_facet (&builder, true);
  scene_add_horizon (&builder, true);
  builder.pass = PASS_MARKS;
  add_marks (&builder);
  scene_add_step_name (&builder, true);
  scene_add_answers (&builder, true);
  scene_light (&builder);
  scene_add_pointed_space (&builder);
  scene_builder_clear (&builder);
}
