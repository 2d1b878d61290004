/* Lessons: CommonMark with commands in fenced blocks. lessons/README.md is
 * the reference of the language.
 *
 * A lesson is read whole before anything is done; a fault is reported as
 * FILE:LINE:COL: reason and nothing of it takes effect.
 */
#ifndef LESSON_H
#define LESSON_H

#include "site.h"

#include <gio/gio.h>

G_BEGIN_DECLS

#define LESSON_FORMAT 1

/* One line of a steps block: a verb of the action registry, or expect. */
typedef struct LessonCommand {
  guint line; /* in the file, from 1 */
  char *text; /* the line, trimmed */
  char *verb;
  GVariant *parameter; /* NULL: none */
} LessonCommand;

typedef struct LessonStop {
  guint line;
  char *title;         /* plain text of the heading */
  char *prose;         /* CommonMark of what the student reads */
  char *note;          /* CommonMark of the lecturer's notes, or NULL */
  GPtrArray *commands; /* of LessonCommand */
  guint step;          /* where its commands lead, known once checked */
} LessonStop;

typedef struct Lesson {
  int reference_count;
  char *path; /* as it was opened, for messages */
  char *title;
  char *prose; /* between title and first stop, CommonMark */
  Site *sites;
  guint n_sites;
  GPtrArray *stops; /* of LessonStop */
} Lesson;

#define LESSON_ERROR (lesson_error_quark ())
GQuark lesson_error_quark (void);
typedef enum LessonError {
  LESSON_ERROR_CANNOT_OPEN,
  LESSON_ERROR_BROKEN, /* the message is FILE:LINE:COL: reason */
  LESSON_ERROR_SITES,  /* a sites file was refused */
} LessonError;

/* Reads and checks a lesson; positions are checked by playing it once.
 *
 * Returns: (transfer full): the lesson, or NULL with @error set. */
Lesson *lesson_load (const char *path, GError **error);
Lesson *
lesson_parse (const char *text, gsize length, const char *path, GError **error);
Lesson *lesson_ref (Lesson *lesson);
void lesson_unref (Lesson *lesson);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Lesson, lesson_unref)

G_END_DECLS

#endif
