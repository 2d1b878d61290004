/* Pictures for other programs: what is exported and what is copied. */
#include "window-private.h"

#include "document.h"
#include "export-dialog.h"
#include "file-dialogs.h"
#include "session-picture.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <stdio.h>
#include <stdlib.h>

#define COPY_SCALE 2 /* of pixels; other programs scale lines themselves */

/* Draws the session as it is now.
 *
 * Returns: (transfer full): the file, or NULL when it cannot be drawn. */
static GBytes *
draw (Hull2vdWindow *window, Picture *picture, PictureFormat format)
{
  const Lesson *lesson = session_get_lesson (window->session);
  g_autofree char *sentence = session_narrate (window->session);
  char *bytes = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&bytes, &length);
  gboolean is_drawn;

  if (file == NULL)
    g_error ("open_memstream: %s", g_strerror (errno));
  session_picture_take (picture, window->session);
  picture->title = lesson != NULL ? lesson->title : "Hull2VD";
  picture->description = sentence;
  is_drawn = picture_write (picture, session_get_frame (window->session),
                            format, file);
  fclose (file);
  if (is_drawn)
    return g_bytes_new_with_free_func (bytes, length, free, bytes);
  free (bytes);
  return NULL;
}

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
on_file_chosen (const char *path, gpointer user)
{
  Export *export = user;
  g_autoptr (GBytes) bytes = NULL;
  g_autoptr (GError) error = NULL;
  PictureFormat format = export->format;
  gsize length;
  gconstpointer data;

  if (!picture_format_of (path, &format)) {
    g_autofree char *message = g_strdup_printf (
        _ ("%s: the name of a picture must end in .svg, .pdf or .png"), path);

    hull2vd_window_say (export->window, message);
    return;
  }
  bytes = draw (export->window, &export->picture, format);
  if (bytes == NULL) {
    g_autofree char *message
        = g_strdup_printf (_ ("%s: the picture could not be drawn"), path);

    hull2vd_window_say (export->window, message);
    return;
  }
  data = g_bytes_get_data (bytes, &length);
  if (!document_write (path, data, length, &error))
    hull2vd_window_say (export->window, error->message);
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

void
window_picture_copy (Hull2vdWindow *window)
{
  Session *session = window->session;
  Copy *copy = g_new0 (Copy, 1);
  Picture picture;
  Theme theme;

  theme_init (&theme, session_get_appearance (session));
  picture_init (&picture, PICTURE_BOTH, session_get_frame (session));
  picture.theme = &theme;
  copy->svg = draw (window, &picture, PICTURE_SVG);
  picture.scale = COPY_SCALE;
  copy->png = draw (window, &picture, PICTURE_PNG);
  gtk_clipboard_set_with_data (
      gtk_widget_get_clipboard (GTK_WIDGET (window), GDK_SELECTION_CLIPBOARD),
      targets, G_N_ELEMENTS (targets), on_wanted, on_cleared, copy);
}
