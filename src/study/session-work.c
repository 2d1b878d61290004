#include "session-work.h"

#include "session-private.h"

struct SessionWork {
  Edit edit; /* its sites and name are the following ones */
  Site *own_sites;
  char *own_name;
  RunWatch watch;
  gboolean has_next; /* a drag that goes on */
  guint next_site;
  Site next_to;
};

static SessionWork *
work_new (const Edit *edit)
{
  SessionWork *work = g_new0 (SessionWork, 1);

  work->edit = *edit;
  work->own_sites
      = g_memdup2 (edit->sites, edit->n_sites * sizeof *edit->sites);
  work->own_name = g_strdup (edit->name);
  work->edit.sites = work->own_sites;
  work->edit.name = work->own_name;
  return work;
}

static void
work_free (gpointer data)
{
  SessionWork *work = data;

  g_free (work->own_sites);
  g_free (work->own_name);
  g_free (work);
}

static void
make_run (GTask *task,
          gpointer source,
          gpointer task_data,
          GCancellable *cancellable)
{
  SessionWork *work = task_data;
  const Edit *edit = &work->edit;

  (void)source;
  (void)cancellable;
  g_task_return_pointer (
      task,
      run_new_watched (edit->sites, edit->n_sites, &edit->order, &work->watch),
      (GDestroyNotify)run_unref);
}

/* Asks for the edit as if for the first time; its run is there now. */
static void
ask_again (Session *session, const Edit *edit)
{
  switch (edit->kind) {
  case EDIT_REPLACE:
    session_replace_sites (session, edit->sites, edit->n_sites, edit->name,
                           NULL);
    break;
  case EDIT_OPEN:
    session_open_sites (session, edit->sites, edit->n_sites, edit->name, NULL);
    break;
  case EDIT_PUT:
    session_edit_sites (session, edit->sites, edit->n_sites, edit->name, NULL);
    break;
  case EDIT_ADD:
    session_add_site (session, edit->to, NULL);
    break;
  case EDIT_MOVE:
    session_move_site (session, edit->site, edit->to, NULL);
    break;
  case EDIT_REMOVE:
    session_remove_site (session, edit->site, NULL);
    break;
  case EDIT_ORDER:
    session_set_order (session, &edit->order);
    break;
  case EDIT_UNDO:
    session_undo (session);
    break;
  case EDIT_REDO:
    session_redo (session);
    break;
  }
}

static void
on_made (GObject *source, GAsyncResult *result, gpointer user)
{
  Session *session = HULL2VD_SESSION (source);
  SessionWork *work = g_task_get_task_data (G_TASK (result));
  g_autoptr (Run) run = g_task_propagate_pointer (G_TASK (result), NULL);

  (void)user;
  if (session->work != work || run == NULL)
    return;
  session_hold (session);
  session->work = NULL;
  session->finished = session->n_works;
  session_tell (session, CHANGED_WORK);
  session->ready = g_steal_pointer (&run);
  ask_again (session, &work->edit);
  g_clear_pointer (&session->ready, run_unref);
  if (work->has_next)
    session_move_site (session, work->next_site, work->next_to, NULL);
  if (session->ends_later && session->work == NULL)
    session_end_edit (session);
  session_release (session);
}

Run *
session_take_ready (Session *session, const Edit *edit)
{
  Run *run = session->ready;

  if (run == NULL || !run_is_of (run, edit->sites, edit->n_sites, &edit->order))
    return NULL;
  session->ready = NULL;
  return run;
}

/* Whether the sites can be compared at all: who asks is told at once. */
static gboolean
is_in_range (const Edit *edit)
{
  SiteSet *set = site_set_new (edit->sites, edit->n_sites);

  if (set == NULL)
    return FALSE;
  site_set_free (set);
  return TRUE;
}

gboolean
session_defer (Session *session, const Edit *edit)
{
  g_autoptr (GTask) task = NULL;

  if (!session->is_patient || session->is_replaying
      || edit->n_sites <= SESSION_AT_ONCE || !is_in_range (edit))
    return FALSE;
  session_hold (session);
  session_cancel (session);
  session->work = work_new (edit);
  session->n_works += 1;
  task = g_task_new (session, NULL, on_made, NULL);
  g_task_set_task_data (task, session->work, work_free);
  g_task_run_in_thread (task, make_run);
  session_tell (session, CHANGED_WORK);
  session_release (session);
  return TRUE;
}

gboolean
session_defer_move (Session *session, const Edit *edit)
{
  SessionWork *work = session->work;

  if (work == NULL || !session->is_dragging || work->edit.kind != EDIT_MOVE
      || work->edit.site != edit->site)
    return FALSE;
  work->has_next = TRUE;
  work->next_site = edit->site;
  work->next_to = edit->to;
  return TRUE;
}

void
session_set_patient (Session *session, gboolean patient)
{
  session->is_patient = patient;
}

gboolean
session_is_working (Session *session, double *part)
{
  SessionWork *work = session->work;

  if (work == NULL)
    return FALSE;
  if (part != NULL)
    *part = (double)g_atomic_int_get (&work->watch.n_done) / work->edit.n_sites;
  return TRUE;
}

guint
session_get_work (Session *session)
{
  return session->work != NULL ? session->n_works : 0;
}

gboolean
session_has_finished (Session *session, guint work)
{
  return work != 0 && session->finished == work;
}

guint
session_get_n_awaited (Session *session)
{
  return session->work != NULL ? session->work->edit.n_sites : 0;
}

void
session_cancel (Session *session)
{
  if (session->work == NULL)
    return;
  session_hold (session);
  g_atomic_int_set (&session->work->watch.is_cancelled, 1);
  session->work = NULL;
  if (session->ends_later)
    session_end_edit (session);
  session_tell (session, CHANGED_WORK);
  session_release (session);
}
