#include "picture-task.h"

#include "document.h"
#include "session-chore.h"
#include "session-picture.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <stdio.h>
#include <stdlib.h>

struct PictureTask {
  Session *session; /* borrowed; of the main loop alone, as the next five */
  guint chore;
  gboolean is_over; /* nobody is told */
  PictureTaskDone done;
  gpointer user;
  GDestroyNotify destroy;

  Picture picture;
  Theme theme;
  char *title, *description;
  KeptPanes *panes;
  PictureFile files[N_PICTURE_FILES];
  guint n_files;
};

static void
picture_task_free (gpointer data)
{
  PictureTask *task = data;

  for (guint i = 0; i < task->n_files; i++) {
    g_free (task->files[i].path);
    g_clear_pointer (&task->files[i].bytes, g_bytes_unref);
  }
  kept_panes_free (task->panes);
  g_free (task->title);
  g_free (task->description);
  g_free (task);
}

/* Returns: (transfer full): the file, or NULL when it cannot be drawn. */
static GBytes *
draw (Picture *picture, PictureFormat format)
{
  char *bytes = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&bytes, &length);
  gboolean is_drawn;

  if (file == NULL)
    g_error ("open_memstream: %s", g_strerror (errno));
  is_drawn = picture_write (picture, NULL, format, file);
  fclose (file);
  if (is_drawn)
    return g_bytes_new_with_free_func (bytes, length, free, bytes);
  free (bytes);
  return NULL;
}

static gboolean
write_file (PictureTask *task, PictureFile *file, GError **error)
{
  gsize length;
  gconstpointer data;

  task->picture.scale = file->scale;
  file->bytes = draw (&task->picture, file->format);
  if (file->bytes == NULL) {
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE,
                 _ ("%s: the picture could not be drawn"),
                 file->path != NULL ? file->path : task->title);
    return FALSE;
  }
  if (file->path == NULL || kept_panes_are_given_up (task->panes))
    return TRUE;
  data = g_bytes_get_data (file->bytes, &length);
  return document_write (file->path, data, length, error);
}

static void
work (GTask *job, gpointer source, gpointer data, GCancellable *cancellable)
{
  PictureTask *task = data;
  GError *error = NULL;

  (void)source;
  (void)cancellable;
  for (guint i = 0; i < task->n_files; i++)
    if (!kept_panes_are_given_up (task->panes)
        && !write_file (task, &task->files[i], &error)) {
      g_task_return_error (job, error);
      return;
    }
  g_task_return_boolean (job, TRUE);
}

static void
end (PictureTask *task)
{
  if (task->is_over)
    return;
  task->is_over = TRUE;
  session_end_chore (task->session, task->chore);
  task->destroy (task->user);
}

/* The session is let go of here: by the task, it might be in the thread. */
static void
on_worked (GObject *source, GAsyncResult *result, gpointer user)
{
  g_autoptr (Session) session = user;
  PictureTask *task = g_task_get_task_data (G_TASK (result));
  g_autoptr (GError) error = NULL;

  (void)source;
  (void)session;
  g_task_propagate_boolean (G_TASK (result), &error);
  if (!task->is_over)
    task->done (task->files, error, task->user);
  end (task);
}

void
picture_task_give_up (PictureTask *task)
{
  kept_panes_give_up (task->panes);
  end (task);
}

static void
give_up (gpointer user)
{
  picture_task_give_up (user);
}

static PictureTask *
picture_task_new (Session *session, const Picture *picture)
{
  const Lesson *lesson = session_get_lesson (session);
  PictureTask *task = g_new0 (PictureTask, 1);

  task->session = session;
  task->picture = *picture;
  task->theme = *picture->theme;
  task->panes = session_picture_keep (&task->picture, session);
  task->title = g_strdup (lesson != NULL ? lesson->title : "Hull2VD");
  task->description = session_narrate (session);
  task->picture.theme = &task->theme;
  task->picture.title = task->title;
  task->picture.description = task->description;
  return task;
}

PictureTask *
picture_task_begin (Session *session,
                    const Picture *picture,
                    const PictureFile *files,
                    guint n_files,
                    PictureTaskDone done,
                    gpointer user,
                    GDestroyNotify destroy)
{
  PictureTask *task = picture_task_new (session, picture);
  g_autoptr (GTask) job
      = g_task_new (NULL, NULL, on_worked, g_object_ref (session));

  for (guint i = 0; i < n_files; i++) {
    task->files[i] = files[i];
    task->files[i].path = g_strdup (files[i].path);
  }
  task->n_files = n_files;
  task->done = done;
  task->user = user;
  task->destroy = destroy;
  task->chore = session_begin_chore (
      session, _ ("The picture for other programs is being drawn"), give_up,
      task);
  g_task_set_task_data (job, task, picture_task_free);
  g_task_run_in_thread (job, work);
  return task;
}
