/* The files that were used last, as the desktop remembers them. */
#ifndef WINDOW_RECENT_H
#define WINDOW_RECENT_H

#include <gio/gio.h>

G_BEGIN_DECLS

/* Remembers that @path was opened or saved. */
void window_recent_add (const char *path);

/* Fills @menu anew with what opens them, the latest first. */
void window_recent_fill (GMenu *menu);

G_END_DECLS

#endif
