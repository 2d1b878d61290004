#include "canvas-keys.h"

#include "answer-objects.h"
#include "canvas-input.h"
#include "canvas-menu.h"
#include "site-edit.h"

#define ZOOM_STEP 1.15
#define PAN_STEP_PX 40.0

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

static gboolean
is_return (guint keyval)
{
  return keyval == GDK_KEY_Return || keyval == GDK_KEY_KP_Enter;
}

/* Enter selects, with Ctrl beside what is selected already. */
static gboolean
is_joining (const GdkEventKey *event)
{
  return is_return (event->keyval) && (event->state & GDK_CONTROL_MASK) != 0;
}

gboolean
canvas_keeps_key (guint keyval, GdkModifierType modifiers)
{
  double by[2];

  if (modifiers & (GDK_CONTROL_MASK | GDK_MOD1_MASK))
    return FALSE;
  return is_return (keyval) || keyval == GDK_KEY_Insert
         || keyval == GDK_KEY_plus || keyval == GDK_KEY_KP_Add
         || keyval == GDK_KEY_minus || keyval == GDK_KEY_KP_Subtract
         || (canvas_arrow (keyval, by) && (modifiers & GDK_SHIFT_MASK) != 0);
}

gboolean
canvas_wants_key (Canvas *canvas, const GdkEventKey *event)
{
  const gboolean has_cursor = canvas_get_cursor (canvas).kind != OBJECT_NONE;
  double by[2];

  if (is_joining (event))
    return canvas_get_cursor (canvas).kind == OBJECT_SITE;
  if (canvas_keeps_key (event->keyval, event->state))
    return TRUE;
  if (event->state & (GDK_CONTROL_MASK | GDK_MOD1_MASK))
    return FALSE;
  return has_cursor
         && (canvas_arrow (event->keyval, by) || event->keyval == GDK_KEY_Delete
             || event->keyval == GDK_KEY_BackSpace
             || event->keyval == GDK_KEY_Escape);
}

static gboolean
zoom_by_key (Canvas *canvas, guint keyval)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  const double middle[2] = { gtk_widget_get_allocated_width (widget) / 2.0,
                             gtk_widget_get_allocated_height (widget) / 2.0 };

  if (keyval == GDK_KEY_plus || keyval == GDK_KEY_KP_Add)
    HULL2VD_CANVAS_GET_CLASS (canvas)->zoom (canvas, middle, ZOOM_STEP);
  else if (keyval == GDK_KEY_minus || keyval == GDK_KEY_KP_Subtract)
    HULL2VD_CANVAS_GET_CLASS (canvas)->zoom (canvas, middle, 1 / ZOOM_STEP);
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
    return gtk_bindings_activate_event (G_OBJECT (widget), event);
  canvas_show_focus (canvas, TRUE);
  if (is_joining (event) && session_is_asking (canvas_get_session (canvas)))
    return FALSE;
  if (is_joining (event)) {
    session_toggle_site (canvas_get_session (canvas),
                         canvas_get_cursor (canvas).number);
    return TRUE;
  }
  if (HULL2VD_CANVAS_GET_CLASS (canvas)->key (canvas, event)
      || zoom_by_key (canvas, event->keyval))
    return TRUE;
  if (event->keyval == GDK_KEY_Escape) {
    if (!canvas_input_cancel (canvas))
      canvas_set_cursor (canvas, (Object){ OBJECT_NONE, 0 });
    return TRUE;
  }
  if (is_return (event->keyval)) {
    canvas_answer (canvas, canvas_get_cursor (canvas));
    return TRUE;
  }
  if (canvas_arrow (event->keyval, by)
      && (event->state & GDK_SHIFT_MASK) != 0) {
    HULL2VD_CANVAS_GET_CLASS (canvas)->pan (
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
  const guint n = HULL2VD_CANVAS_GET_CLASS (canvas)->count_objects (canvas);

  for (guint i = 0; i < n; i++)
    if (object_equal (HULL2VD_CANVAS_GET_CLASS (canvas)->get_object (canvas, i),
                      cursor))
      return (int)i;
  return -1;
}

/* The middle of what the keyboard is on is seen. */
static void
bring_cursor_into_view (Canvas *canvas)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  const int width = gtk_widget_get_allocated_width (widget);
  const int height = gtk_widget_get_allocated_height (widget);
  GdkRectangle place;
  int x, y;

  if (!canvas_locate (canvas, canvas_get_cursor (canvas), &place))
    return;
  x = place.x + place.width / 2;
  y = place.y + place.height / 2;
  if (x < 0 || y < 0 || x >= width || y >= height)
    HULL2VD_CANVAS_GET_CLASS (canvas)->pan (
        canvas, (const double[]){ width / 2.0 - x, height / 2.0 - y });
}

static gboolean
canvas_focus (GtkWidget *widget, GtkDirectionType direction)
{
  Canvas *canvas = HULL2VD_CANVAS (widget);
  const int n = (int)HULL2VD_CANVAS_GET_CLASS (canvas)->count_objects (canvas);
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
  canvas_set_cursor (canvas,
                     to < 0 ? (Object){ OBJECT_NONE, 0 }
                            : HULL2VD_CANVAS_GET_CLASS (canvas)->get_object (
                                canvas, (guint)to));
  bring_cursor_into_view (canvas);
  return TRUE;
}

/* The menu key, and Shift with F10. */
static gboolean
canvas_popup_menu (GtkWidget *widget)
{
  canvas_menu_popup_at_cursor (HULL2VD_CANVAS (widget));
  return TRUE;
}

void
canvas_keys_class_init (GtkWidgetClass *class)
{
  class->key_press_event = canvas_key_press;
  class->key_release_event = canvas_key_release;
  class->focus = canvas_focus;
  class->popup_menu = canvas_popup_menu;
}
