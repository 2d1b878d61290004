/* The scene of a canvas: made when it is first asked for, and kept. Where only
 * what a person points at has changed, no more than that is made anew. */
#ifndef CANVAS_SCENE_H
#define CANVAS_SCENE_H

#include "legend-mark.h"
#include "session.h"

G_BEGIN_DECLS

typedef struct CanvasScene CanvasScene;

CanvasScene *canvas_scene_new (void);
void canvas_scene_free (CanvasScene *kept);

/* The session has changed: its look and nothing else, when @is_only_look. */
void canvas_scene_invalidate (CanvasScene *kept, gboolean is_only_look);

/* Returns: whether it shows the session as it is. */
gboolean canvas_scene_is_valid (const CanvasScene *kept);

/* Makes it valid: what @pane of the session shows for @look. */
void canvas_scene_update (CanvasScene *kept,
                          Session *session,
                          guint pane,
                          const SceneLook *look);

/* The same where no more has changed than what a person points at, which takes
 * no time.
 *
 * Returns: FALSE: there is more to do. */
gboolean canvas_scene_relight (CanvasScene *kept,
                               Session *session,
                               guint pane,
                               const SceneLook *look);

/* Whether its stock is that of the session as it is. */
gboolean canvas_scene_has_stock (const CanvasScene *kept);

/* Makes it valid with what was kept, and does what picks and lights will need.
 * This another thread can do. */
void canvas_scene_fill (CanvasScene *kept, const Showing *showing);
void canvas_scene_prepare (CanvasScene *kept, const Projection *projection);

/* Tells of the marks of another one until it is valid. */
void canvas_scene_take_marks (CanvasScene *kept, const CanvasScene *from);

/* Returns: the scene, borrowed. */
const Scene *canvas_scene_get (const CanvasScene *kept);

/* What is in it, for the legend. */
const LegendMarks *canvas_scene_get_marks (const CanvasScene *kept);

Object canvas_scene_pick (CanvasScene *kept,
                          const Projection *projection,
                          const double at_px[2],
                          double reach_px);

G_END_DECLS

#endif
