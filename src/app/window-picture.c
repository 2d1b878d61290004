/* Pictures for other programs: what is exported and what is copied. */
#include "window-private.h"

#include "export-dialog.h"
#include "file-dialogs.h"
#include "picture-task.h"

#include <glib/gi18n.h>

#define COPY_SCALE 2 /* of pixels; other programs scale lines themselves */

/* Export */

/* What was asked for, while the name of the file is asked for. */
typedef struct Export {
  Hull2vdWindow *window;
  Theme theme;
  Picture picture;
  PictureFormat format;
} Export;

static void
export_free (Export *export)
{
  g_object_unref (export->window);
  g_free (export);
}

static const char *const endings[] = { ".svg", ".pdf", ".png" };

static void
on_exported (PictureFile files[N_PICTURE_FILES],
             const GError *error,
             gpointer user)
{
  (void)files;
  if (error != NULL)
    window_message_say (user, "export-picture", error->message);
  else
    window_message_settle (user, "export-picture");
}

static void
on_file_chosen (const char *path, gpointer user)
{
  Export *export = user;
  PictureFile file
      = { export->format, export->picture.scale, (char *)path, NULL };

  if (!picture_format_of (path, &file.format)) {
    g_autofree char *message = g_strdup_printf (
        _ ("%s: the name of a picture must end in .svg, .pdf or .png"), path);

    window_message_say (export->window, "export-picture", message);
    return;
  }
  picture_task_begin (export->window->session, &export->picture, &file, 1,
                      on_exported, g_object_ref (export->window),
                      g_object_unref);
}

static void
on_response (ExportDialog *dialog, int response, Export *export)
{
  g_autofree char *name = NULL;

  if (response == GTK_RESPONSE_ACCEPT) {
    export_dialog_fill (dialog, &export->picture, &export->theme);
    export->format = export_dialog_get_format (dialog);
    name = g_strconcat (_ ("hull"), endings[export->format], NULL);
    file_dialog_save_with (GTK_WINDOW (export->window), _ ("Export Picture"),
                           name, on_file_chosen, export,
                           (GDestroyNotify)export_free);
  } else
    export_free (export);
  gtk_widget_destroy (GTK_WIDGET (dialog));
}

void
window_picture_export (Hull2vdWindow *window)
{
  ExportDialog *dialog
      = export_dialog_new (GTK_WINDOW (window), window->session);
  Export *export = g_new0 (Export, 1);

  export->window = g_object_ref (window);
  g_signal_connect (dialog, "response", G_CALLBACK (on_response), export);
  gtk_window_present (GTK_WINDOW (dialog));
}

/* Copy */

/* A picture as the clipboard hands it out. */
typedef struct Copy {
  GBytes *png, *svg;
} Copy;

static const GtkTargetEntry targets[] = {
  { (char *)"image/png", 0, PICTURE_PNG },
  { (char *)"image/svg+xml", 0, PICTURE_SVG },
};

static void
on_wanted (GtkClipboard *clipboard,
           GtkSelectionData *selection,
           guint format,
           gpointer user)
{
  const Copy *copy = user;
  GBytes *bytes = format == PICTURE_PNG ? copy->png : copy->svg;
  gsize length;
  const guint8 *data = g_bytes_get_data (bytes, &length);

  (void)clipboard;
  gtk_selection_data_set (selection, gtk_selection_data_get_target (selection),
                          8, data, (int)length);
}

static void
on_cleared (GtkClipboard *clipboard, gpointer user)
{
  Copy *copy = user;

  (void)clipboard;
  g_clear_pointer (&copy->png, g_bytes_unref);
  g_clear_pointer (&copy->svg, g_bytes_unref);
  g_free (copy);
}

static void
on_copied (PictureFile files[N_PICTURE_FILES],
           const GError *error,
           gpointer user)
{
  GtkWidget *window = user;
  Copy *copy;

  if (error != NULL) {
    window_message_say (user, "copy-picture", error->message);
    return;
  }
  window_message_settle (user, "copy-picture");
  copy = g_new0 (Copy, 1);
  copy->svg = g_steal_pointer (&files[0].bytes);
  copy->png = g_steal_pointer (&files[1].bytes);
  gtk_clipboard_set_with_data (
      gtk_widget_get_clipboard (window, GDK_SELECTION_CLIPBOARD), targets,
      G_N_ELEMENTS (targets), on_wanted, on_cleared, copy);
}

void
window_picture_copy (Hull2vdWindow *window)
{
  static const PictureFile files[N_PICTURE_FILES]
      = { { PICTURE_SVG, 1, NULL, NULL },
          { PICTURE_PNG, COPY_SCALE, NULL, NULL } };
  Session *session = window->session;
  Picture picture;
  Theme theme;

  theme_init (&theme, session_get_appearance (session));
  picture_init (&picture, PICTURE_BOTH, session_get_frame (session));
  picture.theme = &theme;
  picture_task_begin (session, &picture, files, N_PICTURE_FILES, on_copied,
                      g_object_ref (window), g_object_unref);
}
