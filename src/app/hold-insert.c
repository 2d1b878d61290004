#include "hold-insert.h"

#include "canvas-input.h"
#include "plane-view.h"
#include "site-edit.h"
#include "site-preview.h"

typedef struct HoldInsert {
  Canvas *canvas;
  GtkGesture *press, *drag;
  gboolean is_holding;
  guint site;         /* that is held */
  double start_px[2]; /* where the button went down */
} HoldInsert;

static void
hold_insert_free (gpointer user)
{
  HoldInsert *hold = user;

  g_object_unref (hold->press);
  g_object_unref (hold->drag);
  g_free (hold);
}

static gboolean
is_by_touch (GtkGesture *gesture)
{
  const GdkEvent *event = gtk_gesture_get_last_event (
      gesture,
      gtk_gesture_single_get_current_sequence (GTK_GESTURE_SINGLE (gesture)));

  return event != NULL && event->type == GDK_TOUCH_BEGIN;
}

/* With Ctrl a band is drawn, with Shift the plane is moved; the paper's left
 * button never adds. */
static gboolean
means_something_else (Canvas *canvas)
{
  GdkKeymap *keymap = gdk_keymap_get_for_display (
      gtk_widget_get_display (GTK_WIDGET (canvas)));

  return plane_view_get_paper_bindings (HULL2VD_PLANE_VIEW (canvas))
         || (gdk_keymap_get_modifier_state (keymap)
             & (GDK_CONTROL_MASK | GDK_SHIFT_MASK))
                != 0;
}

/* A busy machine tells late what has happened in the meantime: what is a click
 * by now, or a drag, is none of this. */
static gboolean
is_still_held (GtkGesture *gesture, const double at_px[2])
{
  GtkWidget *widget
      = gtk_event_controller_get_widget (GTK_EVENT_CONTROLLER (gesture));
  GdkModifierType buttons = 0;
  double x = 0, y = 0;

  gdk_window_get_device_position_double (gtk_widget_get_window (widget),
                                         gtk_gesture_get_device (gesture), &x,
                                         &y, &buttons);
  return (buttons & GDK_BUTTON1_MASK) != 0
         && !gtk_drag_check_threshold (widget, (int)at_px[0], (int)at_px[1],
                                       (int)x, (int)y);
}

static Point3
point_at (Canvas *canvas, const double at_px[2])
{
  const Projection projection = canvas_get_projection (canvas);

  return projection_unapply (&projection, at_px[0], at_px[1]);
}

static void
on_pressed (GtkGesture *gesture, double x, double y, HoldInsert *hold)
{
  Session *session = canvas_get_session (hold->canvas);
  const guint n_sites = session_get_set (session)->n_sites;
  const double at_px[2] = { x, y };

  if (is_by_touch (gesture) || !is_still_held (gesture, at_px)
      || means_something_else (hold->canvas) || session_is_asking (session)
      || site_preview_is_on_site (hold->canvas, at_px))
    return;
  session_begin_edit (session);
  site_edit_add (hold->canvas, point_at (hold->canvas, at_px));
  /* What is not there at once cannot be looked at: it is a click. */
  if (session_get_set (session)->n_sites == n_sites) {
    session_cancel_edit (session);
    return;
  }
  canvas_input_give_up (hold->canvas);
  session_set_hover (session, (Object){ OBJECT_SITE, n_sites });
  hold->is_holding = TRUE;
  hold->site = n_sites;
  hold->start_px[0] = x;
  hold->start_px[1] = y;
  canvas_set_moving (hold->canvas, TRUE);
}

static void
release (HoldInsert *hold, gboolean is_kept)
{
  Session *session = canvas_get_session (hold->canvas);

  if (!hold->is_holding)
    return;
  hold->is_holding = FALSE;
  canvas_set_moving (hold->canvas, FALSE);
  if (is_kept) {
    session_end_edit (session);
    return;
  }
  canvas_set_cursor (hold->canvas, (Object){ OBJECT_NONE, 0 });
  session_cancel_edit (session);
}

static void
on_drag_update (GtkGesture *gesture, double dx, double dy, HoldInsert *hold)
{
  const double to_px[2] = { hold->start_px[0] + dx, hold->start_px[1] + dy };

  (void)gesture;
  if (hold->is_holding)
    site_edit_move (hold->canvas, hold->site, point_at (hold->canvas, to_px));
}

static void
on_drag_end (GtkGesture *gesture, double dx, double dy, HoldInsert *hold)
{
  (void)gesture;
  (void)dx;
  (void)dy;
  release (hold, FALSE);
}

static void
on_cancel (GtkGesture *gesture, GdkEventSequence *sequence, HoldInsert *hold)
{
  (void)gesture;
  (void)sequence;
  release (hold, FALSE);
}

static gboolean
on_key (GtkWidget *widget, GdkEventKey *event, HoldInsert *hold)
{
  (void)widget;
  if (!hold->is_holding)
    return GDK_EVENT_PROPAGATE;
  switch (event->keyval) {
  case GDK_KEY_Return:
  case GDK_KEY_KP_Enter:
    release (hold, TRUE);
    return GDK_EVENT_STOP;
  case GDK_KEY_Escape:
    release (hold, FALSE);
    return GDK_EVENT_STOP;
  default:
    return GDK_EVENT_PROPAGATE;
  }
}

void
hold_insert_attach (Canvas *canvas)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  HoldInsert *hold = g_new0 (HoldInsert, 1);

  hold->canvas = canvas;
  hold->press = gtk_gesture_long_press_new (widget);
  hold->drag = gtk_gesture_drag_new (widget);
  gtk_gesture_group (hold->drag, hold->press);
  g_signal_connect (hold->press, "pressed", G_CALLBACK (on_pressed), hold);
  g_signal_connect (hold->drag, "drag-update", G_CALLBACK (on_drag_update),
                    hold);
  g_signal_connect (hold->drag, "drag-end", G_CALLBACK (on_drag_end), hold);
  g_signal_connect (hold->drag, "cancel", G_CALLBACK (on_cancel), hold);
  g_signal_connect (widget, "key-press-event", G_CALLBACK (on_key), hold);
  g_object_set_data_full (G_OBJECT (canvas), "hold-insert", hold,
                          hold_insert_free);
}
