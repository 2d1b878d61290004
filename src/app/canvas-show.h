/* What a canvas shows: its scene and its picture, kept until something
 * changes. Large sets are another thread's work (canvas-work.h); until it is
 * done what was there before is shown. */
#ifndef CANVAS_SHOW_H
#define CANVAS_SHOW_H

#include "canvas.h"

G_BEGIN_DECLS

typedef struct CanvasShow CanvasShow;

CanvasShow *canvas_show_new (Canvas *canvas); /* borrowed; it has a session */
void canvas_show_free (CanvasShow *show);

/* What has changed: all but what is seen from elsewhere; the look alone; the
 * theme or sizes, which change all widgets too; or where it is seen from. */
typedef enum CanvasChange {
  CANVAS_CHANGE_SCENE,
  CANVAS_CHANGE_LOOK,
  CANVAS_CHANGE_APPEARANCE,
  CANVAS_CHANGE_PICTURE,
} CanvasChange;

void canvas_show_invalidate (CanvasShow *show, CanvasChange change);

/* The session has other sites: no work is done for what is quite gone. */
void canvas_show_check_work (CanvasShow *show);
gboolean canvas_show_is_busy (CanvasShow *show);

/* Returns: the scene of the session as it is, made when first asked for. */
const Scene *canvas_show_get_scene (CanvasShow *show);
Object canvas_show_pick (CanvasShow *show, const double at_px[2]);
const LegendMarks *canvas_show_get_marks (CanvasShow *show);

void canvas_show_draw (CanvasShow *show, cairo_t *cr);
void canvas_show_set_moving (CanvasShow *show, gboolean moving);

/* The window is about to go. */
void canvas_show_release (CanvasShow *show);

G_END_DECLS

#endif
