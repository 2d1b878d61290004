/* Storyboards: a lesson as a PDF, one panel a stop: both views, title,
 * prose, narration. */
#ifndef STORYBOARD_H
#define STORYBOARD_H

#include "appearance.h"
#include "session.h"

#include <stdio.h>

G_BEGIN_DECLS

/* Plays the session's lesson (or, without one, its rounds, of very many a
 * choice) and writes an A4 page for every four stops, with metadata and an
 * outline, its pictures in @appearance. The session is left at the step and
 * stop where it was. The same lesson gives the same bytes. Between two pages it
 * is asked whether @cancellable, unless NULL, still wants them.
 *
 * Returns: FALSE with @error set when writing failed, or nobody wants it. */
gboolean storyboard_write (Session *session,
                           const Appearance *appearance,
                           FILE *file,
                           GCancellable *cancellable,
                           GError **error);

G_END_DECLS

#endif
