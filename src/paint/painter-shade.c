/* The light on facets. */
#include "painter-private.h"

#include <math.h>

/* Shade of a facet seen edge-on; face-on it is 1. */
#define SHADE_LEAST 0.78

static Point3
normal_of (const Point3 *points)
{
  const Point3 a = points[0], b = points[1], c = points[2];
  const Point3 d = { b.x - a.x, b.y - a.y, b.z - a.z };
  const Point3 e = { c.x - a.x, c.y - a.y, c.z - a.z };

  return (Point3){ d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z,
                   d.x * e.y - d.y * e.x };
}

Point3
painter_lamp (const Projection *projection)
{
  const double *m = projection->matrix;
  const double right = hypot (m[0], hypot (m[4], m[8]));
  const double up = hypot (m[1], hypot (m[5], m[9]));

  return (Point3){ 0.45 * m[1] / up - 0.35 * m[0] / right,
                   0.45 * m[5] / up - 0.35 * m[4] / right,
                   0.45 * m[9] / up - 0.35 * m[8] / right };
}

static Point3
light_at (const Painter *painter, Point3 point)
{
  const Point3 eye = projection_to_eye (painter->projection, point);
  const Point3 lamp = painter->lamp;

  return (Point3){ eye.x + lamp.x, eye.y + lamp.y, eye.z + lamp.z };
}

static double
dot (Point3 a, Point3 b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Colour
painter_shade (const Painter *painter, const SceneItem *item, Colour fill)
{
  const Point3 *points = &painter->scene->points[item->first];
  const Point3 normal = normal_of (points);
  const Point3 light = light_at (painter, points[0]);
  const double cosine = fabs (dot (normal, light))
                        / sqrt (dot (normal, normal) * dot (light, light));
  const Colour black = { 0, 0, 0, 1 };

  if (!isfinite (cosine))
    return fill;
  return colour_mix (fill, black, (1 - SHADE_LEAST) * (1 - cosine));
}
