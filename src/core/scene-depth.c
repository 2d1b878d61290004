/* The order of paint: one rule for painters and picker, so that what is picked
 * is what is seen. */
#include "memory.h"
#include "scene.h"

#include <stdlib.h>

/* Half the normal vector that the sum over all corners gives is right for any
 * planar polygon.
 *
 * Source: Newell's method. */
static Point3
normal_of (const Point3 *points, uint32_t n)
{
  const Point3 *a = &points[n - 1], *b = points;
  Point3 normal = { 0, 0, 0 };

  for (; b < points + n; a = b++) {
    normal.x += (a->y - b->y) * (a->z + b->z);
    normal.y += (a->z - b->z) * (a->x + b->x);
    normal.z += (a->x - b->x) * (a->y + b->y);
  }
  return normal;
}

bool
scene_faces_eye (const Scene *scene,
                 const SceneItem *item,
                 const Projection *projection)
{
  const Point3 *points = &scene->points[item->first];
  const Point3 normal = normal_of (points, item->n);
  Point3 to_eye = projection->eye;

  if (!projection->is_parallel) {
    to_eye.x -= points[0].x;
    to_eye.y -= points[0].y;
    to_eye.z -= points[0].z;
  }
  return normal.x * to_eye.x + normal.y * to_eye.y + normal.z * to_eye.z > 0;
}

/* Who looks at a scene. */
typedef struct Onlooker {
  const Scene *scene;
  const Projection *projection;
  /* Of each item: 0, or which way it faces, once that has been asked. A facet
   * is asked by its ridges too. NULL: nothing is kept. */
  unsigned char *facings;
} Onlooker;

enum { FACING_AWAY = 1, FACING_EYE };

static bool
faces_eye (const Onlooker *onlooker, const SceneItem *item)
{
  const Scene *scene = onlooker->scene;
  unsigned char *facing;

  if (onlooker->facings == NULL)
    return scene_faces_eye (scene, item, onlooker->projection);
  facing = &onlooker->facings[item - scene->items];
  if (*facing == 0)
    *facing = scene_faces_eye (scene, item, onlooker->projection) ? FACING_EYE
                                                                  : FACING_AWAY;
  return *facing == FACING_EYE;
}

static bool
is_cone (const SceneItem *item)
{
  return item->role == ROLE_CONE || item->role == ROLE_CONE_UPPER;
}

/* Lines of the hull lie with the facets beside them: in front when one of the
 * two is. */
static SceneDepth
hull_depth (const Onlooker *onlooker, const SceneItem *item)
{
  bool is_near = false, is_new = is_cone (item);
  int i;

  if (item->shape == SHAPE_POLYGON)
    is_near = item->is_two_sided || faces_eye (onlooker, item);
  else if (item->beside[0] == INDEX_NONE)
    return DEPTH_HULL_NEAR;
  for (i = 0; i < 2 && item->beside[i] != INDEX_NONE; i++) {
    const SceneItem *facet = &onlooker->scene->items[item->beside[i]];

    is_near = is_near || faces_eye (onlooker, facet);
    is_new = is_new || is_cone (facet);
  }
  if (is_near)
    return is_new ? DEPTH_CONE_NEAR : DEPTH_HULL_NEAR;
  return is_new ? DEPTH_CONE_FAR : DEPTH_HULL_FAR;
}

/* Planes, and lines where two of them meet. */
static SceneDepth
outer_depth (const Onlooker *onlooker, const SceneItem *item)
{
  bool is_near = item->shape == SHAPE_POLYGON && faces_eye (onlooker, item);
  int i;

  for (i = 0; i < 2 && item->beside[i] != INDEX_NONE; i++)
    is_near = is_near
              || faces_eye (onlooker, &onlooker->scene->items[item->beside[i]]);
  return is_near ? DEPTH_OUTER_NEAR : DEPTH_OUTER_FAR;
}

static SceneDepth
depth_of (const Onlooker *onlooker, const SceneItem *item)
{
  switch (item->pass) {
  case PASS_GROUND:
    return onlooker->scene->is_space && onlooker->projection->eye.z < 0
               ? DEPTH_UNDER
               : DEPTH_GROUND;
  case PASS_OUTER:
    return outer_depth (onlooker, item);
  case PASS_SHEET_FAR:
    return DEPTH_SHEET_FAR;
  case PASS_HULL:
    return hull_depth (onlooker, item);
  case PASS_SHEET_NEAR:
    return DEPTH_SHEET_NEAR;
  case PASS_LINES:
    return DEPTH_LINES;
  case PASS_MARKS:
    return DEPTH_MARKS;
  }
  return DEPTH_LINES;
}

SceneDepth
scene_depth (const Scene *scene,
             const SceneItem *item,
             const Projection *projection)
{
  const Onlooker onlooker = { scene, projection, NULL };

  return depth_of (&onlooker, item);
}

void
scene_stock_depths (const Scene *scene,
                    const Projection *projection,
                    unsigned char *depths)
{
  const uint32_t n = scene->stock.n_items;
  const Onlooker onlooker
      = { scene, projection, memory_new (n, sizeof *onlooker.facings) };
  uint32_t i;

  for (i = 0; i < n; i++)
    depths[i] = (unsigned char)depth_of (&onlooker, &scene->items[i]);
  free (onlooker.facings);
}
