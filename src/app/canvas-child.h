/* A site or facet of a canvas, for assistive technology: name, state, place,
 * and the action "select". */
#ifndef CANVAS_CHILD_H
#define CANVAS_CHILD_H

#include "canvas.h"

#include <atk/atk.h>

G_BEGIN_DECLS

#define CANVAS_CHILD_TYPE (canvas_child_get_type ())
G_DECLARE_FINAL_TYPE (
    CanvasChild, canvas_child, HULL2VD, CANVAS_CHILD, AtkObject)

/* @canvas is borrowed until it is detached, which it must be before the canvas
 * goes. */
AtkObject *canvas_child_new (Canvas *canvas, Object object);

/* The object is no more; whoever still holds the child can see it, and is told
 * so when @is_told. */
void canvas_child_detach (CanvasChild *child, gboolean is_told);

Object canvas_child_get_object (CanvasChild *child);

/* Tell that it is called otherwise now than when somebody last asked; that it
 * is selected, or no longer, if that is new. */
void canvas_child_tell_name (CanvasChild *child);
void canvas_child_tell_selected (CanvasChild *child);

G_END_DECLS

#endif
