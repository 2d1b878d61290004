/* You be QuickHull on paper: a line for each task, and the model answer. */
#ifndef HANDOUT_PERFORM_H
#define HANDOUT_PERFORM_H

#include "handout-private.h"

G_BEGIN_DECLS

/* Adds room for the tasks of all insertions. */
void handout_add_tasks (const Handout *handout,
                        const LessonStop *stop,
                        Block *stack);

/* Adds what the engine does, one of the legal ways. */
void handout_add_performance (const Handout *handout,
                              const LessonStop *stop,
                              Block *stack);

G_END_DECLS

#endif
