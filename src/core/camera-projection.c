/* From cameras to matrices. */
#include "camera-private.h"

#include <math.h>

/* How much of the shorter side of a view the square -1 … 1 takes. */
#define PLANE_FILL 0.82

/* The paraboloid stands raised by 0.7 and ends at u² + v² = 2.2 at the most. */
#define HOME_RAISE 0.7
#define HOME_TALL 2.9

/* Half of what home shows of it, at the depth of the centre: */
#define HOME_HALF_WIDTH 1.6
#define HOME_HALF_HEIGHT 1.9

/* From the centre to the eye, and to where depth ends; scene units. */
#define EYE_DISTANCE 12.0
#define DEPTH 8.0

#define EDGE_ON 0.02 /* width of a picture that is turned like a card */

Quaternion
camera_normalize (Quaternion q)
{
  const double length = sqrt (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);

  if (!(length > 0))
    return (Quaternion){ 1, 0, 0, 0 };
  return (Quaternion){ q.w / length, q.x / length, q.y / length, q.z / length };
}

/* Rows of the rotation: the eye's axes in scene coordinates. */
static void
rotation_rows (Quaternion q, Point3 rows[3])
{
  rows[0]
      = (Point3){ 1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z),
                  2 * (q.x * q.z + q.w * q.y) };
  rows[1]
      = (Point3){ 2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z),
                  2 * (q.y * q.z - q.w * q.x) };
  rows[2] = (Point3){ 2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x),
                      1 - 2 * (q.x * q.x + q.y * q.y) };
}

static double
dot (Point3 a, Point3 b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

double
camera_plane_scale (double width, double height)
{
  return PLANE_FILL * fmin (width, height) / 2;
}

/* Pixels of a scene unit at the depth of the centre. */
static double
camera_scale (const Camera *camera, double width, double height)
{
  if (camera->is_parallel)
    return camera->zoom * camera_plane_scale (width, height);
  return camera->zoom
         * fmin (width / (2 * HOME_HALF_WIDTH),
                 height / (2 * HOME_HALF_HEIGHT));
}

static void
set_row (double matrix[16], int row, Point3 factor, double constant)
{
  matrix[row] = factor.x;
  matrix[row + 4] = factor.y;
  matrix[row + 8] = factor.z;
  matrix[row + 12] = constant;
}

/* @a + @factor · @b */
static Point3
add_scaled (Point3 a, double factor, Point3 b)
{
  return (Point3){ a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z };
}

static Point3
scaled (Point3 a, double factor)
{
  return add_scaled ((Point3){ 0, 0, 0 }, factor, a);
}

/* What a projection is made of: that of a camera, or something between those
 * of two. */
typedef struct Lens {
  Quaternion turn;
  Point3 centre;
  double scale; /* px of a scene unit at the depth of the centre */
  double fall;  /* 1 / distance of the eye from the centre; 0: parallel */
  double pan_x, pan_y;
  double mirror; /* 1, or -1 where left and right are exchanged */
} Lens;

static Lens
lens_of (const Camera *camera, double width, double height)
{
  return (Lens){ .turn = camera->turn,
                 .centre = camera->centre,
                 .scale = camera_scale (camera, width, height),
                 .fall = camera->is_parallel ? 0 : 1 / EYE_DISTANCE,
                 .pan_x = camera->pan_x,
                 .pan_y = camera->pan_y,
                 .mirror = camera->is_mirrored ? -1 : 1 };
}

/* w is 1 at the depth of the centre and falls towards the eye, where it is 0;
 * panning moves the picture, not the eye. */
static Projection
lens_projection (const Lens *lens, double width, double height)
{
  const double pan_x = lens->pan_x * height / width, pan_y = lens->pan_y;
  const double at_centre[4] = { pan_x, pan_y, lens->fall * DEPTH, 1 };
  Projection projection
      = { .is_parallel = lens->fall == 0, .width = width, .height = height };
  Point3 axis[3], row[4];
  int i;

  rotation_rows (lens->turn, axis);
  row[3] = scaled (axis[2], -lens->fall);
  row[0] = add_scaled (scaled (axis[0], 2 * lens->mirror * lens->scale / width),
                       pan_x, row[3]);
  row[1]
      = add_scaled (scaled (axis[1], 2 * lens->scale / height), pan_y, row[3]);
  row[2] = scaled (axis[2], -1 / DEPTH);
  for (i = 0; i < 4; i++)
    set_row (projection.matrix, i, row[i],
             at_centre[i] - dot (row[i], lens->centre));
  projection.eye = projection.is_parallel
                       ? axis[2]
                       : add_scaled (lens->centre, 1 / lens->fall, axis[2]);
  return projection;
}

Camera
camera_raised (const Camera *camera, double raise)
{
  const double more = raise - HOME_RAISE;
  Camera raised = *camera;
  double upright;
  Point3 axis[3];

  rotation_rows (camera->turn, axis);
  upright = sqrt (fmax (0, 1 - axis[2].z * axis[2].z));
  raised.centre.z += more / 2;
  raised.zoom *= HOME_TALL / (HOME_TALL + fmax (more, 0) * upright);
  return raised;
}

Projection
camera_projection (const Camera *camera, double width, double height)
{
  const Lens lens = lens_of (camera, width, height);

  return lens_projection (&lens, width, height);
}

static double
between (double from, double to, double part)
{
  return from + part * (to - from);
}

/* The shorter way round. */
static Quaternion
turn_between (Quaternion from, Quaternion to, double part)
{
  const double cosine
      = from.w * to.w + from.x * to.x + from.y * to.y + from.z * to.z;
  const double sign = cosine < 0 ? -1 : 1;

  return camera_normalize ((Quaternion){ between (from.w, sign * to.w, part),
                                         between (from.x, sign * to.x, part),
                                         between (from.y, sign * to.y, part),
                                         between (from.z, sign * to.z, part) });
}

/* A picture turned like a card, but never so that it has no width at all. */
static double
mirror_between (double from, double to, double part)
{
  const double mirror = between (from, to, part);

  return copysign (fmax (fabs (mirror), EDGE_ON), mirror);
}

Projection
camera_projection_between (const Camera *from,
                           const Camera *to,
                           double part,
                           double width,
                           double height)
{
  const Lens a = lens_of (from, width, height);
  const Lens b = lens_of (to, width, height);
  const Lens lens
      = { .turn = turn_between (a.turn, b.turn, part),
          .centre = { between (a.centre.x, b.centre.x, part),
                      between (a.centre.y, b.centre.y, part),
                      between (a.centre.z, b.centre.z, part) },
          .scale = exp (between (log (a.scale), log (b.scale), part)),
          .fall = between (a.fall, b.fall, part),
          .pan_x = between (a.pan_x, b.pan_x, part),
          .pan_y = between (a.pan_y, b.pan_y, part),
          .mirror = mirror_between (a.mirror, b.mirror, part) };

  return lens_projection (&lens, width, height);
}

bool
camera_is_from_below (const Camera *camera)
{
  Point3 axis[3];

  rotation_rows (camera->turn, axis);
  return axis[2].z < 0;
}

Projection
plane_camera_projection (const PlaneCamera *camera, double width, double height)
{
  const double scale = camera->zoom * camera_plane_scale (width, height);
  const double x = 2 * scale / width, y = 2 * scale / height;
  Projection projection = {
    .eye = { 0, 0, 1 }, .is_parallel = true, .width = width, .height = height
  };

  set_row (projection.matrix, 0, (Point3){ x, 0, 0 }, -x * camera->centre_x);
  set_row (projection.matrix, 1, (Point3){ 0, y, 0 }, -y * camera->centre_y);
  set_row (projection.matrix, 2, (Point3){ 0, 0, -1 / DEPTH }, 0);
  set_row (projection.matrix, 3, (Point3){ 0, 0, 0 }, 1);
  return projection;
}
