/* Recording what a person does, as text of a lesson. */
#include "window-private.h"

#include <glib/gi18n.h>

gboolean
window_record_is_on (Hull2vdWindow *window)
{
  return window->record != NULL;
}

static void
end (Hull2vdWindow *window)
{
  record_window_set_record (window->record_window, NULL);
  g_clear_pointer (&window->record, session_record_free);
}

/* Closing the text ends the record. */
static gboolean
on_delete (GtkWidget *widget, GdkEvent *event, Hull2vdWindow *window)
{
  (void)event;
  if (window->record != NULL)
    g_action_group_activate_action (G_ACTION_GROUP (window), "record", NULL);
  return gtk_widget_hide_on_delete (widget);
}

/* The text has keys of its own; all others are those of the pictures. */
static gboolean
on_key (GtkWidget *widget, GdkEventKey *event, Hull2vdWindow *window)
{
  return gtk_window_propagate_key_event (GTK_WINDOW (widget), event)
         || hull2vd_window_forward_key (window, GTK_WINDOW (widget), event);
}

static void
begin (Hull2vdWindow *window)
{
  if (window->record_window == NULL) {
    window->record_window
        = record_window_new (GTK_APPLICATION_WINDOW (window), window->session);
    g_signal_connect (window->record_window, "delete-event",
                      G_CALLBACK (on_delete), window);
    g_signal_connect (window->record_window, "key-press-event",
                      G_CALLBACK (on_key), window);
  }
  window->record = session_record_new (window->session);
  record_window_set_record (window->record_window, window->record);
  gtk_window_present (GTK_WINDOW (window->record_window));
  window_message_settle (window, "record");
}

void
window_record_toggle (Hull2vdWindow *window)
{
  if (window->record != NULL)
    end (window);
  else
    begin (window);
}

void
window_record_cut (Hull2vdWindow *window)
{
  if (window->record != NULL)
    session_record_cut (window->record);
  else
    hull2vd_window_say (window, _ ("Nothing is being recorded."));
}

void
window_record_copy (Hull2vdWindow *window)
{
  if (window->record_window != NULL)
    record_window_copy (window->record_window);
  else
    hull2vd_window_say (window, _ ("Nothing has been recorded."));
}

void
window_record_end (Hull2vdWindow *window)
{
  if (window->record != NULL)
    end (window);
}
