#include "camera-private.h"

#include <math.h>
#include <string.h>

/* Home: the eye's height above the plane and its turn to the right. */
#define HOME_ELEVATION (18 * ACOS_MINUS_1 / 180)
#define HOME_AZIMUTH (20 * ACOS_MINUS_1 / 180)
#define ACOS_MINUS_1 3.14159265358979323846

#define HOME_CENTRE 1.30

static const char *const preset_names[N_CAMERA_PRESETS] = {
  [CAMERA_HOME] = "home",
  [CAMERA_LOOK_UP] = "look-up",
  [CAMERA_LOOK_DOWN] = "look-down",
  [CAMERA_SIDE] = "side",
  [CAMERA_LOOK_UP_UNMIRRORED] = "look-up-unmirrored",
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
  *camera = (Camera){ .turn = { 1, 0, 0, 0 },
                      .centre = { 0, 0, HOME_CENTRE },
                      .zoom = 1,
                      .is_parallel = true };
  switch (preset) {
  case CAMERA_HOME:
    camera->turn = turn_of (HOME_AZIMUTH, HOME_ELEVATION);
    camera->is_parallel = false;
    break;
  case CAMERA_LOOK_UP_UNMIRRORED:
    camera->is_mirrored = true;
    camera->turn = (Quaternion){ 0, 0, 1, 0 };
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

/* Straight above and below there is no azimuth: it is all roll. */
#define LEAST_AWAY 1e-4

CameraStance
camera_stance (const Camera *camera)
{
  const double degree = ACOS_MINUS_1 / 180;
  const Quaternion turn = camera_normalize (camera->turn);
  /* The direction to the eye, in scene axes. */
  const Point3 eye = { 2 * (turn.x * turn.z - turn.w * turn.y),
                       2 * (turn.y * turn.z + turn.w * turn.x),
                       1 - 2 * (turn.x * turn.x + turn.y * turn.y) };
  const double away = hypot (eye.x, eye.y);
  const double azimuth = away < LEAST_AWAY ? 0 : atan2 (eye.x, -eye.y);
  const double elevation = atan2 (eye.z, away < LEAST_AWAY ? 0 : away);
  const Quaternion level = turn_of (azimuth, elevation);
  const Quaternion back = { level.w, -level.x, -level.y, -level.z };
  const Quaternion rest = quaternion_times (turn, back);

  return (CameraStance){ azimuth / degree, elevation / degree,
                         remainder (2 * atan2 (rest.z, rest.w) / degree, 360) };
}

void
camera_take_stance (Camera *camera, CameraStance stance)
{
  const double half = stance.roll * ACOS_MINUS_1 / 360;

  camera_stand (camera, stance.azimuth, stance.elevation);
  camera->turn = camera_normalize (quaternion_times (
      (Quaternion){ cos (half), 0, 0, sin (half) }, camera->turn));
}

bool
camera_equal (const Camera *a, const Camera *b)
{
  return a->turn.w == b->turn.w && a->turn.x == b->turn.x
         && a->turn.y == b->turn.y && a->turn.z == b->turn.z
         && a->centre.x == b->centre.x && a->centre.y == b->centre.y
         && a->centre.z == b->centre.z && a->zoom == b->zoom
         && a->pan_x == b->pan_x && a->pan_y == b->pan_y
         && a->is_parallel == b->is_parallel
         && a->is_mirrored == b->is_mirrored;
}

void
camera_follow_plane (Camera *camera, const PlaneCamera *plane)
{
  camera->zoom = plane->zoom;
  camera->centre.x = plane->centre_x;
  camera->centre.y = plane->centre_y;
  camera->pan_x = camera->pan_y = 0;
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
  Point3 a = ball_point (from_px, size_px);
  Point3 b = ball_point (to_px, size_px);
  Quaternion roll;

  /* The ball is rolled behind the mirror. */
  if (camera->is_mirrored) {
    a.x = -a.x;
    b.x = -b.x;
  }
  roll = camera_normalize ((Quaternion){
      1 + a.x * b.x + a.y * b.y + a.z * b.z, a.y * b.z - a.z * b.y,
      a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x });

  camera->turn = camera_normalize (quaternion_times (roll, camera->turn));
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
  const double scale
      = camera->zoom * camera_plane_scale (size_px[0], size_px[1]);

  camera->centre_x -= by_px[0] / scale;
  camera->centre_y += by_px[1] / scale;
}

void
camera_pan (Camera *camera, const double by_px[2], const double size_px[2])
{
  camera->pan_x += 2 * by_px[0] / size_px[1];
  camera->pan_y -= 2 * by_px[1] / size_px[1];
}
