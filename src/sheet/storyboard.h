/* Storyboards: a lesson as a PDF, one panel a stop: both views, title,
 * prose, narration. */
#ifndef STORYBOARD_H
#define STORYBOARD_H

#include "session.h"

#include <stdio.h>

G_BEGIN_DECLS

/* Plays the session's lesson (or, without one, its rounds) and writes a page
 * for every four stops, A4, with metadata and outline.
 *
 * Returns: FALSE with @error set when writing failed. */
gboolean storyboard_write (Session *session, FILE *file, GError **error);

G_END_DECLS

#endif
