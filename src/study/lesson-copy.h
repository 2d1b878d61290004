/* Lessons of one's own: a copy of a lesson, to be changed. */
#ifndef LESSON_COPY_H
#define LESSON_COPY_H

#include "lesson.h"

G_BEGIN_DECLS

/* Returns: (transfer full): the folder of a person's own lessons: Hull2VD in
 *          the folder of documents, or at home. */
char *lesson_copy_folder (void);

/* Copies the file of @lesson, and its file of sites, into @folder, which is
 * made when it is not there. What is there already is kept: the copy gets a
 * name that is free.
 *
 * Returns: (transfer full): the path of the copy, or NULL with @error set. */
char *lesson_copy (const Lesson *lesson, const char *folder, GError **error);

G_END_DECLS

#endif
