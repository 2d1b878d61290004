/* Answers on paper: what is right, as the engine computes it, and why. */
#ifndef HANDOUT_ANSWER_H
#define HANDOUT_ANSWER_H

#include "handout-private.h"

G_BEGIN_DECLS

/* Adds the answer to the question of a stop to @stack. */
void handout_add_answer (const Handout *handout, guint stop, Block *stack);

G_END_DECLS

#endif
