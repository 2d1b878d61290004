/* What can be undone and redone: the sites before and after each edit, by
 * name. Traces are not kept; they are made anew. */
#ifndef HISTORY_H
#define HISTORY_H

#include "site.h"

#include <glib.h>

G_BEGIN_DECLS

#define HISTORY_MAX 200 /* edits; the oldest are forgotten */

typedef struct History History;

/* The sites on one side of an edit; coordinates as given. */
typedef struct Snapshot {
  GBytes *sites;        /* one Site after the other, shared with the run */
  GBytes *hues;         /* of their cells: guint32 */
  gboolean is_replaced; /* there are quite others on the other side */
} Snapshot;

History *history_new (void);
void history_free (History *history);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (History, history_free)

/* Remembers an edit; what had been undone can no longer be redone.
 *
 * Owns: takes what @before and @after hold, and @edit: the edit as a noun,
 *       translated: "move of s3". */
void
history_push (History *history, Snapshot before, Snapshot after, char *edit);

/* Makes @after what the last edit led to, as a drag goes on.
 *
 * Owns: takes what @after holds. */
void history_amend (History *history, Snapshot after);

/* Forgets the last edit, which has been taken back. */
void history_drop (History *history);

/* Says of the last edit that it replaced all sites. */
void history_mark_replaced (History *history);

/* Steps back (forward) and returns: the sites to show, borrowed, or NULL
 * when there is nothing to undo (redo). */
const Snapshot *history_undo (History *history);
const Snapshot *history_redo (History *history);

/* Returns: "Undo move of s3", translated, or NULL. */
const char *history_undo_label (const History *history);
const char *history_redo_label (const History *history);

G_END_DECLS

#endif
