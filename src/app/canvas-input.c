#include "canvas-input.h"

#include "site-edit.h"

#include <math.h>

/* A press that moves less than this is a click. */
#define CLICK_PX 4.0
#define ZOOM_STEP 1.15
#define PAN_STEP_PX 40.0

typedef enum DragMode {
  DRAG_NONE, /* not moved yet: may still be a click */
  DRAG_PAN,
  DRAG_OBJECT, /* the view drags something itself */
  DRAG_GIVEN_UP,
} DragMode;

typedef struct CanvasInput {
  CanvasPress press;
  DragMode mode;
  gboolean is_click; /* unless it moves */
  int n_presses;     /* in quick succession */
  double last_px[2];
  double pinch_scale;
  const char *pointer; /* name of its shape */
} CanvasInput;

static CanvasInput *
get_input (Canvas *canvas)
{
  return g_object_get_data (G_OBJECT (canvas), "canvas-input");
}

static CanvasClass *
get_class (Canvas *canvas)
{
  return HULL2VD_CANVAS_GET_CLASS (canvas);
}

/* Press, drag, release */

static GdkModifierType
modifiers_of (GtkGesture *gesture)
{
  const GdkEvent *event = gtk_gesture_get_last_event (
      gesture,
      gtk_gesture_single_get_current_sequence (GTK_GESTURE_SINGLE (gesture)));
  GdkModifierType modifiers = 0;

  if (event != NULL)
    gdk_event_get_state (event, &modifiers);
  return modifiers;
}

static void
on_drag_begin (GtkGesture *gesture, double x, double y, Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);
  CanvasPress *press = &input->press;

  press->at_px[0] = input->last_px[0] = x;
  press->at_px[1] = input->last_px[1] = y;
  press->object = canvas_pick (canvas, press->at_px);
  press->button
      = gtk_gesture_single_get_current_button (GTK_GESTURE_SINGLE (gesture));
  press->modifiers = modifiers_of (gesture);
  input->mode = DRAG_NONE;
  input->is_click = TRUE;
  canvas_show_focus (canvas, FALSE);
  gtk_widget_grab_focus (GTK_WIDGET (canvas));
}

static gboolean
is_pan (const CanvasPress *press)
{
  return press->button == GDK_BUTTON_MIDDLE
         || (press->modifiers & GDK_SHIFT_MASK) != 0;
}

static void
begin_dragging (Canvas *canvas, GtkGesture *gesture)
{
  CanvasInput *input = get_input (canvas);

  gtk_gesture_set_state (gesture, GTK_EVENT_SEQUENCE_CLAIMED);
  input->is_click = FALSE;
  input->mode = DRAG_PAN;
  if (!is_pan (&input->press)
      && get_class (canvas)->drag_begin (canvas, &input->press))
    input->mode = DRAG_OBJECT;
  canvas_set_moving (canvas, TRUE);
}

static void
on_drag_update (GtkGesture *gesture, double dx, double dy, Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);
  const double to_px[2]
      = { input->press.at_px[0] + dx, input->press.at_px[1] + dy };
  const double by_px[2]
      = { to_px[0] - input->last_px[0], to_px[1] - input->last_px[1] };

  if (input->mode == DRAG_GIVEN_UP)
    return;
  if (input->mode == DRAG_NONE) {
    if (hypot (dx, dy) < CLICK_PX)
      return;
    begin_dragging (canvas, gesture);
  }
  if (input->mode == DRAG_PAN)
    get_class (canvas)->pan (canvas, by_px);
  else
    get_class (canvas)->drag (canvas, input->last_px, to_px);
  input->last_px[0] = to_px[0];
  input->last_px[1] = to_px[1];
}

/* Ends a drag, also one that another gesture takes over. */
static void
finish_dragging (Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);
  const DragMode mode = input->mode;

  input->mode = DRAG_NONE;
  if (mode == DRAG_OBJECT)
    get_class (canvas)->drag_end (canvas);
  if (mode == DRAG_PAN || mode == DRAG_OBJECT)
    canvas_set_moving (canvas, FALSE);
}

static void
on_drag_end (GtkGesture *gesture, double dx, double dy, Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);

  (void)gesture;
  (void)dx;
  (void)dy;
  if (input->is_click && input->n_presses == 2)
    get_class (canvas)->double_click (canvas, &input->press);
  else if (input->is_click)
    get_class (canvas)->click (canvas, &input->press);
  input->is_click = FALSE;
  finish_dragging (canvas);
}

void
canvas_input_give_up (Canvas *canvas)
{
  get_input (canvas)->is_click = FALSE;
  finish_dragging (canvas);
  get_input (canvas)->mode = DRAG_GIVEN_UP;
}

static void
on_drag_cancel (GtkGesture *gesture, GdkEventSequence *sequence, Canvas *canvas)
{
  (void)gesture;
  (void)sequence;
  get_input (canvas)->is_click = FALSE;
  finish_dragging (canvas);
}

static void
on_pressed (GtkGesture *gesture, int n, double x, double y, Canvas *canvas)
{
  (void)gesture;
  (void)x;
  (void)y;
  get_input (canvas)->n_presses = n;
}

/* Zoom */

static void
on_pinch_begin (GtkGesture *gesture, GdkEventSequence *sequence, Canvas *canvas)
{
  (void)gesture;
  (void)sequence;
  get_input (canvas)->pinch_scale = 1;
}

static void
on_pinch (GtkGesture *gesture, double scale, Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);
  double at_px[2] = { 0, 0 };

  gtk_gesture_get_bounding_box_center (gesture, &at_px[0], &at_px[1]);
  get_class (canvas)->zoom (canvas, at_px, scale / input->pinch_scale);
  input->pinch_scale = scale;
}

static void
on_scroll (GtkEventController *controller, double dx, double dy, Canvas *canvas)
{
  g_autoptr (GdkEvent) event = gtk_get_current_event ();
  double at_px[2] = { 0, 0 };

  (void)controller;
  (void)dx;
  if (event == NULL || !gdk_event_get_coords (event, &at_px[0], &at_px[1]))
    return;
  get_class (canvas)->zoom (canvas, at_px, pow (ZOOM_STEP, -dy));
}

/* Hover */

/* The pointer says what a press would do. */
static void
set_pointer (Canvas *canvas, const char *name)
{
  GdkWindow *window = gtk_widget_get_window (GTK_WIDGET (canvas));
  CanvasInput *input = get_input (canvas);
  g_autoptr (GdkCursor) cursor = NULL;

  if (g_strcmp0 (input->pointer, name) == 0)
    return;
  input->pointer = name;
  cursor = gdk_cursor_new_from_name (gdk_window_get_display (window), name);
  gdk_window_set_cursor (window, cursor);
}

static void
on_motion (GtkEventController *controller, double x, double y, Canvas *canvas)
{
  const double at_px[2] = { x, y };
  Object object;

  (void)controller;
  if (get_input (canvas)->mode != DRAG_NONE)
    return;
  object = canvas_pick (canvas, at_px);
  set_pointer (canvas, get_class (canvas)->pointer (canvas, object, at_px));
  session_set_hover (canvas_get_session (canvas), object);
}

static void
on_leave (GtkEventController *controller, Canvas *canvas)
{
  (void)controller;
  if (get_input (canvas)->mode == DRAG_NONE)
    session_set_hover (canvas_get_session (canvas), (Object){ OBJECT_NONE, 0 });
}

/* Keys */

gboolean
canvas_arrow (guint keyval, double by[2])
{
  static const struct {
    guint keyval, keypad;
    double by[2];
  } arrows[] = {
    { GDK_KEY_Left, GDK_KEY_KP_Left, { -1, 0 } },
    { GDK_KEY_Right, GDK_KEY_KP_Right, { 1, 0 } },
    { GDK_KEY_Up, GDK_KEY_KP_Up, { 0, -1 } },
    { GDK_KEY_Down, GDK_KEY_KP_Down, { 0, 1 } },
  };

  for (guint i = 0; i < G_N_ELEMENTS (arrows); i++)
    if (keyval == arrows[i].keyval || keyval == arrows[i].keypad) {
      by[0] = arrows[i].by[0];
      by[1] = arrows[i].by[1];
      return TRUE;
    }
  return FALSE;
}

gboolean
canvas_wants_key (Canvas *canvas, const GdkEventKey *event)
{
  const gboolean has_cursor = canvas_get_cursor (canvas).kind != OBJECT_NONE;
  double by[2];

  if (event->state & (GDK_CONTROL_MASK | GDK_MOD1_MASK))
    return FALSE;
  if (canvas_arrow (event->keyval, by))
    return has_cursor || (event->state & GDK_SHIFT_MASK) != 0;

  switch (event->keyval) {
  case GDK_KEY_Return:
  case GDK_KEY_KP_Enter:
  case GDK_KEY_Insert:
  case GDK_KEY_plus:
  case GDK_KEY_KP_Add:
  case GDK_KEY_minus:
  case GDK_KEY_KP_Subtract:
    return TRUE;
  case GDK_KEY_Delete:
  case GDK_KEY_BackSpace:
  case GDK_KEY_Escape:
    return has_cursor;
  default:
    return FALSE;
  }
}

static gboolean
zoom_by_key (Canvas *canvas, guint keyval)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  const double middle[2] = { gtk_widget_get_allocated_width (widget) / 2.0,
                             gtk_widget_get_allocated_height (widget) / 2.0 };

  if (keyval == GDK_KEY_plus || keyval == GDK_KEY_KP_Add)
    get_class (canvas)->zoom (canvas, middle, ZOOM_STEP);
  else if (keyval == GDK_KEY_minus || keyval == GDK_KEY_KP_Subtract)
    get_class (canvas)->zoom (canvas, middle, 1 / ZOOM_STEP);
  else
    return FALSE;
  return TRUE;
}

static gboolean
canvas_key_press (GtkWidget *widget, GdkEventKey *event)
{
  Canvas *canvas = HULL2VD_CANVAS (widget);
  double by[2];

  if (!canvas_wants_key (canvas, event))
    return FALSE;
  canvas_show_focus (canvas, TRUE);
  if (get_class (canvas)->key (canvas, event)
      || zoom_by_key (canvas, event->keyval))
    return TRUE;
  if (event->keyval == GDK_KEY_Escape) {
    canvas_set_cursor (canvas, (Object){ OBJECT_NONE, 0 });
    return TRUE;
  }
  if (event->keyval == GDK_KEY_Return || event->keyval == GDK_KEY_KP_Enter) {
    session_set_selection (canvas_get_session (canvas),
                           canvas_get_cursor (canvas));
    return TRUE;
  }
  if (canvas_arrow (event->keyval, by)
      && (event->state & GDK_SHIFT_MASK) != 0) {
    get_class (canvas)->pan (
        canvas, (const double[]){ -PAN_STEP_PX * by[0], -PAN_STEP_PX * by[1] });
    return TRUE;
  }
  return FALSE;
}

/* Keys held down make one edit. */
static gboolean
canvas_key_release (GtkWidget *widget, GdkEventKey *event)
{
  (void)event;
  site_edit_settle (HULL2VD_CANVAS (widget));
  return FALSE;
}

/* Tab */

/* The place of the cursor among the objects, -1 when on the whole view. */
static int
index_of_cursor (Canvas *canvas)
{
  const Object cursor = canvas_get_cursor (canvas);
  const guint n = get_class (canvas)->count_objects (canvas);

  for (guint i = 0; i < n; i++)
    if (object_equal (get_class (canvas)->get_object (canvas, i), cursor))
      return (int)i;
  return -1;
}

static gboolean
canvas_focus (GtkWidget *widget, GtkDirectionType direction)
{
  Canvas *canvas = HULL2VD_CANVAS (widget);
  const int n = (int)get_class (canvas)->count_objects (canvas);
  GdkModifierType modifiers;
  int to;

  if (direction != GTK_DIR_TAB_FORWARD && direction != GTK_DIR_TAB_BACKWARD)
    return FALSE;
  /* Ctrl+Tab leaves at once, however many objects there are. */
  if (gtk_get_current_event_state (&modifiers)
      && (modifiers & GDK_CONTROL_MASK) != 0 && gtk_widget_has_focus (widget))
    return FALSE;
  canvas_show_focus (canvas, TRUE);
  if (!gtk_widget_has_focus (widget)) {
    canvas_set_cursor (canvas, (Object){ OBJECT_NONE, 0 });
    gtk_widget_grab_focus (widget);
    return TRUE;
  }
  to = index_of_cursor (canvas) + (direction == GTK_DIR_TAB_FORWARD ? 1 : -1);
  if (to < -1 || to >= n)
    return FALSE;
  canvas_set_cursor (
      canvas, to < 0 ? (Object){ OBJECT_NONE, 0 }
                     : get_class (canvas)->get_object (canvas, (guint)to));
  return TRUE;
}

static gboolean
on_focus_change (GtkWidget *widget, GdkEventFocus *event, gpointer user)
{
  (void)user;
  site_edit_settle (HULL2VD_CANVAS (widget));
  if (!event->in)
    canvas_show_focus (HULL2VD_CANVAS (widget), FALSE);
  gtk_widget_queue_draw (widget);
  return GDK_EVENT_PROPAGATE;
}

void
canvas_input_class_init (GtkWidgetClass *class)
{
  class->key_press_event = canvas_key_press;
  class->key_release_event = canvas_key_release;
  class->focus = canvas_focus;
}

/* Set-up */

static void
attach_press (Canvas *canvas, GtkGesture *gestures[N_CANVAS_GESTURES])
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GtkGesture *drag = gtk_gesture_drag_new (widget);
  GtkGesture *press = gtk_gesture_multi_press_new (widget);

  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (drag), 0);
  g_signal_connect (drag, "drag-begin", G_CALLBACK (on_drag_begin), canvas);
  g_signal_connect (drag, "drag-update", G_CALLBACK (on_drag_update), canvas);
  g_signal_connect (drag, "drag-end", G_CALLBACK (on_drag_end), canvas);
  g_signal_connect (drag, "cancel", G_CALLBACK (on_drag_cancel), canvas);
  g_signal_connect (press, "pressed", G_CALLBACK (on_pressed), canvas);
  gtk_gesture_group (drag, press);
  gestures[CANVAS_GESTURE_DRAG] = drag;
  gestures[CANVAS_GESTURE_PRESS] = press;
}

static void
attach_zoom (Canvas *canvas,
             GtkGesture *gestures[N_CANVAS_GESTURES],
             GtkEventController *controllers[N_CANVAS_CONTROLLERS])
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GtkGesture *pinch = gtk_gesture_zoom_new (widget);
  GtkEventController *scroll = gtk_event_controller_scroll_new (
      widget, GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);

  g_signal_connect (pinch, "begin", G_CALLBACK (on_pinch_begin), canvas);
  g_signal_connect (pinch, "scale-changed", G_CALLBACK (on_pinch), canvas);
  g_signal_connect (scroll, "scroll", G_CALLBACK (on_scroll), canvas);
  gestures[CANVAS_GESTURE_PINCH] = pinch;
  controllers[CANVAS_CONTROLLER_SCROLL] = scroll;
}

void
canvas_input_attach (Canvas *canvas,
                     GtkGesture *gestures[N_CANVAS_GESTURES],
                     GtkEventController *controllers[N_CANVAS_CONTROLLERS])
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GtkEventController *motion = gtk_event_controller_motion_new (widget);

  g_object_set_data_full (G_OBJECT (canvas), "canvas-input",
                          g_new0 (CanvasInput, 1), g_free);
  gtk_widget_add_events (
      widget,
      GDK_BUTTON_PRESS_MASK | GDK_BUTTON_RELEASE_MASK | GDK_POINTER_MOTION_MASK
          | GDK_ENTER_NOTIFY_MASK | GDK_LEAVE_NOTIFY_MASK | GDK_SCROLL_MASK
          | GDK_SMOOTH_SCROLL_MASK | GDK_TOUCH_MASK | GDK_TOUCHPAD_GESTURE_MASK
          | GDK_KEY_PRESS_MASK | GDK_KEY_RELEASE_MASK | GDK_FOCUS_CHANGE_MASK);
  attach_press (canvas, gestures);
  attach_zoom (canvas, gestures, controllers);
  g_signal_connect (motion, "motion", G_CALLBACK (on_motion), canvas);
  g_signal_connect (motion, "leave", G_CALLBACK (on_leave), canvas);
  controllers[CANVAS_CONTROLLER_MOTION] = motion;
  g_signal_connect (widget, "focus-in-event", G_CALLBACK (on_focus_change),
                    NULL);
  g_signal_connect (widget, "focus-out-event", G_CALLBACK (on_focus_change),
                    NULL);
}
