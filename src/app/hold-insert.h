/* Holding the button down on the empty plane puts a site there for as long as
 * it is held: it can be dragged on, and goes when the button is let go. Enter
 * keeps it; Escape takes it back at once. */
#ifndef HOLD_INSERT_H
#define HOLD_INSERT_H

#include "canvas.h"

G_BEGIN_DECLS

/* For as long as @canvas, a plane view, lives. */
void hold_insert_attach (Canvas *canvas);

G_END_DECLS

#endif
