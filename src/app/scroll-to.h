/* Scrolls to a widget. */
#ifndef SCROLL_TO_H
#define SCROLL_TO_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Brings @widget and @margin px above and below it into the view that it
 * scrolls in, once all have their sizes; as little as is needed. */
void scroll_to (GtkWidget *widget, int margin);

G_END_DECLS

#endif
