#include "camera-glide.h"

#include "motion.h"

struct CameraGlide {
  Motion motion;
  gboolean has_camera;
  Camera from, to;
  gboolean follows; /* the next change is the view's own */
};

CameraGlide *
camera_glide_new (Canvas *canvas)
{
  CameraGlide *glide = g_new0 (CameraGlide, 1);

  motion_init (&glide->motion, canvas);
  return glide;
}

void
camera_glide_free (CameraGlide *glide)
{
  motion_end (&glide->motion);
  g_free (glide);
}

void
camera_glide_follow (CameraGlide *glide)
{
  motion_end (&glide->motion);
  glide->follows = TRUE;
}

/* A way that has begun is not begun again from its start: the next one starts
 * at the camera that it led to. */
static void
begin (CameraGlide *glide, const Camera *to)
{
  glide->from = glide->to;
  glide->to = *to;
  if (glide->follows || !motion_is_wanted (&glide->motion))
    motion_end (&glide->motion);
  else
    motion_begin (&glide->motion);
}

Projection
camera_glide_projection (CameraGlide *glide, double width, double height)
{
  Session *session = canvas_get_session (glide->motion.canvas);
  const Camera *camera = session_get_camera (session);
  const double raise = session_get_look (session)->raise;
  Camera from, to;

  if (!glide->has_camera) {
    glide->to = *camera;
    glide->has_camera = TRUE;
  } else if (!camera_equal (camera, &glide->to)) {
    begin (glide, camera);
  }
  glide->follows = FALSE;
  to = camera_raised (&glide->to, raise);
  if (glide->motion.part >= 1)
    return camera_projection (&to, width, height);
  from = camera_raised (&glide->from, raise);
  return camera_projection_between (&from, &to, glide->motion.part, width,
                                    height);
}
