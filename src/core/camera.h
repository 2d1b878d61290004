/* Cameras: from scene coordinates (scene.h) to the pixels of a view.
 *
 * A Projection is all that a painter and a picker know of a camera; the plane
 * view has one too, so that both views are painted and picked by one code.
 *
 *   PlaneCamera camera;
 *   Projection projection;
 *
 *   plane_camera_init (&camera);
 *   projection = plane_camera_projection (&camera, 400, 400);
 *   projection_apply (&projection, (Point3){ 0, 0, 0 }); is { 200, 200, 0 }
 */
#ifndef CAMERA_H
#define CAMERA_H

#include <stdbool.h>
#include <stdint.h>

typedef struct Point3 {
  double x, y, z;
} Point3;

typedef struct Quaternion {
  double w, x, y, z;
} Quaternion;

/* The look at space: turned about a centre, as with a trackball. */
typedef struct Camera {
  Quaternion turn; /* scene axes to eye axes (x right, y up, z to the eye) */
  Point3 centre;   /* the scene point in the middle of the view */
  double zoom;     /* 1: the scene fills the view; parallel: as the plane
                      view at zoom 1 */
  double pan_x, pan_y; /* in half view heights, right and up */
  bool is_parallel;    /* no perspective */
  bool is_mirrored;    /* left and right of the picture are exchanged */
} Camera;

/* The look at the plane. */
typedef struct PlaneCamera {
  double centre_x, centre_y; /* scene units */
  double zoom;               /* 1: the square -1 … 1 fills the view */
} PlaneCamera;

typedef struct Projection {
  double matrix[16];    /* column-major: scene → clip coordinates */
  Point3 eye;           /* scene units; at infinity when is_parallel */
  bool is_parallel;     /* then eye is the direction to the eye, length 1 */
  double width, height; /* of the view, px */
} Projection;

typedef enum CameraPreset {
  CAMERA_HOME,      /* from a little above, everything seen */
  CAMERA_LOOK_UP,   /* from below along z, parallel: the lower facets lie over
                       their shadows, mirrored left-right */
  CAMERA_LOOK_DOWN, /* from above along z, parallel */
  CAMERA_SIDE,      /* level with the plane, parallel */
  CAMERA_LOOK_UP_UNMIRRORED, /* look up, left and right as in the plane view */
} CameraPreset;

#define N_CAMERA_PRESETS (CAMERA_LOOK_UP_UNMIRRORED + 1)

/* Half the side of the square of the plane that space shows, scene units. */
#define CAMERA_GROUND 1.1

const char *camera_preset_name (CameraPreset preset); /* "look-up" … */
bool camera_preset_parse (const char *name, CameraPreset *preset);

void camera_init (Camera *camera, CameraPreset preset);

bool camera_equal (const Camera *a, const Camera *b);

/* Gives a parallel camera that looks along z the scale and the place of the
 * plane view: at equal sizes what lies over the plane falls on the same pixel,
 * or on the one that it is mirrored to. */
void camera_follow_plane (Camera *camera, const PlaneCamera *plane);

/* Returns: whether the eye stands below the plane: what it sees there is
 *          mirrored, unless the camera mirrors it again. */
bool camera_is_from_below (const Camera *camera);

void plane_camera_init (PlaneCamera *camera);

/* Lets home be seen from elsewhere: the eye turned to the right by @azimuth,
 * and lifted above the plane by @elevation. Units: degrees. */
void camera_stand (Camera *camera, double azimuth, double elevation);

/* Where the eye stands and how it is held. Units: degrees. */
typedef struct CameraStance {
  double azimuth, elevation; /* as camera_stand() has them */
  double roll;               /* of the picture, to the left */
} CameraStance;

CameraStance camera_stance (const Camera *camera);

/* Lets home be seen from there. */
void camera_take_stance (Camera *camera, CameraStance stance);

/* Turns as if a ball filling the view were rolled from one pixel to another.
 *
 * Source: Shoemake 1992, Arcball; Holroyd's sheet of a hyperbola outside the
 *         ball, so that no pixel is beyond it.
 */
void camera_roll (Camera *camera,
                  const double from_px[2],
                  const double to_px[2],
                  const double size_px[2]);

/* Returns: the camera that shows a paraboloid raised by @raise as whole as
 *          @camera shows one raised by RAISE_DEFAULT: its middle stays where it
 *          was, and as much of its height is seen. What lies over the plane
 *          keeps its scale where one looks along z. */
Camera camera_raised (const Camera *camera, double raise);

bool projection_equal (const Projection *a, const Projection *b);

Projection
camera_projection (const Camera *camera, double width, double height);
Projection plane_camera_projection (const PlaneCamera *camera,
                                    double width,
                                    double height);

/* The projection at @part, 0 … 1, of a smooth way from one camera to the
 * other. */
Projection camera_projection_between (const Camera *from,
                                      const Camera *to,
                                      double part,
                                      double width,
                                      double height);

/* Zooms by @factor so that the scene point under a pixel stays there. */
void plane_camera_zoom (PlaneCamera *camera,
                        double factor,
                        const double at_px[2],
                        const double size_px[2]);
void camera_zoom (Camera *camera,
                  double factor,
                  const double at_px[2],
                  const double size_px[2]);

/* Moves the picture by so many pixels, right and down. */
void plane_camera_pan (PlaneCamera *camera,
                       const double by_px[2],
                       const double size_px[2]);
void
camera_pan (Camera *camera, const double by_px[2], const double size_px[2]);

/* Returns: pixel coordinates, y down; z grows away from the eye, -1 … 1 for
 *          all that lies near the scene. Of no use for points behind the
 *          eye: clip.h leaves those out. */
Point3 projection_apply (const Projection *projection, Point3 point);

/* Homogeneous clip coordinates x, y, z, w; w > 0 before the eye. Here, because
 * every point that is shown goes through it. */
static inline void
projection_clip_coordinates (const Projection *projection,
                             Point3 point,
                             double clip[4])
{
  const double *m = projection->matrix;
  int row;

  for (row = 0; row < 4; row++)
    clip[row] = m[row] * point.x + m[row + 4] * point.y + m[row + 8] * point.z
                + m[row + 12];
}

/* Returns: the point of the plane z = 0 under a pixel. Plane view only. */
Point3 projection_unapply (const Projection *projection, double x, double y);

/* Returns: the direction from @point to the eye, length 1. */
Point3 projection_to_eye (const Projection *projection, Point3 point);

#endif
