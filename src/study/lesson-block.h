/* The lines inside the fenced blocks of a lesson. */
#ifndef LESSON_BLOCK_H
#define LESSON_BLOCK_H

#include "lesson-source.h"
#include "lesson.h"

G_BEGIN_DECLS

/* Reads a lesson block: format and sites, each once. Files of sites are
 * looked for below @folder alone. What is wrong is told to @faults. */
void lesson_block_read_head (const LessonSource *source,
                             const LessonLines *lines,
                             const char *folder,
                             Lesson *lesson,
                             LessonFaults *faults);

/* Reads a steps block: adds a LessonCommand to @commands for each line, and
 * to *@n_commands, those of the whole lesson. */
void lesson_block_read_steps (const LessonSource *source,
                              const LessonLines *lines,
                              guint *n_commands,
                              GPtrArray *commands,
                              LessonFaults *faults);

void lesson_command_free (gpointer command);

/* Reads a file of sites that lies, links followed, below @folder.
 *
 * Returns: FALSE with @error set: LESSON_ERROR_SITES with the FILE:LINE:
 *          reason of the file, or LESSON_ERROR_CANNOT_OPEN with the reason
 *          alone. */
gboolean lesson_read_site_file (const char *folder,
                                const char *name,
                                Lesson *lesson,
                                GError **error);

G_END_DECLS

#endif
