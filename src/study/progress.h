/* Progress: what a person has done in lessons, kept from one time to the next
 * in one file of JSON. Nothing of it leaves the computer.
 *
 * A lesson is known by its file, a question by what it asks and of which
 * sites, never by its number: in a lesson that was edited, an answer counts
 * for the question that was asked, and for no other.
 */
#ifndef PROGRESS_H
#define PROGRESS_H

#include "exercise.h"
#include "lesson.h"

#include <json-glib/json-glib.h>

G_BEGIN_DECLS

#define PROGRESS_FORMAT 1 /* the newest that this program knows */
#define PROGRESS_MAX_BYTES (16 << 20)

/* How a question was answered for the first time. */
typedef enum Outcome {
  OUTCOME_OPEN,       /* not yet */
  OUTCOME_AT_ONCE,    /* right at the first check, without a hint */
  OUTCOME_AFTER_HELP, /* right after all */
  OUTCOME_SHOWN,      /* the answer was shown, not found */
} Outcome;

#define N_OUTCOMES (OUTCOME_SHOWN + 1)

const char *outcome_name (Outcome outcome); /* "open", "at-once" … */
gboolean outcome_parse (const char *name, Outcome *outcome);

typedef struct QuestionRecord {
  char *key;   /* question_key() */
  char *title; /* of its stop, as it was last met */
  guint stop;  /* where it was last met, from 0 */
  Outcome outcome;
  guint total, correct; /* at the first check; 0 0: none yet */
  guint n_checks, hinted, undone;
  double seconds;     /* that it was open before the person */
  gint64 answered;    /* Unix time; 0: not yet */
  JsonObject *memory; /* the answer, as exercise_remember() tells; or NULL */
} QuestionRecord;

typedef struct LessonRecord {
  char *key; /* lesson_key() */
  char *title;
  guint stop, furthest, n_stops; /* where the person is, and has been */
  double seconds;
  gint64 first, last;   /* Unix time */
  GPtrArray *questions; /* of QuestionRecord */
  gboolean is_changed;  /* since it was read or written */
} LessonRecord;

typedef struct Progress {
  int reference_count;
  char *path;         /* of its file */
  char *learner;      /* a random name: a person without a name */
  GPtrArray *lessons; /* of LessonRecord, the oldest first */
  gboolean is_changed, is_cleared;
} Progress;

Progress *progress_new (const char *path);
Progress *progress_ref (Progress *progress);
void progress_unref (Progress *progress);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Progress, progress_unref)

/* Returns: (transfer full): where a person's progress is. */
char *progress_default_path (void);

/* Returns: the record, or NULL. */
LessonRecord *progress_find (const Progress *progress, const char *key);

/* The same; makes one where there is none. */
LessonRecord *progress_lesson (Progress *progress, const char *key);
QuestionRecord *lesson_record_find (const LessonRecord *lesson,
                                    const char *key);
QuestionRecord *lesson_record_question (LessonRecord *lesson, const char *key);

/* Returns: how many questions have this outcome. */
guint lesson_record_count (const LessonRecord *lesson, Outcome outcome);

/* Returns: whether the person was at the end, and no question is open. */
gboolean lesson_record_is_done (const LessonRecord *lesson);

/* Takes what @exercise knows by now into @record; the first outcome stays,
 * but for an answer that was shown first and found later.
 *
 * Returns: whether it changed. */
gboolean question_record_take (QuestionRecord *record,
                               const Exercise *exercise);

/* Puts @exercise, which has just begun, where it was left. */
void question_record_restore (const QuestionRecord *record, Exercise *exercise);

/* Returns: (transfer full): names that stay while words and places change:
 *          the file of a lesson, without its folder when it comes with the
 *          program; a digest of what is asked and of which sites. */
char *lesson_key (const Lesson *lesson);
char *question_key (const Question *question, const Run *run);

/* exercise-memory.c: an answer as JSON, and back. What cannot be, of this
 * question, is refused as a whole.
 *
 * Returns: (transfer full): NULL: there is nothing to keep. */
JsonObject *exercise_remember (const Exercise *exercise);
gboolean exercise_recall (Exercise *exercise, JsonObject *memory);

/* performance-memory.c: the tasks that are settled, and back, as far as they
 * fit. */
JsonArray *performance_remember (const Performance *performance);
void performance_recall (Performance *performance, JsonArray *tasks);

/* progress-file.c */

#define PROGRESS_ERROR (progress_error_quark ())
GQuark progress_error_quark (void);
typedef enum ProgressError {
  PROGRESS_ERROR_MISSING, /* there is no file */
  PROGRESS_ERROR_CANNOT_OPEN,
  PROGRESS_ERROR_BROKEN, /* the message is FILE:LINE: reason */
  PROGRESS_ERROR_NEWER,  /* it needs a newer program */
} ProgressError;

/* Reads its file; on failure it is empty. */
gboolean progress_read (Progress *progress, GError **error);

/* The same for a person: no file is no fault, and one that cannot be read is
 * kept under another name, so that nothing is lost.
 *
 * Returns: (transfer full): what to tell, or NULL. */
char *progress_open (Progress *progress);

/* Writes its file, whole or not at all, when something has changed; what other
 * programs have written since stays. */
gboolean progress_write (Progress *progress, GError **error);

/* Forgets all; what was there is kept beside it, with a tilde.
 *
 * Returns: (transfer full): where, or NULL: there was no file. */
char *progress_clear (Progress *progress);

/* progress-merge.c: several programs, one file. */

/* Takes from @theirs, which was read just now, what another program has done
 * since: all of the lessons that did not change here, and each answer in those
 * that did. */
void progress_merge (Progress *progress, Progress *theirs);

/* Others wait while the file in @folder is read and written.
 *
 * Returns: what to hand to progress_unlock(). */
int progress_lock (const char *folder);
void progress_unlock (int lock);

G_END_DECLS

#endif
