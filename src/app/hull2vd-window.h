/* The window: one session, its views and panels, and its actions, which are
 * on D-Bus too. */
#ifndef HULL2VD_WINDOW_H
#define HULL2VD_WINDOW_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define HULL2VD_WINDOW_TYPE (hull2vd_window_get_type ())
G_DECLARE_FINAL_TYPE (
    Hull2vdWindow, hull2vd_window, HULL2VD, WINDOW, GtkApplicationWindow)

Hull2vdWindow *hull2vd_window_new (GtkApplication *application);
Session *hull2vd_window_get_session (Hull2vdWindow *window);

/* Says what could not be done, without getting in the way. */
void hull2vd_window_say (Hull2vdWindow *window, const char *message);

G_END_DECLS

#endif
