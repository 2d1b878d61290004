/* The picture of a large set is another thread's work, from the scene to the
 * pixels; the canvas shows the one before until then. What the thread needs is
 * lent to it: nobody else sees it meanwhile. */
#ifndef CANVAS_WORK_H
#define CANVAS_WORK_H

#include "canvas-picture.h"
#include "canvas-scene.h"

G_BEGIN_DECLS

typedef struct CanvasWork CanvasWork;

struct CanvasWork {
  CanvasScene *scene;
  Showing *showing; /* to fill it from; NULL: it is filled */
  PictureWork *picture;
  Projection projection;
  gint is_given_up; /* atomic */
  guint n_sites;
  /* What has changed since it was begun. */
  gboolean is_outdated, has_other_scene, has_other_look;
};

/* Told on the main loop, if it was not given up: takes scene and picture and
 * puts NULL in their places; the rest is freed after it. */
typedef void (*CanvasWorkDone) (CanvasWork *work, gpointer user);

/* Takes @work, from g_new0(). */
void canvas_work_begin (CanvasWork *work, CanvasWorkDone done, gpointer user);

/* The picture is one of another moment by now, and perhaps the scene. */
void canvas_work_note (CanvasWork *work,
                       gboolean has_other_scene,
                       gboolean is_only_look);

/* Nobody wants it any more, or will be told: it ends when it can. */
void canvas_work_give_up (CanvasWork *work);

G_END_DECLS

#endif
