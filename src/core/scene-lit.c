/* What a person points at: objects of the stock that are lit, with their
 * counterparts, and what is shown only because of them. */
#include "memory.h"
#include "scene-builder.h"

#include <stdlib.h>

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
compare_numbers (const void *left, const void *right)
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
                     compare_numbers)
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

/* How an item of the stock is lit. */
static Lit
lit_of_item (const SceneBuilder *builder, const SceneItem *item)
{
  const Lit lit = scene_lit (builder, item->object);
  const bool is_triangle = item->shape == SHAPE_POLYGON
                           && item->pass == PASS_GROUND
                           && item->object.kind == OBJECT_FACET;

  /* The circle of what is lit is drawn over it. */
  if (item->role == ROLE_CIRCLE)
    return LIT_NONE;
  /* Its outline is enough where a preview lies over it. */
  if (lit == LIT_HOVER && is_triangle && builder->look->has_preview)
    return LIT_NONE;
  return lit;
}

static void
light_object (SceneBuilder *builder, Object object)
{
  Scene *scene = builder->scene;
  uint32_t i;

  if (object.kind == OBJECT_NONE)
    return;
  for (i = scene_index_first (scene, object); i != INDEX_NONE;
       i = scene_index_next (scene, i)) {
    SceneItem *item = &scene->items[i];
    const Lit lit = lit_of_item (builder, item);

    if (lit == LIT_NONE || item->lit != LIT_NONE)
      continue;
    item->lit = lit;
    if (scene->n_lit == scene->lit_room)
      scene->lit = memory_grow (scene->lit, &scene->lit_room, scene->n_lit + 1,
                                sizeof *scene->lit);
    scene->lit[scene->n_lit++] = i;
  }
}

/* The circle group that a facet or a Voronoi vertex belongs to. */
static uint32_t
group_of (const SceneBuilder *builder, Object object)
{
  uint32_t group;

  /* Scenes without a frame have sites alone. */
  if (builder->frame == NULL
      || (object.kind != OBJECT_FACET && object.kind != OBJECT_VERTEX))
    return INDEX_NONE;
  group = scene_group (builder, object.number);
  return group < builder->frame->voronoi.n_vertices ? group : INDEX_NONE;
}

static void
light_with_counterparts (SceneBuilder *builder, Object object)
{
  const uint32_t group = group_of (builder, object);
  const Delaunay *delaunay;
  uint32_t i;

  light_object (builder, object);
  if (group == INDEX_NONE)
    return;
  if (object.kind == OBJECT_FACET) {
    light_object (builder, scene_vertex_object (builder, group));
    return;
  }
  delaunay = &builder->frame->delaunay;
  for (i = 0; i < delaunay->n_triangles; i++)
    if (delaunay->triangles[i].group == group)
      light_object (builder,
                    (Object){ OBJECT_FACET, delaunay->triangles[i].facet });
}

static void
put_out (Scene *scene)
{
  uint32_t i;

  for (i = 0; i < scene->n_lit; i++)
    scene->items[scene->lit[i]].lit = LIT_NONE;
  scene->n_lit = 0;
}

void
scene_light (SceneBuilder *builder)
{
  const SceneLook *look = builder->look;
  Scene *scene = builder->scene;
  uint32_t i;

  scene->stock.n_items = scene->n_items;
  scene->stock.n_points = scene->n_points;
  scene->stock.n_labels = scene->n_labels;
  builder->has_stock = true;
  put_out (scene);
  if (look->selection.kind == OBJECT_NONE && look->hover.kind == OBJECT_NONE
      && look->n_selected == 0)
    return;
  scene_index_renew (scene);
  light_with_counterparts (builder, look->selection);
  light_with_counterparts (builder, look->hover);
  for (i = 0; i < look->n_selected; i++)
    light_object (builder, (Object){ OBJECT_SITE, look->selected[i] });
  if (scene->n_lit > 1)
    qsort (scene->lit, scene->n_lit, sizeof *scene->lit, compare_numbers);
}

/* Facets that are lit */

static bool
is_there (const SceneBuilder *builder, uint32_t facet)
{
  const Frame *frame = builder->frame;

  return frame->trace->is_flat ? facet < frame->delaunay.n_triangles
                               : scene_roles (builder, facet) != 0;
}

typedef struct FacetList {
  uint32_t *facets;
  uint32_t n, room;
} FacetList;

static void
add_to_list (FacetList *list, const SceneBuilder *builder, uint32_t facet)
{
  uint32_t i = 0;

  while (i < list->n && list->facets[i] != facet)
    i++;
  if (i < list->n || !is_there (builder, facet))
    return;
  if (list->n == list->room)
    list->facets = memory_grow (list->facets, &list->room, list->n + 1,
                                sizeof *list->facets);
  list->facets[list->n++] = facet;
}

static void
list_facets (FacetList *list, const SceneBuilder *builder, Object object)
{
  const Delaunay *delaunay = &builder->frame->delaunay;
  const uint32_t group = group_of (builder, object);
  uint32_t i;

  if (object.kind == OBJECT_FACET)
    add_to_list (list, builder, object.number);
  if (object.kind != OBJECT_VERTEX || group == INDEX_NONE)
    return;
  for (i = 0; i < delaunay->n_triangles; i++)
    if (delaunay->triangles[i].group == group)
      add_to_list (list, builder, delaunay->triangles[i].facet);
}

/* Returns: the facets that are lit, ascending, of those that are in the frame;
 *          free with free(). */
static uint32_t *
lit_facets (const SceneBuilder *builder, uint32_t *n_facets)
{
  FacetList list = { NULL, 0, 0 };

  list_facets (&list, builder, builder->look->selection);
  list_facets (&list, builder, builder->look->hover);
  if (list.n > 1)
    qsort (list.facets, list.n, sizeof *list.facets, compare_numbers);
  *n_facets = list.n;
  return list.facets;
}

/* Outlines that show through, whatever lies before the facet. */
void
scene_add_lit_facets (SceneBuilder *builder, bool lifted)
{
  const Trace *trace = builder->frame->trace;
  uint32_t i, n;
  uint32_t *facets = lit_facets (builder, &n);

  for (i = 0; i < n; i++)
    if (lifted || trace->is_flat
        || trace->facets[facets[i]].facing == FACING_LOWER)
      scene_add_outline (builder, ROLE_LIT, facets[i], lifted)->lit
          = scene_lit (builder, (Object){ OBJECT_FACET, facets[i] });
  free (facets);
}

static void
add_circle_of (SceneBuilder *builder, Object object, const Point3 box[2])
{
  const Frame *frame = builder->frame;
  const uint32_t group = group_of (builder, object);
  uint32_t triangle;
  Object vertex;

  if (group == INDEX_NONE || frame->is_dying[group])
    return;
  vertex = scene_vertex_object (builder, group);
  if (builder->look->has_preview && scene_lit (builder, vertex) == LIT_HOVER)
    return;
  triangle = frame->voronoi.vertices[group].triangle;
  scene_add_circle (builder, ROLE_CIRCLE_SELECTED, vertex,
                    frame->delaunay.triangles[triangle].site, box);
}

/* A facet that is not lower has a circle too. */
static void
add_upper_circles (SceneBuilder *builder, const Point3 box[2])
{
  const Trace *trace = builder->frame->trace;
  uint32_t i, n;
  uint32_t *facets = lit_facets (builder, &n);

  for (i = 0; i < n && !trace->is_flat; i++) {
    const uint32_t roles = scene_roles (builder, facets[i]);
    const bool is_seen = (roles & FACET_VISIBLE) && !(roles & FACET_RETIRED);

    if (trace->facets[facets[i]].facing == FACING_UPPER && !is_seen)
      scene_add_circle (builder, ROLE_CIRCLE_SELECTED,
                        (Object){ OBJECT_FACET, facets[i] },
                        trace->facets[facets[i]].site, box);
  }
  free (facets);
}

void
scene_add_lit_circles (SceneBuilder *builder, const Point3 box[2])
{
  const SceneLook *look = builder->look;
  const uint32_t group = group_of (builder, look->hover);

  if (look->mask & MASK_FACING)
    return;
  if (group != group_of (builder, look->selection))
    add_circle_of (builder, look->hover, box);
  add_circle_of (builder, look->selection, box);
  add_upper_circles (builder, box);
}

/* Another look */

static bool
is_same_point (Point3 a, Point3 b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool
has_same_fades (const SceneLook *a, const SceneLook *b)
{
  int i;

  for (i = 0; i < N_BODIES; i++)
    if (a->body_fade[i] != b->body_fade[i])
      return false;
  for (i = 0; i < N_ROLES; i++)
    if (a->role_fade[i] != b->role_fade[i])
      return false;
  return true;
}

/* Whether both looks show the same stock. What is answered may have changed
 * where it is: then they do not. */
static bool
has_same_stock (const SceneLook *a, const SceneLook *b)
{
  return a->layers == b->layers && a->mask == b->mask && a->focus == b->focus
         && a->n_answers == 0 && b->n_answers == 0
         && a->extent.centre.x == b->extent.centre.x
         && a->extent.centre.y == b->extent.centre.y
         && a->extent.radius == b->extent.radius && a->raise == b->raise
         && a->lift == b->lift && a->moving == b->moving && a->since == b->since
         && a->hues == b->hues && a->n_hues == b->n_hues
         && is_same_point (a->low, b->low) && is_same_point (a->high, b->high)
         && has_same_fades (a, b);
}

bool
scene_relight (Scene *scene, const Frame *frame, const SceneLook *look)
{
  SceneBuilder builder;

  if (scene->stock.edition == 0 || !has_same_stock (&scene->look, look))
    return false;
  scene_builder_resume (&builder, scene, frame, look);
  scene_light (&builder);
  if (scene->is_space)
    scene_add_pointed_space (&builder);
  else if (frame != NULL)
    scene_add_pointed_plane (&builder);
  scene_builder_clear (&builder);
  return true;
}
