/* A side column: two children, of which the lower one takes what the upper one
 * leaves, as far as it needs it, and in any case a share of the height. What is
 * to be read comes first, what is to be looked up gives way so far. */
#ifndef SIDE_COLUMN_H
#define SIDE_COLUMN_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define SIDE_COLUMN_TYPE (side_column_get_type ())
G_DECLARE_FINAL_TYPE (
    SideColumn, side_column, HULL2VD, SIDE_COLUMN, GtkContainer)

/* The least of the height that the lower child has: a part of 1. */
void side_column_set_share (SideColumn *column, double share);

G_END_DECLS

#endif
