/* The tangent planes at the lifts. Their upper envelope touches the paraboloid
 * from outside; seen from above, each plane shows where it is the highest: on
 * the Voronoi cell of its site. */
#include "memory.h"
#include "scene-builder.h"

#include <stdlib.h>

/* The plane z = level + slope.x x + slope.y y */
typedef struct Tangent {
  Site slope;
  double level;
} Tangent;

static Tangent
tangent_at (const SceneBuilder *builder, uint32_t site)
{
  const SceneLook *look = builder->look;
  const Point3 at = scene_at (builder, site, false);

  return (Tangent){ { 2 * look->lift * at.x, 2 * look->lift * at.y },
                    look->lift * (look->raise - at.x * at.x - at.y * at.y) };
}

static double
height_at (const Tangent *tangent, Point3 point)
{
  return tangent->level + tangent->slope.x * point.x
         + tangent->slope.y * point.y;
}

static void
add_raised_point (SceneBuilder *builder, const Tangent *tangent, Point3 point)
{
  if (builder->scene->is_space)
    point.z = height_at (tangent, point);
  scene_add_point (builder, point);
}

/* The point of the segment at which the plane meets the ground. */
static Point3
ground_between (const Tangent *tangent, Point3 a, Point3 b)
{
  const double p = height_at (tangent, a), q = height_at (tangent, b);
  const double t = p / (p - q);

  return (Point3){ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0 };
}

/* Adds what of the polygon is not below the ground, turning clockwise seen
 * from above: the outside of the envelope is below it.
 *
 * Returns: the item's number, or INDEX_NONE when nothing is left. */
static uint32_t
add_polygon (SceneBuilder *builder,
             uint32_t site,
             const Point3 *corners,
             uint32_t n)
{
  const Tangent tangent = tangent_at (builder, site);
  const bool is_cut = builder->scene->is_space;
  const uint32_t first = builder->scene->n_points;
  uint32_t i;

  scene_add (builder, SHAPE_POLYGON, ROLE_TANGENT,
             (Object){ OBJECT_SITE, site })
      ->hue
      = scene_hue (builder, site);
  for (i = n; i-- > 0;) {
    const Point3 here = corners[i], next = corners[(i + n - 1) % n];
    const bool is_up = !is_cut || height_at (&tangent, here) >= 0;
    const bool is_next_up = !is_cut || height_at (&tangent, next) >= 0;

    if (is_up)
      add_raised_point (builder, &tangent, here);
    if (is_up != is_next_up)
      add_raised_point (builder, &tangent,
                        ground_between (&tangent, here, next));
  }
  if (builder->scene->n_points - first >= 3)
    return builder->scene->n_items - 1;
  scene_drop_item (builder);
  return INDEX_NONE;
}

/* An edge lies in the planes of both its sites. */
static void
add_edge (SceneBuilder *builder,
          const uint32_t site[2],
          Point3 ends[2],
          const uint32_t *item_of)
{
  const Tangent tangent = tangent_at (builder, site[0]);
  SceneItem *item;
  int k;

  if (builder->scene->is_space) {
    const bool is_up[2] = { height_at (&tangent, ends[0]) >= 0,
                            height_at (&tangent, ends[1]) >= 0 };

    if (!is_up[0] && !is_up[1])
      return;
    if (is_up[0] != is_up[1])
      ends[is_up[0]] = ground_between (&tangent, ends[0], ends[1]);
  }
  item = scene_add (builder, SHAPE_PATH, ROLE_TANGENT_EDGE,
                    (Object){ OBJECT_NONE, 0 });
  item->beside[0] = item_of[site[0]];
  item->beside[1] = item_of[site[1]];
  if (item->beside[0] == INDEX_NONE) {
    item->beside[0] = item->beside[1];
    item->beside[1] = INDEX_NONE;
  }
  for (k = 0; k < 2; k++)
    add_raised_point (builder, &tangent, ends[k]);
}

void
scene_add_tangents (SceneBuilder *builder, const SceneDiagram *diagram)
{
  const uint32_t n_sites = builder->frame->n_sites;
  Point3 *corners = memory_new (scene_diagram_room (diagram), sizeof *corners);
  uint32_t *item_of = memory_new (n_sites, sizeof *item_of);
  uint32_t i, site[2];
  Point3 ends[2];

  for (i = 0; i < n_sites; i++) {
    const uint32_t n = scene_diagram_cell (diagram, i, corners);

    item_of[i] = n == 0 ? INDEX_NONE : add_polygon (builder, i, corners, n);
  }
  for (i = 0; i < scene_diagram_n_edges (diagram); i++)
    if (scene_diagram_edge (diagram, i, site, ends))
      add_edge (builder, site, ends, item_of);
  free (item_of);
  free (corners);
}
