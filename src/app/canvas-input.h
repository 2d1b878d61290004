/* What the pointer means to a canvas; canvas-touch.h and canvas-keys.h for
 * the rest. */
#ifndef CANVAS_INPUT_H
#define CANVAS_INPUT_H

#include "canvas.h"

G_BEGIN_DECLS

typedef enum CanvasGesture {
  CANVAS_GESTURE_PRESS,
  CANVAS_GESTURE_DRAG,
  CANVAS_GESTURE_PINCH,
  CANVAS_GESTURE_LONG_PRESS,
  N_CANVAS_GESTURES,
} CanvasGesture;

typedef enum CanvasController {
  CANVAS_CONTROLLER_MOTION,
  CANVAS_CONTROLLER_SCROLL,
  N_CANVAS_CONTROLLERS,
} CanvasController;

/* Owns: the canvas takes what is put into both arrays. */
void
canvas_input_attach (Canvas *canvas,
                     GtkGesture *gestures[N_CANVAS_GESTURES],
                     GtkEventController *controllers[N_CANVAS_CONTROLLERS]);

/* What was pressed is no click and no drag: another gesture has it. */
void canvas_input_give_up (Canvas *canvas);

/* What is being dragged goes back to where it was.
 *
 * Returns: FALSE when nothing is. */
gboolean canvas_input_cancel (Canvas *canvas);

G_END_DECLS

#endif
