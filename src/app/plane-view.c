#include "plane-view.h"

#include "answer-objects.h"
#include "canvas-input.h"
#include "canvas-keys.h"
#include "canvas-menu.h"
#include "hold-insert.h"
#include "sign-input.h"
#include "site-edit.h"
#include "site-preview.h"
#include "step-motion.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#define SITE_REACH_PX 12.0
#define ZOOM_LEAST 0.1
#define ZOOM_MOST 1e6

struct _PlaneView {
  Canvas parent_instance;
  StepMotion *motion;
  gboolean has_paper_bindings;
  guint dragged;     /* site */
  double grip_px[2]; /* from the pointer to the site */
  gboolean is_banding;
  double band_px[2][2]; /* two corners of a rubber band */
};

G_DEFINE_TYPE (PlaneView, plane_view, CANVAS_TYPE)

/* The picture */

static Projection
plane_view_project (Canvas *canvas, double width, double height)
{
  const PlaneCamera *camera
      = session_get_plane_camera (canvas_get_session (canvas));

  return plane_camera_projection (camera, width, height);
}

/* Room for the frame of the picture. */
#define INSET_PX 6.0

static void
plane_view_adapt_look (Canvas *canvas, SceneLook *look)
{
  const Projection projection = canvas_get_projection (canvas);

  step_motion_apply (HULL2VD_PLANE_VIEW (canvas)->motion, look);
  scene_look_fit (look, &projection, INSET_PX);
}

static void
plane_view_zoom (Canvas *canvas, const double at_px[2], double factor)
{
  Session *session = canvas_get_session (canvas);
  PlaneCamera camera = *session_get_plane_camera (session);
  const Projection projection = canvas_get_projection (canvas);

  factor = CLAMP (camera.zoom * factor, ZOOM_LEAST, ZOOM_MOST) / camera.zoom;
  plane_camera_zoom (&camera, factor, at_px,
                     (const double[]){ projection.width, projection.height });
  session_set_plane_camera (session, &camera);
}

static void
plane_view_pan (Canvas *canvas, const double by_px[2])
{
  Session *session = canvas_get_session (canvas);
  PlaneCamera camera = *session_get_plane_camera (session);
  const Projection projection = canvas_get_projection (canvas);

  plane_camera_pan (&camera, by_px,
                    (const double[]){ projection.width, projection.height });
  session_set_plane_camera (session, &camera);
}

/* Pointer */

static Point3
point_at (Canvas *canvas, const double at_px[2])
{
  const Projection projection = canvas_get_projection (canvas);

  return projection_unapply (&projection, at_px[0], at_px[1]);
}

/* A cell means its site too; only the mark itself can be grabbed. */
static gboolean
is_on_site (Canvas *canvas, const CanvasPress *press, double grip_px[2])
{
  Session *session = canvas_get_session (canvas);
  const Projection projection = canvas_get_projection (canvas);
  Point3 point;

  if (press->object.kind != OBJECT_SITE)
    return FALSE;
  point = projection_apply (
      &projection,
      scene_point (session_get_look (session),
                   &session_get_set (session)->sites[press->object.number],
                   false));
  grip_px[0] = point.x - press->at_px[0];
  grip_px[1] = point.y - press->at_px[1];
  return hypot (grip_px[0], grip_px[1]) <= SITE_REACH_PX;
}

/* A second click on what is selected lets it go. */
static void
select_or_release (Canvas *canvas, Object object)
{
  Session *session = canvas_get_session (canvas);

  if (object_equal (session_get_look (session)->selection, object))
    object = (Object){ OBJECT_NONE, 0 };
  session_set_selection (session, object);
}

/* A cell means the plane here, not its site. */
static gboolean
is_empty (const CanvasPress *press)
{
  return press->object.kind == OBJECT_NONE || press->object.kind == OBJECT_SITE;
}

/* Inside triangles, where a click selects, two add a site. */
static gboolean
plane_view_click_adds (Canvas *canvas, const CanvasPress *press, int n)
{
  const gboolean is_paper = HULL2VD_PLANE_VIEW (canvas)->has_paper_bindings;
  double grip_px[2];

  if (sign_input_is_on (canvas))
    return FALSE;
  if (press->button != GDK_BUTTON_PRIMARY)
    return is_paper && press->button == GDK_BUTTON_SECONDARY;
  return !is_paper && !is_on_site (canvas, press, grip_px)
         && (n == 2 || is_empty (press)
             || (press->modifiers & GDK_CONTROL_MASK) != 0);
}

/* A click that is on no site. */
static void
click_plane (Canvas *canvas, const CanvasPress *press)
{
  if (plane_view_click_adds (canvas, press, 1)) {
    site_edit_add (canvas, point_at (canvas, press->at_px));
    return;
  }
  canvas_set_cursor (canvas, (Object){ OBJECT_NONE, 0 });
  if (is_empty (press))
    session_set_selection (canvas_get_session (canvas),
                           (Object){ OBJECT_NONE, 0 });
  else
    select_or_release (canvas, press->object);
}

static void
click_primary (Canvas *canvas, const CanvasPress *press)
{
  double grip_px[2];

  if (!is_on_site (canvas, press, grip_px)) {
    click_plane (canvas, press);
    return;
  }
  canvas_set_cursor (canvas, press->object);
  if (!site_edit_joins (press))
    select_or_release (canvas, press->object);
  else
    site_edit_toggle (canvas, press->object);
}

static void
click_secondary (Canvas *canvas, const CanvasPress *press)
{
  CanvasPress on_mark = *press;
  double grip_px[2];

  if (HULL2VD_PLANE_VIEW (canvas)->has_paper_bindings) {
    site_edit_add (canvas, point_at (canvas, press->at_px));
    return;
  }
  if (press->object.kind == OBJECT_SITE && !is_on_site (canvas, press, grip_px))
    on_mark.object = (Object){ OBJECT_NONE, 0 };
  canvas_menu_popup (canvas, on_mark.object, press->at_px);
}

static void
plane_view_click (Canvas *canvas, const CanvasPress *press)
{
  if (sign_input_is_on (canvas)) {
    sign_input_read (canvas, press->at_px);
    return;
  }
  if (press->button == GDK_BUTTON_PRIMARY)
    click_primary (canvas, press);
  else if (press->button == GDK_BUTTON_SECONDARY)
    click_secondary (canvas, press);
}

static void
plane_view_double_click (Canvas *canvas, const CanvasPress *press)
{
  double grip_px[2];

  if (press->button != GDK_BUTTON_PRIMARY || site_edit_joins (press)
      || sign_input_is_on (canvas)
      || HULL2VD_PLANE_VIEW (canvas)->has_paper_bindings)
    plane_view_click (canvas, press);
  else if (!is_on_site (canvas, press, grip_px))
    site_edit_add (canvas, point_at (canvas, press->at_px));
}

static gboolean
plane_view_drag_begin (Canvas *canvas, const CanvasPress *press)
{
  PlaneView *view = HULL2VD_PLANE_VIEW (canvas);
  Session *session = canvas_get_session (canvas);

  if (session_is_asking (session)) {
    if (is_on_site (canvas, press, view->grip_px) && site_edit_refuse (canvas))
      canvas_input_give_up (canvas);
    return FALSE;
  }
  if (sign_input_is_on (canvas))
    return FALSE;
  view->is_banding = (press->modifiers & GDK_CONTROL_MASK) != 0;
  for (int corner = 0; corner < 2; corner++)
    memcpy (view->band_px[corner], press->at_px, sizeof press->at_px);
  if (view->is_banding)
    return TRUE;
  if (!is_on_site (canvas, press, view->grip_px))
    return FALSE;
  view->dragged = press->object.number;
  canvas_set_cursor (canvas, press->object);
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  /* One of several takes the others with it. */
  if (!session_is_selected (session, press->object.number))
    session_set_selection (session, press->object);
  session_begin_edit (session);
  return TRUE;
}

/* The rubber band selects all sites within it. */
static void
select_in_band (PlaneView *view)
{
  Canvas *canvas = HULL2VD_CANVAS (view);
  Session *session = canvas_get_session (canvas);
  const SiteSet *set = session_get_set (session);
  const Projection projection = canvas_get_projection (canvas);
  g_autofree guint32 *sites = g_new (guint32, set->n_sites + 1);
  const double (*band)[2] = view->band_px;
  guint n = 0;

  for (guint i = 0; i < set->n_sites; i++) {
    const Point3 at = projection_apply (
        &projection,
        scene_point (session_get_look (session), &set->sites[i], false));

    if ((at.x - band[0][0]) * (at.x - band[1][0]) <= 0
        && (at.y - band[0][1]) * (at.y - band[1][1]) <= 0)
      sites[n++] = i;
  }
  session_select_sites (session, sites, n);
}

static void
plane_view_draw_over (Canvas *canvas, cairo_t *cr)
{
  PlaneView *view = HULL2VD_PLANE_VIEW (canvas);
  const double (*band)[2] = view->band_px;
  GdkRGBA colour;

  if (!view->is_banding)
    return;
  gtk_style_context_get_color (
      gtk_widget_get_style_context (GTK_WIDGET (canvas)), GTK_STATE_FLAG_NORMAL,
      &colour);
  cairo_rectangle (cr, band[0][0], band[0][1], band[1][0] - band[0][0],
                   band[1][1] - band[0][1]);
  gdk_cairo_set_source_rgba (cr, &colour);
  cairo_set_line_width (cr, 1.5);
  cairo_set_dash (cr, (const double[]){ 5, 4 }, 2, 0);
  cairo_stroke (cr);
}

static void
plane_view_drag (Canvas *canvas, const double from_px[2], const double to_px[2])
{
  PlaneView *view = HULL2VD_PLANE_VIEW (canvas);
  const double at_px[2]
      = { to_px[0] + view->grip_px[0], to_px[1] + view->grip_px[1] };

  (void)from_px;
  if (view->is_banding) {
    memcpy (view->band_px[1], to_px, sizeof view->band_px[1]);
    select_in_band (view);
    gtk_widget_queue_draw (GTK_WIDGET (canvas));
    return;
  }
  site_edit_move (canvas, view->dragged, point_at (canvas, at_px));
}

static void
plane_view_drag_end (Canvas *canvas)
{
  PlaneView *view = HULL2VD_PLANE_VIEW (canvas);

  if (!view->is_banding)
    session_end_edit (canvas_get_session (canvas));
  view->is_banding = FALSE;
  gtk_widget_queue_draw (GTK_WIDGET (canvas));
}

static const char *
plane_view_pointer (Canvas *canvas, Object object, const double at_px[2])
{
  const CanvasPress press
      = { .object = object, .at_px = { at_px[0], at_px[1] } };
  double grip_px[2];

  if (session_is_asking (canvas_get_session (canvas)))
    return object.kind == OBJECT_NONE ? "default" : "pointer";
  if (sign_input_is_on (canvas)) {
    sign_input_read (canvas, at_px);
    return "crosshair";
  }
  if (is_on_site (canvas, &press, grip_px))
    return "grab";
  if (object.kind == OBJECT_NONE || object.kind == OBJECT_SITE)
    return HULL2VD_PLANE_VIEW (canvas)->has_paper_bindings
               ? "default"
               : "crosshair"; /* a click adds a site */
  return "pointer";
}

void
plane_view_set_paper_bindings (PlaneView *view, gboolean has_them)
{
  view->has_paper_bindings = has_them;
}

gboolean
plane_view_get_paper_bindings (PlaneView *view)
{
  return view->has_paper_bindings;
}

/* Keyboard */

static gboolean
plane_view_key (Canvas *canvas, const GdkEventKey *event)
{
  const PlaneCamera *camera
      = session_get_plane_camera (canvas_get_session (canvas));
  const Point3 middle = { camera->centre_x, camera->centre_y, 0 };
  const gboolean is_far = (event->state & GDK_SHIFT_MASK) != 0;
  double by[2];

  if (sign_input_is_on (canvas))
    return sign_input_key (canvas, event);
  if (canvas_arrow (event->keyval, by))
    return site_edit_nudge (canvas, by, is_far);

  switch (event->keyval) {
  case GDK_KEY_Return:
  case GDK_KEY_KP_Enter:
    if (canvas_get_cursor (canvas).kind != OBJECT_NONE
        || session_is_asking (canvas_get_session (canvas)))
      return FALSE;
    site_edit_add (canvas, middle);
    return TRUE;
  case GDK_KEY_Insert:
    site_edit_add (canvas, middle);
    return TRUE;
  case GDK_KEY_Delete:
  case GDK_KEY_BackSpace:
    return site_edit_remove (canvas);
  default:
    return FALSE;
  }
}

/* Objects: the sites, the triangles, then those of the cone over them */

static gboolean
is_cone_triangle (const Frame *frame, guint index)
{
  const FrameFacet *facet = &frame->facets[index];

  return (facet->roles & FACET_CONE) != 0
         && frame->trace->facets[facet->facet].facing == FACING_LOWER;
}

static guint
count_cone_triangles (const Frame *frame)
{
  guint n = 0;

  for (guint i = 0; i < frame->n_facets; i++)
    n += is_cone_triangle (frame, i);
  return n;
}

static Object
get_cone_triangle (const Frame *frame, guint index)
{
  for (guint i = 0; i < frame->n_facets; i++)
    if (is_cone_triangle (frame, i) && index-- == 0)
      return (Object){ OBJECT_FACET, frame->facets[i].facet };
  return (Object){ OBJECT_NONE, 0 };
}

static guint
plane_view_count_objects (Canvas *canvas)
{
  Session *session = canvas_get_session (canvas);
  const Frame *frame = session_get_frame (session);

  if (session_is_answering (session))
    return answer_objects_count (canvas);
  return !session_pane_has_facets (session, canvas_get_pane (canvas))
             ? frame->n_sites
             : frame->n_sites + frame->delaunay.n_triangles
                   + count_cone_triangles (frame);
}

static Object
plane_view_get_object (Canvas *canvas, guint index)
{
  const Frame *frame = session_get_frame (canvas_get_session (canvas));

  if (session_is_answering (canvas_get_session (canvas)))
    return answer_objects_get (canvas, index);

  if (index < frame->n_sites)
    return (Object){ OBJECT_SITE, frame->sites[index].site };
  index -= frame->n_sites;
  if (index >= frame->delaunay.n_triangles)
    return get_cone_triangle (frame, index - frame->delaunay.n_triangles);
  return (Object){ OBJECT_FACET, frame->delaunay.triangles[index].facet };
}

/* Life */

static void
plane_view_finalize (GObject *object)
{
  step_motion_free (HULL2VD_PLANE_VIEW (object)->motion);
  G_OBJECT_CLASS (plane_view_parent_class)->finalize (object);
}

static void
plane_view_class_init (PlaneViewClass *class)
{
  CanvasClass *canvas_class = HULL2VD_CANVAS_CLASS (class);

  G_OBJECT_CLASS (class)->finalize = plane_view_finalize;
  canvas_class->title = N_ ("Plane");
  canvas_class->is_space = FALSE;
  canvas_class->adapt_look = plane_view_adapt_look;
  canvas_class->project = plane_view_project;
  canvas_class->zoom = plane_view_zoom;
  canvas_class->pan = plane_view_pan;
  canvas_class->click = plane_view_click;
  canvas_class->double_click = plane_view_double_click;
  canvas_class->click_adds = plane_view_click_adds;
  canvas_class->drag_begin = plane_view_drag_begin;
  canvas_class->drag = plane_view_drag;
  canvas_class->drag_end = plane_view_drag_end;
  canvas_class->draw_over = plane_view_draw_over;
  canvas_class->pointer = plane_view_pointer;
  canvas_class->key = plane_view_key;
  canvas_class->count_objects = plane_view_count_objects;
  canvas_class->get_object = plane_view_get_object;
  gtk_widget_class_set_css_name (GTK_WIDGET_CLASS (class), "planeview");
}

static void
plane_view_init (PlaneView *view)
{
  view->motion = step_motion_new (HULL2VD_CANVAS (view));
  site_preview_attach (HULL2VD_CANVAS (view));
  hold_insert_attach (HULL2VD_CANVAS (view));
}
