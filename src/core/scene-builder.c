#include "scene-builder.h"

#include "memory.h"

#include <assert.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool
has_current_round (const Frame *frame)
{
  return frame->round != INDEX_NONE
         && frame->step <= frame->trace->rounds[frame->round].end;
}

static bool
is_lower (const Trace *trace, uint32_t facet)
{
  return trace->facets[facet].facing == FACING_LOWER;
}

/* The Delaunay edges stand in the order of the ridges that touch a lower
 * facet. */
static uint32_t *
find_ridges (const Frame *frame)
{
  const Trace *trace = frame->trace;
  const Delaunay *delaunay = &frame->delaunay;
  uint32_t *ridge_of = memory_new (delaunay->n_edges, sizeof *ridge_of);
  uint32_t i, edge = 0;

  for (i = 0; trace->is_flat && i < delaunay->n_edges; i++)
    ridge_of[i] = i;
  if (trace->is_flat || delaunay->n_edges == 0)
    return ridge_of;
  for (i = 0; i < frame->n_ridges; i++) {
    const FrameRidge *row = &frame->ridges[i];
    const uint32_t *site;

    if (!is_lower (trace, row->facet[0]) && !is_lower (trace, row->facet[1]))
      continue;
    site = delaunay->edges[edge].site;
    assert (row->site[0] + row->site[1] == site[0] + site[1]);
    ridge_of[edge++] = row->ridge;
  }
  assert (edge == delaunay->n_edges);
  return ridge_of;
}

/* While a question is open, what would answer it is left out. */
static void
apply_mask (SceneBuilder *builder)
{
  SceneLook *look = &builder->masked;
  const uint32_t mask = look->mask;

  if (mask & MASK_WHY)
    look->layers &= ~(uint32_t)(LAYER_WHY | LAYER_PREVIEW);
  if (mask & MASK_FACING)
    look->layers &= ~(uint32_t)(LAYER_DELAUNAY | LAYER_VORONOI | LAYER_CIRCLES
                                | LAYER_FURTHEST | LAYER_TANGENTS);
  if (!(mask & MASK_ROUND))
    return;
  look->focus = FOCUS_NONE;
  frame_mask_init (&builder->mask, builder->frame);
  builder->frame = &builder->mask.frame;
}

/* What a look borrows may be gone when the next one is compared with it. */
static void
put_look (Scene *scene, const SceneLook *look)
{
  scene->look = *look;
  scene->look.answers = NULL;
  scene->look.selected = NULL;
}

/* Scenes are told apart by it, wherever they lie and whoever fills them. */
static atomic_uint_fast64_t last_edition;

void
scene_builder_open (SceneBuilder *builder,
                    Scene *scene,
                    const SceneLook *look,
                    uint32_t n_labels)
{
  memset (builder, 0, sizeof *builder);
  builder->scene = scene;
  builder->look = look;
  scene->n_items = scene->n_points = scene->n_labels = scene->n_lit = 0;
  put_look (scene, look);
  scene->stock
      = (SceneStock){ .edition = atomic_fetch_add (&last_edition, 1) + 1 };
  if (scene->labels_room < n_labels)
    scene->labels = memory_grow (scene->labels, &scene->labels_room, n_labels,
                                 sizeof *scene->labels);
}

static void
take_frame (SceneBuilder *builder, const Frame *frame, const SceneLook *look)
{
  const bool is_masked = (look->mask & MASK_ROUND) != 0;

  builder->frame = frame;
  builder->masked = *look;
  builder->look = look->mask != 0 ? &builder->masked : look;
  if (look->mask != 0)
    apply_mask (builder);
  if (frame->step > 0 && !is_masked) {
    builder->said = trace_event (frame->trace, frame->step - 1);
    builder->event = &builder->said;
  }
  builder->is_round = has_current_round (frame);
  if (builder->is_round && !is_masked)
    scene_builder_round (builder, frame->place.phase);
}

/* Each site is the corner of a dozen items. */
static Point3 *
lift_sites (const SceneBuilder *builder)
{
  const uint32_t n = builder->frame->n_sites;
  Point3 *lifts = memory_room (n, sizeof *lifts);
  uint32_t i;

  for (i = 0; i < n; i++)
    lifts[i] = scene_at (builder, i, true);
  return lifts;
}

void
scene_builder_init (SceneBuilder *builder,
                    Scene *scene,
                    const Frame *frame,
                    const SceneLook *look)
{
  scene_builder_open (builder, scene, look,
                      frame->n_sites + 16 + 2 * look->n_answers);
  take_frame (builder, frame, look);
  builder->ridge_of = find_ridges (frame);
  builder->roles = scene_roles_new (builder->frame);
  builder->lifts = lift_sites (builder);
}

void
scene_builder_resume (SceneBuilder *builder,
                      Scene *scene,
                      const Frame *frame,
                      const SceneLook *look)
{
  memset (builder, 0, sizeof *builder);
  builder->scene = scene;
  put_look (scene, look);
  scene->n_items = scene->stock.n_items;
  scene->n_points = scene->stock.n_points;
  scene->n_labels = scene->stock.n_labels;
  builder->look = look;
  if (frame != NULL)
    take_frame (builder, frame, look);
}

void
scene_builder_clear (SceneBuilder *builder)
{
  free (builder->ridge_of);
  free (builder->roles);
  free (builder->lifts);
  free (builder->triangles);
  frame_mask_clear (&builder->mask);
}

bool
scene_has_layer (const SceneBuilder *builder, Layer layer)
{
  return (builder->look->layers & (uint32_t)layer) != 0;
}

/* Only lower facets fall on the triangulation when the lifts come down. */
static bool
is_upper (Role role)
{
  return role == ROLE_UPPER || role == ROLE_VERTICAL
         || role == ROLE_VISIBLE_UPPER || role == ROLE_CONE_UPPER;
}

static double
fade_of (const SceneBuilder *builder, Role role)
{
  const SceneLook *look = builder->look;
  double stays = 1 - look->role_fade[role];

  if (!builder->scene->is_space)
    return 1 - stays;
  if (builder->pass == PASS_GROUND)
    stays *= 1 - look->body_fade[BODY_PLANE];
  if (builder->pass == PASS_SHEET_FAR)
    stays *= 1 - look->body_fade[BODY_PARABOLOID];
  if (builder->pass == PASS_HULL)
    stays *= 1 - look->body_fade[BODY_HULL];
  if (is_upper (role))
    stays *= look->lift;
  return 1 - stays;
}

static const RoleLook *
look_of_role (SceneBuilder *builder, Role role)
{
  RoleLook *look = &builder->role_looks[role];

  if (look->pass != (uint32_t)builder->pass + 1)
    *look
        = (RoleLook){ (uint32_t)builder->pass + 1,
                      scene_emphasis (builder, role), fade_of (builder, role) };
  return look;
}

SceneItem *
scene_add (SceneBuilder *builder, SceneShape shape, Role role, Object object)
{
  const RoleLook *look = look_of_role (builder, role);
  Scene *scene = builder->scene;
  SceneItem *item;

  if (scene->n_items == scene->items_room)
    scene->items = memory_grow (scene->items, &scene->items_room,
                                scene->n_items + 1, sizeof *scene->items);
  item = &scene->items[scene->n_items++];
  *item = (SceneItem){ .shape = shape,
                       .role = role,
                       .emphasis = look->emphasis,
                       .lit = builder->has_stock ? scene_lit (builder, object)
                                                 : LIT_NONE,
                       .pass = builder->pass,
                       .object = object,
                       .fade = look->fade,
                       .first = scene->n_points,
                       .beside = { INDEX_NONE, INDEX_NONE } };
  return item;
}

void
scene_add_points (SceneBuilder *builder, const Point3 *points, uint32_t n)
{
  Scene *scene = builder->scene;
  uint32_t i;

  if (scene->points_room - scene->n_points < n)
    scene->points = memory_grow (scene->points, &scene->points_room,
                                 scene->n_points + n, sizeof *scene->points);
  for (i = 0; i < n; i++)
    scene->points[scene->n_points + i] = points[i];
  scene->n_points += n;
  scene->items[scene->n_items - 1].n += n;
}

void
scene_add_point (SceneBuilder *builder, Point3 point)
{
  Scene *scene = builder->scene;

  if (scene->n_points == scene->points_room)
    scene->points = memory_grow (scene->points, &scene->points_room,
                                 scene->n_points + 1, sizeof *scene->points);
  scene->points[scene->n_points++] = point;
  scene->items[scene->n_items - 1].n += 1;
}

void
scene_drop_item (SceneBuilder *builder)
{
  Scene *scene = builder->scene;

  scene->n_items -= 1;
  scene->n_points = scene->items[scene->n_items].first;
}

void
scene_add_segment (SceneBuilder *builder,
                   Role role,
                   Object object,
                   const Point3 ends[2])
{
  scene_add (builder, SHAPE_PATH, role, object);
  scene_add_points (builder, ends, 2);
}

void
scene_add_mark (SceneBuilder *builder,
                Role role,
                Object object,
                Point3 at,
                const char *label)
{
  scene_add (builder, SHAPE_MARK, role, object)->label = label;
  if (!builder->has_stock)
    builder->scene->stock.n_sites
        += role >= ROLE_SITE && role <= ROLE_SITE_IGNORED;
  scene_add_point (builder, at);
}

/* As "%c%u": there are thousands of names. */
static void
write_name (char label[LABEL_ROOM], char letter, uint32_t number)
{
  char digits[16];
  int n = 0, i = 0;

  do
    digits[n++] = (char)('0' + number % 10);
  while ((number /= 10) > 0);
  label[i++] = letter;
  while (n > 0)
    label[i++] = digits[--n];
  label[i] = '\0';
}

const char *
scene_label (SceneBuilder *builder, char letter, uint32_t number)
{
  Scene *scene = builder->scene;
  char *label;

  if (!scene_has_layer (builder, LAYER_LABELS)
      || scene->n_labels == scene->labels_room)
    return NULL;
  label = scene->labels[scene->n_labels++];
  write_name (label, letter, number);
  return label;
}

const char *
scene_text (SceneBuilder *builder, const char *text)
{
  Scene *scene = builder->scene;
  char *label;

  if (scene->n_labels == scene->labels_room)
    return NULL;
  label = scene->labels[scene->n_labels++];
  snprintf (label, sizeof *scene->labels, "%s", text);
  return label;
}

uint32_t
scene_group (const SceneBuilder *builder, uint32_t facet)
{
  const Delaunay *delaunay = &builder->frame->delaunay;
  uint32_t low = 0, high = delaunay->n_triangles;

  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;

    if (delaunay->triangles[middle].facet < facet)
      low = middle + 1;
    else
      high = middle;
  }
  if (low == delaunay->n_triangles || delaunay->triangles[low].facet != facet)
    return INDEX_NONE;
  return delaunay->triangles[low].group;
}

Object
scene_vertex_object (const SceneBuilder *builder, uint32_t group)
{
  const Frame *frame = builder->frame;
  const uint32_t triangle = frame->voronoi.vertices[group].triangle;

  return (Object){ OBJECT_VERTEX, frame->delaunay.triangles[triangle].facet };
}

Role
scene_facet_role (const SceneBuilder *builder, uint32_t facet, uint32_t roles)
{
  const Facing facing = builder->frame->trace->facets[facet].facing;
  const bool lower = facing == FACING_LOWER;

  if (builder->look->mask & MASK_FACING)
    return ROLE_FACET;
  if (roles & FACET_RETIRED)
    return ROLE_RETIRED;
  if (roles & FACET_VISIBLE)
    return lower ? ROLE_VISIBLE : ROLE_VISIBLE_UPPER;
  if (roles & (FACET_CONE | FACET_NEW))
    return lower ? ROLE_CONE : ROLE_CONE_UPPER;
  if (lower)
    return ROLE_LOWER;
  return facing == FACING_UPPER ? ROLE_UPPER : ROLE_VERTICAL;
}

const uint32_t *
scene_facet_sites (const SceneBuilder *builder, uint32_t facet)
{
  const Frame *frame = builder->frame;

  return frame->trace->is_flat ? frame->delaunay.triangles[facet].site
                               : frame->trace->facets[facet].site;
}

Point3
scene_at (const SceneBuilder *builder, uint32_t site, bool lifted)
{
  if (builder->lifts != NULL) {
    const Point3 lift = builder->lifts[site];

    return (Point3){ lift.x, lift.y, lifted ? lift.z : 0 };
  }
  return scene_point (builder->look, &builder->frame->trace->set->sites[site],
                      lifted);
}

uint32_t
scene_hue (const SceneBuilder *builder, uint32_t site)
{
  const SceneLook *look = builder->look;

  /* A site that is only a preview has none yet. */
  return look->hues != NULL && site < look->n_hues ? look->hues[site] : site;
}

Role
scene_site_role (SiteState state)
{
  switch (state) {
  case SITE_WAITING:
    return ROLE_SITE_WAITING;
  case SITE_OUTSIDE:
    return ROLE_SITE_OUTSIDE;
  case SITE_APEX:
    return ROLE_SITE_APEX;
  case SITE_INSERTED:
    return ROLE_SITE;
  case SITE_DUPLICATE:
    return ROLE_SITE_DUPLICATE;
  case SITE_IGNORED:
    return ROLE_SITE_IGNORED;
  }
  return ROLE_SITE;
}
