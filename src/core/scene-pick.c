/* What lies under a pixel, by the painters' own order. */
#include "clip.h"
#include "memory.h"
#include "scene.h"

#include <math.h>
#include <stdlib.h>

typedef struct Picker {
  const Scene *scene;
  const Projection *projection;
  Pixel at;
  Pixel *corners; /* room for the largest polygon */
} Picker;

/* What is not to be seen is not there. */
static bool
is_pickable (const SceneItem *item, SceneShape shape)
{
  return item->shape == shape && item->object.kind != OBJECT_NONE
         && item->fade < 1;
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

  for (i = 0; i < scene->n_items; i++) {
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
  for (i = 0; i < scene->n_items; i++) {
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

  for (i = 0; i < scene->n_items; i++) {
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

Object
scene_pick (const Scene *scene,
            const Projection *projection,
            const double at_px[2],
            double reach_px)
{
  Picker picker = { scene, projection, { at_px[0], at_px[1] }, NULL };
  const SceneItem *best = pick_mark (&picker, reach_px);
  const SceneItem *polygon, *edge;
  SceneDepth depth;

  if (best != NULL)
    return best->object;
  picker.corners
      = memory_new (CLIP_ROOM (largest_polygon (scene)), sizeof (Pixel));
  polygon = pick_polygon (&picker, &depth);
  edge = pick_edge (&picker, reach_px / 2, depth);
  free (picker.corners);
  best = edge != NULL ? edge : polygon;
  return best == NULL ? (Object){ OBJECT_NONE, 0 } : best->object;
}
