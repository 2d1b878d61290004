#include "canvas-input.h"

#include "answer-objects.h"
#include "canvas-touch.h"
#include "site-edit.h"

#include <math.h>

/* A press that moves less than this is a click. */
#define CLICK_PX 4.0
#define ZOOM_STEP 1.15

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
  gboolean is_blind; /* what is under the press is not known yet */
  gboolean is_late;  /* a click that waits until it is known */
  int n_presses;     /* in quick succession */
  double last_px[2];
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

/* While a thread draws, nothing can be pointed at: to look would make the
 * thread's work once more, in the main loop.
 *
 * Returns: FALSE: what is under the press is not known yet. */
static gboolean
find_object (Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);

  if (input->is_blind && !canvas_is_busy (canvas)) {
    input->press.object = canvas_pick (canvas, input->press.at_px);
    input->is_blind = FALSE;
  }
  return !input->is_blind;
}

static void
on_drag_begin (GtkGesture *gesture, double x, double y, Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);
  CanvasPress *press = &input->press;

  press->at_px[0] = input->last_px[0] = x;
  press->at_px[1] = input->last_px[1] = y;
  press->object = (Object){ OBJECT_NONE, 0 };
  press->button
      = gtk_gesture_single_get_current_button (GTK_GESTURE_SINGLE (gesture));
  press->modifiers = modifiers_of (gesture);
  input->mode = DRAG_NONE;
  input->is_click = TRUE;
  input->is_blind = TRUE;
  input->is_late = FALSE;
  find_object (canvas);
  canvas_show_focus (canvas, FALSE);
  gtk_widget_grab_focus (GTK_WIDGET (canvas));
}

static gboolean
is_pan (const CanvasPress *press)
{
  return press->button != GDK_BUTTON_PRIMARY
         || (press->modifiers & GDK_SHIFT_MASK) != 0;
}

static void
begin_dragging (Canvas *canvas, GtkGesture *gesture)
{
  CanvasInput *input = get_input (canvas);

  gtk_gesture_set_state (gesture, GTK_EVENT_SEQUENCE_CLAIMED);
  input->is_click = FALSE;
  input->mode = DRAG_PAN;
  if (!is_pan (&input->press) && find_object (canvas)
      && get_class (canvas)->drag_begin (canvas, &input->press))
    input->mode = DRAG_OBJECT;
  if (input->mode != DRAG_GIVEN_UP)
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
  else if (input->mode == DRAG_OBJECT)
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

/* While a question is open, a click is an answer; one that is none and would
 * add a site is refused in words. */
static void
click_for_question (Canvas *canvas, const CanvasInput *input)
{
  const CanvasPress *press = &input->press;
  const gboolean is_answer = session_is_answering (canvas_get_session (canvas))
                             && press->object.kind != OBJECT_NONE;

  if (!is_answer && get_class (canvas)->click_adds != NULL
      && get_class (canvas)->click_adds (canvas, press, input->n_presses)
      && site_edit_refuse (canvas))
    return;
  canvas_answer (canvas, press->object);
}

static void
click (Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);

  if (session_is_asking (canvas_get_session (canvas)))
    click_for_question (canvas, input);
  else if (input->n_presses == 2)
    get_class (canvas)->double_click (canvas, &input->press);
  else
    get_class (canvas)->click (canvas, &input->press);
}

static void
on_drag_end (GtkGesture *gesture, double dx, double dy, Canvas *canvas)
{
  CanvasInput *input = get_input (canvas);

  (void)gesture;
  (void)dx;
  (void)dy;
  if (input->is_click && find_object (canvas))
    click (canvas);
  else
    input->is_late = input->is_click;
  input->is_click = FALSE;
  finish_dragging (canvas);
}

static void
on_renewed (Canvas *canvas, gpointer user)
{
  CanvasInput *input = get_input (canvas);

  (void)user;
  if (!input->is_late || !find_object (canvas))
    return;
  input->is_late = FALSE;
  click (canvas);
}

void
canvas_input_give_up (Canvas *canvas)
{
  get_input (canvas)->is_click = FALSE;
  get_input (canvas)->is_late = FALSE;
  finish_dragging (canvas);
  get_input (canvas)->mode = DRAG_GIVEN_UP;
}

gboolean
canvas_input_cancel (Canvas *canvas)
{
  if (get_input (canvas)->mode != DRAG_OBJECT)
    return FALSE;
  session_cancel_edit (canvas_get_session (canvas));
  canvas_input_give_up (canvas);
  return TRUE;
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
hover_at (Canvas *canvas, double x, double y)
{
  const double at_px[2] = { x, y };
  Object object;

  if (get_input (canvas)->mode != DRAG_NONE || canvas_is_busy (canvas))
    return;
  object = canvas_pick (canvas, at_px);
  set_pointer (canvas, get_class (canvas)->pointer (canvas, object, at_px));
  session_set_hover (canvas_get_session (canvas), object);
}

static void
on_motion (GtkEventController *controller, double x, double y, Canvas *canvas)
{
  (void)controller;
  hover_at (canvas, x, y);
}

/* The controller of GTK 3 does not tell of every way in and out; who comes in
 * and stops says nothing else. */
static gboolean
on_crossing (GtkWidget *widget, GdkEventCrossing *event, gpointer user)
{
  Canvas *canvas = HULL2VD_CANVAS (widget);

  (void)user;
  if (event->type == GDK_ENTER_NOTIFY)
    hover_at (canvas, event->x, event->y);
  else if (get_input (canvas)->mode == DRAG_NONE)
    session_set_hover (canvas_get_session (canvas), (Object){ OBJECT_NONE, 0 });
  return GDK_EVENT_PROPAGATE;
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

void
canvas_input_attach (Canvas *canvas,
                     GtkGesture *gestures[N_CANVAS_GESTURES],
                     GtkEventController *controllers[N_CANVAS_CONTROLLERS])
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GtkEventController *motion = gtk_event_controller_motion_new (widget);
  GtkEventController *scroll = gtk_event_controller_scroll_new (
      widget, GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);

  g_object_set_data_full (G_OBJECT (canvas), "canvas-input",
                          g_new0 (CanvasInput, 1), g_free);
  gtk_widget_add_events (
      widget,
      GDK_BUTTON_PRESS_MASK | GDK_BUTTON_RELEASE_MASK | GDK_POINTER_MOTION_MASK
          | GDK_ENTER_NOTIFY_MASK | GDK_LEAVE_NOTIFY_MASK | GDK_SCROLL_MASK
          | GDK_SMOOTH_SCROLL_MASK | GDK_TOUCH_MASK | GDK_TOUCHPAD_GESTURE_MASK
          | GDK_KEY_PRESS_MASK | GDK_KEY_RELEASE_MASK | GDK_FOCUS_CHANGE_MASK);
  attach_press (canvas, gestures);
  g_signal_connect (canvas, "renewed", G_CALLBACK (on_renewed), NULL);
  canvas_touch_attach (canvas, gestures);
  g_signal_connect (scroll, "scroll", G_CALLBACK (on_scroll), canvas);
  controllers[CANVAS_CONTROLLER_SCROLL] = scroll;
  g_signal_connect (motion, "motion", G_CALLBACK (on_motion), canvas);
  g_signal_connect (widget, "enter-notify-event", G_CALLBACK (on_crossing),
                    NULL);
  g_signal_connect (widget, "leave-notify-event", G_CALLBACK (on_crossing),
                    NULL);
  controllers[CANVAS_CONTROLLER_MOTION] = motion;
  g_signal_connect (widget, "focus-in-event", G_CALLBACK (on_focus_change),
                    NULL);
  g_signal_connect (widget, "focus-out-event", G_CALLBACK (on_focus_change),
                    NULL);
}
