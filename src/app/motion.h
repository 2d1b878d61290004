/* Motions: what moves by itself in a canvas, on its way from one state to the
 * next. All take as long, begin and end gently, and are over at any key or
 * click. */
#ifndef MOTION_H
#define MOTION_H

#include "canvas.h"

G_BEGIN_DECLS

#define MOTION_MS 450

typedef struct Motion {
  Canvas *canvas;  /* borrowed; drawn anew while it lasts */
  double part;     /* of the way, 0 … 1; 1: there */
  gint64 start_us; /* 0: not started yet */
  guint n_skips;   /* keys and clicks before it began */
  guint tick;
} Motion;

/* It is there. */
void motion_init (Motion *motion, Canvas *canvas);

/* Returns: whether things may move: the canvas is on the screen, and the
 *          desktop has not turned animations off. Tests turn them off by
 *          HULL2VD_ANIMATIONS=0. */
gboolean motion_is_wanted (const Motion *motion);

void motion_begin (Motion *motion);

/* Is there at once. */
void motion_end (Motion *motion);

G_END_DECLS

#endif
