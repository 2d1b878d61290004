/* The end of a lesson: how its questions were answered, with a way back to
 * each, and what comes next. */
#ifndef LESSON_SUMMARY_H
#define LESSON_SUMMARY_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define LESSON_SUMMARY_TYPE (lesson_summary_get_type ())
G_DECLARE_FINAL_TYPE (
    LessonSummary, lesson_summary, HULL2VD, LESSON_SUMMARY, GtkBox)

/* Shows itself at the last stop, once nothing is asked there. */
void lesson_summary_set_session (LessonSummary *summary, Session *session);

/* Gives the keyboard to the button of the next lesson, and scrolls to it.
 *
 * Returns: whether it is there. */
gboolean lesson_summary_show_next (LessonSummary *summary);

G_END_DECLS

#endif
