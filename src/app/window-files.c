#include "window-private.h"

#include "document.h"
#include "file-dialogs.h"

#include <glib/gi18n.h>
#include <string.h>

/* The sites as they are now are those of the file. */
static void
remember_saved (Hull2vdWindow *window)
{
  g_free (window->saved);
  window->saved = document_copy (window->session);
}

gboolean
window_files_is_modified (Hull2vdWindow *window)
{
  g_autofree char *now = NULL;

  /* A lesson is there to be played with. */
  if (session_get_lesson (window->session) != NULL
      || session_get_set (window->session)->n_sites == 0)
    return FALSE;
  now = document_copy (window->session);
  return g_strcmp0 (now, window->saved) != 0;
}

gboolean
window_files_load (Hull2vdWindow *window, const char *path)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *kept = g_strdup (path);

  gtk_info_bar_set_revealed (window->info_bar, FALSE);
  /* The title is made while the session tells of its change. */
  g_free (window->path);
  window->path = g_steal_pointer (&kept);
  if (!document_open (window->session, path, &error)) {
    hull2vd_window_say (window, error->message);
    return FALSE;
  }
  remember_saved (window);
  gtk_widget_grab_focus (GTK_WIDGET (window->plane_view));
  return TRUE;
}

void
window_files_new (Hull2vdWindow *window)
{
  if (window_files_is_modified (window)) {
    window
        = hull2vd_window_new (gtk_window_get_application (GTK_WINDOW (window)));
    gtk_window_present (GTK_WINDOW (window));
  }
  g_clear_pointer (&window->path, g_free);
  session_set_lesson (window->session, NULL);
  session_set_sites (window->session, NULL, 0, NULL);
  remember_saved (window);
  gtk_info_bar_set_revealed (window->info_bar, FALSE);
}

/* Open */

static void
on_open_chosen (const char *path, gpointer user)
{
  Hull2vdWindow *window = user;
  g_autoptr (GFile) file = g_file_new_for_path (path);

  if (!window_files_is_modified (window)) {
    window_files_load (window, path);
    return;
  }
  /* The application gives it a window of its own. */
  g_application_open (
      G_APPLICATION (gtk_window_get_application (GTK_WINDOW (window))), &file,
      1, "");
}

void
window_files_open (Hull2vdWindow *window)
{
  file_dialog_open (GTK_WINDOW (window), _ ("Open a Lesson or Points"),
                    on_open_chosen, window);
}

/* Save */

static void
on_save_chosen (const char *path, gpointer user)
{
  Hull2vdWindow *window = user;
  g_autoptr (GError) error = NULL;

  if (!document_save (window->session, path, &error)) {
    hull2vd_window_say (window, error->message);
    return;
  }
  if (session_get_lesson (window->session) == NULL) {
    g_free (window->path);
    window->path = g_strdup (path);
    remember_saved (window);
  }
  gtk_info_bar_set_revealed (window->info_bar, FALSE);
}

void
window_files_save_as (Hull2vdWindow *window)
{
  file_dialog_save (GTK_WINDOW (window), _ ("Save the Sites"), _ ("sites.txt"),
                    on_save_chosen, window);
}

void
window_files_save (Hull2vdWindow *window)
{
  g_autofree char *path = g_strdup (window->path);

  if (path == NULL || session_get_lesson (window->session) != NULL)
    window_files_save_as (window);
  else
    on_save_chosen (path, window);
}

/* Drop */

static void
on_drop (GtkWidget *widget,
         GdkDragContext *context,
         int x,
         int y,
         GtkSelectionData *data,
         guint info,
         guint time,
         gpointer user)
{
  g_auto (GStrv) uris = gtk_selection_data_get_uris (data);
  g_autofree char *path = NULL;

  (void)context;
  (void)x;
  (void)y;
  (void)info;
  (void)time;
  (void)user;
  if (uris == NULL || uris[0] == NULL)
    return;
  path = g_filename_from_uri (uris[0], NULL, NULL);
  if (path != NULL)
    on_open_chosen (path, widget);
}

/* Close */

static void
on_close_answer (GtkDialog *dialog, int answer, Hull2vdWindow *window)
{
  gtk_widget_destroy (GTK_WIDGET (dialog));
  if (answer == GTK_RESPONSE_ACCEPT)
    window_files_save (window);
  if (answer == GTK_RESPONSE_REJECT
      || (answer == GTK_RESPONSE_ACCEPT
          && !window_files_is_modified (window))) {
    window_layout_save (window);
    gtk_widget_destroy (GTK_WIDGET (window));
  }
}

static void
ask_before_closing (Hull2vdWindow *window)
{
  GtkWidget *dialog = gtk_message_dialog_new (
      GTK_WINDOW (window), GTK_DIALOG_MODAL | GTK_DIALOG_USE_HEADER_BAR,
      GTK_MESSAGE_QUESTION, GTK_BUTTONS_NONE,
      _ ("Save the sites before closing?"));

  gtk_message_dialog_format_secondary_text (GTK_MESSAGE_DIALOG (dialog),
                                            _ ("Otherwise they are lost."));
  gtk_dialog_add_buttons (GTK_DIALOG (dialog), _ ("Close _without Saving"),
                          GTK_RESPONSE_REJECT, _ ("_Cancel"),
                          GTK_RESPONSE_CANCEL, _ ("_Save"), GTK_RESPONSE_ACCEPT,
                          NULL);
  gtk_dialog_set_default_response (GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT);
  g_signal_connect (dialog, "response", G_CALLBACK (on_close_answer), window);
  gtk_widget_show (dialog);
}

static gboolean
on_delete (GtkWidget *widget, GdkEvent *event, gpointer user)
{
  Hull2vdWindow *window = HULL2VD_WINDOW (widget);

  (void)event;
  (void)user;
  if (window_files_is_modified (window)) {
    ask_before_closing (window);
    return TRUE;
  }
  window_layout_save (window);
  return FALSE;
}

void
window_files_init (Hull2vdWindow *window)
{
  GtkWidget *widget = GTK_WIDGET (window);

  gtk_drag_dest_set (widget, GTK_DEST_DEFAULT_ALL, NULL, 0, GDK_ACTION_COPY);
  gtk_drag_dest_add_uri_targets (widget);
  g_signal_connect (widget, "drag-data-received", G_CALLBACK (on_drop), NULL);
  g_signal_connect (widget, "delete-event", G_CALLBACK (on_delete), NULL);
  remember_saved (window);
}
