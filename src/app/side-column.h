/* A side column: two children, of which the lower one takes what the upper one
 * leaves, as far as it needs it, and in any case a third of the height. What is
 * to be read comes first, what is to be looked up gives way so far. */
#ifndef SIDE_COLUMN_H
#define SIDE_COLUMN_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define SIDE_COLUMN_TYPE (side_column_get_type ())
G_DECLARE_FINAL_TYPE (
    SideColumn, side_column, HULL2VD, SIDE_COLUMN, GtkContainer)

G_END_DECLS

#endif
