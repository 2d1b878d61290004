/* Rows in a view that scrolls: one that an edge of the view cuts through is
 * not painted, for half a line of text cannot be read. It is there all the
 * same, for pointers and for readers of the screen. The scrolled window has the
 * class "whole-rows" while they are seen. */
#ifndef WHOLE_ROWS_H
#define WHOLE_ROWS_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Of @rows, whose children are the rows. It may be moved to another view. */
void whole_rows_keep (GtkContainer *rows);

G_END_DECLS

#endif
