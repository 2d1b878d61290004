#include "canvas.h"

#include "answer-objects.h"
#include "brush.h"
#include "canvas-accessible.h"
#include "canvas-input.h"
#include "canvas-keys.h"
#include "canvas-show.h"

#include <math.h>

#define RING_GAP_PX 0.7 /* from a mark to the ring of the focus */
#define RING_PX 3.0
#define RING_CASING_PX 5.0
#define GLOW_PX 9.0 /* round a site; its name is read through it */
#define GLOW_ALPHA 0.25

typedef struct CanvasPrivate {
  Session *session;
  guint pane;
  CanvasShow *show; /* NULL: no session yet */
  Theme theme;
  Projection projection; /* of the plane, when the session last changed */
  Object cursor;
  gboolean shows_focus; /* the keyboard came here by Tab */
  GtkGesture *gestures[N_CANVAS_GESTURES];
  GtkEventController *controllers[N_CANVAS_CONTROLLERS];
} CanvasPrivate;

G_DEFINE_TYPE_WITH_PRIVATE (Canvas, canvas, GTK_TYPE_DRAWING_AREA)

enum { SIGNAL_FAILED, SIGNAL_RENEWED, N_SIGNALS };
static guint signals[N_SIGNALS];

static CanvasPrivate *
priv (Canvas *canvas)
{
  return canvas_get_instance_private (canvas);
}

void
canvas_set_pane (Canvas *canvas, guint pane)
{
  priv (canvas)->pane = pane;
}

guint
canvas_get_pane (Canvas *canvas)
{
  return priv (canvas)->pane;
}

gboolean
canvas_is_shown (Canvas *canvas)
{
  const Pane kind
      = HULL2VD_CANVAS_GET_CLASS (canvas)->is_space ? PANE_SPACE : PANE_PLANE;

  return session_get_pane (priv (canvas)->session, priv (canvas)->pane) == kind;
}

Session *
canvas_get_session (Canvas *canvas)
{
  return priv (canvas)->session;
}

const Theme *
canvas_get_theme (Canvas *canvas)
{
  CanvasPrivate *p = priv (canvas);

  theme_init (&p->theme, session_get_appearance (p->session));
  return &p->theme;
}

void
canvas_invalidate (Canvas *canvas)
{
  if (priv (canvas)->show != NULL)
    canvas_show_invalidate (priv (canvas)->show, CANVAS_CHANGE_SCENE);
}

gboolean
canvas_is_busy (Canvas *canvas)
{
  return canvas_show_is_busy (priv (canvas)->show);
}

Projection
canvas_get_projection (Canvas *canvas)
{
  const double width = gtk_widget_get_allocated_width (GTK_WIDGET (canvas));
  const double height = gtk_widget_get_allocated_height (GTK_WIDGET (canvas));

  return HULL2VD_CANVAS_GET_CLASS (canvas)->project (canvas, width, height);
}

Object
canvas_pick (Canvas *canvas, const double at_px[2])
{
  return canvas_show_pick (priv (canvas)->show, at_px);
}

const LegendMarks *
canvas_get_marks (Canvas *canvas)
{
  return canvas_show_get_marks (priv (canvas)->show);
}

/* The cursor */

Object
canvas_get_cursor (Canvas *canvas)
{
  return priv (canvas)->cursor;
}

void
canvas_set_cursor (Canvas *canvas, Object cursor)
{
  CanvasPrivate *p = priv (canvas);

  if (object_equal (p->cursor, cursor))
    return;
  p->cursor = cursor;
  canvas_accessible_focus (GTK_WIDGET (canvas), cursor);
  gtk_widget_queue_draw (GTK_WIDGET (canvas));
}

/* After an edit the cursor may name what is no more. */
static void
check_cursor (Canvas *canvas)
{
  GdkRectangle rectangle;

  if (!canvas_locate (canvas, priv (canvas)->cursor, &rectangle))
    canvas_set_cursor (canvas, (Object){ OBJECT_NONE, 0 });
}

/* Drawing */

void
canvas_set_moving (Canvas *canvas, gboolean moving)
{
  canvas_show_set_moving (priv (canvas)->show, moving);
}

/* Farther away no path can lead. */
#define FAR_PX 1e5

static gboolean
is_far (const Point3 *point)
{
  return fabs (point->x) > FAR_PX || fabs (point->y) > FAR_PX;
}

/* A facet has its own outline: a box round it would hold its neighbours. */
static gboolean
trace_outline (Canvas *canvas, cairo_t *cr)
{
  const Object cursor = priv (canvas)->cursor;
  Point3 points[3];

  if (cursor.kind != OBJECT_FACET
      || canvas_outline (canvas, cursor, points) != 3)
    return FALSE;
  for (int i = 0; i < 3; i++)
    if (is_far (&points[i]))
      return FALSE;
  for (int i = 0; i < 3; i++)
    cairo_line_to (cr, points[i].x, points[i].y);
  cairo_close_path (cr);
  return TRUE;
}

/* How far the mark of a site reaches, as it is now. */
static double
mark_reach (Canvas *canvas, guint site)
{
  const Scene *scene = canvas_show_get_scene (priv (canvas)->show);
  double most = 0;

  for (guint i = 0; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];

    if (item->shape == SHAPE_MARK && item->object.kind == OBJECT_SITE
        && item->object.number == site) {
      const Style style = theme_style (canvas_get_theme (canvas), item);

      most = MAX (most, brush_mark_reach (&style));
    }
  }
  return most;
}

/* A glow, and a circle in it that leaves the site its name.
 *
 * Returns: FALSE: what has the focus is no site. */
static gboolean
trace_circle (Canvas *canvas, cairo_t *cr)
{
  const Object cursor = priv (canvas)->cursor;
  const Colour colour = canvas_get_theme (canvas)->selection;
  Point3 at[3];
  double radius;

  if (cursor.kind != OBJECT_SITE || canvas_show_is_busy (priv (canvas)->show)
      || canvas_outline (canvas, cursor, at) != 1 || is_far (at))
    return FALSE;
  radius = mark_reach (canvas, cursor.number) + RING_GAP_PX;
  cairo_set_source_rgba (cr, colour.red, colour.green, colour.blue, GLOW_ALPHA);
  cairo_set_fill_rule (cr, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_arc (cr, at[0].x, at[0].y, radius + GLOW_PX, 0, 2 * G_PI);
  cairo_new_sub_path (cr);
  cairo_arc (cr, at[0].x, at[0].y, radius, 0, 2 * G_PI);
  cairo_fill (cr);
  cairo_arc (cr, at[0].x, at[0].y, radius, 0, 2 * G_PI);
  return TRUE;
}

static void
stroke_ring (cairo_t *cr, const Theme *theme)
{
  const Colour colour = theme->selection, ground = theme->background;

  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width (cr, RING_CASING_PX);
  cairo_set_source_rgb (cr, ground.red, ground.green, ground.blue);
  cairo_stroke_preserve (cr);
  cairo_set_line_width (cr, RING_PX);
  cairo_set_source_rgb (cr, colour.red, colour.green, colour.blue);
  cairo_set_dash (cr, (const double[]){ 6, 4 }, 2, 0);
  cairo_stroke (cr);
}

/* Round the object in focus, else round the whole view; only for who works
 * with the keyboard. */
static void
draw_focus (Canvas *canvas, cairo_t *cr)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GdkRectangle box;

  if (trace_outline (canvas, cr) || trace_circle (canvas, cr))
    stroke_ring (cr, canvas_get_theme (canvas));
  else if (canvas_locate (canvas, priv (canvas)->cursor, &box)) {
    cairo_rectangle (cr, box.x, box.y, box.width, box.height);
    stroke_ring (cr, canvas_get_theme (canvas));
  } else
    gtk_render_focus (gtk_widget_get_style_context (widget), cr, 1, 1,
                      gtk_widget_get_allocated_width (widget) - 2,
                      gtk_widget_get_allocated_height (widget) - 2);
}

void
canvas_show_focus (Canvas *canvas, gboolean shows)
{
  priv (canvas)->shows_focus = shows;
  gtk_widget_queue_draw (GTK_WIDGET (canvas));
}

static gboolean
canvas_draw (GtkWidget *widget, cairo_t *cr)
{
  Canvas *canvas = HULL2VD_CANVAS (widget);
  CanvasPrivate *p = priv (canvas);

  if (p->session == NULL)
    return FALSE;
  canvas_show_draw (p->show, cr);
  if (HULL2VD_CANVAS_GET_CLASS (canvas)->draw_over != NULL)
    HULL2VD_CANVAS_GET_CLASS (canvas)->draw_over (canvas, cr);
  if (p->shows_focus && gtk_widget_has_focus (widget))
    draw_focus (canvas, cr);
  return FALSE;
}

static void
canvas_size_allocate (GtkWidget *widget, GtkAllocation *allocation)
{
  Canvas *canvas = HULL2VD_CANVAS (widget);
  GtkAllocation before;

  gtk_widget_get_allocation (widget, &before);
  GTK_WIDGET_CLASS (canvas_parent_class)->size_allocate (widget, allocation);
  if (before.width != allocation->width || before.height != allocation->height)
    canvas_invalidate (canvas);
}

static void
canvas_unrealize (GtkWidget *widget)
{
  CanvasPrivate *p = priv (HULL2VD_CANVAS (widget));

  if (p->show != NULL)
    canvas_show_release (p->show);
  GTK_WIDGET_CLASS (canvas_parent_class)->unrealize (widget);
}

static void
on_scale_factor (GtkWidget *widget, GParamSpec *pspec, gpointer user)
{
  (void)pspec;
  (void)user;
  canvas_invalidate (HULL2VD_CANVAS (widget));
}

/* The session */

#define MATTERS                                                                \
  (CHANGED_SITES | CHANGED_STEP | CHANGED_LOOK | CHANGED_CAMERA                \
   | CHANGED_LESSON | CHANGED_APPEARANCE)

/* What there is in space is the same from everywhere. */
static CanvasChange
change_of (Canvas *canvas, guint changes)
{
  if ((changes & MATTERS) == CHANGED_CAMERA
      && HULL2VD_CANVAS_GET_CLASS (canvas)->is_space)
    return CANVAS_CHANGE_PICTURE;
  if ((changes & MATTERS) == CHANGED_APPEARANCE)
    return CANVAS_CHANGE_APPEARANCE;
  return changes == CHANGED_LOOK ? CANVAS_CHANGE_LOOK : CANVAS_CHANGE_SCENE;
}

/* Whether it was the camera of space that has moved, and this is the plane. */
static gboolean
is_elsewhere (Canvas *canvas, guint changes)
{
  CanvasPrivate *p = priv (canvas);
  Projection before = p->projection;

  if (HULL2VD_CANVAS_GET_CLASS (canvas)->is_space)
    return FALSE;
  p->projection = canvas_get_projection (canvas);
  return (changes & MATTERS) == CHANGED_CAMERA
         && projection_equal (&before, &p->projection);
}

static void
on_changed (Session *session, guint changes, Canvas *canvas)
{
  CanvasShow *show = priv (canvas)->show;

  (void)session;
  if (changes
      & (CHANGED_SITES | CHANGED_STEP | CHANGED_LESSON | CHANGED_QUESTION))
    answer_objects_forget (canvas);
  if ((changes & MATTERS) == 0 || is_elsewhere (canvas, changes))
    return;
  canvas_show_check_work (show);
  canvas_show_invalidate (show, change_of (canvas, changes));
  if (changes & CHANGED_SITES)
    check_cursor (canvas);
  canvas_accessible_update (GTK_WIDGET (canvas), changes);
}

void
canvas_set_session (Canvas *canvas, Session *session)
{
  CanvasPrivate *p = priv (canvas);

  g_assert (p->session == NULL);
  p->session = g_object_ref (session);
  p->show = canvas_show_new (canvas);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), canvas,
                           0);
  canvas_invalidate (canvas);
}

void
canvas_fail (Canvas *canvas, const GError *error)
{
  g_signal_emit (canvas, signals[SIGNAL_FAILED], 0, error->message, TRUE);
}

void
canvas_fail_with (Canvas *canvas, const char *sentence)
{
  g_signal_emit (canvas, signals[SIGNAL_FAILED], 0, sentence, FALSE);
}

void
canvas_tell_renewed (Canvas *canvas)
{
  g_signal_emit (canvas, signals[SIGNAL_RENEWED], 0);
}

/* Life */

static void
canvas_dispose (GObject *object)
{
  CanvasPrivate *p = priv (HULL2VD_CANVAS (object));

  for (guint i = 0; i < N_CANVAS_GESTURES; i++)
    g_clear_object (&p->gestures[i]);
  for (guint i = 0; i < N_CANVAS_CONTROLLERS; i++)
    g_clear_object (&p->controllers[i]);
  g_clear_pointer (&p->show, canvas_show_free);
  g_clear_object (&p->session);
  G_OBJECT_CLASS (canvas_parent_class)->dispose (object);
}

static void
canvas_class_init (CanvasClass *class)
{
  GObjectClass *object_class = G_OBJECT_CLASS (class);
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  object_class->dispose = canvas_dispose;
  widget_class->draw = canvas_draw;
  widget_class->size_allocate = canvas_size_allocate;
  widget_class->unrealize = canvas_unrealize;
  canvas_keys_class_init (widget_class);
  gtk_widget_class_set_accessible_type (widget_class, CANVAS_ACCESSIBLE_TYPE);
  signals[SIGNAL_FAILED]
      = g_signal_new ("failed", CANVAS_TYPE, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                      NULL, G_TYPE_NONE, 2, G_TYPE_STRING, G_TYPE_BOOLEAN);
  signals[SIGNAL_RENEWED]
      = g_signal_new ("renewed", CANVAS_TYPE, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                      NULL, G_TYPE_NONE, 0);
}

static void
canvas_init (Canvas *canvas)
{
  CanvasPrivate *p = priv (canvas);

  gtk_widget_set_can_focus (GTK_WIDGET (canvas), TRUE);
  canvas_input_attach (canvas, p->gestures, p->controllers);
  g_signal_connect (canvas, "notify::scale-factor",
                    G_CALLBACK (on_scale_factor), NULL);
}
