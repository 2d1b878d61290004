/* What the student reads at the current stop; without a lesson, what can be
 * done. The question of the stop stands below it. */
#ifndef LESSON_PANEL_H
#define LESSON_PANEL_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define LESSON_PANEL_TYPE (lesson_panel_get_type ())
G_DECLARE_FINAL_TYPE (LessonPanel, lesson_panel, HULL2VD, LESSON_PANEL, GtkBox)

void lesson_panel_set_session (LessonPanel *panel, Session *session);

/* Which button of the mouse adds sites, as the panel says without a lesson:
 * the left one at first. It has a session. */
void lesson_panel_set_right_button_adds (LessonPanel *panel, gboolean adds);

/* Tells what is wrong with the lesson's file, in place; NULL or none: nothing
 * is. */
void lesson_panel_set_faults (LessonPanel *panel, const LessonFaults *faults);

/* At the end of a lesson there is nothing to go on to but the next one: gives
 * the keyboard to its button.
 *
 * Returns: whether it is there. */
gboolean lesson_panel_show_next_lesson (LessonPanel *panel);

G_END_DECLS

#endif
