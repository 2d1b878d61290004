#include "session-work.h"

#include "session-private.h"

#include <math.h>

struct SessionWork {
  Edit edit; /* its sites and name are the following ones */
  Site *own_sites;
  char *own_name;
  RunWatch watch;
  gboolean has_planar; /* the hull in the plane is shown: its record, too */
  gboolean has_other;  /* two runs are compared: the other one, too */
  Order other;
  Run *before;       /* and the step of it that is looked at, */
  guint step;        /* so that the frame can be made, too */
  gboolean has_next; /* a drag that goes on */
  guint next_site;
  Site next_to;
};

/* What the thread hands over. */
typedef struct Made {
  Run *run, *other;
  KeptFrame *frame, *other_frame;
  Exhibit *exhibit;
} Made;

static void
made_free (gpointer data)
{
  Made *made = data;

  g_clear_pointer (&made->frame, kept_frame_unref);
  g_clear_pointer (&made->other_frame, kept_frame_unref);
  g_clear_pointer (&made->run, run_unref);
  g_clear_pointer (&made->other, run_unref);
  exhibit_free (made->exhibit);
  g_free (made);
}

static SessionWork *
work_new (Session *session, const Edit *edit)
{
  SessionWork *work = g_new0 (SessionWork, 1);

  work->edit = *edit;
  work->own_sites
      = g_memdup2 (edit->sites, edit->n_sites * sizeof *edit->sites);
  work->own_name = g_strdup (edit->name);
  work->edit.sites = work->own_sites;
  work->edit.name = work->own_name;
  work->before
      = run_ref (session->is_dragging ? session->drag_run : session->run);
  work->step = session->is_dragging ? session->drag_step : session->step;
  work->has_planar
      = edit->kind == EDIT_PLANAR || session->exhibit_kind == EXHIBIT_PLANAR;
  work->has_other
      = edit->kind == EDIT_COMPARE || session->exhibit_kind == EXHIBIT_COMPARE;
  work->other = edit->kind == EDIT_COMPARE ? edit->other : session->other_order;
  return work;
}

static void
work_free (gpointer data)
{
  SessionWork *work = data;

  g_free (work->own_sites);
  g_free (work->own_name);
  run_unref (work->before);
  g_free (work);
}

/* The step at which the session will most likely look at the run. */
static guint
step_of (const SessionWork *work, const Run *run)
{
  const gboolean is_new
      = work->edit.kind == EDIT_REPLACE || work->edit.kind == EDIT_OPEN;

  return is_new ? run->trace->n_events
                : run_same_place (work->before, work->step, run);
}

/* Returns: (transfer full): NULL: it was given up. */
static Run *
make_run (SessionWork *work, const Order *order)
{
  const Edit *edit = &work->edit;

  if (run_is_of (work->before, edit->sites, edit->n_sites, order))
    return run_ref (work->before);
  return run_new_watched (edit->sites, edit->n_sites, order, &work->watch);
}

static void
make_frames (const SessionWork *work, Made *made)
{
  const guint step = step_of (work, made->run);

  if (work->has_planar)
    made->exhibit = exhibit_new (EXHIBIT_PLANAR, made->run, NULL);
  if (work->edit.kind == EDIT_PLANAR)
    return;
  made->frame = kept_frame_new (made->run->trace, step);
  if (work->has_other)
    made->other_frame
        = kept_frame_new (made->other->trace,
                          session_other_step_of (made->run, step, made->other));
}

static void
make (GTask *task,
      gpointer source,
      gpointer task_data,
      GCancellable *cancellable)
{
  SessionWork *work = task_data;
  Made *made = g_new0 (Made, 1);

  (void)source;
  (void)cancellable;
  made->run = make_run (work, &work->edit.order);
  if (made->run != NULL && work->has_other)
    made->other = make_run (work, &work->other);
  if (made->run == NULL || (work->has_other && made->other == NULL))
    g_clear_pointer (&made, made_free);
  else if (!g_atomic_int_get (&work->watch.is_cancelled))
    make_frames (work, made);
  g_task_return_pointer (task, made, made_free);
}

/* Asks for the edit as if for the first time; its run is there now. */
static void
ask_again (Session *session, const Edit *edit)
{
  switch (edit->kind) {
  case EDIT_REPLACE:
    session_put_sites (session, edit->sites, edit->n_sites, edit->name, NULL);
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
  case EDIT_COMPARE:
    session_compare (session, (const Order[]){ edit->order, edit->other });
    break;
  case EDIT_PLANAR:
    session_set_exhibit_kind (session, EXHIBIT_PLANAR);
    break;
  case EDIT_UNDO:
    session_undo (session);
    break;
  case EDIT_REDO:
    session_redo (session);
    break;
  }
}

/* What the edit leads to is told while what the thread has made is there. */
static void
carry_out (Session *session, SessionWork *work, Made *made)
{
  session_hold (session);
  session->work = NULL;
  session->finished = session->n_works;
  session_tell (session, CHANGED_WORK);
  session->ready = g_steal_pointer (&made->run);
  session->ready_frame = g_steal_pointer (&made->frame);
  session->ready_other = g_steal_pointer (&made->other);
  session->ready_exhibit = g_steal_pointer (&made->exhibit);
  session->ready_other_frame = g_steal_pointer (&made->other_frame);
  ask_again (session, &work->edit);
  session_take_ready_other (session);
  g_clear_pointer (&session->ready, run_unref);
  if (work->has_next)
    session_move_site (session, work->next_site, work->next_to, NULL);
  if (session->ends_later && session->work == NULL)
    session_end_edit (session);
  session_release (session);
  g_clear_pointer (&session->ready_frame, kept_frame_unref);
  g_clear_pointer (&session->ready_other_frame, kept_frame_unref);
  g_clear_pointer (&session->ready_other, run_unref);
  g_clear_pointer (&session->ready_exhibit, exhibit_free);
}

/* The session is let go of here: by the task, it might be in the thread. */
static void
on_made (GObject *source, GAsyncResult *result, gpointer user)
{
  g_autoptr (Session) session = user;
  SessionWork *work = g_task_get_task_data (G_TASK (result));
  Made *made = g_task_propagate_pointer (G_TASK (result), NULL);

  (void)source;
  if (made == NULL)
    return;
  if (session->work == work)
    carry_out (session, work, made);
  made_free (made);
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
  SiteRange range = SITE_RANGE_INIT;

  for (guint i = 0; i < edit->n_sites; i++)
    if (!isfinite (edit->sites[i].x) || !isfinite (edit->sites[i].y)
        || !site_range_add (&range, &edit->sites[i]))
      return FALSE;
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
  session->work = work_new (session, edit);
  session->n_works += 1;
  task = g_task_new (NULL, NULL, on_made, g_object_ref (session));
  g_task_set_task_data (task, session->work, work_free);
  g_task_run_in_thread (task, make);
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

/* Circles are long lines, and what is selected is drawn over all else: of
 * these, fewer sites take as long. */
#define HEAVY_AT_ONCE 250

gboolean
session_is_large (Session *session, gboolean is_heavy)
{
  const SceneLook *look = &session->look;

  is_heavy = is_heavy || (look->layers & LAYER_CIRCLES) != 0
             || look->n_selected > HEAVY_AT_ONCE;
  return session->is_patient
         && session_get_set (session)->n_sites
                > (is_heavy ? HEAVY_AT_ONCE : SESSION_AT_ONCE);
}

gboolean
session_is_working (Session *session, double *part)
{
  SessionWork *work = session->work;

  if (work == NULL)
    return FALSE;
  if (part != NULL)
    *part = (double)g_atomic_int_get (&work->watch.n_done) / work->edit.n_sites
            / (work->has_other ? 2 : 1);
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
