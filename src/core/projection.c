#include "camera.h"

#include <math.h>

bool
projection_equal (const Projection *a, const Projection *b)
{
  int i;

  for (i = 0; i < 16; i++)
    if (a->matrix[i] != b->matrix[i])
      return false;
  return a->eye.x == b->eye.x && a->eye.y == b->eye.y && a->eye.z == b->eye.z
         && a->is_parallel == b->is_parallel && a->width == b->width
         && a->height == b->height;
}

Point3
projection_apply (const Projection *projection, Point3 point)
{
  double clip[4];

  projection_clip_coordinates (projection, point, clip);
  return (Point3){ (1 + clip[0] / clip[3]) * projection->width / 2,
                   (1 - clip[1] / clip[3]) * projection->height / 2,
                   clip[2] / clip[3] };
}

Point3
projection_unapply (const Projection *projection, double x, double y)
{
  const double *m = projection->matrix;

  return (Point3){ (2 * x / projection->width - 1 - m[12]) / m[0],
                   (1 - 2 * y / projection->height - m[13]) / m[5], 0 };
}

Point3
projection_to_eye (const Projection *projection, Point3 point)
{
  const Point3 eye = projection->eye;
  const Point3 to = { eye.x - point.x, eye.y - point.y, eye.z - point.z };
  const double length = sqrt (to.x * to.x + to.y * to.y + to.z * to.z);

  if (projection->is_parallel || !(length > 0))
    return eye;
  return (Point3){ to.x / length, to.y / length, to.z / length };
}
