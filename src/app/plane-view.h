/* The plane: sites to add, select, drag and delete; triangles, circles and
 * cells that follow. */
#ifndef PLANE_VIEW_H
#define PLANE_VIEW_H

#include "canvas.h"

G_BEGIN_DECLS

#define PLANE_VIEW_TYPE (plane_view_get_type ())
G_DECLARE_FINAL_TYPE (PlaneView, plane_view, HULL2VD, PLANE_VIEW, Canvas)

G_END_DECLS

#endif
