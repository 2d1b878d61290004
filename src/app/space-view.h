/* Space: the paraboloid, the lifted sites and their hull, to turn and to look
 * at from below. */
#ifndef SPACE_VIEW_H
#define SPACE_VIEW_H

#include "canvas.h"

G_BEGIN_DECLS

#define SPACE_VIEW_TYPE (space_view_get_type ())
G_DECLARE_FINAL_TYPE (SpaceView, space_view, HULL2VD, SPACE_VIEW, Canvas)

G_END_DECLS

#endif
