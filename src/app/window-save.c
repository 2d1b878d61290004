/* The sites as a file and as text: of many a thread writes it. */
#include "window-private.h"

#include "document.h"
#include "file-dialogs.h"
#include "window-ask.h"
#include "window-recent.h"

#include <glib/gi18n.h>
#include <string.h>

void
window_files_remember_saved (Hull2vdWindow *window)
{
  g_clear_pointer (&window->saved, g_bytes_unref);
  window->saved = document_sites (window->session);
  /* What is still on its way to a file is of another document. */
  window->saving = NULL;
}

gboolean
window_files_is_modified (Hull2vdWindow *window)
{
  g_autoptr (GBytes) now = NULL;

  /* A lesson is there to be played with. */
  if (session_get_lesson (window->session) != NULL
      || session_get_set (window->session)->n_sites == 0)
    return FALSE;
  now = document_sites (window->session);
  return window->saved == NULL || !g_bytes_equal (now, window->saved);
}

/* Save */

typedef struct Save {
  Hull2vdWindow *window;
  char *path;
  GBytes *sites;
  gboolean is_of_lesson;
  ChoreTask *task; /* NULL: it was done at once */
} Save;

static void
save_free (gpointer data)
{
  Save *save = data;

  if (save->task != NULL && save->window->saving == save->task)
    save->window->saving = NULL;
  g_object_unref (save->window);
  g_bytes_unref (save->sites);
  g_free (save->path);
  g_free (save);
}

/* Takes the file as that of the document. */
static void
adopt (Save *save)
{
  Hull2vdWindow *window = save->window;

  g_free (window->path);
  window->path = g_strdup (save->path);
  window->is_foreign = FALSE;
  g_clear_pointer (&window->saved, g_bytes_unref);
  window->saved = g_bytes_ref (save->sites);
  if (!window_files_is_modified (window))
    window_recovery_clear (window);
  hull2vd_window_update_title (window);
}

/* What waits for that goes on, but not over what was changed meanwhile. */
static void
on_saved (gpointer data, const GError *error)
{
  Save *save = data;
  Hull2vdWindow *window = save->window;
  const gboolean is_current = save->task == window->saving;

  if (error != NULL) {
    window_message_say (window, "save", error->message);
    return;
  }
  if (!save->is_of_lesson && is_current)
    adopt (save);
  window_recent_add (save->path);
  window_message_settle (window, "save");
  if (is_current && !window_files_is_modified (window))
    window_ask_saved (window);
  else if (is_current)
    window_ask_forget (window);
}

static gboolean
write_sites (ChoreTask *task, gpointer data, GError **error)
{
  Save *save = data;
  g_autofree char *text = document_sites_text (save->sites);

  return chore_task_write (task, save->path, text, strlen (text), error);
}

static void
save_at_once (Save *save)
{
  g_autofree char *text = document_sites_text (save->sites);
  g_autoptr (GError) error = NULL;

  document_write (save->path, text, strlen (text), &error);
  on_saved (save, error);
  save_free (save);
}

static void
on_save_chosen (const char *path, gpointer user)
{
  Hull2vdWindow *window = user;
  Save *save = g_new0 (Save, 1);

  save->window = g_object_ref (window);
  save->path = g_strdup (path);
  save->sites = document_sites (window->session);
  save->is_of_lesson = session_get_lesson (window->session) != NULL;
  /* The sites as they are now replace what is still on its way. */
  if (window->saving != NULL)
    chore_task_give_up (window->saving);
  window->saving = NULL;
  if (session_get_set (window->session)->n_sites <= SESSION_AT_ONCE)
    save_at_once (save);
  else
    window->saving = save->task
        = chore_task_begin (window->session, _ ("The sites are being saved"),
                            write_sites, on_saved, save, save_free);
}

/* A lesson's sites are offered a name of their own, and so are those that came
 * from another form than the one they are written in. */
static char *
suggest_name (Hull2vdWindow *window)
{
  g_autofree char *base = NULL;
  char *dot;

  if (window->path == NULL || session_get_lesson (window->session) != NULL)
    return g_strdup (_ ("sites.txt"));
  base = g_path_get_basename (window->path);
  dot = strrchr (base, '.');
  if (!window->is_foreign || dot == NULL)
    return g_steal_pointer (&base);
  *dot = '\0';
  return g_strconcat (base, ".txt", NULL);
}

static void
ask_for_name (Hull2vdWindow *window)
{
  g_autofree char *name = suggest_name (window);

  if (window_dialog_refuse (window, NULL))
    return;
  file_dialog_save (GTK_WINDOW (window), _ ("Save the Sites"), name,
                    on_save_chosen, window);
}

void
window_files_save_as (Hull2vdWindow *window)
{
  window_ask_forget (window);
  ask_for_name (window);
}

void
window_files_save (Hull2vdWindow *window)
{
  window_ask_forget (window);
  window_files_save_now (window);
}

void
window_files_save_now (Hull2vdWindow *window)
{
  g_autofree char *path = g_strdup (window->path);

  if (path == NULL || window->is_foreign
      || session_get_lesson (window->session) != NULL)
    ask_for_name (window);
  else
    on_save_chosen (path, window);
}

/* Copy */

typedef struct Copy {
  Hull2vdWindow *window;
  GBytes *sites;
  char *text;
} Copy;

static void
copy_free (gpointer data)
{
  Copy *copy = data;

  g_object_unref (copy->window);
  g_bytes_unref (copy->sites);
  g_free (copy->text);
  g_free (copy);
}

static gboolean
make_text (ChoreTask *task, gpointer data, GError **error)
{
  Copy *copy = data;

  (void)task;
  (void)error;
  copy->text = document_sites_text (copy->sites);
  return TRUE;
}

static void
on_text (gpointer data, const GError *error)
{
  Copy *copy = data;

  (void)error;
  gtk_clipboard_set_text (gtk_widget_get_clipboard (GTK_WIDGET (copy->window),
                                                    GDK_SELECTION_CLIPBOARD),
                          copy->text, -1);
}

void
window_files_copy (Hull2vdWindow *window)
{
  Copy *copy = g_new0 (Copy, 1);

  copy->window = g_object_ref (window);
  copy->sites = document_sites (window->session);
  if (session_get_set (window->session)->n_sites > SESSION_AT_ONCE) {
    chore_task_begin (window->session, _ ("The sites are being copied"),
                      make_text, on_text, copy, copy_free);
    return;
  }
  make_text (NULL, copy, NULL);
  on_text (copy, NULL);
  copy_free (copy);
}
