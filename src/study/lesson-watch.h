/* Watches the files of the open lesson, its own and that of its sites: when
 * one is saved, the lesson is read again.
 *
 * Whatever becomes of the files, the lesson that is open runs on until a good
 * one takes its place: removed, cut off, half written, or something else than
 * a file in their place.
 */
#ifndef LESSON_WATCH_H
#define LESSON_WATCH_H

#include "session.h"

G_BEGIN_DECLS

typedef struct LessonWatch LessonWatch;

/* All that is wrong with the files; NULL, or none: nothing is. */
typedef void (*LessonWatchTell) (const LessonFaults *faults, gpointer user);

/* A lesson that is good takes the place of the one that is open, at the same
 * stop; of one that is broken @tell is told. One that is as it was is left
 * alone, with what a person has answered so far.
 *
 * Owns: neither; both must outlive it. */
LessonWatch *
lesson_watch_new (Session *session, LessonWatchTell tell, gpointer user);
void lesson_watch_free (LessonWatch *watch);

/* Watches the lesson of the session, which is the file @path; NULL:
 * nothing. */
void lesson_watch_set_path (LessonWatch *watch, const char *path);

G_END_DECLS

#endif
