/* What lies under a pixel, by the painters' own order. */
#include "box-index.h"
#include "clip.h"
#include "memory.h"
#include "scene.h"

#include <math.h>
#include <stdlib.h>

/* Further than this from the view nothing is in a picker's list. */
#define REACH_MOST 32.0

typedef struct Picker {
  const Scene *scene;
  const Projection *projection;
  Pixel at;
  const BoxIndex *found; /* NULL: all items may be near */
  Pixel *corners;        /* room for the largest polygon */
} Picker;

/* Returns: the first item from @item that may be near, or INDEX_NONE. */
static uint32_t
next_item (const Picker *picker, uint32_t item)
{
  if (picker->found != NULL)
    return box_index_next (picker->found, item);
  return item < picker->scene->n_items ? item : INDEX_NONE;
}

/* What is not to be seen is not there; and a name is no mark. */
static bool
is_pickable (const SceneItem *item, SceneShape shape)
{
  return item->shape == shape && item->object.kind != OBJECT_NONE
         && item->fade < 1 && item->role != ROLE_FACET_NAME
         && item->role != ROLE_ANSWER_NAME;
}

static double
distance_to (const Picker *picker, Pixel pixel)
{
  return hypot (pixel.x - picker->at.x, pixel.y - picker->at.y);
}

static const SceneItem *
pick_mark (const Picker *picker, double reach_px)
{
  const Scene *scene = picker->scene;
  const SceneItem *best = NULL;
  double least = reach_px;
  uint32_t i;

  for (i = next_item (picker, 0); i != INDEX_NONE;
       i = next_item (picker, i + 1)) {
    const SceneItem *item = &scene->items[i];
    Pixel pixel;

    if (!is_pickable (item, SHAPE_MARK)
        || !clip_point (picker->projection, scene->points[item->first], &pixel))
      continue;
    if (distance_to (picker, pixel) <= least) {
      least = distance_to (picker, pixel);
      best = item;
    }
  }
  return best;
}

/* Whether a ray to the right from the pixel leaves the polygon. */
static bool
is_inside (const Picker *picker, uint32_t n)
{
  bool is_in = false;
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Pixel a = picker->corners[i], b = picker->corners[(i + 1) % n];

    if ((a.y > picker->at.y) != (b.y > picker->at.y)
        && picker->at.x
               < a.x + (picker->at.y - a.y) / (b.y - a.y) * (b.x - a.x))
      is_in = !is_in;
  }
  return is_in;
}

static const SceneItem *
pick_polygon (const Picker *picker, SceneDepth *depth)
{
  const Scene *scene = picker->scene;
  const SceneItem *best = NULL;
  uint32_t i;

  *depth = DEPTH_GROUND;
  for (i = next_item (picker, 0); i != INDEX_NONE;
       i = next_item (picker, i + 1)) {
    const SceneItem *item = &scene->items[i];
    SceneDepth here;
    uint32_t n;

    if (!is_pickable (item, SHAPE_POLYGON))
      continue;
    n = clip_polygon (picker->projection, &scene->points[item->first], item->n,
                      1, picker->corners);
    if (!is_inside (picker, n))
      continue;
    here = scene_depth (scene, item, picker->projection);
    if (best == NULL || here >= *depth) {
      best = item;
      *depth = here;
    }
  }
  return best;
}

static double
distance_to_segment (const Picker *picker, const Pixel ends[2])
{
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y;
  const double squared = dx * dx + dy * dy;
  double t = 0;

  if (squared > 0)
    t = ((picker->at.x - ends[0].x) * dx + (picker->at.y - ends[0].y) * dy)
        / squared;
  t = fmin (fmax (t, 0), 1);
  return distance_to (picker,
                      (Pixel){ ends[0].x + t * dx, ends[0].y + t * dy });
}

/* Circles and lifts run through everything: they would be in the way. */
static bool
is_edge (const SceneItem *item)
{
  return is_pickable (item, SHAPE_PATH) && item->object.kind == OBJECT_RIDGE;
}

/* The nearest edge that does not lie behind @depth. */
static const SceneItem *
pick_edge (const Picker *picker, double reach_px, SceneDepth depth)
{
  const Scene *scene = picker->scene;
  const SceneItem *best = NULL;
  double least = reach_px;
  uint32_t i;

  for (i = next_item (picker, 0); i != INDEX_NONE;
       i = next_item (picker, i + 1)) {
    const SceneItem *item = &scene->items[i];
    Pixel ends[2];
    double distance;

    if (!is_edge (item)
        || !clip_segment (picker->projection, &scene->points[item->first],
                          reach_px, ends))
      continue;
    distance = distance_to_segment (picker, ends);
    if (distance <= least
        && scene_depth (scene, item, picker->projection) >= depth) {
      least = distance;
      best = item;
    }
  }
  return best;
}

static uint32_t
largest_polygon (const Scene *scene)
{
  uint32_t i, n = 0;

  for (i = 0; i < scene->n_items; i++)
    if (scene->items[i].shape == SHAPE_POLYGON && scene->items[i].n > n)
      n = scene->items[i].n;
  return n;
}

static Object
pick (Picker *picker, double reach_px)
{
  const SceneItem *best = pick_mark (picker, reach_px);
  const SceneItem *polygon, *edge;
  SceneDepth depth;

  if (best != NULL)
    return best->object;
  polygon = pick_polygon (picker, &depth);
  edge = pick_edge (picker, reach_px / 2, depth);
  best = edge != NULL ? edge : polygon;
  return best == NULL ? (Object){ OBJECT_NONE, 0 } : best->object;
}

Object
scene_pick (const Scene *scene,
            const Projection *projection,
            const double at_px[2],
            double reach_px)
{
  Picker picker = { .scene = scene,
                    .projection = projection,
                    .at = { at_px[0], at_px[1] } };
  Object object;

  picker.corners
      = memory_new (CLIP_ROOM (largest_polygon (scene)), sizeof (Pixel));
  object = pick (&picker, reach_px);
  free (picker.corners);
  return object;
}

/* Pickers */

struct ScenePicker {
  BoxIndex *index; /* of the boxes of the stock's items … */
  uint64_t edition;
  Projection projection; /* … seen through this */
  PixelBox *boxes;
  uint32_t boxes_room;
  Pixel *corners;
  uint32_t corners_room;
};

ScenePicker *
scene_picker_new (void)
{
  ScenePicker *picker = memory_new (1, sizeof *picker);

  picker->index = box_index_new ();
  return picker;
}

void
scene_picker_free (ScenePicker *picker)
{
  if (picker == NULL)
    return;
  box_index_free (picker->index);
  free (picker->boxes);
  free (picker->corners);
  free (picker);
}

static PixelBox
box_of (const Pixel *pixels, uint32_t n)
{
  Pixel low = pixels[0], high = pixels[0];
  uint32_t i;

  for (i = 1; i < n; i++) {
    low.x = fmin (low.x, pixels[i].x);
    low.y = fmin (low.y, pixels[i].y);
    high.x = fmax (high.x, pixels[i].x);
    high.y = fmax (high.y, pixels[i].y);
  }
  /* An edge may have no width, and doubles are rounded to floats. */
  return (PixelBox){ (float)low.x - 1, (float)low.y - 1, (float)high.x + 1,
                     (float)high.y + 1 };
}

/* Where a click may mean @item; nowhere: a box far outside the view. */
static PixelBox
box_of_item (ScenePicker *picker, const Scene *scene, const SceneItem *item)
{
  const Point3 *points = &scene->points[item->first];
  const PixelBox nowhere = { -2e9F, -2e9F, -1e9F, -1e9F };
  uint32_t n = 0;

  if (item->object.kind == OBJECT_NONE)
    return nowhere;
  switch (item->shape) {
  case SHAPE_MARK:
    n = clip_point (&picker->projection, points[0], picker->corners);
    break;
  case SHAPE_PATH:
    if (is_edge (item))
      n = clip_segment (&picker->projection, points, REACH_MOST,
                        picker->corners)
              ? 2
              : 0;
    break;
  case SHAPE_POLYGON:
    n = clip_polygon (&picker->projection, points, item->n, REACH_MOST,
                      picker->corners);
    break;
  }
  return n == 0 ? nowhere : box_of (picker->corners, n);
}

static void
make_room (ScenePicker *picker, const Scene *scene)
{
  const uint32_t n_corners = CLIP_ROOM (largest_polygon (scene));

  if (n_corners > picker->corners_room)
    picker->corners = memory_grow (picker->corners, &picker->corners_room,
                                   n_corners, sizeof *picker->corners);
  if (scene->stock.n_items > picker->boxes_room)
    picker->boxes = memory_grow (picker->boxes, &picker->boxes_room,
                                 scene->stock.n_items, sizeof *picker->boxes);
}

void
scene_picker_prepare (ScenePicker *picker,
                      const Scene *scene,
                      const Projection *projection)
{
  const float width = (float)projection->width;
  const float height = (float)projection->height;
  const float reach = (float)REACH_MOST;
  const PixelBox view = { -reach, -reach, width + reach, height + reach };
  uint32_t i;

  if (picker->edition == scene->stock.edition
      && projection_equal (&picker->projection, projection))
    return;
  picker->edition = scene->stock.edition;
  picker->projection = *projection;
  make_room (picker, scene);
  for (i = 0; i < scene->stock.n_items; i++)
    picker->boxes[i] = box_of_item (picker, scene, &scene->items[i]);
  box_index_set (picker->index, &view, picker->boxes, sizeof *picker->boxes,
                 scene->stock.n_items);
}

Object
scene_picker_pick (ScenePicker *list,
                   const Scene *scene,
                   const Projection *projection,
                   const double at_px[2],
                   double reach_px)
{
  const float x = (float)at_px[0], y = (float)at_px[1];
  const float reach = (float)reach_px + 1;
  const PixelBox place = { x - reach, y - reach, x + reach, y + reach };
  Picker picker = { .scene = scene,
                    .projection = projection,
                    .at = { at_px[0], at_px[1] } };
  Object object;

  if (reach_px > REACH_MOST)
    return scene_pick (scene, projection, at_px, reach_px);
  scene_picker_prepare (list, scene, projection);
  box_index_find (list->index, &place);
  picker.found = list->index;
  picker.corners = list->corners;
  object = pick (&picker, reach_px);
  box_index_forget (list->index);
  return object;
}
