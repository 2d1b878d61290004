#include "window-private.h"

#include "chore-task.h"
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

/* What a thread writes. Another session plays it, so that the window's stays
 * in place. */
typedef struct Export {
  Hull2vdWindow *window;
  char *path;
  Lesson *lesson; /* NULL: the sites, in their order */
  GBytes *sites;
  Order order;
  gboolean is_handout; /* else a storyboard */
  HandoutOptions options;
} Export;

static Export *
export_new (Hull2vdWindow *window)
{
  Session *session = window->session;
  Lesson *lesson = session_get_lesson (session);
  Export *export = g_new0 (Export, 1);

  export->window = g_object_ref (window);
  if (lesson != NULL)
    export->lesson = lesson_ref (lesson);
  export->sites = document_sites (session);
  export->order = session_get_order (session);
  return export;
}

static void
export_free (gpointer data)
{
  Export *export = data;

  g_object_unref (export->window);
  g_clear_pointer (&export->lesson, lesson_unref);
  g_bytes_unref (export->sites);
  g_free (export->path);
  g_free (export);
}

static Session *
play (const Export *export)
{
  Session *session = session_new ();
  gsize length;
  const Site *sites = g_bytes_get_data (export->sites, &length);

  if (export->lesson != NULL) {
    session_set_lesson (session, export->lesson);
    return session;
  }
  session_set_order (session, &export->order);
  session_set_sites (session, sites, (guint)(length / sizeof *sites), NULL);
  return session;
}

static gboolean
write_pages (const Export *export,
             FILE *file,
             GCancellable *cancellable,
             GError **error)
{
  g_autoptr (Session) session = play (export);
  g_autoptr (Handout) handout = NULL;
  Appearance appearance;

  appearance_init (&appearance);
  if (!export->is_handout)
    return storyboard_write (session, &appearance, file, cancellable, error);
  handout = handout_new (session, &export->options);
  return handout_write (handout, file, cancellable, error);
}

static gboolean
export_pages (ChoreTask *task, gpointer data, GError **error)
{
  Export *export = data;
  Pages pages;
  gboolean is_good;

  pages_open (&pages);
  is_good = write_pages (export, pages.file, chore_task_get_cancellable (task),
                         error);
  fclose (pages.file);
  is_good = is_good
            && chore_task_write (task, export->path, pages.bytes, pages.length,
                                 error);
  free (pages.bytes);
  return is_good;
}

static void
on_exported (gpointer data, const GError *error)
{
  const Export *export = data;
  const char *command = export->is_handout ? "handout" : "storyboard";

  if (error != NULL)
    window_message_say (export->window, command, error->message);
  else
    window_message_settle (export->window, command);
}

static void
begin (Export *export, const char *path)
{
  export->path = g_strdup (path);
  chore_task_begin (export->window->session,
                    export->is_handout ? _ ("The handout is being written")
                                       : _ ("The storyboard is being written"),
                    export_pages, on_exported, export, export_free);
}

static void
on_storyboard_chosen (const char *path, gpointer user)
{
  begin (export_new (user), path);
}

void
window_files_storyboard (Hull2vdWindow *window)
{
  file_dialog_save (GTK_WINDOW (window), _ ("Export a Storyboard (.pdf)"),
                    _ ("storyboard.pdf"), on_storyboard_chosen, window);
}

/* Handouts */

/* Takes over what was asked for, while the name of the file is asked for. */
static void
on_handout_chosen (const char *path, gpointer user)
{
  Export **asked = user;

  begin (g_steal_pointer (asked), path);
}

static void
asked_free (gpointer user)
{
  Export **asked = user;

  g_clear_pointer (asked, export_free);
  g_free (asked);
}

static void
on_handout_response (HandoutDialog *dialog, int response, Export *export)
{
  Export **asked;

  if (response == GTK_RESPONSE_ACCEPT) {
    handout_dialog_fill (dialog, &export->options);
    asked = g_new (Export *, 1);
    *asked = export;
    file_dialog_save_with (GTK_WINDOW (export->window),
                           _ ("Export a Handout (.pdf)"), _ ("handout.pdf"),
                           on_handout_chosen, asked, asked_free);
  } else
    export_free (export);
  gtk_widget_destroy (GTK_WIDGET (dialog));
}

void
window_files_handout (Hull2vdWindow *window)
{
  Export *export = export_new (window);
  HandoutDialog *dialog = handout_dialog_new (GTK_WINDOW (window),
                                              window->session, export->lesson);

  export->is_handout = TRUE;
  g_signal_connect (dialog, "response", G_CALLBACK (on_handout_response),
                    export);
  gtk_window_present (GTK_WINDOW (dialog));
}
