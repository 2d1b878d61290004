#include "camera.h"

#include <math.h>
#include <string.h>

/* How much of the shorter side of a view the square -1 … 1 takes. */
#define PLANE_FILL 0.82

/* Home: the eye's height above the plane and its turn to the right. */
#define HOME_ELEVATION (18 * ACOS_MINUS_1 / 180)
#define HOME_AZIMUTH (20 * ACOS_MINUS_1 / 180)
#define ACOS_MINUS_1 3.14159265358979323846

/* The paraboloid stands raised by 0.7 and ends at u² + v² = 2.2 at the most.
 * Half of what home shows of it, at the depth of the centre: */
#define HOME_HALF_WIDTH 1.6
#define HOME_HALF_HEIGHT 1.9
#define HOME_CENTRE 1.30

/* From the centre to the eye, and to where depth ends; scene units. */
#define EYE_DISTANCE 12.0
#define DEPTH 8.0

static const char *const preset_names[N_CAMERA_PRESETS] = {
  [CAMERA_HOME] = "home",
  [CAMERA_LOOK_UP] = "look-up",
  [CAMERA_LOOK_DOWN] = "look-down",
  [CAMERA_SIDE] = "side",
};

const char *
camera_preset_name (CameraPreset preset)
{
  return preset_names[preset];
}

bool
camera_preset_parse (const char *name, CameraPreset *preset)
{
  int i;

  for (i = 0; i < N_CAMERA_PRESETS; i++) {
    if (strcmp (name, preset_names[i]) != 0)
      continue;
    *preset = (CameraPreset)i;
    return true;
  }
  return false;
}

static Quaternion
quaternion_times (Quaternion a, Quaternion b)
{
  return (Quaternion){ a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                       a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                       a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                       a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w };
}

static Quaternion
quaternion_normalize (Quaternion q)
{
  const double length = sqrt (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);

  if (!(length > 0))
    return (Quaternion){ 1, 0, 0, 0 };
  return (Quaternion){ q.w / length, q.x / length, q.y / length, q.z / length };
}

/* The eye stands in front of the plane (at negative y), turned to the right
 * by @azimuth and lifted by @elevation. */
static Quaternion
turn_of (double azimuth, double elevation)
{
  const double tilt = elevation - ACOS_MINUS_1 / 2;
  const Quaternion about_x = { cos (tilt / 2), sin (tilt / 2), 0, 0 };
  const Quaternion about_z = { cos (azimuth / 2), 0, 0, -sin (azimuth / 2) };

  return quaternion_times (about_x, about_z);
}

void
camera_init (Camera *camera, CameraPreset preset)
{
  *camera = (Camera){ { 1, 0, 0, 0 }, { 0, 0, HOME_CENTRE }, 1, 0, 0, true };
  switch (preset) {
  case CAMERA_HOME:
    camera->turn = turn_of (HOME_AZIMUTH, HOME_ELEVATION);
    camera->is_parallel = false;
    break;
  case CAMERA_LOOK_UP:
    camera->turn = (Quaternion){ 0, 0, 1, 0 };
    break;
  case CAMERA_LOOK_DOWN:
    break;
  case CAMERA_SIDE:
    /* Lower than the plane view's scale, for 2.7 units of height. */
    camera->turn = turn_of (0, 0);
    camera->zoom = 0.78;
    break;
  }
}

void
camera_stand (Camera *camera, double azimuth, double elevation)
{
  const double degree = ACOS_MINUS_1 / 180;

  camera_init (camera, CAMERA_HOME);
  camera->turn = turn_of (azimuth * degree, elevation * degree);
}

void
plane_camera_init (PlaneCamera *camera)
{
  *camera = (PlaneCamera){ 0, 0, 1 };
}

/* The point of the ball, or of the hyperbola around it, over a pixel. */
static Point3
ball_point (const double px[2], const double size_px[2])
{
  const double radius = fmin (size_px[0], size_px[1]) / 2;
  const double x = (px[0] - size_px[0] / 2) / radius;
  const double y = (size_px[1] / 2 - px[1]) / radius;
  const double squared = x * x + y * y;
  const double z = squared < 0.5 ? sqrt (1 - squared) : 0.5 / sqrt (squared);
  const double length = sqrt (squared + z * z);

  return (Point3){ x / length, y / length, z / length };
}

void
camera_roll (Camera *camera,
             const double from_px[2],
             const double to_px[2],
             const double size_px[2])
{
  const Point3 a = ball_point (from_px, size_px);
  const Point3 b = ball_point (to_px, size_px);
  const Quaternion roll = quaternion_normalize ((Quaternion){
      1 + a.x * b.x + a.y * b.y + a.z * b.z, a.y * b.z - a.z * b.y,
      a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x });

  camera->turn = quaternion_normalize (quaternion_times (roll, camera->turn));
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

/* Pixels of a scene unit in the plane view at zoom 1. */
static double
plane_scale (double width, double height)
{
  return PLANE_FILL * fmin (width, height) / 2;
}

/* Pixels of a scene unit at the depth of the centre. */
static double
camera_scale (const Camera *camera, double width, double height)
{
  if (camera->is_parallel)
    return camera->zoom * plane_scale (width, height);
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

/* w is 1 at the depth of the centre and falls towards the eye, where it is 0;
 * panning moves the picture, not the eye. */
Projection
camera_projection (const Camera *camera, double width, double height)
{
  const double scale = camera_scale (camera, width, height);
  const double fall = camera->is_parallel ? 0 : 1 / EYE_DISTANCE;
  Projection projection = { .is_parallel = camera->is_parallel,
                            .width = width,
                            .height = height };
  Point3 axis[3], row[4];
  int i;

  rotation_rows (camera->turn, axis);
  row[3] = scaled (axis[2], -fall);
  row[0] = add_scaled (scaled (axis[0], 2 * scale / width),
                       camera->pan_x * height / width, row[3]);
  row[1] = add_scaled (scaled (axis[1], 2 * scale / height), camera->pan_y,
                       row[3]);
  row[2] = scaled (axis[2], -1 / DEPTH);
  for (i = 0; i < 4; i++) {
    const double at_centre[4]
        = { camera->pan_x * height / width, camera->pan_y, fall * DEPTH, 1 };

    set_row (projection.matrix, i, row[i],
             at_centre[i] - dot (row[i], camera->centre));
  }
  projection.eye = camera->is_parallel
                       ? axis[2]
                       : add_scaled (camera->centre, EYE_DISTANCE, axis[2]);
  return projection;
}

Projection
plane_camera_projection (const PlaneCamera *camera, double width, double height)
{
  const double scale = camera->zoom * plane_scale (width, height);
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

void
plane_camera_zoom (PlaneCamera *camera,
                   double factor,
                   const double at_px[2],
                   const double size_px[2])
{
  const Projection before
      = plane_camera_projection (camera, size_px[0], size_px[1]);
  const Point3 fixed = projection_unapply (&before, at_px[0], at_px[1]);

  camera->zoom *= factor;
  camera->centre_x = fixed.x + (camera->centre_x - fixed.x) / factor;
  camera->centre_y = fixed.y + (camera->centre_y - fixed.y) / factor;
}

/* The picture grows about the pixel: so does its pan. */
void
camera_zoom (Camera *camera,
             double factor,
             const double at_px[2],
             const double size_px[2])
{
  const double x = (2 * at_px[0] - size_px[0]) / size_px[1];
  const double y = 1 - 2 * at_px[1] / size_px[1];

  camera->zoom *= factor;
  camera->pan_x = x + factor * (camera->pan_x - x);
  camera->pan_y = y + factor * (camera->pan_y - y);
}

void
plane_camera_pan (PlaneCamera *camera,
                  const double by_px[2],
                  const double size_px[2])
{
  const double scale = camera->zoom * plane_scale (size_px[0], size_px[1]);

  camera->centre_x -= by_px[0] / scale;
  camera->centre_y += by_px[1] / scale;
}

void
camera_pan (Camera *camera, const double by_px[2], const double size_px[2])
{
  camera->pan_x += 2 * by_px[0] / size_px[1];
  camera->pan_y -= 2 * by_px[1] / size_px[1];
}
