/* Lessons: CommonMark with commands in fenced blocks. lessons/README.md is
 * the reference of the language.
 *
 * A lesson is read whole before anything is done; a fault is reported as
 * FILE:LINE:COL: reason and nothing of it takes effect.
 */
#ifndef LESSON_H
#define LESSON_H

#include "question.h"

#include <gio/gio.h>

G_BEGIN_DECLS

#define LESSON_FORMAT 1 /* the newest that this program knows */

/* Limits. What goes beyond is refused with its line. */
#define LESSON_MAX_BYTES (4 << 20)
#define LESSON_MAX_LINE (64 << 10)
#define LESSON_MAX_COMMANDS 100000
#define LESSON_MAX_STOPS 1000
#define LESSON_MAX_SITES 20000 /* of all the sets it makes, together */

/* Which of the two pictures are shown. */
typedef enum Views {
  VIEWS_BOTH,
  VIEWS_PLANE,
  VIEWS_SPACE,
} Views;

#define N_VIEWS (VIEWS_SPACE + 1)

const char *views_name (Views views); /* "both", "plane", "space" */
gboolean views_parse (const char *name, Views *views);

/* What students do in a lesson. Source: Naps et al. 2002. */
typedef enum Level {
  LEVEL_VIEWING,
  LEVEL_RESPONDING,
  LEVEL_CHANGING,
  LEVEL_CONSTRUCTING,
  LEVEL_PRESENTING,
} Level;

#define N_LEVELS (LEVEL_PRESENTING + 1)

const char *level_name (Level level); /* "viewing" … */

/* What a session is at a stop: sites, step, look. Opaque; see stop-state.h. */
typedef struct StopState StopState;

/* One line of a steps block: a verb of the action registry, or expect. */
typedef struct LessonCommand {
  guint line;          /* in the file, from 1 */
  guint column;        /* of its first character, from 1 */
  char *text;          /* the line, trimmed */
  char *verb;          /* name of the action, or "expect" */
  GVariant *parameter; /* NULL: none; of expect: the rest of the line */
} LessonCommand;

typedef struct LessonStop {
  guint line;
  char *title;         /* plain text of the heading */
  char *prose;         /* CommonMark of what the student reads */
  char *note;          /* CommonMark of the lecturer's notes, or NULL */
  GPtrArray *commands; /* of LessonCommand */
  guint step;          /* where its commands lead */
  StopState *state;
  Question *question;   /* NULL: none is asked */
  guint n_setup;        /* commands that come before the question */
  Occasion occasion;    /* of the question, in the run of ask_state */
  StopState *ask_state; /* while the question is open; NULL: none */
} LessonStop;

typedef struct Lesson {
  int reference_count;
  char *path; /* as it was opened, for messages */
  char *title;
  char *prose; /* between title and first stop, CommonMark */
  char *note;  /* lecturer's notes before the first stop, or NULL */
  Site *sites; /* at its start */
  guint n_sites;
  char *site_file;  /* where they come from, or NULL: no file */
  char *author;     /* a name, or NULL: not said */
  Views views;      /* to begin with */
  int step_size;    /* a StepSize, to begin with; -1: as it is */
  int theme;        /* a ThemeKind, to begin with; -1: as it is */
  guint levels;     /* bits 1 << Level */
  guint minutes;    /* that it takes; 0: not said */
  GPtrArray *stops; /* of LessonStop, at least one */
  StopState *start; /* before the first stop's commands */
} Lesson;

#define LESSON_ERROR (lesson_error_quark ())
GQuark lesson_error_quark (void);
typedef enum LessonError {
  LESSON_ERROR_CANNOT_OPEN,
  LESSON_ERROR_BROKEN, /* the message is FILE:LINE:COL: reason */
  LESSON_ERROR_SITES,  /* a sites file was refused: its FILE:LINE: reason */
} LessonError;

/* Sets @error to LESSON_ERROR_BROKEN, the reason alone.
 *
 * Returns: FALSE. */
gboolean lesson_refuse (GError **error, const char *format, ...)
    G_GNUC_PRINTF (2, 3);

/* Reads a file, or "-", up to one byte more than a lesson may have.
 *
 * Returns: (transfer full): its bytes, or NULL with @error set. */
char *lesson_read (const char *path, gsize *length, GError **error);

/* Reads and checks a lesson, from a file or from "-", whose files of sites are
 * sought from the current folder; positions are checked by playing it once.
 *
 * Returns: (transfer full): the lesson, or NULL with @error set. */
Lesson *lesson_load (const char *path, GError **error);

/* Both halves of that: reading, which is quick and finds most of what can be
 * wrong; and playing, which takes long with many sites, and may be another
 * thread's. A lesson that is not played yet has no states.
 *
 * Returns: (transfer full): the lesson, or NULL with @error set. */
Lesson *lesson_load_unplayed (const char *path, GError **error);

/* Plays such a lesson once; when that goes wrong it is of no use.
 *
 * Returns: FALSE with @error set. */
gboolean lesson_play (Lesson *lesson, GError **error);

Lesson *
lesson_parse (const char *text, gsize length, const char *path, GError **error);
Lesson *lesson_parse_unplayed (const char *text,
                               gsize length,
                               const char *path,
                               GError **error);

/* The same, but tells all that is wrong, not only the first of it.
 *
 * Returns: (transfer full): the lesson; NULL when there are faults. */
Lesson *lesson_load_all (const char *path, LessonFaults *faults);
Lesson *lesson_parse_all (const char *text,
                          gsize length,
                          const char *path,
                          LessonFaults *faults);
Lesson *lesson_ref (Lesson *lesson);
void lesson_unref (Lesson *lesson);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Lesson, lesson_unref)

/* Returns: stop @index. */
const LessonStop *lesson_stop (const Lesson *lesson, guint index);

G_END_DECLS

#endif
