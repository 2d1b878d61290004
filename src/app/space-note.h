/* A word over the space view on what is unusual about it: that it is seen
 * through the plane, mirrored or not. */
#ifndef SPACE_NOTE_H
#define SPACE_NOTE_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Adds the note to @overlay, which holds the space view. */
void space_note_attach (GtkOverlay *overlay, Session *session);

G_END_DECLS

#endif
