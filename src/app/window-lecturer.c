/* The lecturer's window beside the one that the class sees. */
#include "window-private.h"

#include "lecturer-window.h"
#include "overview-window.h"

#include <glib/gi18n.h>

gboolean
window_lecturer_is_open (Hull2vdWindow *window)
{
  return window->lecturer != NULL;
}

/* What the class sees instead of what the session shows. */
static char *
cover_text (Hull2vdWindow *window)
{
  if (window_cover_is_black (window))
    return g_strdup (_ ("The class sees a black screen. Any key brings the "
                        "pictures back."));
  if (window_cover_is_frozen (window))
    return g_strdup_printf (_ ("Frozen: the class still sees %s."),
                            window->frozen_place);
  return NULL;
}

void
window_lecturer_follow_cover (Hull2vdWindow *window)
{
  g_autofree char *text = NULL;

  if (window->lecturer == NULL)
    return;
  text = cover_text (window);
  lecturer_window_set_cover (window->lecturer, text);
}

/* The class would see a picture that nobody brings to life again. */
static gboolean
on_delete (GtkWidget *widget, GdkEvent *event, Hull2vdWindow *window)
{
  (void)widget;
  (void)event;
  g_action_group_activate_action (G_ACTION_GROUP (window), "lecturer", NULL);
  return TRUE;
}

/* The lecturer's hands are on the class's window. */
static gboolean
on_key (GtkWidget *widget, GdkEventKey *event, Hull2vdWindow *window)
{
  if (hull2vd_window_forward_key (window, GTK_WINDOW (widget), event))
    return TRUE;
  if (event->keyval != GDK_KEY_Escape)
    return FALSE;
  gtk_window_unfullscreen (GTK_WINDOW (window));
  return TRUE;
}

/* Where the class's window is not, if there are two screens. */
static void
place (Hull2vdWindow *window)
{
  GdkDisplay *display = gtk_widget_get_display (GTK_WIDGET (window));
  GdkMonitor *taken = gdk_display_get_monitor_at_window (
      display, gtk_widget_get_window (GTK_WIDGET (window)));

  for (int i = 0; i < gdk_display_get_n_monitors (display); i++) {
    GdkMonitor *monitor = gdk_display_get_monitor (display, i);
    GdkRectangle room;

    if (monitor == taken)
      continue;
    gdk_monitor_get_workarea (monitor, &room);
    gtk_window_move (GTK_WINDOW (window->lecturer), room.x, room.y);
    return;
  }
}

static void
open_lecturer (Hull2vdWindow *window)
{
  window->lecturer
      = lecturer_window_new (GTK_APPLICATION_WINDOW (window), window->session);
  window_layout_follow_width (GTK_WIDGET (window->lecturer));
  window_theme_dress (window);
  g_signal_connect (window->lecturer, "delete-event", G_CALLBACK (on_delete),
                    window);
  g_signal_connect (window->lecturer, "key-press-event", G_CALLBACK (on_key),
                    window);
  place (window);
  window_lecturer_follow_cover (window);
  gtk_window_present (GTK_WINDOW (window->lecturer));
  window_message_settle (window, "lecturer");
}

static void
close_lecturer (Hull2vdWindow *window)
{
  GtkWidget *lecturer = GTK_WIDGET (window->lecturer);

  if (window_cover_is_frozen (window))
    g_action_group_activate_action (G_ACTION_GROUP (window), "freeze", NULL);
  window->lecturer = NULL;
  gtk_widget_destroy (lecturer);
}

void
window_lecturer_toggle (Hull2vdWindow *window)
{
  if (window->lecturer == NULL)
    open_lecturer (window);
  else
    close_lecturer (window);
}

/* Who freezes the pictures must see where the lesson is. */
void
window_lecturer_toggle_freeze (Hull2vdWindow *window)
{
  const Lesson *lesson = session_get_lesson (window->session);

  if (window->lecturer == NULL)
    g_action_group_activate_action (G_ACTION_GROUP (window), "lecturer", NULL);
  g_free (window->frozen_place);
  window->frozen_place
      = lesson != NULL ? g_strdup_printf (
            _ ("stop %u"), session_get_stop (window->session) + 1)
                       : g_strdup_printf (_ ("event %u"),
                                          session_get_step (window->session));
  window_cover_toggle_frozen (window);
}

/* Clock */

gboolean
window_lecturer_is_running (Hull2vdWindow *window)
{
  return window->lecturer != NULL
         && lecturer_window_is_running (window->lecturer);
}

void
window_lecturer_toggle_clock (Hull2vdWindow *window)
{
  if (window->lecturer == NULL)
    g_action_group_activate_action (G_ACTION_GROUP (window), "lecturer", NULL);
  lecturer_window_set_running (window->lecturer,
                               !lecturer_window_is_running (window->lecturer));
}

void
window_lecturer_reset_clock (Hull2vdWindow *window)
{
  if (window->lecturer != NULL)
    lecturer_window_reset_clock (window->lecturer);
  else
    hull2vd_window_say (window, _ ("The lecturer’s window is not open."));
}

/* Where the class does not see it, if there is such a place. */
void
window_lecturer_show_overview (Hull2vdWindow *window)
{
  overview_window_show (window->lecturer != NULL ? GTK_WINDOW (window->lecturer)
                                                 : GTK_WINDOW (window),
                        G_ACTION_GROUP (window), window->session);
}

void
window_lecturer_end (Hull2vdWindow *window)
{
  g_clear_pointer (&window->frozen_place, g_free);
  if (window->lecturer == NULL)
    return;
  gtk_widget_destroy (GTK_WIDGET (window->lecturer));
  window->lecturer = NULL;
}
