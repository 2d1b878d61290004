#include "scene-rounding.h"

#include "scene-builder.h"

#define NO_OBJECT ((Object){ OBJECT_NONE, 0 })

/* Sign maps */

#define NODE_ROOM 3 /* nodes round the current one, that its mark is seen */

static Role
sign_role (int sign)
{
  if (sign == 0)
    return ROLE_SIGN_ZERO;
  return sign > 0 ? ROLE_SIGN_LEFT : ROLE_SIGN_RIGHT;
}

/* The border of a column or row: the map fills the square -1 … 1. */
static double
border (double i)
{
  return 2.0 * i / SIGN_MAP_SIDE - 1;
}

/* Nodes from the one at @low to before that at @high. */
static void
add_nodes (SceneBuilder *builder,
           Role role,
           const uint32_t low[2],
           const uint32_t high[2])
{
  const double left = border (low[0]), right = border (high[0]);
  const double bottom = border (low[1]), top = border (high[1]);

  scene_add (builder, SHAPE_POLYGON, role, NO_OBJECT);
  scene_add_point (builder, (Point3){ left, bottom, 0 });
  scene_add_point (builder, (Point3){ right, bottom, 0 });
  scene_add_point (builder, (Point3){ right, top, 0 });
  scene_add_point (builder, (Point3){ left, top, 0 });
}

/* What turns left is one area under all others, so that its hatch is whole. */
static bool
is_ground (int sign)
{
  return sign > 0;
}

/* Returns: the end of the run of nodes that begins at @first. */
static uint32_t
end_of_run (const signed char *signs, uint32_t first, uint32_t end)
{
  uint32_t i;

  for (i = first + 1; i < end; i++)
    if (signs[i] != signs[first])
      break;
  return i;
}

/* Nodes from @first to before @end reach down under the row that is painted
 * next, where that is not ground. */
static void
reach_down (SceneBuilder *builder,
            int sign,
            const signed char *below,
            uint32_t row,
            const uint32_t ends[2])
{
  uint32_t first, end;

  for (first = ends[0]; first < ends[1]; first = end) {
    end = end_of_run (below, first, ends[1]);
    if (!is_ground (below[first]))
      add_nodes (builder, sign_role (sign), (uint32_t[2]){ first, row - 1 },
                 (uint32_t[2]){ end, row + 1 });
  }
}

/* Each run reaches a node further to the right and down, under the runs that
 * are painted after it: so no ground shows between them. @below is NULL for
 * the last row. */
static void
add_row (SceneBuilder *builder,
         const signed char *signs,
         const signed char *below,
         uint32_t row)
{
  uint32_t first, end;

  for (first = 0; first < SIGN_MAP_SIDE; first = end) {
    uint32_t right;

    right = end = end_of_run (signs, first, SIGN_MAP_SIDE);
    if (is_ground (signs[first]))
      continue;
    if (end < SIGN_MAP_SIDE && !is_ground (signs[end]))
      right++;
    if (below != NULL)
      reach_down (builder, signs[first], below, row,
                  (uint32_t[2]){ first, end });
    add_nodes (builder, sign_role (signs[first]), (uint32_t[2]){ first, row },
               (uint32_t[2]){ right, row + 1 });
  }
}

/* An outline of the nodes from @low to before @high, and so many more. */
static void
add_outline (SceneBuilder *builder,
             Role role,
             const uint32_t low[2],
             const uint32_t high[2],
             double more)
{
  const double left = border (low[0] - more), right = border (high[0] + more);
  const double bottom = border (low[1] - more), top = border (high[1] + more);
  const Point3 corners[5] = { { left, bottom, 0 },
                              { right, bottom, 0 },
                              { right, top, 0 },
                              { left, top, 0 },
                              { left, bottom, 0 } };
  int i;

  scene_add (builder, SHAPE_PATH, role, NO_OBJECT);
  for (i = 0; i < 5; i++)
    scene_add_point (builder, corners[i]);
}

void
scene_sign_map (Scene *scene,
                const SignMap *map,
                bool is_exact,
                const uint32_t node[2],
                const SceneLook *look)
{
  static const uint32_t all[2][2]
      = { { 0, 0 }, { SIGN_MAP_SIDE, SIGN_MAP_SIDE } };
  const signed char (*signs)[SIGN_MAP_SIDE]
      = is_exact ? map->exact : map->rounded;
  SceneBuilder builder;
  uint32_t row;

  scene_builder_open (&builder, scene, look, 0);
  scene->is_space = false;
  builder.pass = PASS_GROUND;
  add_nodes (&builder, ROLE_SIGN_LEFT, all[0], all[1]);
  for (row = SIGN_MAP_SIDE; row-- > 0;)
    add_row (&builder, signs[row], row > 0 ? signs[row - 1] : NULL, row);
  add_outline (&builder, ROLE_GROUND, all[0], all[1], 0);
  add_outline (&builder, ROLE_SIGN_NODE, node,
               (const uint32_t[2]){ node[0] + 1, node[1] + 1 }, NODE_ROOM);
  scene_light (&builder);
}

/* Hulls */

static Point3
at (const SceneBuilder *builder, const RoundedHull *hull, uint32_t site)
{
  return scene_point (builder->look, &hull->set->sites[site], false);
}

static void
add_loop (SceneBuilder *builder,
          const RoundedHull *hull,
          Role role,
          const uint32_t *corners,
          uint32_t n)
{
  uint32_t i;

  for (i = 0; i < n && n > 1; i++)
    scene_add_segment (builder, role, NO_OBJECT,
                       (Point3[2]){ at (builder, hull, corners[i]),
                                    at (builder, hull, corners[(i + 1) % n]) });
}

static void
add_area (SceneBuilder *builder, const RoundedHull *hull)
{
  uint32_t i;

  if (hull->n_true < 3)
    return;
  scene_add (builder, SHAPE_POLYGON, ROLE_HULL_AREA, NO_OBJECT);
  for (i = 0; i < hull->n_true; i++)
    scene_add_point (builder, at (builder, hull, hull->true_corners[i]));
}

static Role
site_role (const RoundedHull *hull, bool is_exact, uint32_t site)
{
  if (hull->set->first[site] != site)
    return ROLE_SITE_DUPLICATE;
  if (hull->n_steps > 0 && hull->steps[hull->n_steps - 1].site == site)
    return ROLE_SITE_APEX;
  if (!rounded_hull_has_tried (hull, site))
    return ROLE_SITE_WAITING;
  if (!is_exact && rounded_hull_has_lost (hull, site))
    return ROLE_SITE_LOST;
  return rounded_hull_has_corner (hull, is_exact, site) ? ROLE_SITE
                                                        : ROLE_SITE_IGNORED;
}

static void
add_sites (SceneBuilder *builder, const RoundedHull *hull, bool is_exact)
{
  uint32_t site;

  for (site = 0; site < hull->set->n_sites; site++)
    scene_add_mark (builder, site_role (hull, is_exact, site),
                    (Object){ OBJECT_SITE, site }, at (builder, hull, site),
                    scene_label (builder, 's', site));
}

void
scene_rounded (Scene *scene,
               const RoundedHull *hull,
               bool is_exact,
               const SceneLook *look)
{
  SceneBuilder builder;

  scene_builder_open (&builder, scene, look, hull->set->n_sites);
  scene->is_space = false;
  builder.pass = PASS_GROUND;
  scene_add_frame (&builder);
  if (is_exact)
    add_area (&builder, hull);
  if (is_exact)
    add_loop (&builder, hull, ROLE_HULL_EDGE, hull->true_corners, hull->n_true);
  else
    add_loop (&builder, hull, ROLE_ROUNDED_EDGE, hull->corners,
              hull->n_corners);
  builder.pass = PASS_MARKS;
  add_sites (&builder, hull, is_exact);
  scene_light (&builder);
}
