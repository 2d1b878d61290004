/* The lecturer's own window: what the class sees, what comes next, notes and
 * the clock. It runs the actions of the main window, which is the class's. */
#ifndef LECTURER_WINDOW_H
#define LECTURER_WINDOW_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define LECTURER_WINDOW_TYPE (lecturer_window_get_type ())
G_DECLARE_FINAL_TYPE (
    LecturerWindow, lecturer_window, HULL2VD, LECTURER_WINDOW, GtkWindow)

/* @parent: whose actions its buttons run. */
LecturerWindow *lecturer_window_new (GtkApplicationWindow *parent,
                                     Session *session);

/* @text: what the class sees instead of what the session shows, or NULL. */
void lecturer_window_set_cover (LecturerWindow *window, const char *text);

/* The clock begins with the first stop that is gone to. */
gboolean lecturer_window_is_running (LecturerWindow *window);
void lecturer_window_set_running (LecturerWindow *window, gboolean is_running);
void lecturer_window_reset_clock (LecturerWindow *window);

G_END_DECLS

#endif
