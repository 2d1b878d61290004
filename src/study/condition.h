/* Conditions: statements that hold at a step or do not, in words.
 *
 *   cone = visible + 2           sums of quantities and whole numbers, with
 *   facets = 2*inserted - 4      =, !=, <, <=, >, >=; blanks around signs
 *   vertical                     there is some: vertical > 0
 *   sees s4 f1                   words with sites and facets
 *   not neighbours s1 s3
 *   only-upper                   words about the site that is dragged
 *
 * condition_words() lists the words. They decide by the exact signs of the
 * core.
 */
#ifndef CONDITION_H
#define CONDITION_H

#include "quantity.h"

G_BEGIN_DECLS

typedef struct Condition Condition;

/* What a condition is about. */
typedef struct Situation {
  const Frame *frame;
  const Trace *before; /* as it was before the drag, or NULL */
  guint site;          /* that is dragged, or INDEX_NONE */
} Situation;

/* Reads a condition.
 *
 * Returns: (transfer full): NULL with @error set: LESSON_ERROR_BROKEN, the
 *          reason alone. */
Condition *condition_parse (const char *text, GError **error);
void condition_free (Condition *condition);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Condition, condition_free)

/* Returns: as it was written. */
const char *condition_text (const Condition *condition);

/* Returns: (transfer full): it in words, translated, as CommonMark: "a
 *          diagonal flips". */
char *condition_sentence (const Condition *condition);

/* Returns: (transfer full): what its word says, whether the condition negates
 *          it or not; NULL: it compares numbers. */
char *condition_statement (const Condition *condition);
gboolean condition_is_negated (const Condition *condition);

/* Returns: the name of its word, "sees", and its arguments, two at most, to
 *          @arguments; NULL: it compares numbers. */
const char *condition_word (const Condition *condition, guint arguments[2]);

/* Returns: (transfer full): the numbers that it compares, as they are in
 *          @frame: "facets of the cone: 4, visible facets: 2". */
char *condition_facts (const Condition *condition, const Frame *frame);

/* Calls @visit for each quantity that it speaks of. */
void condition_for_each_quantity (const Condition *condition,
                                  void (*visit) (Quantity quantity,
                                                 gpointer user),
                                  gpointer user);

/* Returns: whether it speaks of a drag. */
gboolean condition_needs_drag (const Condition *condition);

/* Returns: where all its quantities say something. */
QuantityScope condition_scope (const Condition *condition);

/* Returns: why it says nothing of @situation, translated ("there is no site
 *          s9"), or NULL. */
const char *condition_fault (const Condition *condition,
                             const Situation *situation);

/* Returns: whether it holds; condition_fault() must say NULL. */
gboolean condition_holds (const Condition *condition,
                          const Situation *situation);

/* Returns: the words, ending with NULL. */
const char *const *condition_words (void);

G_END_DECLS

#endif
