/* The layer that tells why, in the plane and in space: why.h says what it
 * shows. */
#include "clip.h"
#include "scene-builder.h"
#include "why.h"

#include <math.h>

/* How far the patch of plane goes beyond the circle, times its radius, but no
 * more than so much; and round the end of the gap. */
#define MARGIN 0.15
#define MARGIN_MOST 0.08
#define ROOM 0.06

#define PATCH_ROOM 12 /* corners: of a square, two more for each cut */
#define N_PARABOLA 48

static const Object no_object = { OBJECT_NONE, 0 };

static Why
find_why (const SceneBuilder *builder)
{
  const SceneLook *look = builder->look;

  if (!scene_has_layer (builder, LAYER_WHY))
    return (Why){ INDEX_NONE, INDEX_NONE };
  return why_find (builder->frame, look->selection, look->hover,
                   look->measured);
}

/* The plane z = level + slope.x x + slope.y y through three lifts. With the
 * centre o and the radius r of their circle it is 2 o·p - o² + r². */
typedef struct FacetPlane {
  Site centre;
  double radius;
  double level;
} FacetPlane;

static FacetPlane
plane_of (const SceneBuilder *builder, uint32_t facet)
{
  const uint32_t *corner = scene_facet_sites (builder, facet);
  const Point3 a = scene_at (builder, corner[0], false);
  const Point3 b = scene_at (builder, corner[1], false);
  const Point3 c = scene_at (builder, corner[2], false);
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double ex = c.x - a.x, ey = c.y - a.y;
  const double d = dx * dx + dy * dy, e = ex * ex + ey * ey;
  const double area = 2 * (dx * ey - dy * ex);
  const Site to = { (d * ey - e * dy) / area, (e * dx - d * ex) / area };
  const Site centre = { a.x + to.x, a.y + to.y };

  /* r² - o² = a² - 2 o·a, for the radius is the distance to a. */
  return (FacetPlane){ centre, hypot (to.x, to.y),
                       a.x * a.x + a.y * a.y
                           - 2 * (centre.x * a.x + centre.y * a.y) };
}

static Point3
on_plane (const SceneBuilder *builder, const FacetPlane *plane, Pixel at)
{
  const SceneLook *look = builder->look;

  return (Point3){
    at.x, at.y,
    look->lift
        * (look->raise + plane->level
           + 2 * (plane->centre.x * at.x + plane->centre.y * at.y))
  };
}

/* A patch of a facet's plane: what of it lies over a rectangle of the ground
 * between two heights. */
typedef struct Patch {
  Pixel low, high;
  double floor, ceiling;
} Patch;

/* As high as the paraboloid, but the gap of a site ends on it wherever that
 * is. */
static Patch
find_patch (const SceneBuilder *builder, Why why, const FacetPlane *plane)
{
  const double rim = scene_rim (builder);
  const double r = plane->radius + fmin (MARGIN * plane->radius, MARGIN_MOST);
  const Pixel o = { plane->centre.x, plane->centre.y };
  Patch patch = { { o.x - r, o.y - r },
                  { o.x + r, o.y + r },
                  0,
                  builder->look->lift * (builder->look->raise + rim * rim) };
  Point3 foot;

  if (why.site == INDEX_NONE)
    return patch;
  foot = scene_at (builder, why.site, false);
  foot = on_plane (builder, plane, (Pixel){ foot.x, foot.y });
  patch.low.x = fmin (patch.low.x, foot.x - ROOM);
  patch.low.y = fmin (patch.low.y, foot.y - ROOM);
  patch.high.x = fmax (patch.high.x, foot.x + ROOM);
  patch.high.y = fmax (patch.high.y, foot.y + ROOM);
  patch.floor = fmin (patch.floor, foot.z - ROOM);
  patch.ceiling = fmax (patch.ceiling, foot.z + ROOM);
  return patch;
}

/* The rectangle of a patch, cut off where the paraboloid is. */
static uint32_t
find_corners (const SceneBuilder *builder,
              const FacetPlane *plane,
              const Patch *patch,
              Point3 corners[PATCH_ROOM])
{
  const double reach = fmax (CAMERA_GROUND, scene_rim (builder));
  Pixel in_plane[8] = { patch->low,
                        { patch->high.x, patch->low.y },
                        patch->high,
                        { patch->low.x, patch->high.y } };
  const uint32_t n = clip_polygon_to_rectangle (
      (Pixel){ -reach, -reach }, (Pixel){ reach, reach }, in_plane, 4);
  uint32_t i;

  for (i = 0; i < n; i++)
    corners[i] = on_plane (builder, plane, in_plane[i]);
  return n;
}

/* Keeps what of a convex polygon lies above a height; below, for @sign -1. */
static uint32_t
cut_at (Point3 corners[PATCH_ROOM], uint32_t n, double height, int sign)
{
  Point3 kept[PATCH_ROOM];
  uint32_t i, n_kept = 0;

  for (i = 0; i < n; i++) {
    const Point3 a = corners[i], b = corners[(i + 1) % n];
    const double from = sign * (a.z - height), to = sign * (b.z - height);

    if (from >= 0)
      kept[n_kept++] = a;
    if ((from >= 0) != (to >= 0)) {
      const double t = from / (from - to);

      kept[n_kept++]
          = (Point3){ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), height };
    }
  }
  for (i = 0; i < n_kept; i++)
    corners[i] = kept[i];
  return n_kept;
}

static void
add_patch (SceneBuilder *builder,
           uint32_t facet,
           const FacetPlane *plane,
           const Patch *patch)
{
  const bool is_lower = why_facing (builder->frame, facet) == FACING_LOWER;
  Point3 corners[PATCH_ROOM];
  uint32_t n = find_corners (builder, plane, patch, corners);
  uint32_t i;

  n = cut_at (corners, n, patch->floor, 1);
  n = cut_at (corners, n, patch->ceiling, -1);
  if (n < 3)
    return;
  scene_add (builder, SHAPE_POLYGON, ROLE_PLANE, no_object);
  /* Its outside is that of the facet: below, or above. */
  for (i = 0; i < n; i++)
    scene_add_point (builder, corners[is_lower ? n - 1 - i : i]);
}

/* The line of a vertical facet's hull edge, cut off at the ground's border. */
static bool
line_of (const SceneBuilder *builder, uint32_t facet, Pixel ends[2])
{
  const Pixel low = { -CAMERA_GROUND, -CAMERA_GROUND };
  const Pixel high = { CAMERA_GROUND, CAMERA_GROUND };
  const uint32_t *corner = scene_facet_sites (builder, facet);
  const Point3 a = scene_at (builder, corner[0], false);
  Point3 b = scene_at (builder, corner[1], false);
  double length = hypot (b.x - a.x, b.y - a.y);

  if (!(length > 0)) {
    b = scene_at (builder, corner[2], false);
    length = hypot (b.x - a.x, b.y - a.y);
  }
  ends[0] = (Pixel){ a.x - 4 * (b.x - a.x) / length,
                     a.y - 4 * (b.y - a.y) / length };
  ends[1] = (Pixel){ a.x + 4 * (b.x - a.x) / length,
                     a.y + 4 * (b.y - a.y) / length };
  return length > 0 && clip_to_rectangle (low, high, ends);
}

static double
paraboloid_at (const SceneBuilder *builder, double x, double y)
{
  return builder->look->lift * (builder->look->raise + x * x + y * y);
}

/* A vertical plane cuts the paraboloid in a parabola; its shadow is a line. */
static void
add_upright (SceneBuilder *builder, uint32_t facet)
{
  Pixel ends[2];
  int i;

  if (!line_of (builder, facet, ends))
    return;
  scene_add (builder, SHAPE_POLYGON, ROLE_PLANE, no_object)->is_two_sided
      = true;
  for (i = 0; i < 4; i++) {
    const Pixel at = ends[i == 1 || i == 2];

    scene_add_point (
        builder, (Point3){ at.x, at.y,
                           i < 2 ? 0 : paraboloid_at (builder, at.x, at.y) });
  }
}

static void
add_parabola (SceneBuilder *builder, uint32_t facet, bool lifted)
{
  Pixel ends[2];
  int i;

  if (!line_of (builder, facet, ends))
    return;
  scene_add (builder, SHAPE_PATH, ROLE_ELLIPSE, no_object);
  for (i = 0; i <= N_PARABOLA; i++) {
    const double t = (double)i / N_PARABOLA;
    const double x = ends[0].x + t * (ends[1].x - ends[0].x);
    const double y = ends[0].y + t * (ends[1].y - ends[0].y);

    scene_add_point (
        builder, (Point3){ x, y, lifted ? paraboloid_at (builder, x, y) : 0 });
  }
}

void
scene_add_why_plane (SceneBuilder *builder)
{
  const Why why = find_why (builder);
  FacetPlane plane;
  Patch patch;

  if (why.facet == INDEX_NONE)
    return;
  if (why_facing (builder->frame, why.facet) == FACING_VERTICAL) {
    add_upright (builder, why.facet);
    return;
  }
  plane = plane_of (builder, why.facet);
  if (!isfinite (plane.radius))
    return;
  patch = find_patch (builder, why, &plane);
  add_patch (builder, why.facet, &plane, &patch);
}

/* In the plane: the square on this segment is the power. From outside it
 * touches the circle; inside it is half the chord through the site that the
 * site halves. */
static void
plane_gap (const FacetPlane *plane, Point3 at, Point3 ends[2])
{
  const double x = at.x - plane->centre.x, y = at.y - plane->centre.y;
  const double distance = hypot (x, y), r = plane->radius;
  const double cosine = r / distance;
  double sine;

  ends[0] = ends[1] = at;
  if (distance < r) {
    const double half = sqrt ((r - distance) * (r + distance));
    const Pixel along = distance > 0 ? (Pixel){ -y / distance, x / distance }
                                     : (Pixel){ 1, 0 };

    ends[1].x += half * along.x;
    ends[1].y += half * along.y;
    return;
  }
  sine = sqrt ((1 - cosine) * (1 + cosine));
  ends[1].x = plane->centre.x + r * (cosine * x - sine * y) / distance;
  ends[1].y = plane->centre.y + r * (cosine * y + sine * x) / distance;
}

static void
add_gap (SceneBuilder *builder, Why why, bool lifted)
{
  const uint32_t *corner = scene_facet_sites (builder, why.facet);
  const Point3 at = scene_at (builder, why.site, lifted);
  const FacetPlane plane = plane_of (builder, why.facet);
  Point3 ends[2] = { at, at };
  char text[WHY_NUMBER_ROOM];

  if (!isfinite (plane.radius))
    return;
  if (lifted)
    ends[1] = on_plane (builder, &plane, (Pixel){ at.x, at.y });
  else
    plane_gap (&plane, at, ends);
  scene_add_segment (builder, ROLE_GAP, (Object){ OBJECT_SITE, why.site },
                     ends);
  why_write_number (why_power (builder->frame->trace->set, corner, why.site),
                    text);
  scene_add_mark (builder, ROLE_POWER, no_object,
                  (Point3){ (ends[0].x + ends[1].x) / 2,
                            (ends[0].y + ends[1].y) / 2,
                            (ends[0].z + ends[1].z) / 2 },
                  scene_text (builder, text));
}

static bool
is_corner (const uint32_t corner[3], uint32_t site)
{
  return corner[0] == site || corner[1] == site || corner[2] == site;
}

void
scene_add_why (SceneBuilder *builder, bool lifted)
{
  const Why why = find_why (builder);

  if (why.facet == INDEX_NONE)
    return;
  if (why_facing (builder->frame, why.facet) == FACING_VERTICAL) {
    add_parabola (builder, why.facet, lifted);
    return;
  }
  if (lifted)
    scene_add_ellipse (builder, scene_facet_sites (builder, why.facet));
  if (why.site != INDEX_NONE
      && !is_corner (scene_facet_sites (builder, why.facet), why.site))
    add_gap (builder, why, lifted);
}
