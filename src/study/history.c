#include "history.h"

#include <glib/gi18n.h>

typedef struct Edit {
  Snapshot before, after;
  char *undo_label, *redo_label;
} Edit;

struct History {
  GPtrArray *edits; /* of Edit, oldest first */
  guint n_done;     /* edits[n_done] would be redone next */
};

static void
snapshot_clear (Snapshot *snapshot)
{
  g_bytes_unref (snapshot->sites);
  g_bytes_unref (snapshot->hues);
}

static void
edit_free (gpointer data)
{
  Edit *edit = data;

  snapshot_clear (&edit->before);
  snapshot_clear (&edit->after);
  g_free (edit->undo_label);
  g_free (edit->redo_label);
  g_free (edit);
}

History *
history_new (void)
{
  History *history = g_new0 (History, 1);

  history->edits = g_ptr_array_new_with_free_func (edit_free);
  return history;
}

void
history_free (History *history)
{
  g_ptr_array_unref (history->edits);
  g_free (history);
}

void
history_push (History *history, Snapshot before, Snapshot after, char *noun)
{
  Edit *edit = g_new0 (Edit, 1);

  edit->before = before;
  edit->after = after;
  /* Translators: %s is an edit, as "move of s3". */
  edit->undo_label = g_strdup_printf (_ ("Undo %s"), noun);
  /* Translators: %s is an edit, as "move of s3". */
  edit->redo_label = g_strdup_printf (_ ("Redo %s"), noun);
  g_free (noun);

  g_ptr_array_set_size (history->edits, (gint)history->n_done);
  g_ptr_array_add (history->edits, edit);
  if (history->edits->len > HISTORY_MAX)
    g_ptr_array_remove_index (history->edits, 0);
  history->n_done = history->edits->len;
}

void
history_amend (History *history, Snapshot after)
{
  Edit *edit;

  g_assert (history->n_done > 0 && history->n_done == history->edits->len);
  edit = g_ptr_array_index (history->edits, history->n_done - 1);
  snapshot_clear (&edit->after);
  edit->after = after;
}

void
history_drop (History *history)
{
  g_assert (history->n_done > 0 && history->n_done == history->edits->len);
  history->n_done -= 1;
  g_ptr_array_set_size (history->edits, (int)history->n_done);
}

void
history_mark_replaced (History *history)
{
  Edit *edit;

  g_assert (history->n_done > 0);
  edit = g_ptr_array_index (history->edits, history->n_done - 1);
  edit->before.is_replaced = edit->after.is_replaced = TRUE;
}

/* Returns: the edit that would be undone, or NULL. */
static const Edit *
last_done (const History *history)
{
  return history->n_done == 0
             ? NULL
             : g_ptr_array_index (history->edits, history->n_done - 1);
}

static const Edit *
first_undone (const History *history)
{
  return history->n_done == history->edits->len
             ? NULL
             : g_ptr_array_index (history->edits, history->n_done);
}

const Snapshot *
history_undo (History *history)
{
  const Edit *edit = last_done (history);

  if (edit == NULL)
    return NULL;
  history->n_done -= 1;
  return &edit->before;
}

const Snapshot *
history_redo (History *history)
{
  const Edit *edit = first_undone (history);

  if (edit == NULL)
    return NULL;
  history->n_done += 1;
  return &edit->after;
}

const char *
history_undo_label (const History *history)
{
  const Edit *edit = last_done (history);

  return edit == NULL ? NULL : edit->undo_label;
}

const char *
history_redo_label (const History *history)
{
  const Edit *edit = first_undone (history);

  return edit == NULL ? NULL : edit->redo_label;
}
