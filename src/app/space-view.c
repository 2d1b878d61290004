#include "space-view.h"

#include "answer-objects.h"
#include "camera-glide.h"
#include "canvas-keys.h"
#include "canvas-menu.h"
#include "site-edit.h"
#include "step-motion.h"

#include <glib/gi18n.h>

#define ZOOM_LEAST 0.1
#define ZOOM_MOST 100.0
#define TURN_STEP_PX 24.0

struct _SpaceView {
  Canvas parent_instance;
  CameraGlide *glide;
  StepMotion *motion;
};

G_DEFINE_TYPE (SpaceView, space_view, CANVAS_TYPE)

/* The picture */

static Projection
space_view_project (Canvas *canvas, double width, double height)
{
  return camera_glide_projection (HULL2VD_SPACE_VIEW (canvas)->glide, width,
                                  height);
}

static void
space_view_adapt_look (Canvas *canvas, SceneLook *look)
{
  step_motion_apply (HULL2VD_SPACE_VIEW (canvas)->motion, look);
}

static void
get_size (Canvas *canvas, double size_px[2])
{
  size_px[0] = gtk_widget_get_allocated_width (GTK_WIDGET (canvas));
  size_px[1] = gtk_widget_get_allocated_height (GTK_WIDGET (canvas));
}

/* What the pointer does is followed at once. */
static void
put_camera (Canvas *canvas, const Camera *camera)
{
  camera_glide_follow (HULL2VD_SPACE_VIEW (canvas)->glide);
  session_set_camera (canvas_get_session (canvas), camera);
}

static void
space_view_zoom (Canvas *canvas, const double at_px[2], double factor)
{
  Session *session = canvas_get_session (canvas);
  Camera camera = *session_get_camera (session);
  double size_px[2];

  get_size (canvas, size_px);
  factor = CLAMP (camera.zoom * factor, ZOOM_LEAST, ZOOM_MOST) / camera.zoom;
  camera_zoom (&camera, factor, at_px, size_px);
  put_camera (canvas, &camera);
}

static void
space_view_pan (Canvas *canvas, const double by_px[2])
{
  Session *session = canvas_get_session (canvas);
  Camera camera = *session_get_camera (session);
  double size_px[2];

  get_size (canvas, size_px);
  camera_pan (&camera, by_px, size_px);
  put_camera (canvas, &camera);
}

static void
turn (Canvas *canvas, const double from_px[2], const double to_px[2])
{
  Session *session = canvas_get_session (canvas);
  Camera camera = *session_get_camera (session);
  double size_px[2];

  get_size (canvas, size_px);
  camera_roll (&camera, from_px, to_px, size_px);
  put_camera (canvas, &camera);
}

/* Pointer */

static void
space_view_click (Canvas *canvas, const CanvasPress *press)
{
  Session *session = canvas_get_session (canvas);
  Object object = press->object;

  if (press->button == GDK_BUTTON_SECONDARY)
    canvas_menu_popup (canvas, press->object, press->at_px);
  if (press->button != GDK_BUTTON_PRIMARY)
    return;
  canvas_set_cursor (
      canvas, object.kind == OBJECT_SITE ? object : (Object){ OBJECT_NONE, 0 });
  if (site_edit_joins (press) && site_edit_toggle (canvas, object))
    return;
  if (object_equal (session_get_look (session)->selection, object))
    object = (Object){ OBJECT_NONE, 0 };
  session_set_selection (session, object);
}

static void
space_view_double_click (Canvas *canvas, const CanvasPress *press)
{
  (void)canvas;
  (void)press;
}

static gboolean
space_view_drag_begin (Canvas *canvas, const CanvasPress *press)
{
  (void)canvas;
  return press->button == GDK_BUTTON_PRIMARY;
}

static void
space_view_drag_end (Canvas *canvas)
{
  (void)canvas;
}

static const char *
space_view_pointer (Canvas *canvas, Object object, const double at_px[2])
{
  (void)canvas;
  (void)at_px;
  return object.kind == OBJECT_NONE ? "grab" : "pointer";
}

/* Keyboard */

static gboolean
turn_by_key (Canvas *canvas, const double by[2])
{
  double from_px[2], to_px[2];

  get_size (canvas, from_px);
  for (int axis = 0; axis < 2; axis++) {
    from_px[axis] /= 2;
    to_px[axis] = from_px[axis] + TURN_STEP_PX * by[axis];
  }
  turn (canvas, from_px, to_px);
  return TRUE;
}

static gboolean
space_view_key (Canvas *canvas, const GdkEventKey *event)
{
  const gboolean is_shifted = (event->state & GDK_SHIFT_MASK) != 0;
  double by[2];

  if (canvas_arrow (event->keyval, by)) {
    if (site_edit_nudge (canvas, by, is_shifted))
      return TRUE;
    return is_shifted && turn_by_key (canvas, by);
  }
  if (event->keyval == GDK_KEY_Delete || event->keyval == GDK_KEY_BackSpace)
    return site_edit_remove (canvas);
  return FALSE;
}

/* Objects: the sites, then the facets */

static guint
space_view_count_objects (Canvas *canvas)
{
  Session *session = canvas_get_session (canvas);
  const Frame *frame = session_get_frame (session);

  if (session_is_answering (session))
    return answer_objects_count (canvas);
  return session_pane_has_facets (session, canvas_get_pane (canvas))
             ? frame->n_sites + frame->n_facets
             : frame->n_sites;
}

static Object
space_view_get_object (Canvas *canvas, guint index)
{
  const Frame *frame = session_get_frame (canvas_get_session (canvas));

  if (session_is_answering (canvas_get_session (canvas)))
    return answer_objects_get (canvas, index);

  if (index < frame->n_sites)
    return (Object){ OBJECT_SITE, frame->sites[index].site };
  return (Object){ OBJECT_FACET, frame->facets[index - frame->n_sites].facet };
}

/* Life */

static void
space_view_finalize (GObject *object)
{
  camera_glide_free (HULL2VD_SPACE_VIEW (object)->glide);
  step_motion_free (HULL2VD_SPACE_VIEW (object)->motion);
  G_OBJECT_CLASS (space_view_parent_class)->finalize (object);
}

static void
space_view_class_init (SpaceViewClass *class)
{
  CanvasClass *canvas_class = HULL2VD_CANVAS_CLASS (class);

  G_OBJECT_CLASS (class)->finalize = space_view_finalize;
  canvas_class->title = N_ ("Space");
  canvas_class->is_space = TRUE;
  canvas_class->adapt_look = space_view_adapt_look;
  canvas_class->project = space_view_project;
  canvas_class->zoom = space_view_zoom;
  canvas_class->pan = space_view_pan;
  canvas_class->click = space_view_click;
  canvas_class->double_click = space_view_double_click;
  canvas_class->drag_begin = space_view_drag_begin;
  canvas_class->drag = turn;
  canvas_class->drag_end = space_view_drag_end;
  canvas_class->pointer = space_view_pointer;
  canvas_class->key = space_view_key;
  canvas_class->count_objects = space_view_count_objects;
  canvas_class->get_object = space_view_get_object;
  gtk_widget_class_set_css_name (GTK_WIDGET_CLASS (class), "spaceview");
}

static void
space_view_init (SpaceView *view)
{
  canvas_set_pane (HULL2VD_CANVAS (view), 1);
  view->glide = camera_glide_new (HULL2VD_CANVAS (view));
  view->motion = step_motion_new (HULL2VD_CANVAS (view));
}
