#include "camera-glide.h"

#include "motion.h"

struct CameraGlide {
  Canvas *canvas;
  gboolean has_camera;
  Camera from, to;
  double part;      /* of the way; 1: there */
  gint64 start_us;  /* 0: not started yet */
  guint n_skips;    /* when it started */
  gboolean follows; /* the next change is the view's own */
  guint tick;
};

CameraGlide *
camera_glide_new (Canvas *canvas)
{
  CameraGlide *glide = g_new0 (CameraGlide, 1);

  glide->canvas = canvas;
  glide->part = 1;
  return glide;
}

static void
stop (CameraGlide *glide)
{
  glide->part = 1;
  glide->from = glide->to;
  if (glide->tick != 0)
    gtk_widget_remove_tick_callback (GTK_WIDGET (glide->canvas), glide->tick);
  glide->tick = 0;
}

void
camera_glide_free (CameraGlide *glide)
{
  stop (glide);
  g_free (glide);
}

void
camera_glide_follow (CameraGlide *glide)
{
  stop (glide);
  glide->follows = TRUE;
}

static gboolean
on_tick (GtkWidget *widget, GdkFrameClock *clock, gpointer user)
{
  CameraGlide *glide = user;
  const gint64 now_us = gdk_frame_clock_get_frame_time (clock);

  (void)widget;
  if (glide->start_us == 0)
    glide->start_us = now_us;
  glide->part = motion_part (now_us - glide->start_us);
  if (glide->part >= 1 || glide->n_skips != motion_n_skips ()) {
    glide->tick = 0;
    stop (glide);
    canvas_invalidate (glide->canvas);
    return G_SOURCE_REMOVE;
  }
  canvas_invalidate (glide->canvas);
  return G_SOURCE_CONTINUE;
}

/* A way that has begun is not begun again from its start: the next one starts
 * at the camera that it led to. */
static void
begin (CameraGlide *glide, const Camera *to)
{
  GtkWidget *widget = GTK_WIDGET (glide->canvas);

  stop (glide);
  glide->to = *to;
  if (glide->follows || !motion_is_wanted (widget)) {
    glide->follows = FALSE;
    glide->from = *to;
    return;
  }
  glide->part = 0;
  glide->start_us = 0;
  glide->n_skips = motion_n_skips ();
  glide->tick = gtk_widget_add_tick_callback (widget, on_tick, glide, NULL);
}

Projection
camera_glide_projection (CameraGlide *glide, double width, double height)
{
  Session *session = canvas_get_session (glide->canvas);
  const Camera *camera = session_get_camera (session);
  const double raise = session_get_look (session)->raise;
  Camera from, to;

  if (!glide->has_camera) {
    glide->from = glide->to = *camera;
    glide->has_camera = TRUE;
  } else if (!camera_equal (camera, &glide->to)) {
    begin (glide, camera);
  }
  glide->follows = FALSE;
  to = camera_raised (&glide->to, raise);
  if (glide->part >= 1)
    return camera_projection (&to, width, height);
  from = camera_raised (&glide->from, raise);
  return camera_projection_between (&from, &to, glide->part, width, height);
}
