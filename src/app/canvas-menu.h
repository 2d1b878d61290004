/* The menu of what can be done with the object at a point of a canvas. */
#ifndef CANVAS_MENU_H
#define CANVAS_MENU_H

#include "canvas.h"

G_BEGIN_DECLS

/* Selects @object unless it is selected already, and pops up its menu. */
void canvas_menu_popup (Canvas *canvas, Object object, const double at_px[2]);

/* The menu of the object that the keyboard is on, beside it. */
void canvas_menu_popup_at_cursor (Canvas *canvas);

G_END_DECLS

#endif
