/* Space in a window of its own, for a second screen. The keys are those of the
 * main window, which it belongs to. */
#include "window-private.h"

#include <glib/gi18n.h>

gboolean
window_space_is_detached (Hull2vdWindow *window)
{
  return window->space_window != NULL;
}

/* Puts space under another parent; it is the same widget. */
static void
move_space (Hull2vdWindow *window, GtkContainer *to)
{
  GtkWidget *box = window->space_box;
  GtkWidget *from = gtk_widget_get_parent (box);

  g_object_ref (box);
  gtk_container_remove (GTK_CONTAINER (from), box);
  if (GTK_IS_PANED (to))
    gtk_paned_pack2 (GTK_PANED (to), box, TRUE, FALSE);
  else
    gtk_container_add (to, box);
  g_object_unref (box);
}

static gboolean
is_fullscreen (GtkWidget *widget)
{
  return (gdk_window_get_state (gtk_widget_get_window (widget))
          & GDK_WINDOW_STATE_FULLSCREEN)
         != 0;
}

void
window_space_save (Hull2vdWindow *window)
{
  int width, height;

  if (window->settings == NULL || !window_space_is_detached (window)
      || is_fullscreen (window->space_window))
    return;
  gtk_window_get_size (GTK_WINDOW (window->space_window), &width, &height);
  g_settings_set (window->settings, "space-window-size", "(ii)", width, height);
}

static gboolean
on_space_delete (GtkWidget *widget, GdkEvent *event, Hull2vdWindow *window)
{
  (void)widget;
  (void)event;
  g_action_group_activate_action (G_ACTION_GROUP (window), "detach-space",
                                  NULL);
  return TRUE;
}

static void
toggle_fullscreen (GtkWidget *widget)
{
  if (is_fullscreen (widget))
    gtk_window_unfullscreen (GTK_WINDOW (widget));
  else
    gtk_window_fullscreen (GTK_WINDOW (widget));
}

/* Work ends first, then the full screen, then the window. */
static void
escape (GtkWidget *widget, Hull2vdWindow *window)
{
  if (session_give_up (window->session))
    return;
  if (is_fullscreen (widget))
    gtk_window_unfullscreen (GTK_WINDOW (widget));
  else
    gtk_window_close (GTK_WINDOW (widget));
}

/* The full screen is that of this window. */
static gboolean
on_space_key (GtkWidget *widget, GdkEventKey *event, Hull2vdWindow *window)
{
  if (event->keyval == GDK_KEY_F11 && !window_cover_is_black (window)) {
    toggle_fullscreen (widget);
    return TRUE;
  }
  if (hull2vd_window_forward_key (window, GTK_WINDOW (widget), event))
    return TRUE;
  if (event->keyval != GDK_KEY_Escape)
    return FALSE;
  escape (widget, window);
  return TRUE;
}

static GtkWidget *
make_title_bar (void)
{
  return gtk_widget_new (GTK_TYPE_HEADER_BAR, "visible", TRUE, "title",
                         _ ("Space – Hull2VD"), "has-subtitle", FALSE,
                         "show-close-button", TRUE, NULL);
}

/* With a title bar the window fits on the screen. */
#define FRAME_PX 60

static void
get_size (Hull2vdWindow *window, int *width, int *height)
{
  GdkDisplay *display = gtk_widget_get_display (GTK_WIDGET (window));
  GdkMonitor *monitor = gdk_display_get_monitor_at_window (
      display, gtk_widget_get_window (GTK_WIDGET (window)));
  GdkRectangle room;

  *width = 900;
  *height = 800;
  if (window->settings != NULL)
    g_settings_get (window->settings, "space-window-size", "(ii)", width,
                    height);
  gdk_monitor_get_workarea (monitor, &room);
  *width = MIN (*width, room.width);
  *height = MIN (*height, room.height - FRAME_PX);
}

static GtkWidget *
make_window (Hull2vdWindow *window)
{
  GtkWidget *space = gtk_window_new (GTK_WINDOW_TOPLEVEL);
  int width, height;

  get_size (window, &width, &height);
  gtk_window_set_title (GTK_WINDOW (space), _ ("Space – Hull2VD"));
  gtk_window_set_titlebar (GTK_WINDOW (space), make_title_bar ());
  gtk_window_set_default_size (GTK_WINDOW (space), width, height);
  gtk_style_context_add_class (gtk_widget_get_style_context (space), "hull2vd");
  window_layout_follow_width (space);
  /* Menus and buttons in it find their actions. */
  gtk_widget_insert_action_group (space, "win", G_ACTION_GROUP (window));
  window_files_take_drops (window, space);
  g_signal_connect (space, "delete-event", G_CALLBACK (on_space_delete),
                    window);
  g_signal_connect (space, "key-press-event", G_CALLBACK (on_space_key),
                    window);
  window_cover_add (window, space);
  return space;
}

static void
attach (Hull2vdWindow *window)
{
  GtkWidget *space = window->space_window;

  window_space_save (window);
  window->space_window = NULL;
  move_space (window, GTK_CONTAINER (window->view_paned));
  gtk_widget_destroy (space);
}

void
window_space_detach (Hull2vdWindow *window, gboolean detached)
{
  if (detached == window_space_is_detached (window))
    return;
  if (window->settings != NULL)
    g_settings_set_boolean (window->settings, "space-detached", detached);
  if (!detached) {
    attach (window);
    return;
  }
  window->space_window = make_window (window);
  window_theme_dress (window);
  move_space (window, GTK_CONTAINER (window->space_window));
  gtk_window_present (GTK_WINDOW (window->space_window));
}

/* The one goes with the other. */
static void
on_destroy (Hull2vdWindow *window, gpointer user)
{
  (void)user;
  if (window->space_window == NULL)
    return;
  gtk_widget_destroy (window->space_window);
  window->space_window = NULL;
}

/* As it was left; by the action, whose state is to say so. */
static void
on_map (Hull2vdWindow *window, gpointer user)
{
  (void)user;
  if (window->settings != NULL && !window_space_is_detached (window)
      && g_settings_get_boolean (window->settings, "space-detached"))
    g_action_group_activate_action (G_ACTION_GROUP (window), "detach-space",
                                    NULL);
}

void
window_space_init (Hull2vdWindow *window)
{
  g_signal_connect (window, "destroy", G_CALLBACK (on_destroy), NULL);
  g_signal_connect (window, "map", G_CALLBACK (on_map), NULL);
}
