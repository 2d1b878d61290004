/* Time, formulas and code run from left to right in every language. */
#ifndef DIRECTION_H
#define DIRECTION_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Keeps a widget and all that is in it from being mirrored. */
void direction_keep (GtkWidget *widget);

G_END_DECLS

#endif
