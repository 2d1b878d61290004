#include "canvas.h"

#include "answer-objects.h"
#include "canvas-accessible.h"
#include "canvas-input.h"
#include "canvas-keys.h"
#include "canvas-picture.h"
#include "canvas-scene.h"

#include <glib/gi18n.h>
#include <string.h>

#define REACH_PX 12.0

/* A picture that was painted roughly, because something moved, is painted well
 * when nothing has moved for so long. */
#define SETTLE_MS 120

typedef struct CanvasPrivate {
  Session *session;
  guint pane;
  CanvasScene *scene;
  Theme theme;
  CanvasPicture *picture; /* NULL: no session yet */
  gboolean is_moving;
  gboolean is_settling; /* the next picture is to be a good one */
  guint settle_source;
  char *trouble; /* to be told: why OpenGL does not paint */
  guint trouble_source;
  Object cursor;
  gboolean shows_focus; /* the keyboard came here by Tab */
  GtkGesture *gestures[N_CANVAS_GESTURES];
  GtkEventController *controllers[N_CANVAS_CONTROLLERS];
} CanvasPrivate;

G_DEFINE_TYPE_WITH_PRIVATE (Canvas, canvas, GTK_TYPE_DRAWING_AREA)

enum { SIGNAL_FAILED, N_SIGNALS };
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

/* The scene of the session as it is, made when first asked for. */
static const Scene *
canvas_get_scene (Canvas *canvas)
{
  CanvasPrivate *p = priv (canvas);
  SceneLook look;

  if (!canvas_scene_is_valid (p->scene)) {
    look = *session_get_look (p->session);
    HULL2VD_CANVAS_GET_CLASS (canvas)->adapt_look (canvas, &look);
    canvas_scene_update (p->scene, p->session, p->pane, &look);
  }
  return canvas_scene_get (p->scene);
}

static void
invalidate_picture (Canvas *canvas)
{
  CanvasPrivate *p = priv (canvas);

  if (p->picture != NULL)
    canvas_picture_invalidate (p->picture);
  gtk_widget_queue_draw (GTK_WIDGET (canvas));
}

void
canvas_invalidate (Canvas *canvas)
{
  canvas_scene_invalidate (priv (canvas)->scene, FALSE);
  invalidate_picture (canvas);
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
  const Projection projection = canvas_get_projection (canvas);
  const Scene *scene = canvas_get_scene (canvas);

  if (session_is_answering (priv (canvas)->session))
    return answer_objects_pick (canvas, scene, at_px, REACH_PX);
  return canvas_scene_pick (priv (canvas)->scene, &projection, at_px, REACH_PX);
}

gboolean
canvas_has_role (Canvas *canvas, Role role)
{
  canvas_get_scene (canvas);
  return canvas_scene_has_role (priv (canvas)->scene, role);
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

static gboolean
on_settled (gpointer user)
{
  CanvasPrivate *p = priv (user);

  p->settle_source = 0;
  p->is_settling = TRUE;
  invalidate_picture (user);
  return G_SOURCE_REMOVE;
}

/* Puts off the good picture until nothing has moved for a while. */
static void
settle_later (Canvas *canvas)
{
  CanvasPrivate *p = priv (canvas);

  if (p->settle_source != 0)
    g_source_remove (p->settle_source);
  p->settle_source = g_timeout_add (SETTLE_MS, on_settled, canvas);
}

void
canvas_set_moving (Canvas *canvas, gboolean moving)
{
  priv (canvas)->is_moving = moving;
}

static gboolean
on_trouble (gpointer user)
{
  CanvasPrivate *p = priv (user);
  g_autofree char *trouble = g_steal_pointer (&p->trouble);

  p->trouble_source = 0;
  g_signal_emit (user, signals[SIGNAL_FAILED], 0, trouble);
  return G_SOURCE_REMOVE;
}

/* A window that is being drawn cannot show a sentence more: later. */
static void
tell_trouble (Canvas *canvas, const GError *error)
{
  CanvasPrivate *p = priv (canvas);

  g_free (p->trouble);
  p->trouble = g_strdup_printf (_ ("Space is painted without OpenGL: %s"),
                                error->message);
  if (p->trouble_source == 0)
    p->trouble_source = g_idle_add (on_trouble, canvas);
}

static void
paint (Canvas *canvas)
{
  CanvasPrivate *p = priv (canvas);
  const Projection projection = canvas_get_projection (canvas);
  g_autoptr (GError) error = NULL;

  if (!canvas_picture_update (p->picture, canvas_get_scene (canvas),
                              &projection, canvas_get_theme (canvas),
                              p->is_moving && !p->is_settling, &error))
    tell_trouble (canvas, error);
  p->is_settling = FALSE;
  if (canvas_picture_is_rough (p->picture))
    settle_later (canvas);
}

static void
draw_ring (cairo_t *cr, const Theme *theme, const GdkRectangle *box)
{
  const Colour colour = theme->selection, ground = theme->background;

  cairo_rectangle (cr, box->x, box->y, box->width, box->height);
  cairo_set_line_width (cr, 4);
  cairo_set_source_rgb (cr, ground.red, ground.green, ground.blue);
  cairo_stroke_preserve (cr);
  cairo_set_line_width (cr, 2);
  cairo_set_source_rgb (cr, colour.red, colour.green, colour.blue);
  cairo_set_dash (cr, (const double[]){ 5, 3 }, 2, 0);
  cairo_stroke (cr);
}

/* Round the object in focus, else round the whole view; only for who works
 * with the keyboard. */
static void
draw_focus (Canvas *canvas, cairo_t *cr)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GdkRectangle box;

  if (canvas_locate (canvas, priv (canvas)->cursor, &box))
    draw_ring (cr, canvas_get_theme (canvas), &box);
  else
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
  if (!canvas_picture_is_valid (p->picture))
    paint (canvas);
  canvas_picture_draw (p->picture, cr);
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

  if (p->picture != NULL)
    canvas_picture_release (p->picture);
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

static void
on_changed (Session *session, guint changes, Canvas *canvas)
{
  const guint matters = CHANGED_SITES | CHANGED_STEP | CHANGED_LOOK
                        | CHANGED_CAMERA | CHANGED_LESSON | CHANGED_APPEARANCE;

  (void)session;
  if ((changes & matters) == 0)
    return;
  /* What there is in space is the same from everywhere. */
  if ((changes & matters) != CHANGED_CAMERA
      || !HULL2VD_CANVAS_GET_CLASS (canvas)->is_space)
    canvas_scene_invalidate (priv (canvas)->scene, changes == CHANGED_LOOK);
  invalidate_picture (canvas);
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
  p->picture = canvas_picture_new (GTK_WIDGET (canvas),
                                   HULL2VD_CANVAS_GET_CLASS (canvas)->is_space);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), canvas,
                           0);
  canvas_invalidate (canvas);
}

void
canvas_fail (Canvas *canvas, const GError *error)
{
  g_signal_emit (canvas, signals[SIGNAL_FAILED], 0, error->message);
}

/* Life */

static void
canvas_dispose (GObject *object)
{
  CanvasPrivate *p = priv (HULL2VD_CANVAS (object));

  if (p->settle_source != 0)
    g_source_remove (p->settle_source);
  p->settle_source = 0;
  if (p->trouble_source != 0)
    g_source_remove (p->trouble_source);
  p->trouble_source = 0;
  for (guint i = 0; i < N_CANVAS_GESTURES; i++)
    g_clear_object (&p->gestures[i]);
  for (guint i = 0; i < N_CANVAS_CONTROLLERS; i++)
    g_clear_object (&p->controllers[i]);
  g_clear_pointer (&p->picture, canvas_picture_free);
  g_clear_object (&p->session);
  G_OBJECT_CLASS (canvas_parent_class)->dispose (object);
}

static void
canvas_finalize (GObject *object)
{
  g_free (priv (HULL2VD_CANVAS (object))->trouble);
  canvas_scene_free (priv (HULL2VD_CANVAS (object))->scene);
  G_OBJECT_CLASS (canvas_parent_class)->finalize (object);
}

static void
canvas_class_init (CanvasClass *class)
{
  GObjectClass *object_class = G_OBJECT_CLASS (class);
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  object_class->dispose = canvas_dispose;
  object_class->finalize = canvas_finalize;
  widget_class->draw = canvas_draw;
  widget_class->size_allocate = canvas_size_allocate;
  widget_class->unrealize = canvas_unrealize;
  canvas_keys_class_init (widget_class);
  gtk_widget_class_set_accessible_type (widget_class, CANVAS_ACCESSIBLE_TYPE);
  signals[SIGNAL_FAILED]
      = g_signal_new ("failed", CANVAS_TYPE, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                      NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
}

static void
canvas_init (Canvas *canvas)
{
  CanvasPrivate *p = priv (canvas);

  p->scene = canvas_scene_new ();
  gtk_widget_set_can_focus (GTK_WIDGET (canvas), TRUE);
  canvas_input_attach (canvas, p->gestures, p->controllers);
  g_signal_connect (canvas, "notify::scale-factor",
                    G_CALLBACK (on_scale_factor), NULL);
}
