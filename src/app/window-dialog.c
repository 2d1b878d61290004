/* One dialog at a time: what would ask while another one asks is refused, in
 * the same words, whoever asks for it: D-Bus, a drop, another program. */
#include "window-private.h"

#include "file-dialogs.h"

#include <glib/gi18n.h>

static gboolean
is_dialog_of (GtkWindow *dialog, Hull2vdWindow *window)
{
  return gtk_window_get_modal (dialog)
         && gtk_widget_get_visible (GTK_WIDGET (dialog))
         && gtk_window_get_transient_for (dialog) == GTK_WINDOW (window);
}

static GtkWindow *
find_dialog (Hull2vdWindow *window)
{
  GList *windows = gtk_window_list_toplevels ();
  GtkWindow *found = NULL;

  for (GList *node = windows; node != NULL; node = node->next)
    if (is_dialog_of (node->data, window))
      found = node->data;
  g_list_free (windows);
  return found;
}

gboolean
window_dialog_refuse (Hull2vdWindow *window, const char *path)
{
  GtkWindow *dialog = find_dialog (window);
  g_autofree char *message = NULL;

  if (dialog == NULL && !file_dialog_is_open (GTK_WINDOW (window)))
    return FALSE;
  if (dialog != NULL)
    gtk_window_present (dialog);
  message = path == NULL
                ? g_strdup (_ ("Another dialog is open. Close it first."))
                : g_strdup_printf (
                    _ ("%s was not opened: another dialog is open."), path);
  window_message_say (window, path == NULL ? window->command : "open", message);
  return TRUE;
}
