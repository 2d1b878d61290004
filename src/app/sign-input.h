/* What pointer and keyboard mean to a plane view that shows a sign map: they
 * read its nodes. */
#ifndef SIGN_INPUT_H
#define SIGN_INPUT_H

#include "canvas.h"

G_BEGIN_DECLS

/* Whether the view shows a sign map now. */
gboolean sign_input_is_on (Canvas *canvas);

/* Reads the node at a place of the view. */
void sign_input_read (Canvas *canvas, const double at_px[2]);

/* Arrows go to the next node, with Shift to the sixteenth.
 *
 * Returns: whether the key was used. */
gboolean sign_input_key (Canvas *canvas, const GdkEventKey *event);

G_END_DECLS

#endif
