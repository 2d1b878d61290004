/* The plane: sites to add, select, drag and delete; triangles, circles and
 * cells that follow. */
#ifndef PLANE_VIEW_H
#define PLANE_VIEW_H

#include "canvas.h"

G_BEGIN_DECLS

#define PLANE_VIEW_TYPE (plane_view_get_type ())
G_DECLARE_FINAL_TYPE (PlaneView, plane_view, HULL2VD, PLANE_VIEW, Canvas)

/* The bindings of 2004: the right button adds, the left one selects and moves
 * and never adds. */
void plane_view_set_paper_bindings (PlaneView *view, gboolean has_them);
gboolean plane_view_get_paper_bindings (PlaneView *view);

G_END_DECLS

#endif
