/* The text of a lesson, checked byte by byte before anything reads it, and
 * the place of every fault in it. */
#ifndef LESSON_SOURCE_H
#define LESSON_SOURCE_H

#include <glib.h>

G_BEGIN_DECLS

typedef struct LessonSource {
  char *name;    /* for messages */
  char *text;    /* UTF-8, lines end in LF, no byte order mark */
  GArray *lines; /* gsize: where each line begins */
} LessonSource;

/* Refuses what is too large, not UTF-8, holds control or invisible
 * characters, or is nested so deeply that reading it would take for ever.
 *
 * Errors: LESSON_ERROR_BROKEN. */
LessonSource *lesson_source_new (const char *text,
                                 gsize length,
                                 const char *path,
                                 GError **error);
void lesson_source_free (LessonSource *source);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (LessonSource, lesson_source_free)

guint lesson_source_n_lines (const LessonSource *source);

/* Returns: line @line, from 1, not ended by a zero byte; sets *@length,
 *          without the line end. */
const char *
lesson_source_line (const LessonSource *source, guint line, gsize *length);

/* Returns: the bytes in lines @first … @last. */
gsize lesson_source_bytes (const LessonSource *source, guint first, guint last);

/* Sets @error to FILE:LINE:COL: reason.
 *
 * Returns: FALSE. */
gboolean lesson_source_blame (const LessonSource *source,
                              guint line,
                              guint column,
                              GError **error,
                              const char *format,
                              ...) G_GNUC_PRINTF (5, 6);

/* One line of a block, without the blanks around it. */
typedef struct LessonLine {
  guint line, column; /* in the file, from 1 */
  char *text;         /* "" for empty lines and those that begin with # */
} LessonLine;

/* Lines @first … @last of the file; last < first: none. */
typedef struct LessonLines {
  guint first, last;
} LessonLines;

void
lesson_line_init (LessonLine *line, const LessonSource *source, guint number);
void lesson_line_clear (LessonLine *line);

/* Sets @error to FILE:LINE:COL: @reason, COL that of @at in the line's text.
 *
 * Returns: FALSE. */
gboolean lesson_line_blame (const LessonLine *line,
                            const LessonSource *source,
                            const char *at,
                            const char *reason,
                            GError **error);

/* All that is wrong with a lesson, in the order in which it was found. */
#define LESSON_MAX_FAULTS 100

typedef struct LessonFaults {
  GPtrArray *errors;  /* of GError */
  GArray *html_lines; /* of guint: where HTML is left out */
  char *site_file;    /* that the lesson names, or NULL: none */
} LessonFaults;

LessonFaults *lesson_faults_new (void);
void lesson_faults_free (LessonFaults *faults);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (LessonFaults, lesson_faults_free)

/* Takes @error. */
void lesson_faults_take (LessonFaults *faults, GError *error);

/* Returns: whether there are so many that the rest is not read. */
gboolean lesson_faults_is_full (const LessonFaults *faults);

/* Returns: (transfer full): @path for messages: UTF-8 without control
 *          characters. */
char *display_path (const char *path);

G_END_DECLS

#endif
