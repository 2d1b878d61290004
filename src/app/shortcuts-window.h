/* The keys of the window, from the registry. */
#ifndef SHORTCUTS_WINDOW_H
#define SHORTCUTS_WINDOW_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

void shortcuts_window_show (GtkWindow *parent);

G_END_DECLS

#endif
