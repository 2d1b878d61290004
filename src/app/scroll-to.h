/* Scrolls to a widget. */
#ifndef SCROLL_TO_H
#define SCROLL_TO_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Brings @widget and @margin px above and below it into the view that it
 * scrolls in, once all have their sizes; as little as is needed. */
void scroll_to (GtkWidget *widget, int margin);

/* The same for @line of a list. The first of its lines that is in view is seen
 * whole, where there is as much to scroll. */
void scroll_to_line (GtkWidget *line, int margin);

G_END_DECLS

#endif
