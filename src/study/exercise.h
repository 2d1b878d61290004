/* An exercise: one person at one question, from the first click to the
 * answer. */
#ifndef EXERCISE_H
#define EXERCISE_H

#include "attempt.h"

G_BEGIN_DECLS

typedef struct Performance Performance; /* performance.h */

typedef struct Exercise {
  Question *question;
  Run *run; /* where it is asked */
  Occasion occasion;
  Attempt *attempt;
  GPtrArray *undo; /* of Attempt: those before, the last one last */
  guint n_hints;   /* shown so far */
  guint n_checks;
  gboolean is_open;  /* the answer is not shown yet */
  gboolean is_shown; /* it was shown, not found */
  Verdict *verdict;  /* of the last check; NULL: none yet, or changed since */
  Performance *performance;   /* QUESTION_PERFORM: its tasks; else NULL */
  guint n_undone;             /* steps taken back */
  gboolean was_right_at_once; /* the first check found nothing wrong */
} Exercise;

Exercise *exercise_new (Question *question, Run *run, const Occasion *occasion);
void exercise_free (Exercise *exercise);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Exercise, exercise_free)

/* Each returns: FALSE: nothing changed, for it is closed or means nothing. */
gboolean exercise_toggle (Exercise *exercise, Object object);
gboolean exercise_set_number (Exercise *exercise, guint index, gint64 number);
gboolean exercise_undo (Exercise *exercise);
gboolean exercise_hint (Exercise *exercise);

/* The sites as they are now, of a drag. */
void exercise_set_run (Exercise *exercise, Run *run);

/* Whether what was dragged so far is right as it is. */
gboolean exercise_holds_now (const Exercise *exercise);

/* Grades what there is; right, or with no retry left, the answer is shown. */
gboolean exercise_check (Exercise *exercise);

/* Shows the answer without a check. */
void exercise_reveal (Exercise *exercise);

/* Closes QUESTION_PERFORM with the score of its tasks, once these are over. */
void exercise_finish (Exercise *exercise);

/* Begins anew: the score of the first time stays. */
void exercise_retry (Exercise *exercise);

G_END_DECLS

#endif
