/* Watches the file of the open lesson: when it is saved, it is read again. */
#ifndef LESSON_WATCH_H
#define LESSON_WATCH_H

#include "lesson-panel.h"
#include "session.h"

G_BEGIN_DECLS

typedef struct LessonWatch LessonWatch;

/* A lesson that is good takes the place of the one that is open, at the same
 * stop; of one that is broken @panel tells all that is wrong, and the last
 * good one runs on.
 *
 * Owns: neither; both must outlive it. */
LessonWatch *lesson_watch_new (Session *session, LessonPanel *panel);
void lesson_watch_free (LessonWatch *watch);

/* Watches @path; NULL: nothing. */
void lesson_watch_set_path (LessonWatch *watch, const char *path);

G_END_DECLS

#endif
