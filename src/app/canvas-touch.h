/* What two fingers and a long press mean to a canvas. One finger is a pointer:
 * a gesture that sees touches takes them from the mouse's events, so that
 * drags go through a gesture too (canvas-input.h). */
#ifndef CANVAS_TOUCH_H
#define CANVAS_TOUCH_H

#include "canvas-input.h"

G_BEGIN_DECLS

void canvas_touch_attach (Canvas *canvas,
                          GtkGesture *gestures[N_CANVAS_GESTURES]);

G_END_DECLS

#endif
