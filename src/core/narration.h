/* One sentence for each event, in the words of the mathematics. */
#ifndef NARRATION_H
#define NARRATION_H

#include "trace.h"

#include <stddef.h>

/* Gives the translation of an English template; gettext() is one. */
typedef const char *(*NarrationTranslate) (const char *english);

#define NARRATION_ROOM 512

/* Writes the sentence for the event that led to @step; at step 0 it says
 * what there is. Templates name their parts in braces, "{p} sees {f}", so
 * that a translation may put them in its own order.
 *
 * Shape: UTF-8 in @text, at most NARRATION_ROOM bytes with the final zero.
 *        @translate may be NULL: English.
 */
void narration_write (const Trace *trace,
                      uint32_t step,
                      NarrationTranslate translate,
                      char text[NARRATION_ROOM]);

#endif
