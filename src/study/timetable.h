/* Timetables: the minutes of a lesson shared out among its stops, twice as
 * much to a stop that asks as to another. */
#ifndef TIMETABLE_H
#define TIMETABLE_H

#include "lesson.h"

G_BEGIN_DECLS

/* @stop: from 0; one more than there are for the end of the lesson.
 *
 * Returns: when it begins, in seconds, a multiple of 15; 0 when the lesson does
 *          not say how long it takes. */
guint timetable_begin (const Lesson *lesson, guint stop);

/* Returns: (transfer full): "3:15 – 4:00", or "" when the lesson does not say
 *          how long it takes. */
char *timetable_text (const Lesson *lesson, guint stop);

G_END_DECLS

#endif
