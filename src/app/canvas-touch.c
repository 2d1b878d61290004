#include "canvas-touch.h"

#include "canvas-menu.h"

/* Two fingers as they were last seen. */
typedef struct Pinch {
  double centre_px[2];
  double scale;
} Pinch;

static Pinch *
get_pinch (Canvas *canvas)
{
  return g_object_get_data (G_OBJECT (canvas), "canvas-pinch");
}

static Pinch
pinch_at (GtkGesture *gesture, double scale)
{
  Pinch now = { { 0, 0 }, scale };

  gtk_gesture_get_bounding_box_center (gesture, &now.centre_px[0],
                                       &now.centre_px[1]);
  return now;
}

static void
on_pinch_begin (GtkGesture *gesture, GdkEventSequence *sequence, Canvas *canvas)
{
  (void)sequence;
  /* The first finger was no drag after all. */
  canvas_input_give_up (canvas);
  gtk_gesture_set_state (gesture, GTK_EVENT_SEQUENCE_CLAIMED);
  /* The gesture learns its first distance after this signal. */
  *get_pinch (canvas) = pinch_at (gesture, 1);
  canvas_set_moving (canvas, TRUE);
}

/* What lies between the fingers stays between them. */
static void
on_pinch_update (GtkGesture *gesture,
                 GdkEventSequence *sequence,
                 Canvas *canvas)
{
  CanvasClass *class = HULL2VD_CANVAS_GET_CLASS (canvas);
  Pinch *before = get_pinch (canvas);
  const Pinch now = pinch_at (
      gesture, gtk_gesture_zoom_get_scale_delta (GTK_GESTURE_ZOOM (gesture)));
  const double by_px[2] = { now.centre_px[0] - before->centre_px[0],
                            now.centre_px[1] - before->centre_px[1] };

  (void)sequence;
  if (by_px[0] != 0 || by_px[1] != 0)
    class->pan (canvas, by_px);
  if (now.scale != before->scale && before->scale > 0)
    class->zoom (canvas, now.centre_px, now.scale / before->scale);
  *before = now;
}

static void
on_pinch_end (GtkGesture *gesture, GdkEventSequence *sequence, Canvas *canvas)
{
  (void)gesture;
  (void)sequence;
  canvas_set_moving (canvas, FALSE);
}

static void
on_long_press (GtkGesture *gesture, double x, double y, Canvas *canvas)
{
  const double at_px[2] = { x, y };

  canvas_input_give_up (canvas);
  gtk_gesture_set_state (gesture, GTK_EVENT_SEQUENCE_CLAIMED);
  if (!canvas_is_busy (canvas))
    canvas_menu_popup (canvas, canvas_pick (canvas, at_px), at_px);
}

void
canvas_touch_attach (Canvas *canvas, GtkGesture *gestures[N_CANVAS_GESTURES])
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GtkGesture *pinch = gtk_gesture_zoom_new (widget);
  GtkGesture *press = gtk_gesture_long_press_new (widget);

  g_object_set_data_full (G_OBJECT (canvas), "canvas-pinch", g_new0 (Pinch, 1),
                          g_free);
  g_signal_connect (pinch, "begin", G_CALLBACK (on_pinch_begin), canvas);
  g_signal_connect (pinch, "update", G_CALLBACK (on_pinch_update), canvas);
  g_signal_connect (pinch, "end", G_CALLBACK (on_pinch_end), canvas);
  gestures[CANVAS_GESTURE_PINCH] = pinch;
  gtk_gesture_single_set_touch_only (GTK_GESTURE_SINGLE (press), TRUE);
  g_signal_connect (press, "pressed", G_CALLBACK (on_long_press), canvas);
  gestures[CANVAS_GESTURE_LONG_PRESS] = press;
}
