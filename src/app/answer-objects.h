/* The objects of a view that can be chosen as an answer, while a question is
 * open that is answered in the pictures: what Tab walks through, what a click
 * can mean. */
#ifndef ANSWER_OBJECTS_H
#define ANSWER_OBJECTS_H

#include "canvas.h"

G_BEGIN_DECLS

guint answer_objects_count (Canvas *canvas);

/* The session has changed: what was listed is kept no longer. */
void answer_objects_forget (Canvas *canvas);
Object answer_objects_get (Canvas *canvas, guint index);

/* What a click at a pixel means as an answer, among the shapes of @scene: what
 * cannot be an answer is not in the way.
 *
 * Returns: OBJECT_NONE: nothing. */
Object answer_objects_pick (Canvas *canvas,
                            const Scene *scene,
                            const double at_px[2],
                            double reach_px);

/* While a question is open an object that is clicked is an answer to it, and
 * nothing is edited; else it is selected. */
void canvas_answer (Canvas *canvas, Object object);

G_END_DECLS

#endif
