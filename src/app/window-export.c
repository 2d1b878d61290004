#include "window-private.h"

#include "document.h"
#include "file-dialogs.h"
#include "handout-dialog.h"
#include "storyboard.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <stdio.h>
#include <stdlib.h>

/* A file in memory, so that it appears on the disk whole or not at all. */
typedef struct Pages {
  FILE *file;
  char *bytes;
  size_t length;
} Pages;

static void
pages_open (Pages *pages)
{
  pages->bytes = NULL;
  pages->length = 0;
  pages->file = open_memstream (&pages->bytes, &pages->length);
  if (pages->file == NULL)
    g_error ("open_memstream: %s", g_strerror (errno));
}

/* Writes the pages to @path unless @is_good is FALSE, and lets them go. */
static gboolean
pages_close (Pages *pages, const char *path, gboolean is_good, GError **error)
{
  gboolean is_written = FALSE;

  fclose (pages->file);
  if (is_good)
    is_written = document_write (path, pages->bytes, pages->length, error);
  free (pages->bytes);
  return is_written;
}

/* Another session plays the lesson, so that the window's stays in place. */
static Session *
copy_session (Session *session)
{
  Session *copy = session_new ();
  const SiteSet *set = session_get_set (session);
  g_autofree Site *sites = g_new (Site, MAX (set->n_sites, 1));

  if (session_get_lesson (session) != NULL) {
    session_set_lesson (copy, session_get_lesson (session));
    return copy;
  }
  for (guint i = 0; i < set->n_sites; i++)
    sites[i] = site_set_given (set, i);
  session_set_sites (copy, sites, set->n_sites, NULL);
  return copy;
}

static void
on_storyboard_chosen (const char *path, gpointer user)
{
  Hull2vdWindow *window = user;
  g_autoptr (Session) session = copy_session (window->session);
  g_autoptr (GError) error = NULL;
  Appearance appearance;
  Pages pages;
  gboolean is_good;

  appearance_init (&appearance);
  pages_open (&pages);
  is_good = storyboard_write (session, &appearance, pages.file, &error);
  if (!pages_close (&pages, path, is_good, error == NULL ? &error : NULL))
    hull2vd_window_say (window, error->message);
}

void
window_files_storyboard (Hull2vdWindow *window)
{
  file_dialog_save (GTK_WINDOW (window), _ ("Export a Storyboard (.pdf)"),
                    _ ("storyboard.pdf"), on_storyboard_chosen, window);
}

/* Handouts */

/* What was asked for, while the name of the file is asked for. */
typedef struct HandoutExport {
  Hull2vdWindow *window;
  Lesson *lesson;
  HandoutOptions options;
} HandoutExport;

static void
handout_export_free (gpointer user)
{
  HandoutExport *export = user;

  g_object_unref (export->window);
  lesson_unref (export->lesson);
  g_free (export);
}

static void
on_handout_chosen (const char *path, gpointer user)
{
  HandoutExport *export = user;
  g_autoptr (Session) session = session_new ();
  g_autoptr (Handout) handout = NULL;
  g_autoptr (GError) error = NULL;
  Pages pages;
  gboolean is_good;

  session_set_lesson (session, export->lesson);
  handout = handout_new (session, &export->options);
  pages_open (&pages);
  is_good = handout_write (handout, pages.file, &error);
  if (!pages_close (&pages, path, is_good, error == NULL ? &error : NULL))
    hull2vd_window_say (export->window, error->message);
}

static void
on_handout_response (HandoutDialog *dialog, int response, HandoutExport *export)
{
  if (response == GTK_RESPONSE_ACCEPT) {
    handout_dialog_fill (dialog, &export->options);
    file_dialog_save_with (GTK_WINDOW (export->window),
                           _ ("Export a Handout (.pdf)"), _ ("handout.pdf"),
                           on_handout_chosen, export, handout_export_free);
  } else
    handout_export_free (export);
  gtk_widget_destroy (GTK_WIDGET (dialog));
}

void
window_files_handout (Hull2vdWindow *window)
{
  HandoutExport *export = g_new0 (HandoutExport, 1);
  HandoutDialog *dialog;

  export->window = g_object_ref (window);
  export->lesson = lesson_ref (session_get_lesson (window->session));
  dialog = handout_dialog_new (GTK_WINDOW (window), export->lesson);
  g_signal_connect (dialog, "response", G_CALLBACK (on_handout_response),
                    export);
  gtk_window_present (GTK_WINDOW (dialog));
}
