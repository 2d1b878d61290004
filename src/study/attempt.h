/* Attempts at a question, what is right, and how right an attempt is. */
#ifndef ATTEMPT_H
#define ATTEMPT_H

#include "question.h"

G_BEGIN_DECLS

#define NUMBER_NONE (-1)

/* What a person has answered so far. Options and "yes" and "no" are objects
 * of no kind, by their number from 0. */
typedef struct Attempt {
  GArray *objects; /* of Object, in the order of their choice */
  GArray *numbers; /* of gint64, NUMBER_NONE: none yet */
  Run *run;        /* drags: the sites as they are now; else NULL */
} Attempt;

Attempt *attempt_new (const Question *question);
Attempt *attempt_copy (const Attempt *attempt);
void attempt_free (Attempt *attempt);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Attempt, attempt_free)

gboolean attempt_is_empty (const Attempt *attempt);
gboolean attempt_has (const Attempt *attempt, Object object);

/* Whether one alone can be right, so that one choice takes the place of
 * another. */
gboolean attempt_is_single (const Question *question);

/* Chooses an object, or lets it go again; where one alone can be right it
 * takes the place of another. */
void attempt_toggle (Attempt *attempt, const Question *question, Object object);

/* What is right. */
typedef struct Answer {
  GArray *objects;   /* of Object */
  gboolean is_any;   /* each of them is a whole answer */
  GArray *numbers;   /* of gint64 */
  gboolean is_found; /* drag, always: sites that show it */
  Site *sites;       /* these, as given, of the run's number or another */
  guint n_sites;
} Answer;

/* What is right at @occasion, which question_locate() has found.
 *
 * Cost: of drags and "always" it searches, among the sets of sites that a
 *       person can reach and among those of all families: some
 *       milliseconds. */
Answer *answer_new (const Question *question, const Occasion *occasion);
void answer_free (Answer *answer);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Answer, answer_free)

/* Returns: (transfer full): an attempt that is right: the model answer. */
Attempt *answer_model (const Question *question, const Occasion *occasion);

/* Returns: (transfer full): an attempt that is wrong. */
Attempt *answer_wrong (const Question *question, const Occasion *occasion);

/* Returns: (transfer full): the reason why a single object is right, or is not,
 *          as a verdict tells it; NULL where one object has none. */
char *answer_reason (const Question *question,
                     const Occasion *occasion,
                     Object object,
                     gboolean is_right);

typedef struct Verdict {
  gboolean is_right;
  guint total, right, missing, wrong;
  GPtrArray *reasons; /* why what is wrong is wrong, translated */
  GPtrArray *missed;  /* why what is missing is right; for the end */
} Verdict;

/* Grades by legality: whatever QuickHull may do is right. */
Verdict *attempt_grade (const Attempt *attempt,
                        const Question *question,
                        const Occasion *occasion);
Verdict *verdict_new (void); /* nothing is right yet */
void verdict_free (Verdict *verdict);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Verdict, verdict_free)

G_END_DECLS

#endif
