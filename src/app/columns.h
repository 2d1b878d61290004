/* Columns: a box whose last child gives way when there is no room for it. It
 * asks for no more width than it needs when folded, so that the window can
 * become as narrow as that. */
#ifndef COLUMNS_H
#define COLUMNS_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define COLUMNS_TYPE (columns_get_type ())
G_DECLARE_FINAL_TYPE (Columns, columns, HULL2VD, COLUMNS, GtkBox)

/* Widths below this ask for folding: both pictures, the lesson, and the last
 * column would no longer fit side by side. */
#define COLUMNS_FOLD_PX 1320

/* "fold" (gboolean is_folded) says when the fold should change. The owner of
 * the last child then hides or shows it. */
gboolean columns_is_folded (Columns *columns);

/* Folds at once, before any size is given. */
void columns_fold (Columns *columns);
void columns_set_folding (Columns *columns, GtkWidget *child);

G_END_DECLS

#endif
