/* Positions in words, as in "goto before round 1 see". */
#ifndef POSITION_H
#define POSITION_H

#include "timeline.h"

#include <glib.h>

G_BEGIN_DECLS

/* Finds the step that @text names:
 *
 *   [before] round R [PHASE]   PHASE: choose, see, horizon, cone, hand-over;
 *                              none: the whole round
 *   [before] simplex           the first simplex and the first partition
 *   start, complete            step 0, the last step
 *
 * Errors: ACTION_ERROR_PARAMETER: these words are no position;
 *         ACTION_ERROR_POSITION: the trace has no such place. */
gboolean position_find (const Trace *trace,
                        const char *text,
                        guint *step,
                        GError **error);

/* Reads the words alone: @place, or what is just before it. */
gboolean position_read (const char *text,
                        Place *place,
                        gboolean *is_before,
                        GError **error);

/* Checks the words alone. */
gboolean position_check (const char *text, GError **error);

G_END_DECLS

#endif
