/* A side column: a box whose last child takes what its first leaves, as far as
 * it needs it, and never less than its least. What is to be read comes first,
 * what is to be looked up gives way. */
#ifndef SIDE_COLUMN_H
#define SIDE_COLUMN_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define SIDE_COLUMN_TYPE (side_column_get_type ())
G_DECLARE_FINAL_TYPE (SideColumn, side_column, HULL2VD, SIDE_COLUMN, GtkBox)

G_END_DECLS

#endif
