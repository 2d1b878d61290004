/* The keys of the window, from the registry. */
#ifndef SHORTCUTS_WINDOW_H
#define SHORTCUTS_WINDOW_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

void shortcuts_window_show (GtkWindow *parent);

/* Keys have changed: the next time it is made anew. */
void shortcuts_window_forget (GtkWindow *parent);

G_END_DECLS

#endif
