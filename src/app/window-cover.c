/* The black screen: while a lecturer speaks, nobody looks at the pictures. The
 * first key, click or touch brings them back and does nothing else, since
 * nobody sees what it would do. */
#include "window-private.h"

#include "announcement.h"

#include <glib/gi18n.h>

#define GUARDS "blank-guards"

gboolean
window_blank_is_on (Hull2vdWindow *window)
{
  return window->is_blank;
}

/* The window without the shadow that GTK draws round it, where it can. */
static void
clip_shadow (GtkWidget *widget, cairo_t *context)
{
  GtkWidget *bar = gtk_window_get_titlebar (GTK_WINDOW (widget));
  GdkRectangle all, title;

  if (!gdk_screen_is_composited (gtk_widget_get_screen (widget)))
    return;
  gtk_widget_get_allocation (gtk_bin_get_child (GTK_BIN (widget)), &all);
  if (gtk_widget_get_child_visible (bar)) {
    gtk_widget_get_allocation (bar, &title);
    gdk_rectangle_union (&all, &title, &all);
  }
  gdk_cairo_rectangle (context, &all);
  cairo_clip (context);
}

static gboolean
on_draw (GtkWidget *widget, cairo_t *context, Hull2vdWindow *window)
{
  if (!window->is_blank)
    return FALSE;
  clip_shadow (widget, context);
  cairo_set_source_rgb (context, 0, 0, 0);
  cairo_paint (context);
  return FALSE;
}

/* By the action, whose state is to say so. */
static void
show_again (Hull2vdWindow *window)
{
  if (window->is_blank)
    g_action_group_activate_action (G_ACTION_GROUP (window), "blank", NULL);
}

static gboolean
on_idle (gpointer user)
{
  show_again (user);
  return G_SOURCE_REMOVE;
}

static void
on_pressed (GtkGesture *gesture)
{
  gtk_gesture_set_state (gesture, GTK_EVENT_SEQUENCE_CLAIMED);
}

/* The guards go with the black screen, so not while one of them speaks. */
static void
on_released (Hull2vdWindow *window)
{
  g_idle_add_full (G_PRIORITY_DEFAULT, on_idle, g_object_ref (window),
                   g_object_unref);
}

/* What the pointer does reaches the guards first, and while the screen is black
 * nothing else. */
static void
guard (GtkWidget *widget, GtkEventController *controller)
{
  gtk_event_controller_set_propagation_phase (controller, GTK_PHASE_CAPTURE);
  g_ptr_array_add (g_object_get_data (G_OBJECT (widget), GUARDS), controller);
}

static void
set_guards (GtkWidget *widget, Hull2vdWindow *window)
{
  GtkGesture *press;

  g_object_set_data_full (G_OBJECT (widget), GUARDS,
                          g_ptr_array_new_with_free_func (g_object_unref),
                          (GDestroyNotify)g_ptr_array_unref);
  if (!window->is_blank)
    return;
  press = gtk_gesture_multi_press_new (widget);
  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (press), 0);
  g_signal_connect (press, "pressed", G_CALLBACK (on_pressed), NULL);
  g_signal_connect_swapped (press, "released", G_CALLBACK (on_released),
                            window);
  guard (widget, GTK_EVENT_CONTROLLER (press));
  guard (widget, gtk_event_controller_scroll_new (
                     widget, GTK_EVENT_CONTROLLER_SCROLL_BOTH_AXES));
}

static void
update (GtkWidget *widget, Hull2vdWindow *window)
{
  if (widget == NULL)
    return;
  set_guards (widget, window);
  gtk_widget_queue_draw (widget);
}

void
window_blank_toggle (Hull2vdWindow *window)
{
  window->is_blank = !window->is_blank;
  session_set_playing (window->session, FALSE);
  update (GTK_WIDGET (window), window);
  update (window->space_window, window);
  announce (GTK_WIDGET (window), window->is_blank
                                     ? _ ("The screen is black.")
                                     : _ ("The pictures are back."));
}

gboolean
window_blank_key (Hull2vdWindow *window, const GdkEventKey *event)
{
  if (!window->is_blank || event->is_modifier)
    return FALSE;
  show_again (window);
  return TRUE;
}

void
window_blank_add (Hull2vdWindow *window, GtkWidget *widget)
{
  g_signal_connect_after (widget, "draw", G_CALLBACK (on_draw), window);
  set_guards (widget, window);
}
