/* The person's progress, one for all windows: read when it is first asked for,
 * written a moment after it has changed. */
#ifndef PROGRESS_KEEPER_H
#define PROGRESS_KEEPER_H

#include "progress.h"

G_BEGIN_DECLS

Progress *progress_keeper_get (void);

/* Returns: (transfer full): what to tell the person, once: of a file that
 *          could not be read or written; else NULL. */
char *progress_keeper_take_message (void);

/* To be called when it may have changed: it is written soon. */
void progress_keeper_touch (void);

/* Writes it now. */
void progress_keeper_flush (void);

G_END_DECLS

#endif
