/* Where the program's own files are: beside the sources while it runs from
 * its build folder, else where it was installed. */
#ifndef LOCATE_H
#define LOCATE_H

#include <glib.h>

G_BEGIN_DECLS

/* Returns: (transfer full): the folder of the lessons: $HULL2VD_LESSONS,
 *          else lessons/ of the source tree when the running program lies in
 *          its build folder, else DATADIR/hull2vd/lessons. */
char *locate_lessons (void);

/* Returns: (transfer full) (element-type filename): the paths of the lessons
 *          there, by number. */
GPtrArray *locate_lesson_files (void);

/* Binds the translations of interface and lessons: those in $HULL2VD_LOCALE,
 * else those of the build folder, else those in LOCALEDIR. Call once, after
 * setlocale(). */
void locate_translations (void);

G_END_DECLS

#endif
