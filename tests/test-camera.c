#include "camera.h"
#include "clip.h"
#include "scene.h"

#include <glib.h>
#include <math.h>

static const double sizes[][2]
    = { { 400, 640 }, { 650, 700 }, { 320, 320 }, { 900, 340 } };

#define N_SIZES (sizeof sizes / sizeof sizes[0])

static void
assert_near (double a, double b, double tolerance)
{
  if (!(fabs (a - b) <= tolerance))
    g_error ("%.17g is not within %g of %.17g", a, tolerance, b);
}

static Point3
lift (double x, double y)
{
  return (Point3){ x, y, 0.7 + x * x + y * y };
}

static void
test_look_up (void)
{
  size_t i;
  int x, y;

  for (i = 0; i < N_SIZES; i++) {
    const double w = sizes[i][0], h = sizes[i][1];
    PlaneCamera plane;
    Camera space;
    Projection on_plane, on_space;

    plane_camera_init (&plane);
    camera_init (&space, CAMERA_LOOK_UP);
    on_plane = plane_camera_projection (&plane, w, h);
    on_space = camera_projection (&space, w, h);
    for (x = -10; x <= 10; x++)
      for (y = -10; y <= 10; y++) {
        const Point3 site = { x / 10.0, y / 10.0, 0 };
        const Point3 a = projection_apply (&on_plane, site);
        const Point3 b = projection_apply (&on_space, lift (site.x, site.y));

        assert_near (b.x, w - a.x, 1e-9);
        assert_near (b.y, a.y, 1e-9);
      }
  }
}

/* Wherever the plane view looks, and mirrored or not. */
static void
test_follow (void)
{
  const CameraPreset presets[3]
      = { CAMERA_LOOK_UP, CAMERA_LOOK_UP_UNMIRRORED, CAMERA_LOOK_DOWN };
  const PlaneCamera plane = { 0.31, -0.47, 2.7 };
  size_t i;
  int k, x, y;

  for (i = 0; i < N_SIZES; i++)
    for (k = 0; k < 3; k++) {
      const double w = sizes[i][0], h = sizes[i][1];
      const Projection on_plane = plane_camera_projection (&plane, w, h);
      const bool is_mirrored = presets[k] == CAMERA_LOOK_UP;
      Camera space;
      Projection on_space;

      camera_init (&space, presets[k]);
      camera_follow_plane (&space, &plane);
      on_space = camera_projection (&space, w, h);
      g_assert_true (camera_is_from_below (&space)
                     == (presets[k] != CAMERA_LOOK_DOWN));
      for (x = -10; x <= 10; x++)
        for (y = -10; y <= 10; y++) {
          const Point3 site = { x / 10.0, y / 10.0, 0 };
          const Point3 a = projection_apply (&on_plane, site);
          const Point3 b = projection_apply (&on_space, lift (site.x, site.y));

          assert_near (b.x, is_mirrored ? w - a.x : a.x, 0.5);
          assert_near (b.y, a.y, 0.5);
        }
    }
}

/* A way from camera to camera begins and ends at them, and no step of it is
 * a leap. */
static void
test_between (void)
{
  Camera from, to;
  int a, b, i;

  for (a = 0; a < N_CAMERA_PRESETS; a++)
    for (b = 0; b < N_CAMERA_PRESETS; b++) {
      Projection at[2];
      Point3 last;

      camera_init (&from, (CameraPreset)a);
      camera_init (&to, (CameraPreset)b);
      at[0] = camera_projection (&from, 500, 400);
      at[1] = camera_projection (&to, 500, 400);
      last = projection_apply (&at[0], lift (0.8, -0.6));
      for (i = 0; i <= 1000; i++) {
        const Projection here
            = camera_projection_between (&from, &to, i / 1000.0, 500, 400);
        const Point3 p = projection_apply (&here, lift (0.8, -0.6));

        assert_near (p.x, last.x, 20);
        assert_near (p.y, last.y, 20);
        last = p;
      }
      assert_near (last.x, projection_apply (&at[1], lift (0.8, -0.6)).x, 1e-6);
      assert_near (last.y, projection_apply (&at[1], lift (0.8, -0.6)).y, 1e-6);
    }
}

static void
test_home (void)
{
  size_t i;
  int k;

  for (i = 0; i < N_SIZES; i++) {
    const double w = sizes[i][0], h = sizes[i][1];
    Camera camera;
    Projection projection;

    camera_init (&camera, CAMERA_HOME);
    projection = camera_projection (&camera, w, h);
    for (k = 0; k < 360; k++) {
      const double angle = k * G_PI / 180;
      const Point3 rim = lift (1.48 * cos (angle), 1.48 * sin (angle));
      const Point3 corner = { k % 2 == 0 ? CAMERA_GROUND : -CAMERA_GROUND,
                              k % 4 < 2 ? CAMERA_GROUND : -CAMERA_GROUND, 0 };
      const Point3 seen[2] = { projection_apply (&projection, rim),
                               projection_apply (&projection, corner) };
      int j;

      for (j = 0; j < 2; j++) {
        g_assert_cmpfloat (seen[j].x, >=, 0);
        g_assert_cmpfloat (seen[j].x, <=, w);
        g_assert_cmpfloat (seen[j].y, >=, 0);
        g_assert_cmpfloat (seen[j].y, <=, h);
        g_assert_cmpfloat (fabs (seen[j].z), <, 1);
      }
    }
  }
}

/* From home the near border of the plane is lower on the screen, and what is
 * higher in space is higher on the screen. */
static void
test_home_is_above (void)
{
  Camera camera;
  Projection projection;
  Point3 front, back, top;

  camera_init (&camera, CAMERA_HOME);
  projection = camera_projection (&camera, 500, 500);
  front = projection_apply (&projection, (Point3){ 0, -1, 0 });
  back = projection_apply (&projection, (Point3){ 0, 1, 0 });
  top = projection_apply (&projection, (Point3){ 0, 0, 2 });
  g_assert_cmpfloat (front.y, >, back.y);
  g_assert_cmpfloat (front.z, <, back.z);
  g_assert_cmpfloat (top.y, <, back.y);
  g_assert_cmpfloat (projection.eye.z, >, 2);
}

/* Whether a circle at this height is in the view, and the plane as well. */
static void
check_in_view (const Projection *projection, double radius, double z)
{
  int i;

  for (i = 0; i < 64; i++) {
    const double x = cos (i * G_PI / 32), y = sin (i * G_PI / 32);
    const Point3 rim
        = projection_apply (projection, (Point3){ radius * x, radius * y, z });
    const Point3 ground = projection_apply (
        projection, (Point3){ CAMERA_GROUND * x, CAMERA_GROUND * y, 0 });

    g_assert_true (rim.x >= 0 && rim.x <= projection->width && rim.y >= 0
                   && rim.y <= projection->height);
    g_assert_true (ground.x >= 0 && ground.x <= projection->width
                   && ground.y >= 0 && ground.y <= projection->height);
  }
}

/* The whole of a paraboloid whose rim is that of the unit circle, however high
 * it stands; from straight above nothing changes. */
static void
test_raised (void)
{
  static const double raises[] = { 0, 0.3, RAISE_DEFAULT, 1.2, RAISE_MOST };
  static const CameraPreset presets[] = { CAMERA_HOME, CAMERA_SIDE };
  Camera down;
  guint i, k;

  camera_init (&down, CAMERA_LOOK_DOWN);
  for (i = 0; i < G_N_ELEMENTS (raises); i++) {
    const Camera same = camera_raised (&down, raises[i]);

    g_assert_cmpfloat (fabs (same.zoom - down.zoom), <, 1e-12);
    for (k = 0; k < G_N_ELEMENTS (presets); k++) {
      Camera camera, raised;
      Projection projection;

      camera_init (&camera, presets[k]);
      raised = camera_raised (&camera, raises[i]);
      projection = camera_projection (&raised, 500, 500);
      check_in_view (&projection, sqrt (2), raises[i] + 2);
      g_assert_true (raises[i] != RAISE_DEFAULT
                     || camera_equal (&camera, &raised));
    }
  }
}

static void
test_names (void)
{
  int i;

  for (i = 0; i < N_CAMERA_PRESETS; i++) {
    CameraPreset preset;

    g_assert_true (
        camera_preset_parse (camera_preset_name ((CameraPreset)i), &preset));
    g_assert_cmpint (preset, ==, i);
  }
  g_assert_cmpstr (camera_preset_name (CAMERA_LOOK_UP), ==, "look-up");
  {
    CameraPreset preset;

    g_assert_false (camera_preset_parse ("sideways", &preset));
  }
}

static double
length_of (Quaternion q)
{
  return sqrt (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

static void
test_roll (void)
{
  const double size[2] = { 400, 300 };
  const double middle[2] = { 200, 150 }, right[2] = { 240, 150 };
  const Point3 front = { 0, -1, 1.3 };
  Camera camera, home;
  Projection projection;
  double before;
  int i;

  camera_init (&home, CAMERA_HOME);
  camera = home;
  projection = camera_projection (&camera, size[0], size[1]);
  before = projection_apply (&projection, front).x;
  camera_roll (&camera, middle, right, size);
  projection = camera_projection (&camera, size[0], size[1]);
  g_assert_cmpfloat (projection_apply (&projection, front).x, >, before + 10);
  camera_roll (&camera, right, middle, size);
  assert_near (camera.turn.w, home.turn.w, 1e-12);
  assert_near (camera.turn.z, home.turn.z, 1e-12);
  for (i = 0; i < 10000; i++)
    camera_roll (&camera, middle, (double[2]){ i % 400, i % 299 }, size);
  assert_near (length_of (camera.turn), 1, 1e-12);
}

static void
test_zoom_and_pan (void)
{
  const double size[2] = { 500, 400 }, at[2] = { 120, 333 };
  const double by[2] = { 30, -12 };
  PlaneCamera plane;
  Camera space;
  Projection before, after;
  Point3 fixed, moved;

  plane_camera_init (&plane);
  before = plane_camera_projection (&plane, size[0], size[1]);
  fixed = projection_unapply (&before, at[0], at[1]);
  plane_camera_zoom (&plane, 1.7, at, size);
  after = plane_camera_projection (&plane, size[0], size[1]);
  assert_near (projection_apply (&after, fixed).x, at[0], 1e-9);
  assert_near (projection_apply (&after, fixed).y, at[1], 1e-9);
  plane_camera_pan (&plane, by, size);
  after = plane_camera_projection (&plane, size[0], size[1]);
  assert_near (projection_apply (&after, fixed).x, at[0] + by[0], 1e-9);
  assert_near (projection_apply (&after, fixed).y, at[1] + by[1], 1e-9);

  camera_init (&space, CAMERA_HOME);
  before = camera_projection (&space, size[0], size[1]);
  fixed = (Point3){ 0.3, 0.4, 1.1 };
  moved = projection_apply (&before, fixed);
  camera_zoom (&space, 1.7, (double[2]){ moved.x, moved.y }, size);
  after = camera_projection (&space, size[0], size[1]);
  assert_near (projection_apply (&after, fixed).x, moved.x, 1e-9);
  assert_near (projection_apply (&after, fixed).y, moved.y, 1e-9);
  camera_pan (&space, by, size);
  after = camera_projection (&space, size[0], size[1]);
  assert_near (projection_apply (&after, fixed).x, moved.x + by[0], 1e-9);
  assert_near (projection_apply (&after, fixed).y, moved.y + by[1], 1e-9);
}

static void
test_unapply (void)
{
  const PlaneCamera camera = { 0.3, -2, 3.5 };
  const Projection projection = plane_camera_projection (&camera, 640, 480);
  int i;

  for (i = 0; i < 50; i++) {
    const Point3 point = projection_unapply (&projection, 13.0 * i, 9.0 * i);
    const Point3 pixel = projection_apply (&projection, point);

    assert_near (pixel.x, 13.0 * i, 1e-9);
    assert_near (pixel.y, 9.0 * i, 1e-9);
  }
}

static double
clipped_area (const Pixel *corners, uint32_t n)
{
  double twice = 0;
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Pixel a = corners[i], b = corners[(i + 1) % n];

    twice += a.x * b.y - b.x * a.y;
  }
  return fabs (twice) / 2;
}

/* Whether a triangle of the plane covers a pixel, by its three sides. */
static gboolean
covers (const Point3 *t, double x, double y)
{
  int i, n_left = 0;

  for (i = 0; i < 3; i++) {
    const Point3 a = t[i], b = t[(i + 1) % 3];

    n_left += (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) > 0;
  }
  return n_left == 0 || n_left == 3;
}

/* The area of what is left of a triangle is that of the pixels of the view
 * which it covers. */
static void
test_clip_polygon (void)
{
  const PlaneCamera camera = { 0, 0, 1 };
  const Projection projection = plane_camera_projection (&camera, 100, 100);
  g_autoptr (GRand) rand = g_rand_new_with_seed (7);
  int round;

  for (round = 0; round < 60; round++) {
    Pixel corners[CLIP_ROOM (3)];
    Point3 triangle[3], seen[3];
    int i, x, y, n_covered = 0;
    uint32_t n;

    for (i = 0; i < 3; i++) {
      triangle[i] = (Point3){ g_rand_double_range (rand, -3, 3),
                              g_rand_double_range (rand, -3, 3), 0 };
      seen[i] = projection_apply (&projection, triangle[i]);
    }
    n = clip_polygon (&projection, triangle, 3, 0, corners);
    for (x = 0; x < 400; x++)
      for (y = 0; y < 400; y++)
        n_covered += covers (seen, (x + 0.5) / 4, (y + 0.5) / 4);
    assert_near (clipped_area (corners, n), n_covered / 16.0, 40);
    for (i = 0; i < (int)n; i++)
      g_assert_true (corners[i].x > -1e-9 && corners[i].x < 100 + 1e-9
                     && corners[i].y > -1e-9 && corners[i].y < 100 + 1e-9);
  }
}

static void
test_clip_behind_the_eye (void)
{
  Camera camera;
  Projection projection;
  Point3 way[2];
  Pixel ends[2], corners[CLIP_ROOM (3)];
  uint32_t i, n;

  camera_init (&camera, CAMERA_HOME);
  projection = camera_projection (&camera, 400, 400);
  way[0] = (Point3){ 0, 0, 1 };
  way[1] = (Point3){ 2 * projection.eye.x, 2 * projection.eye.y,
                     2 * projection.eye.z };
  g_assert_true (clip_segment (&projection, way, 10, ends));
  for (i = 0; i < 2; i++)
    g_assert_true (ends[i].x >= -10 - 1e-9 && ends[i].x <= 410 + 1e-9
                   && ends[i].y >= -10 - 1e-9 && ends[i].y <= 410 + 1e-9);
  way[0] = (Point3){ way[1].x, way[1].y, way[1].z + 1 };
  g_assert_false (clip_segment (&projection, way, 10, ends));
  n = clip_polygon (&projection,
                    (Point3[3]){ { 0, 0, 0 }, way[0], { 1, 0, 0 } }, 3, 10,
                    corners);
  for (i = 0; i < n; i++)
    g_assert_true (corners[i].x >= -10 - 1e-9 && corners[i].x <= 410 + 1e-9
                   && corners[i].y >= -10 - 1e-9 && corners[i].y <= 410 + 1e-9);
}

static void
test_clip_far_away (void)
{
  const PlaneCamera camera = { 0, 0, 1 };
  const Projection projection = plane_camera_projection (&camera, 200, 200);
  const Point3 ray[2] = { { 0, 0, 0 }, { 1e300, 1e300, 0 } };
  const Point3 beyond[2] = { { 0, 0, 0 }, { INFINITY, 0, 0 } };
  Pixel ends[2];

  g_assert_true (clip_segment (&projection, ray, 0, ends));
  assert_near (ends[1].x, 200, 1e-9);
  assert_near (ends[1].y, 0, 1e-9);
  g_assert_false (clip_segment (&projection, beyond, 0, ends));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/camera/all-of-a-raised-paraboloid-is-in-the-view",
                   test_raised);
  g_test_add_func ("/camera/looks-along-z-fall-on-the-plane-view", test_follow);
  g_test_add_func ("/camera/the-way-between-cameras-has-no-leaps",
                   test_between);
  g_test_add_func ("/camera/look-up-lays-lifts-over-the-mirrored-plane",
                   test_look_up);
  g_test_add_func ("/camera/home-sees-everything-in-any-view", test_home);
  g_test_add_func ("/camera/home-looks-from-above", test_home_is_above);
  g_test_add_func ("/camera/every-preset-has-a-name", test_names);
  g_test_add_func ("/camera/a-roll-follows-the-pointer-and-back", test_roll);
  g_test_add_func ("/camera/zoom-keeps-the-point-and-pan-moves-it",
                   test_zoom_and_pan);
  g_test_add_func ("/camera/unapply-undoes-apply", test_unapply);
  g_test_add_func ("/clip/what-is-left-of-a-polygon-is-what-the-view-covers",
                   test_clip_polygon);
  g_test_add_func ("/clip/nothing-behind-the-eye-is-seen",
                   test_clip_behind_the_eye);
  g_test_add_func ("/clip/a-ray-to-the-end-of-doubles-ends-at-the-border",
                   test_clip_far_away);
  return g_test_run ();
}
