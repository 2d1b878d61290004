/* What stands in the plane: the triangulation and the shadows of the current
 * round; and what is drawn alike in the plane and in space. */
#include "memory.h"
#include "scene-builder.h"

#include <stdlib.h>

uint32_t *
scene_roles_new (const Frame *frame)
{
  uint32_t *roles = memory_new (frame->trace->n_facets, sizeof *roles);
  uint32_t i;

  for (i = 0; i < frame->n_facets; i++)
    roles[frame->facets[i].facet] = frame->facets[i].roles;
  return roles;
}

uint32_t
scene_roles (const SceneBuilder *builder, uint32_t facet)
{
  const Trace *trace = builder->frame->trace;

  if (trace->is_flat)
    return FACET_STANDS;
  if (builder->roles == NULL)
    return frame_facet_roles (builder->frame, facet);
  return facet < trace->n_facets ? builder->roles[facet] : 0;
}

static const RoundRow *
round_of (const SceneBuilder *builder)
{
  return &builder->frame->trace->rounds[builder->frame->round];
}

bool
scene_is_new_apex (const SceneBuilder *builder, uint32_t site)
{
  return builder->is_round && !(builder->look->mask & MASK_ROUND)
         && builder->frame->base == builder->frame->step
         && round_of (builder)->site == site;
}

/* Whether a facet of the cone is still on its way to the apex. */
static bool
is_growing (const SceneBuilder *builder, uint32_t facet)
{
  const SceneLook *look = builder->look;

  return look->moving > 0 && builder->is_round
         && (scene_roles (builder, facet) & FACET_CONE)
         && builder->frame->trace->facets[facet].span.birth > look->since;
}

static Point3
between (Point3 from, Point3 to, double part)
{
  return (Point3){ from.x + part * (to.x - from.x),
                   from.y + part * (to.y - from.y),
                   from.z + part * (to.z - from.z) };
}

/* Moves the apex of a growing facet back towards its ridge. */
static void
hold_apex (const SceneBuilder *builder, const uint32_t site[3], Point3 at[3])
{
  const uint32_t apex = round_of (builder)->site;
  int k = 0;

  while (k < 2 && site[k] != apex)
    k++;
  at[k] = between (at[k], between (at[(k + 1) % 3], at[(k + 2) % 3], 0.5),
                   builder->look->moving);
}

/* Facets and edges begin at their lowest site, whatever made them:
 * scene-order.c. */
static int
first_corner (const uint32_t site[3])
{
  if (site[0] < site[1])
    return site[0] < site[2] ? 0 : 2;
  return site[1] < site[2] ? 1 : 2;
}

SceneItem *
scene_add_polygon (SceneBuilder *builder,
                   Role role,
                   uint32_t facet,
                   bool lifted)
{
  const uint32_t *corner = scene_facet_sites (builder, facet);
  const int first = first_corner (corner);
  const uint32_t site[3]
      = { corner[first], corner[(first + 1) % 3], corner[(first + 2) % 3] };
  Point3 at[3];
  int k;

  for (k = 0; k < 3; k++)
    at[k] = scene_at (builder, site[k], lifted);
  if (is_growing (builder, facet))
    hold_apex (builder, site, at);
  scene_add (builder, SHAPE_POLYGON, role, (Object){ OBJECT_FACET, facet });
  scene_add_points (builder, at, 3);
  return &builder->scene->items[builder->scene->n_items - 1];
}

void
scene_add_edge (SceneBuilder *builder,
                Role role,
                Object object,
                const uint32_t site[2],
                bool lifted)
{
  const int first = site[1] < site[0];

  scene_add_segment (builder, role, object,
                     (Point3[2]){ scene_at (builder, site[first], lifted),
                                  scene_at (builder, site[!first], lifted) });
}

/* While the first simplex is being made, there is no triangulation yet, only
 * the facets so far. */
static void
add_simplex_shadow (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i;
  int k;

  for (i = 0; i < frame->n_facets; i++) {
    const FacetRow *row = &frame->trace->facets[frame->facets[i].facet];

    if (row->facing != FACING_LOWER)
      continue;
    scene_add_polygon (builder, ROLE_TRIANGLE, frame->facets[i].facet, false);
    for (k = 0; k < 3; k++)
      scene_add_edge (builder, ROLE_DELAUNAY_EDGE, (Object){ OBJECT_NONE, 0 },
                      (uint32_t[2]){ row->site[k], row->site[(k + 1) % 3] },
                      false);
  }
}

/* The role of a triangle; a standing one has no look of its own. */
static Role
triangle_role (const SceneBuilder *builder, uint32_t facet)
{
  Role role;

  if (builder->frame->trace->is_flat)
    return ROLE_TRIANGLE;
  role = scene_facet_role (builder, facet, scene_roles (builder, facet));
  return role == ROLE_LOWER ? ROLE_TRIANGLE : role;
}

void
scene_add_triangles (SceneBuilder *builder)
{
  const Delaunay *delaunay = &builder->frame->delaunay;
  const bool has_layer = scene_has_layer (builder, LAYER_DELAUNAY);
  const uint32_t *order;
  uint32_t i;

  if (builder->look->mask & MASK_FACING)
    return;
  if (delaunay->n_triangles == 0 && has_layer)
    add_simplex_shadow (builder);
  order = scene_order_triangles (builder);
  for (i = 0; i < delaunay->n_triangles; i++) {
    const uint32_t facet = delaunay->triangles[order[i]].facet;
    const Role role = triangle_role (builder, facet);

    if (has_layer || role != ROLE_TRIANGLE)
      scene_add_polygon (builder, role, facet, false);
  }
}

static bool
is_visible (const SceneBuilder *builder, uint32_t triangle)
{
  const Triangle *triangles = builder->frame->delaunay.triangles;
  uint32_t roles;

  if (triangle == INDEX_NONE)
    return false;
  roles = scene_roles (builder, triangles[triangle].facet);
  return (roles & FACET_VISIBLE) && !(roles & FACET_RETIRED);
}

static Role
edge_role (const SceneBuilder *builder, const DelaunayEdge *edge)
{
  if (is_visible (builder, edge->triangle[0])
      || is_visible (builder, edge->triangle[1]))
    return ROLE_VISIBLE_EDGE;
  if (edge->is_free)
    return ROLE_FREE_EDGE;
  if (scene_is_new_apex (builder, edge->site[0])
      || scene_is_new_apex (builder, edge->site[1]))
    return ROLE_CONE_EDGE;
  return ROLE_DELAUNAY_EDGE;
}

static const uint32_t *
edge_corners (const SceneBuilder *builder, uint32_t edge)
{
  return builder->frame->delaunay.edges[edge].site;
}

void
scene_add_delaunay_edges (SceneBuilder *builder)
{
  const Delaunay *delaunay = &builder->frame->delaunay;
  uint32_t *order = scene_order (builder, delaunay->n_edges, 2, edge_corners);
  uint32_t i;

  for (i = 0; i < delaunay->n_edges; i++) {
    const DelaunayEdge *edge = &delaunay->edges[order[i]];
    const Role role = edge_role (builder, edge);

    if (role == ROLE_VISIBLE_EDGE || role == ROLE_CONE_EDGE
        || scene_has_layer (builder, LAYER_DELAUNAY))
      scene_add_edge (builder, role,
                      (Object){ OBJECT_RIDGE, builder->ridge_of[order[i]] },
                      edge->site, false);
  }
  free (order);
}

static bool
is_lower (const SceneBuilder *builder, uint32_t facet)
{
  return builder->frame->trace->facets[facet].facing == FACING_LOWER;
}

/* The shadow of a vertical facet is the segment between its outer two
 * corners: those that lie furthest apart. */
static void
add_seen_edge (SceneBuilder *builder, uint32_t facet)
{
  const uint32_t *site = scene_facet_sites (builder, facet);
  double most = -1;
  uint32_t ends[2] = { site[0], site[1] };
  int k;

  for (k = 0; k < 3; k++) {
    const Point3 a = scene_at (builder, site[k], false);
    const Point3 b = scene_at (builder, site[(k + 1) % 3], false);
    const double squared
        = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);

    if (squared <= most)
      continue;
    most = squared;
    ends[0] = site[k];
    ends[1] = site[(k + 1) % 3];
  }
  scene_add_edge (builder, ROLE_SEEN_EDGE, (Object){ OBJECT_FACET, facet },
                  ends, false);
}

/* The current site lies beyond the hull edges of vertical facets that it
 * sees; no triangle would tell. */
void
scene_add_seen_edges (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i;

  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t facet = frame->facets[i].facet;

    if ((frame->facets[i].roles & FACET_VISIBLE)
        && !(frame->facets[i].roles & FACET_RETIRED)
        && frame->trace->facets[facet].facing == FACING_VERTICAL)
      add_seen_edge (builder, facet);
  }
}

static bool
has_cone_shadow (const SceneBuilder *builder, const FrameFacet *facet)
{
  return (facet->roles & FACET_CONE) && is_lower (builder, facet->facet);
}

bool
scene_has_cone_shadow (const SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i;

  for (i = 0; i < frame->n_facets; i++)
    if (has_cone_shadow (builder, &frame->facets[i]))
      return true;
  return false;
}

void
scene_add_cone_shadow (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i;

  for (i = 0; i < frame->n_facets; i++)
    if (has_cone_shadow (builder, &frame->facets[i]))
      scene_add_polygon (builder, ROLE_CONE, frame->facets[i].facet, false);
}

static void
add_cone_edge (SceneBuilder *builder,
               uint32_t facet,
               uint32_t site,
               bool lifted)
{
  const Point3 apex = scene_at (builder, round_of (builder)->site, lifted);
  const Point3 end = scene_at (builder, site, lifted);
  const double moving = is_growing (builder, facet) ? builder->look->moving : 0;

  scene_add_segment (builder, ROLE_CONE_EDGE, (Object){ OBJECT_NONE, 0 },
                     (Point3[2]){ between (apex, end, moving), end });
}

/* The edges from the apex to the horizon, once each. In the plane those of
 * lower facets only: no others will be Delaunay edges. */
void
scene_add_cone_edges (SceneBuilder *builder, bool lifted)
{
  const Frame *frame = builder->frame;
  bool *is_drawn = memory_new (frame->n_sites, sizeof *is_drawn);
  uint32_t i;
  int k;

  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t facet = frame->facets[i].facet;
    const uint32_t *site = scene_facet_sites (builder, facet);
    const uint32_t apex
        = builder->is_round ? round_of (builder)->site : INDEX_NONE;

    if (!(frame->facets[i].roles & FACET_CONE)
        || !(lifted || is_lower (builder, facet)))
      continue;
    for (k = 0; k < 3; k++) {
      if (site[k] == apex || is_drawn[site[k]])
        continue;
      is_drawn[site[k]] = true;
      add_cone_edge (builder, facet, site[k], lifted);
    }
  }
  free (is_drawn);
}

/* For each horizon ridge, by its tail: whether a lower facet touches it. The
 * horizon is one loop, so each of its sites is tail of one ridge. */
static bool *
find_lower_horizon (const SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t *head = memory_new (frame->n_sites, sizeof *head);
  bool *has_lower = memory_new (frame->n_sites, sizeof *has_lower);
  uint32_t i;
  int k;

  for (i = 0; i < frame->n_sites; i++)
    head[i] = INDEX_NONE;
  for (i = 0; i < frame->n_horizon; i++) {
    head[frame->horizon[i].site[0]] = frame->horizon[i].site[1];
    has_lower[frame->horizon[i].site[0]]
        = is_lower (builder, frame->horizon[i].beyond);
  }
  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t facet = frame->facets[i].facet;
    const uint32_t *site = frame->trace->facets[facet].site;

    if (!(frame->facets[i].roles & FACET_VISIBLE) || !is_lower (builder, facet))
      continue;
    for (k = 0; k < 3; k++)
      if (head[site[k]] == site[(k + 1) % 3])
        has_lower[site[k]] = true;
  }
  free (head);
  return has_lower;
}

/* How many ridges of the horizon are drawn, the last one perhaps in part. */
static double
drawn_horizon (const SceneBuilder *builder)
{
  const SceneLook *look = builder->look;
  const uint32_t n = builder->frame->n_horizon;
  const uint32_t before = round_of (builder)->first_horizon - 1;
  const uint32_t n_old = look->since > before ? look->since - before : 0;

  return n_old >= n ? n : n - look->moving * (n - n_old);
}

void
scene_add_horizon (SceneBuilder *builder, bool lifted)
{
  const Frame *frame = builder->frame;
  bool *has_lower;
  double drawn;
  uint32_t i;

  if (frame->n_horizon == 0
      || (frame->place.phase == PHASE_HAND_OVER && frame->base == frame->step))
    return;
  drawn = drawn_horizon (builder);
  has_lower = find_lower_horizon (builder);
  /* What is not drawn yet is there, unseen: the legend tells of it. */
  for (i = 0; i < frame->n_horizon; i++) {
    const uint32_t *site = frame->horizon[i].site;
    const double part = drawn - i < 0 ? 0 : drawn - i < 1 ? drawn - i : 1;
    const Point3 tail = scene_at (builder, site[0], lifted);
    const Point3 head = scene_at (builder, site[1], lifted);

    scene_add_segment (
        builder, has_lower[site[0]] ? ROLE_HORIZON : ROLE_HORIZON_UPPER,
        (Object){ OBJECT_NONE, 0 },
        (Point3[2]){ tail, part < 1 ? between (tail, head, part) : head });
    if (!(part > 0))
      builder->scene->items[builder->scene->n_items - 1].fade = 1;
  }
  free (has_lower);
}

uint32_t
scene_selected_facet (const SceneBuilder *builder)
{
  const Phase phase = builder->frame->place.phase;

  if (builder->event != NULL && builder->event->kind == EVENT_CLAIM)
    return builder->event->facet;
  if (builder->is_round && phase == PHASE_CHOOSE
      && !(builder->look->mask & MASK_ROUND))
    return round_of (builder)->facet;
  return INDEX_NONE;
}

SceneItem *
scene_add_outline (SceneBuilder *builder,
                   Role role,
                   uint32_t facet,
                   bool lifted)
{
  const uint32_t *site = scene_facet_sites (builder, facet);
  int k;

  scene_add (builder, SHAPE_PATH, role, (Object){ OBJECT_NONE, 0 });
  for (k = 0; k < 4; k++)
    scene_add_point (builder, scene_at (builder, site[k % 3], lifted));
  return &builder->scene->items[builder->scene->n_items - 1];
}

void
scene_add_selected_facet (SceneBuilder *builder, bool lifted)
{
  const uint32_t facet = scene_selected_facet (builder);

  if (facet != INDEX_NONE)
    scene_add_outline (builder, ROLE_SELECTED_FACET, facet, lifted);
}
