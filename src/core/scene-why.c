/* The layer that tells why, in the plane and in space: why.h says what it
 * shows. */
#include "clip.h"
#include "scene-builder.h"
#include "why.h"

#include <math.h>

#define MARGIN 1.15 /* of the patch of plane beyond the circle */
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

/* Adds what of the patch lies above the ground; in @corners, with room for
 * two more. */
static void
add_patch (SceneBuilder *builder,
           uint32_t facet,
           const FacetPlane *plane,
           const Pixel *corners,
           uint32_t n)
{
  const bool is_lower = why_facing (builder->frame, facet) == FACING_LOWER;
  uint32_t i;

  scene_add (builder, SHAPE_POLYGON, ROLE_PLANE, no_object);
  for (i = 0; i < n; i++) {
    /* Its outside is that of the facet: below, or above. */
    const uint32_t k = is_lower ? n - 1 - i : i;
    const uint32_t next = is_lower ? (k + n - 1) % n : (k + 1) % n;
    const Point3 a = on_plane (builder, plane, corners[k]);
    const Point3 b = on_plane (builder, plane, corners[next]);

    if (a.z >= 0)
      scene_add_point (builder, a);
    if ((a.z >= 0) != (b.z >= 0)) {
      const double t = a.z / (a.z - b.z);

      scene_add_point (
          builder, (Point3){ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0 });
    }
  }
  if (builder->scene->items[builder->scene->n_items - 1].n < 3)
    scene_drop_item (builder);
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
  const Pixel low = { -CAMERA_GROUND, -CAMERA_GROUND };
  const Pixel high = { CAMERA_GROUND, CAMERA_GROUND };
  const Why why = find_why (builder);
  FacetPlane plane;
  Pixel corners[8];
  double r;

  if (why.facet == INDEX_NONE)
    return;
  if (why_facing (builder->frame, why.facet) == FACING_VERTICAL) {
    add_upright (builder, why.facet);
    return;
  }
  plane = plane_of (builder, why.facet);
  r = MARGIN * plane.radius;
  if (!isfinite (r))
    return;
  corners[0] = (Pixel){ plane.centre.x - r, plane.centre.y - r };
  corners[1] = (Pixel){ plane.centre.x + r, plane.centre.y - r };
  corners[2] = (Pixel){ plane.centre.x + r, plane.centre.y + r };
  corners[3] = (Pixel){ plane.centre.x - r, plane.centre.y + r };
  add_patch (builder, why.facet, &plane, corners,
             clip_polygon_to_rectangle (low, high, corners, 4));
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
  const Point3 box[2] = { { -CAMERA_GROUND, -CAMERA_GROUND, 0 },
                          { CAMERA_GROUND, CAMERA_GROUND, 0 } };
  const Why why = find_why (builder);

  if (why.facet == INDEX_NONE)
    return;
  if (why_facing (builder->frame, why.facet) == FACING_VERTICAL) {
    add_parabola (builder, why.facet, lifted);
    return;
  }
  if (lifted)
    scene_add_circle (builder, ROLE_ELLIPSE, no_object,
                      scene_facet_sites (builder, why.facet), box, true);
  if (why.site != INDEX_NONE
      && !is_corner (scene_facet_sites (builder, why.facet), why.site))
    add_gap (builder, why, lifted);
}
