#include "file-dialogs.h"

#include <glib/gi18n.h>

#define MOST_OF_SCREEN 0.9

typedef struct Choice {
  FileChosen on_chosen;
  gpointer user;
  GDestroyNotify free_user; /* may be NULL */
} Choice;

/* The desktop's own dialogs are no windows of this program. */
#define OPEN_DIALOG "file-dialog"

gboolean
file_dialog_is_open (GtkWindow *parent)
{
  return g_object_get_data (G_OBJECT (parent), OPEN_DIALOG) != NULL;
}

static void
on_response (GtkNativeDialog *dialog, int response, Choice *choice)
{
  GtkWindow *parent = gtk_native_dialog_get_transient_for (dialog);

  if (parent != NULL)
    g_object_set_data (G_OBJECT (parent), OPEN_DIALOG, NULL);
  if (response == GTK_RESPONSE_ACCEPT) {
    g_autofree char *path
        = gtk_file_chooser_get_filename (GTK_FILE_CHOOSER (dialog));

    if (path != NULL)
      choice->on_chosen (path, choice->user);
  }
  if (choice->free_user != NULL)
    choice->free_user (choice->user);
  g_free (choice);
  g_object_unref (dialog);
}

static GtkFileChooser *
make_dialog (GtkWindow *parent, const char *title, gboolean saves)
{
  GtkFileChooserNative *dialog = gtk_file_chooser_native_new (
      title, parent,
      saves ? GTK_FILE_CHOOSER_ACTION_SAVE : GTK_FILE_CHOOSER_ACTION_OPEN,
      saves ? _ ("_Save") : _ ("_Open"), _ ("_Cancel"));

  gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (dialog), TRUE);
  return GTK_FILE_CHOOSER (dialog);
}

/* GTK's own dialog, where the desktop has none, is as large as letters ask for:
 * larger than a small screen. */
static void
fit_dialog (GtkWindow *dialog)
{
  GdkWindow *surface = gtk_widget_get_window (GTK_WIDGET (dialog));
  GdkMonitor *monitor = gdk_display_get_monitor_at_window (
      gtk_widget_get_display (GTK_WIDGET (dialog)), surface);
  GdkRectangle room;
  int width, height;

  gdk_monitor_get_workarea (monitor, &room);
  gtk_window_get_size (dialog, &width, &height);
  gtk_window_resize (dialog, MIN (width, MOST_OF_SCREEN * room.width),
                     MIN (height, MOST_OF_SCREEN * room.height));
}

static void
fit_dialogs (void)
{
  g_autoptr (GList) tops = gtk_window_list_toplevels ();

  for (GList *node = tops; node != NULL; node = node->next)
    if (GTK_IS_FILE_CHOOSER_DIALOG (node->data)
        && gtk_widget_get_mapped (node->data))
      fit_dialog (node->data);
}

static void
show_dialog (GtkFileChooser *dialog,
             GtkWindow *parent,
             FileChosen on_chosen,
             gpointer user,
             GDestroyNotify free_user)
{
  Choice *choice = g_new0 (Choice, 1);

  choice->on_chosen = on_chosen;
  choice->user = user;
  choice->free_user = free_user;
  g_signal_connect (dialog, "response", G_CALLBACK (on_response), choice);
  g_object_set_data (G_OBJECT (parent), OPEN_DIALOG, dialog);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (dialog));
  fit_dialogs ();
}

static void
add_filter (GtkFileChooser *dialog, const char *name, const char *patterns)
{
  GtkFileFilter *filter = gtk_file_filter_new ();
  g_auto (GStrv) each = g_strsplit (patterns, " ", -1);

  gtk_file_filter_set_name (filter, name);
  for (guint i = 0; each[i] != NULL; i++)
    gtk_file_filter_add_pattern (filter, each[i]);
  gtk_file_chooser_add_filter (dialog, filter);
}

void
file_dialog_open (GtkWindow *parent,
                  const char *title,
                  FileChosen on_chosen,
                  gpointer user)
{
  GtkFileChooser *dialog = make_dialog (parent, title, FALSE);

  add_filter (dialog, _ ("Lessons and points"),
              "*.md *.txt *.csv *.xy *.points");
  add_filter (dialog, _ ("All files"), "*");
  show_dialog (dialog, parent, on_chosen, user, NULL);
}

void
file_dialog_save (GtkWindow *parent,
                  const char *title,
                  const char *name,
                  FileChosen on_chosen,
                  gpointer user)
{
  file_dialog_save_with (parent, title, name, on_chosen, user, NULL);
}

void
file_dialog_save_with (GtkWindow *parent,
                       const char *title,
                       const char *name,
                       FileChosen on_chosen,
                       gpointer user,
                       GDestroyNotify free_user)
{
  GtkFileChooser *dialog = make_dialog (parent, title, TRUE);

  gtk_file_chooser_set_do_overwrite_confirmation (dialog, TRUE);
  gtk_file_chooser_set_current_name (dialog, name);
  show_dialog (dialog, parent, on_chosen, user, free_user);
}
