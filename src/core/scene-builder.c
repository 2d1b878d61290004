#include "scene-builder.h"

#include "memory.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The parts of the active set of a step. */
typedef enum Part {
  PART_NONE = 0,
  PART_CHOICE = 1, /* the selected facet and its outside set */
  PART_APEX = 2,
  PART_VISIBLE = 4,
  PART_HORIZON = 8,
  PART_CONE = 16,
} Part;

static const Part part_of[N_ROLES] = {
  [ROLE_SELECTED_FACET] = PART_CHOICE,
  [ROLE_DROP] = PART_CHOICE,
  [ROLE_EDGE_LINE] = PART_CHOICE | PART_VISIBLE,
  [ROLE_LIFT_OUTSIDE] = PART_CHOICE,
  [ROLE_SITE_OUTSIDE] = PART_CHOICE,
  [ROLE_SITE_APEX] = PART_APEX,
  [ROLE_LIFT_APEX] = PART_APEX,
  [ROLE_FOOT_APEX] = PART_APEX,
  [ROLE_FACET_NAME] = PART_APEX,
  [ROLE_VISIBLE] = PART_VISIBLE,
  [ROLE_VISIBLE_UPPER] = PART_VISIBLE,
  [ROLE_RETIRED] = PART_VISIBLE,
  [ROLE_CIRCLE_VISIBLE] = PART_VISIBLE,
  [ROLE_CIRCLE_UPPER] = PART_VISIBLE,
  [ROLE_VISIBLE_EDGE] = PART_VISIBLE,
  [ROLE_SEEN_EDGE] = PART_VISIBLE,
  [ROLE_VORONOI_VERTEX_DYING] = PART_VISIBLE,
  [ROLE_HORIZON] = PART_HORIZON,
  [ROLE_HORIZON_UPPER] = PART_HORIZON,
  [ROLE_HORIZON_CORNER] = PART_HORIZON,
  [ROLE_CONE] = PART_CONE,
  [ROLE_CONE_UPPER] = PART_CONE,
  [ROLE_CONE_EDGE] = PART_CONE,
};

/* The answer to what a person asked for, in whatever phase. */
static bool
is_answer (Role role)
{
  switch ((int)role) {
  case ROLE_PLANE:
  case ROLE_ELLIPSE:
  case ROLE_GAP:
  case ROLE_POWER:
  case ROLE_PREVIEW_TRIANGLE:
  case ROLE_PREVIEW_STOLEN:
  case ROLE_PREVIEW_EDGE:
  case ROLE_PREVIEW_CELL:
  case ROLE_ANSWER_CHOSEN:
  case ROLE_ANSWER_RIGHT:
  case ROLE_ANSWER_WRONG:
  case ROLE_ANSWER_MISSED:
    return true;
  default:
    return false;
  }
}

static uint32_t
parts_of_phase (Phase phase)
{
  switch (phase) {
  case PHASE_CHOOSE:
    return PART_CHOICE | PART_APEX;
  case PHASE_SEE:
    return PART_VISIBLE | PART_APEX;
  case PHASE_HORIZON:
    return PART_HORIZON | PART_VISIBLE | PART_APEX;
  case PHASE_CONE:
    return PART_CONE | PART_HORIZON | PART_APEX;
  case PHASE_HAND_OVER:
    return PART_CONE | PART_VISIBLE | PART_APEX | PART_CHOICE;
  case PHASE_START:
  case PHASE_SIMPLEX:
  case PHASE_COMPLETE:
    break;
  }
  return PART_NONE;
}

static uint32_t
loud_parts (Phase phase, Focus focus)
{
  switch (focus) {
  case FOCUS_VISIBLE:
    return PART_VISIBLE | PART_APEX;
  case FOCUS_HORIZON:
    return PART_HORIZON | PART_APEX;
  case FOCUS_CONE:
    return PART_CONE | PART_APEX;
  case FOCUS_ACTIVE:
  case FOCUS_NONE:
    break;
  }
  return parts_of_phase (phase);
}

static bool
is_round_in_hand (const Frame *frame)
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
    const RidgeRow *row = &trace->ridges[frame->ridges[i].ridge];
    const uint32_t *site;

    if (!is_lower (trace, row->facet[0]) && !is_lower (trace, row->facet[1]))
      continue;
    site = delaunay->edges[edge].site;
    assert (row->site[0] + row->site[1] == site[0] + site[1]);
    ridge_of[edge++] = frame->ridges[i].ridge;
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

void
scene_builder_open (SceneBuilder *builder,
                    Scene *scene,
                    const SceneLook *look,
                    uint32_t n_labels)
{
  memset (builder, 0, sizeof *builder);
  builder->scene = scene;
  builder->look = look;
  scene->n_items = scene->n_points = scene->n_labels = 0;
  if (scene->labels_room < n_labels)
    scene->labels = memory_grow (scene->labels, &scene->labels_room, n_labels,
                                 sizeof *scene->labels);
}

void
scene_builder_round (SceneBuilder *builder, Phase phase)
{
  builder->is_round = true;
  builder->parts = loud_parts (phase, builder->look->focus);
}

void
scene_builder_init (SceneBuilder *builder,
                    Scene *scene,
                    const Frame *frame,
                    const SceneLook *look)
{
  scene_builder_open (builder, scene, look,
                      frame->n_sites + 16 + 2 * look->n_answers);
  builder->frame = frame;
  builder->masked = *look;
  builder->look = look->mask != 0 ? &builder->masked : look;
  if (look->mask != 0)
    apply_mask (builder);
  if (frame->step > 0 && !(look->mask & MASK_ROUND))
    builder->event = &frame->trace->events[frame->step - 1];
  builder->is_round = is_round_in_hand (frame);
  if (!(look->mask & MASK_ROUND))
    builder->parts = loud_parts (frame->place.phase, look->focus);
  builder->ridge_of = find_ridges (frame);
  builder->roles = scene_roles_new (builder->frame);
}

void
scene_builder_clear (SceneBuilder *builder)
{
  free (builder->ridge_of);
  free (builder->roles);
  frame_mask_clear (&builder->mask);
}

bool
scene_has_layer (const SceneBuilder *builder, Layer layer)
{
  return (builder->look->layers & (uint32_t)layer) != 0;
}

static Emphasis
emphasis_of (const SceneBuilder *builder, Role role)
{
  const bool is_mark = role >= ROLE_PREVIEW_SITE;

  if (!builder->is_round)
    return EMPHASIS_NORMAL;
  if ((uint32_t)part_of[role] & builder->parts)
    return EMPHASIS_LOUD;
  if (builder->look->focus == FOCUS_NONE || is_mark || is_answer (role))
    return EMPHASIS_NORMAL;
  return EMPHASIS_PALE;
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

SceneItem *
scene_add (SceneBuilder *builder, SceneShape shape, Role role, Object object)
{
  Scene *scene = builder->scene;
  SceneItem *item;

  if (scene->n_items == scene->items_room)
    scene->items = memory_grow (scene->items, &scene->items_room,
                                scene->n_items + 1, sizeof *scene->items);
  item = &scene->items[scene->n_items++];
  *item = (SceneItem){ .shape = shape,
                       .role = role,
                       .emphasis = emphasis_of (builder, role),
                       .lit = scene_lit (builder, object),
                       .pass = builder->pass,
                       .object = object,
                       .fade = fade_of (builder, role),
                       .first = scene->n_points,
                       .beside = { INDEX_NONE, INDEX_NONE } };
  return item;
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
  scene_add_point (builder, ends[0]);
  scene_add_point (builder, ends[1]);
}

void
scene_add_mark (SceneBuilder *builder,
                Role role,
                Object object,
                Point3 at,
                const char *label)
{
  scene_add (builder, SHAPE_MARK, role, object)->label = label;
  scene_add_point (builder, at);
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
  snprintf (label, sizeof *scene->labels, "%c%u", letter, number);
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

/* A facet and the Voronoi vertex of its circle are counterparts; all other
 * counterparts have one name. */
static bool
is_counterpart (const SceneBuilder *builder, Object a, Object b)
{
  uint32_t group;

  if (object_equal (a, b))
    return a.kind != OBJECT_NONE;
  if (!(a.kind == OBJECT_FACET && b.kind == OBJECT_VERTEX)
      && !(a.kind == OBJECT_VERTEX && b.kind == OBJECT_FACET))
    return false;
  group = scene_group (builder, a.number);
  return group != INDEX_NONE && group == scene_group (builder, b.number);
}

static int
compare_sites (const void *left, const void *right)
{
  const uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;

  return a < b ? -1 : a > b;
}

bool
scene_is_selected (const SceneLook *look, uint32_t site)
{
  if (look->selection.kind == OBJECT_SITE && look->selection.number == site)
    return true;
  return look->n_selected > 0
         && bsearch (&site, look->selected, look->n_selected, sizeof site,
                     compare_sites)
                != NULL;
}

Lit
scene_lit (const SceneBuilder *builder, Object object)
{
  if (object.kind == OBJECT_SITE
      && scene_is_selected (builder->look, object.number))
    return LIT_SELECTED;
  if (is_counterpart (builder, object, builder->look->selection))
    return LIT_SELECTED;
  /* A preview has taken the place of what a cell would light. */
  if (builder->look->has_preview && object.kind == OBJECT_SITE)
    return LIT_NONE;
  if (is_counterpart (builder, object, builder->look->hover))
    return LIT_HOVER;
  return LIT_NONE;
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
