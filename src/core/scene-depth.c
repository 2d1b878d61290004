/* The order of paint: one rule for painters and picker, so that what is picked
 * is what is seen. */
#include "scene.h"

/* Half the normal vector that the sum over all corners gives is right for any
 * planar polygon.
 *
 * Source: Newell's method. */
static Point3
normal_of (const Point3 *points, uint32_t n)
{
  Point3 normal = { 0, 0, 0 };
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Point3 *a = &points[i], *b = &points[(i + 1) % n];

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

static bool
is_cone (const SceneItem *item)
{
  return item->role == ROLE_CONE || item->role == ROLE_CONE_UPPER;
}

/* Lines of the hull lie with the facets beside them: in front when one of the
 * two is. */
static SceneDepth
hull_depth (const Scene *scene,
            const SceneItem *item,
            const Projection *projection)
{
  bool is_near = false, is_new = is_cone (item);
  int i;

  if (item->shape == SHAPE_POLYGON)
    is_near = item->is_two_sided || scene_faces_eye (scene, item, projection);
  else if (item->beside[0] == INDEX_NONE)
    return DEPTH_HULL_NEAR;
  for (i = 0; i < 2 && item->beside[i] != INDEX_NONE; i++) {
    const SceneItem *facet = &scene->items[item->beside[i]];

    is_near = is_near || scene_faces_eye (scene, facet, projection);
    is_new = is_new || is_cone (facet);
  }
  if (is_near)
    return is_new ? DEPTH_CONE_NEAR : DEPTH_HULL_NEAR;
  return is_new ? DEPTH_CONE_FAR : DEPTH_HULL_FAR;
}

/* Planes, and lines where two of them meet. */
static SceneDepth
outer_depth (const Scene *scene,
             const SceneItem *item,
             const Projection *projection)
{
  bool is_near = item->shape == SHAPE_POLYGON
                 && scene_faces_eye (scene, item, projection);
  int i;

  for (i = 0; i < 2 && item->beside[i] != INDEX_NONE; i++)
    is_near = is_near
              || scene_faces_eye (scene, &scene->items[item->beside[i]],
                                  projection);
  return is_near ? DEPTH_OUTER_NEAR : DEPTH_OUTER_FAR;
}

SceneDepth
scene_depth (const Scene *scene,
             const SceneItem *item,
             const Projection *projection)
{
  switch (item->pass) {
  case PASS_GROUND:
    return scene->is_space && projection->eye.z < 0 ? DEPTH_UNDER
                                                    : DEPTH_GROUND;
  case PASS_OUTER:
    return outer_depth (scene, item, projection);
  case PASS_SHEET_FAR:
    return DEPTH_SHEET_FAR;
  case PASS_HULL:
    return hull_depth (scene, item, projection);
  case PASS_SHEET_NEAR:
    return DEPTH_SHEET_NEAR;
  case PASS_LINES:
    return DEPTH_LINES;
  case PASS_MARKS:
    return DEPTH_MARKS;
  }
  return DEPTH_LINES;
}
