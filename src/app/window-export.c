#include "window-private.h"

#include "document.h"
#include "file-dialogs.h"
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
