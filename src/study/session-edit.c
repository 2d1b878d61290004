#include "session-private.h"

#include <glib/gi18n.h>
#include <string.h>

gboolean
session_can_edit (Session *session, GError **error)
{
  if (session->is_replaying || !session_is_asking (session)
      || session_get_performance (session) != NULL)
    return TRUE;
  g_set_error (error, SESSION_ERROR, SESSION_ERROR_ASKED,
               _ ("the question is about the sites as they are: answer it, or "
                  "go on, before you change them"));
  return FALSE;
}

/* Returns: (transfer full): the run that an edit leads to; the
 *          lesson's own when they are the sites of its stop, so that its steps
 *          are valid again. NULL with @error set, or without when a thread
 *          makes it: then session->is_deferred. */
static Run *
make_run (Session *session, const Edit *edit, GError **error)
{
  Run *run = session_take_ready (session, edit);

  session->is_deferred = FALSE;
  if (run != NULL)
    return run;
  if (session->is_replaying)
    session->n_sites_made += edit->n_sites;
  else if (session->lesson != NULL) {
    run = lesson_stop (session->lesson, session->stop)->state->run;
    if (run_is_of (run, edit->sites, edit->n_sites, &edit->order))
      return run_ref (run);
  }

  session->is_deferred = session_defer (session, edit);
  if (session->is_deferred)
    return NULL;
  run = run_new (edit->sites, edit->n_sites, &edit->order);
  if (run == NULL)
    g_set_error (
        error, SESSION_ERROR, SESSION_ERROR_RANGE,
        _ ("these coordinates differ too much in size to be compared exactly"));
  return run;
}

static Snapshot
snapshot_of (const Run *run)
{
  return (Snapshot){
    g_bytes_ref (run->given),
    g_bytes_new (run->hues, run->set->n_sites * sizeof *run->hues), FALSE
  };
}

void
session_remember (Session *session, const Run *before, char *edit)
{
  const Snapshot after = snapshot_of (session->run);

  if (session->is_dragging && session->has_dragged) {
    history_amend (session->history, after);
    g_free (edit);
    return;
  }
  history_push (session->history, snapshot_of (before), after, edit);
  session->has_dragged = session->is_dragging;
  session_tell (session, CHANGED_HISTORY);
}

/* Only sites keep their names through an edit; facets are numbered anew. */
static Object
keep_object (Object object, guint n_sites)
{
  if (object.kind == OBJECT_SITE && object.number < n_sites)
    return object;
  return (Object){ OBJECT_NONE, 0 };
}

/* Puts an edited run in place. Takes @run and @edit. */
static void
put_edit (Session *session, Run *run, char *edit)
{
  Run *before = run_ref (session->run);
  const guint step
      = session->is_dragging
            ? run_same_place (session->drag_run, session->drag_step, run)
            : run_same_place (session->run, session->step, run);

  run_inherit_hues (run, before);
  session_hold (session);
  session_put_run (session, run, step);
  if (session->is_replaying)
    g_free (edit);
  else
    session_remember (session, before, edit);
  session_set_hover (session,
                     keep_object (session->look.hover, run->set->n_sites));
  session_trim_selection (session, run->set->n_sites);
  session_release (session);
  run_unref (before);
}

Site *
session_copy_sites (Session *session)
{
  return run_given (session->run);
}

/* A file that takes a lesson's place is not inserted in the lesson's order. */
static Order
order_of (Session *session, EditKind kind)
{
  return kind == EDIT_OPEN && session->lesson != NULL
             ? (Order){ ORDER_FURTHEST, 0 }
             : session->run->trace->order;
}

static Edit
edit_of (Session *session,
         EditKind kind,
         const Site *sites,
         guint n_sites,
         const char *name)
{
  return (Edit){ .kind = kind,
                 .sites = sites,
                 .n_sites = n_sites,
                 .order = order_of (session, kind),
                 .name = name };
}

gboolean
session_edit_sites (Session *session,
                    const Site *sites,
                    guint n_sites,
                    const char *name,
                    GError **error)
{
  const Edit edit = edit_of (session, EDIT_PUT, sites, n_sites, name);
  Run *run;

  if (!session_can_edit (session, error))
    return FALSE;
  run = make_run (session, &edit, error);
  if (run == NULL)
    return session->is_deferred;
  put_edit (session, run, g_strdup (name));
  return TRUE;
}

Order
session_get_order (Session *session)
{
  return session->run->trace->order;
}

void
session_set_order (Session *session, const Order *order)
{
  g_autofree Site *sites = run_given (session->run);
  const guint n_sites = session->run->set->n_sites;
  const Edit edit = {
    .kind = EDIT_ORDER, .sites = sites, .n_sites = n_sites, .order = *order
  };
  Run *run;

  if (run_is_of (session->run, sites, n_sites, order))
    return;
  run = make_run (session, &edit, NULL);
  if (run == NULL)
    return;
  run_inherit_hues (run, session->run);
  session_hold (session);
  session_end_edit (session);
  session_put_run (session, run,
                   run_same_place (session->run, session->step, run));
  session_trim_selection (session, n_sites);
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  session_release (session);
}

/* Takes @run. */
static void
put_sites (Session *session, Run *run, const char *edit)
{
  session_hold (session);
  session_end_edit (session);
  put_edit (session, run, g_strdup (edit));
  if (!session->is_replaying)
    history_mark_replaced (session->history);
  session_put_step (session, session_get_n_steps (session));
  session_set_selection (session, (Object){ OBJECT_NONE, 0 });
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  session_fit (session);
  session_release (session);
}

gboolean
session_put_sites (Session *session,
                   const Site *sites,
                   guint n_sites,
                   const char *name,
                   GError **error)
{
  const Edit edit = edit_of (session, EDIT_REPLACE, sites, n_sites, name);
  Run *run = make_run (session, &edit, error);

  if (run == NULL)
    return session->is_deferred;
  put_sites (session, run, name);
  return TRUE;
}

gboolean
session_replace_sites (Session *session,
                       const Site *sites,
                       guint n_sites,
                       const char *name,
                       GError **error)
{
  return session_can_edit (session, error)
         && session_put_sites (session, sites, n_sites, name, error);
}

gboolean
session_open_sites (Session *session,
                    const Site *sites,
                    guint n_sites,
                    const char *name,
                    GError **error)
{
  const Edit edit = edit_of (session, EDIT_OPEN, sites, n_sites, name);
  Run *run = make_run (session, &edit, error);

  if (run == NULL)
    return session->is_deferred;
  session_hold (session);
  session_set_lesson (session, NULL);
  put_sites (session, run, name);
  session_release (session);
  return TRUE;
}

gboolean
session_set_sites (Session *session,
                   const Site *sites,
                   guint n_sites,
                   GError **error)
{
  return session_replace_sites (session, sites, n_sites,
                                n_sites == 0 ? _ ("deleting all sites")
                                             : _ ("replacing all sites"),
                                error);
}

gboolean
session_add_site (Session *session, Site site, GError **error)
{
  const guint n_sites = session->run->set->n_sites;
  g_autofree Site *sites = run_given (session->run);
  Edit edit = { .kind = EDIT_ADD,
                .n_sites = n_sites + 1,
                .order = session->run->trace->order,
                .to = site };
  Run *run;

  if (!session_can_edit (session, error))
    return FALSE;
  sites = g_renew (Site, sites, n_sites + 1);
  sites[n_sites] = site;
  edit.sites = sites;
  run = make_run (session, &edit, error);
  if (run == NULL)
    return session->is_deferred;
  session_hold (session);
  put_edit (session, run, g_strdup_printf (_ ("adding s%u"), n_sites));
  session_fit_extent (session, FALSE);
  session_release (session);
  return TRUE;
}

static gboolean
has_site (Session *session, guint site, GError **error)
{
  const guint n_sites = session->run->set->n_sites;

  if (site < n_sites)
    return TRUE;
  if (n_sites == 0)
    g_set_error (error, SESSION_ERROR, SESSION_ERROR_SITE,
                 _ ("there is no site s%u: there are no sites at all"), site);
  else
    g_set_error (error, SESSION_ERROR, SESSION_ERROR_SITE,
                 _ ("there is no site s%u: the last is s%u"), site,
                 n_sites - 1);
  return FALSE;
}

gboolean
session_move_site (Session *session, guint site, Site to, GError **error)
{
  g_autofree Site *sites = NULL;
  Edit edit = { .kind = EDIT_MOVE,
                .n_sites = session->run->set->n_sites,
                .order = session->run->trace->order,
                .site = site,
                .to = to };
  Run *run;

  if (!session_can_edit (session, error) || !has_site (session, site, error))
    return FALSE;
  if (session_defer_move (session, &edit))
    return TRUE;
  sites = run_given (session->run);
  if (sites[site].x == to.x && sites[site].y == to.y)
    return TRUE;
  sites[site] = to;
  edit.sites = sites;
  run = make_run (session, &edit, error);
  if (run == NULL)
    return session->is_deferred;
  session_hold (session);
  put_edit (session, run, g_strdup_printf (_ ("moving s%u"), site));
  /* Under a hand the pictures must not move. */
  if (!session->is_dragging)
    session_fit_extent (session, FALSE);
  session_release (session);
  return TRUE;
}

/* The name that @object has once @site is gone. */
static Object
object_without (Object object, guint site)
{
  if (object.kind == OBJECT_SITE && object.number == site)
    return (Object){ OBJECT_NONE, 0 };
  if (object.kind == OBJECT_SITE && object.number > site)
    object.number -= 1;
  return object;
}

gboolean
session_remove_site (Session *session, guint site, GError **error)
{
  g_autofree Site *sites = NULL;
  Edit edit = { .kind = EDIT_REMOVE,
                .order = session->run->trace->order,
                .site = site };
  guint n_sites;
  Run *run;

  if (!session_can_edit (session, error) || !has_site (session, site, error))
    return FALSE;
  n_sites = session->run->set->n_sites - 1;
  sites = run_given (session->run);
  memmove (sites + site, sites + site + 1, (n_sites - site) * sizeof *sites);
  edit.sites = sites;
  edit.n_sites = n_sites;
  run = make_run (session, &edit, error);
  if (run == NULL)
    return session->is_deferred;
  session_hold (session);
  session_set_hover (session, object_without (session->look.hover, site));
  session_forget_site (session, site);
  put_edit (session, run, g_strdup_printf (_ ("deleting s%u"), site));
  session_release (session);
  return TRUE;
}

void
session_begin_edit (Session *session)
{
  session_cancel (session);
  session_end_edit (session);
  session->is_dragging = TRUE;
  session->drag_run = run_ref (session->run);
  session->drag_step = session->step;
}

void
session_end_edit (Session *session)
{
  const gboolean has_dragged = session->has_dragged;

  /* The last place of a drag is still on its way. */
  session->ends_later = session->is_dragging && session->work != NULL;
  if (session->ends_later)
    return;
  session->is_dragging = FALSE;
  session->has_dragged = FALSE;
  g_clear_pointer (&session->drag_run, run_unref);
  if (has_dragged)
    session_question_settle (session);
}

void
session_cancel_edit (Session *session)
{
  const guint step = session->drag_step;
  Run *run;

  if (!session->is_dragging)
    return;
  run = run_ref (session->drag_run);
  session_hold (session);
  if (session->has_dragged)
    history_drop (session->history);
  session_end_edit (session);
  session_put_run (session, run, step);
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  session_trim_selection (session, run->set->n_sites);
  session_fit_extent (session, FALSE);
  session_tell (session, CHANGED_HISTORY);
  session_release (session);
}

/* Shows what the history tells; the place in time is kept. */
static gboolean
show_snapshot (Session *session, const Snapshot *snapshot, EditKind kind)
{
  Edit edit = { .kind = kind, .order = session->run->trace->order };
  gsize length;
  Run *run;

  if (snapshot == NULL)
    return FALSE;
  edit.sites = g_bytes_get_data (snapshot->sites, &length);
  edit.n_sites = (guint)(length / sizeof *edit.sites);
  /* They have been shown before, so their run exists. */
  run = make_run (session, &edit, NULL);
  if (run == NULL) {
    /* It is not done yet. */
    if (kind == EDIT_UNDO)
      history_redo (session->history);
    else
      history_undo (session->history);
    return TRUE;
  }
  if (run->reference_count == 1 && run->set->n_sites > 0)
    memcpy (run->hues, g_bytes_get_data (snapshot->hues, NULL),
            run->set->n_sites * sizeof *run->hues);
  session_hold (session);
  session_put_run (session, run,
                   run_same_place (session->run, session->step, run));
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  session_trim_selection (session, session->run->set->n_sites);
  /* What was looked at before says nothing about quite other sites. */
  if (snapshot->is_replaced)
    session_fit (session);
  else
    session_fit_extent (session, FALSE);
  session_tell (session, CHANGED_HISTORY);
  session_release (session);
  return TRUE;
}

gboolean
session_undo (Session *session)
{
  session_end_edit (session);
  return show_snapshot (session, history_undo (session->history), EDIT_UNDO);
}

gboolean
session_redo (Session *session)
{
  session_end_edit (session);
  return show_snapshot (session, history_redo (session->history), EDIT_REDO);
}

const char *
session_get_undo_label (Session *session)
{
  return history_undo_label (session->history);
}

const char *
session_get_redo_label (Session *session)
{
  return history_redo_label (session->history);
}
