/* What assistive technology sees of a canvas: a picture with a description,
 * and one child for each of its objects, made when first asked for. Of very
 * many objects the first are listed as its children; the others are told when
 * the keyboard comes to them, and the description says so. */
#ifndef CANVAS_ACCESSIBLE_H
#define CANVAS_ACCESSIBLE_H

#include "object.h"

#include <gtk/gtk-a11y.h>
#include <gtk/gtk.h>

G_BEGIN_DECLS

#define CANVAS_ACCESSIBLE_TYPE (canvas_accessible_get_type ())
G_DECLARE_FINAL_TYPE (CanvasAccessible,
                      canvas_accessible,
                      HULL2VD,
                      CANVAS_ACCESSIBLE,
                      GtkWidgetAccessible)

/* So many objects are listed as children. Whoever looks for something in the
 * window asks each of them, 30 µs long. */
#define CANVAS_LISTED 1000

/* Returns: the place of @object among the children, -1: it is not listed. */
int canvas_accessible_index (GtkWidget *canvas, Object object);

/* The session has changed: see SessionChange. */
void canvas_accessible_update (GtkWidget *canvas, guint changes);

/* The keyboard has come to @cursor. */
void canvas_accessible_focus (GtkWidget *canvas, Object cursor);

G_END_DECLS

#endif
