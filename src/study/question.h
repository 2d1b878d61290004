/* Questions of lessons. A question says what is asked and where; what is
 * right is never written down: it is computed from the trace each time.
 *
 *   question_locate (question, trace, &occasion, &error)   where it is asked
 *   answer_new (question, &occasion)                       what is right
 *   attempt_grade (attempt, question, &occasion)           how right it is
 */
#ifndef QUESTION_H
#define QUESTION_H

#include "condition.h"
#include "lesson-source.h"
#include "run.h"

G_BEGIN_DECLS

typedef enum QuestionKind {
  QUESTION_CHOOSE,  /* one, or several, of written options */
  QUESTION_NUMBERS, /* one or several quantities */
  QUESTION_CLICK,   /* objects in either view */
  QUESTION_ORDER,   /* things one after the other */
  QUESTION_DRAG,    /* move a site until a condition holds */
  QUESTION_ALWAYS,  /* does a condition hold for every set of sites? */
  QUESTION_PERFORM, /* do what QuickHull does: performance.h */
} QuestionKind;

/* An option of QUESTION_CHOOSE; the trace decides whether it is right. */
typedef struct QuestionOption {
  char *text;
  Condition *condition;
} QuestionOption;

/* What there is to put in order. */
typedef enum QuestionOrder {
  ORDER_OF_SITES,       /* as QuickHull inserts them; all legal orders count */
  ORDER_OF_OUTSIDE_SET, /* of a facet: the furthest first */
  ORDER_OF_PHASES,      /* of a round */
} QuestionOrder;

typedef struct ClickKind ClickKind; /* question-click.h */

typedef struct Question {
  int reference_count;
  guint line, column; /* of its block, for messages */
  QuestionKind kind;
  char *position; /* in words: "before round 1 see" */
  char *prompt;   /* CommonMark, or NULL: question_prompt() makes one */
  GPtrArray *hints;
  guint n_retries; /* checks before the answer is shown, besides the first */

  gboolean is_several; /* options: more than one may be chosen */
  GPtrArray *options;  /* of QuestionOption */
  GArray *quantities;  /* of Quantity */
  const ClickKind *click;
  Object argument; /* of click and order: "f0" in "outside-set f0" */
  QuestionOrder order;
  guint site; /* to be dragged */
  Condition *condition;
  char *generate; /* the kind, when a seed makes the question; else NULL */
  guint64 seed;
  guint64 n_insertions; /* to be performed */
  char *fresh;          /* where other sites to perform on come from, a source
                           with a seed, without the latter: "random 7"; or NULL */
} Question;

#define QUESTION_MAX_OPTIONS 12
#define QUESTION_MAX_NUMBERS 8
#define QUESTION_MAX_HINTS 8
#define QUESTION_MAX_RETRIES 20
#define QUESTION_MAX_SITES 200 /* of drags, orders, "always", performances */
#define QUESTION_MAX_INSERTIONS 20

Question *question_new (void);
Question *question_ref (Question *question);
void question_unref (Question *question);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Question, question_unref)

/* Where a question is asked in a run. */
typedef struct Occasion {
  const Trace *trace; /* borrowed */
  guint step;         /* shown while it is asked: before its event */
  guint reveal;       /* shown once it is answered */
  guint round;        /* that it is about, from 1; beyond the last: none */
} Occasion;

/* Finds the place of @question in @trace, and checks that it can be asked
 * there: its answer is not empty, can be given, and is not shown already.
 *
 * Errors: LESSON_ERROR_BROKEN or ACTION_ERROR: the reason alone. */
gboolean question_locate (const Question *question,
                          const Trace *trace,
                          Occasion *occasion,
                          GError **error);

/* Returns: the row of the round that it is about, or NULL. */
const RoundRow *occasion_round (const Occasion *occasion);

/* What of the picture would give the answer away: SceneMask bits. */
guint question_mask (const Question *question);

/* Returns: (transfer full): what is asked, as CommonMark, translated unless
 *          the author wrote it. */
char *question_prompt (const Question *question, const Occasion *occasion);

/* Returns: (transfer full): how to answer it: "Click facets in either
 *          picture.", translated. */
char *question_instruction (const Question *question);

/* Returns: whether a click on @object means something to it; *@object becomes
 *          what it means: a triangle its circle's vertex. */
gboolean
question_takes (const Question *question, const Frame *frame, Object *object);

/* Returns: (transfer full) (element-type Object): what there is to put in
 *          order, the order telling nothing. */
GArray *question_items (const Question *question, const Occasion *occasion);

/* Returns: (transfer full): the name of an item or option, translated. */
char *question_item_text (const Question *question, Object item);

/* Reads a block of lines into a question. Faults are told to @faults.
 *
 * Returns: (transfer full): the question, or NULL. */
Question *question_parse (const LessonSource *source,
                          const LessonLines *lines,
                          LessonFaults *faults);

/* Returns: the " if " before the condition of "TEXT if CONDITION", or NULL. */
const char *question_find_if (const char *option);

/* Returns: (transfer full): its TEXT, or NULL. */
char *question_option_words (const char *option);

/* Makes a question from a kind and a seed, which chooses the round; the same
 * for the same trace, kind and seed. @kind is one of
 * question_generate_kinds().
 *
 * Returns: (transfer full): NULL with @error set: no round has such a
 *          question. */
Question *question_generate (const Trace *trace,
                             const char *kind,
                             guint64 seed,
                             GError **error);
const char *const *question_generate_kinds (void);

/* Returns: the kind that makes questions like this one, or NULL. */
const char *question_generator_of (const Question *question);

G_END_DECLS

#endif
