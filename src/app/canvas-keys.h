/* What the keyboard means to a canvas. */
#ifndef CANVAS_KEYS_H
#define CANVAS_KEYS_H

#include "canvas.h"

G_BEGIN_DECLS

void canvas_keys_class_init (GtkWidgetClass *class);

/* Returns: whether pictures have a use of their own for the key, whatever the
 *          keyboard is on: no action can have it while they have the focus. */
gboolean canvas_keeps_key (guint keyval, GdkModifierType modifiers);

/* Returns: whether the key is an arrow; @by gets its direction, y down. */
gboolean canvas_arrow (guint keyval, double by[2]);

G_END_DECLS

#endif
