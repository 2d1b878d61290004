/* What the keyboard means to a canvas. */
#ifndef CANVAS_KEYS_H
#define CANVAS_KEYS_H

#include "canvas.h"

G_BEGIN_DECLS

void canvas_keys_class_init (GtkWidgetClass *class);

/* Returns: whether the key is an arrow; @by gets its direction, y down. */
gboolean canvas_arrow (guint keyval, double by[2]);

G_END_DECLS

#endif
