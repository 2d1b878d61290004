#include "chore-task.h"

#include "document.h"
#include "session-chore.h"

struct ChoreTask {
  Session *session; /* of the main loop alone, as the next two */
  guint chore;
  ChoreDone done;
  ChoreWork work;
  gpointer data;
  GDestroyNotify free_data;
  GCancellable *wanted; /* no longer, when it is given up */
};

gboolean
chore_task_is_given_up (ChoreTask *task)
{
  return g_cancellable_is_cancelled (task->wanted);
}

GCancellable *
chore_task_get_cancellable (ChoreTask *task)
{
  return task->wanted;
}

gboolean
chore_task_write (ChoreTask *task,
                  const char *path,
                  const char *bytes,
                  gsize length,
                  GError **error)
{
  static GMutex one_file;
  gboolean is_good;

  /* Who gives up a file to write it anew finds the new one there at last. */
  g_mutex_lock (&one_file);
  is_good = chore_task_is_given_up (task)
            || document_write (path, bytes, length, error);
  g_mutex_unlock (&one_file);
  return is_good;
}

static void
work (GTask *job, gpointer source, gpointer data, GCancellable *cancellable)
{
  ChoreTask *task = data;
  GError *error = NULL;

  (void)source;
  (void)cancellable;
  if (chore_task_is_given_up (task) || task->work (task, task->data, &error))
    g_task_return_boolean (job, TRUE);
  else
    g_task_return_error (job, error);
}

/* All is let go of here: by the job, it might be in the thread. */
static void
on_worked (GObject *source, GAsyncResult *result, gpointer user)
{
  ChoreTask *task = user;
  g_autoptr (GError) error = NULL;

  (void)source;
  g_task_propagate_boolean (G_TASK (result), &error);
  if (!chore_task_is_given_up (task)) {
    session_end_chore (task->session, task->chore);
    task->done (task->data, error);
  }
  task->free_data (task->data);
  g_object_unref (task->wanted);
  g_object_unref (task->session);
  g_free (task);
}

void
chore_task_give_up (ChoreTask *task)
{
  if (chore_task_is_given_up (task))
    return;
  g_cancellable_cancel (task->wanted);
  session_end_chore (task->session, task->chore);
}

static void
give_up (gpointer user)
{
  chore_task_give_up (user);
}

ChoreTask *
chore_task_begin (Session *session,
                  const char *sentence,
                  ChoreWork do_work,
                  ChoreDone done,
                  gpointer data,
                  GDestroyNotify free_data)
{
  ChoreTask *task = g_new0 (ChoreTask, 1);
  g_autoptr (GTask) job = g_task_new (NULL, NULL, on_worked, task);

  task->session = g_object_ref (session);
  task->wanted = g_cancellable_new ();
  task->work = do_work;
  task->done = done;
  task->data = data;
  task->free_data = free_data;
  task->chore = session_begin_chore (session, sentence, give_up, task);
  g_task_set_task_data (job, task, NULL);
  g_task_run_in_thread (job, work);
  return task;
}
