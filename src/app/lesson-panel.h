/* What the student reads at the current stop; without a lesson, what can be
 * done. */
#ifndef LESSON_PANEL_H
#define LESSON_PANEL_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define LESSON_PANEL_TYPE (lesson_panel_get_type ())
G_DECLARE_FINAL_TYPE (
    LessonPanel, lesson_panel, HULL2VD, LESSON_PANEL, GtkScrolledWindow)

void lesson_panel_set_session (LessonPanel *panel, Session *session);

G_END_DECLS

#endif
