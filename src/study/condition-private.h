/* The words of conditions, for condition.c and condition-words.c alone. */
#ifndef CONDITION_PRIVATE_H
#define CONDITION_PRIVATE_H

#include "condition.h"

G_BEGIN_DECLS

typedef struct ConditionWord {
  const char *name;
  const char *arguments; /* "sf": a site and a facet */
  gboolean needs_drag;
  const char *sentence; /* English: "a diagonal flips"; %s: the arguments */
  gboolean (*holds) (const Situation *situation, const guint arguments[2]);
} ConditionWord;

/* Returns: the word of this name, or NULL. */
const ConditionWord *condition_word_find (const char *name);

G_END_DECLS

#endif
