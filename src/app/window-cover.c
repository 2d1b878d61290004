/* What covers the windows that a class sees. The black screen: while a
 * lecturer speaks, nobody looks at the pictures; the first key, click or touch
 * brings them back and does nothing else, since nobody sees what it would do.
 * The frozen picture: the class sees what there was while the lecturer goes
 * on, by keys and in the lecturer's window; the pointer does nothing below
 * it. */
#include "window-private.h"

#include "announcement.h"

#include <glib/gi18n.h>

#define GUARDS "cover-guards"
#define FROZEN "frozen-picture"

gboolean
window_cover_is_black (Hull2vdWindow *window)
{
  return window->is_blank;
}

gboolean
window_cover_is_frozen (Hull2vdWindow *window)
{
  return window->is_frozen;
}

/* Painting */

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

static void
paint_black (GtkWidget *widget, cairo_t *context)
{
  clip_shadow (widget, context);
  cairo_set_source_rgb (context, 0, 0, 0);
  cairo_paint (context);
}

/* A window that has another size by now shows what fits. */
static void
paint_frozen (GtkWidget *widget, cairo_t *context)
{
  cairo_surface_t *picture = g_object_get_data (G_OBJECT (widget), FROZEN);

  if (picture == NULL)
    return;
  cairo_set_source_surface (context, picture, 0, 0);
  cairo_paint (context);
}

static gboolean
on_draw (GtkWidget *widget, cairo_t *context, Hull2vdWindow *window)
{
  if (window->is_blank)
    paint_black (widget, context);
  else if (window->is_frozen)
    paint_frozen (widget, context);
  return FALSE;
}

/* Pointer */

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

/* The guards go with the cover, so not while one of them speaks. */
static void
on_released (Hull2vdWindow *window)
{
  g_idle_add_full (G_PRIORITY_DEFAULT, on_idle, g_object_ref (window),
                   g_object_unref);
}

/* What the pointer does reaches the guards first, and while there is a cover
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
  if (!window->is_blank && !window->is_frozen)
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

static void
update_all (Hull2vdWindow *window)
{
  update (GTK_WIDGET (window), window);
  update (window->space_window, window);
  window_lecturer_follow_cover (window);
}

/* Black */

void
window_cover_toggle_black (Hull2vdWindow *window)
{
  window->is_blank = !window->is_blank;
  session_set_playing (window->session, FALSE);
  update_all (window);
  announce (GTK_WIDGET (window), window->is_blank
                                     ? _ ("The screen is black.")
                                     : _ ("The pictures are back."));
}

gboolean
window_cover_key (Hull2vdWindow *window, const GdkEventKey *event)
{
  if (!window->is_blank || event->is_modifier)
    return FALSE;
  show_again (window);
  return TRUE;
}

/* Frozen */

static void
freeze (GtkWidget *widget)
{
  cairo_surface_t *picture;
  cairo_t *context;

  if (widget == NULL || !gtk_widget_get_mapped (widget))
    return;
  picture = gdk_window_create_similar_surface (
      gtk_widget_get_window (widget), CAIRO_CONTENT_COLOR_ALPHA,
      gtk_widget_get_allocated_width (widget),
      gtk_widget_get_allocated_height (widget));
  context = cairo_create (picture);
  gtk_widget_draw (widget, context);
  cairo_destroy (context);
  g_object_set_data_full (G_OBJECT (widget), FROZEN, picture,
                          (GDestroyNotify)cairo_surface_destroy);
}

static void
thaw (GtkWidget *widget)
{
  if (widget != NULL)
    g_object_set_data (G_OBJECT (widget), FROZEN, NULL);
}

void
window_cover_toggle_frozen (Hull2vdWindow *window)
{
  GtkWidget *widgets[] = { GTK_WIDGET (window), window->space_window };

  for (guint i = 0; i < G_N_ELEMENTS (widgets); i++)
    if (window->is_frozen)
      thaw (widgets[i]);
    else
      freeze (widgets[i]);
  window->is_frozen = !window->is_frozen;
  update_all (window);
}

void
window_cover_add (Hull2vdWindow *window, GtkWidget *widget)
{
  g_signal_connect_after (widget, "draw", G_CALLBACK (on_draw), window);
  set_guards (widget, window);
}
