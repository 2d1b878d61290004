/* Boxes, places and segments, as the rules for names need them. */
#ifndef LABEL_GEOMETRY_H
#define LABEL_GEOMETRY_H

#include "box-index.h"
#include "clip.h"

#include <glib.h>
#include <math.h>

/* From a box to a place, squared. */
static inline double
label_square_to (const PixelBox *box, Pixel at)
{
  const double x = MAX (MAX (box->left - at.x, at.x - box->right), 0);
  const double y = MAX (MAX (box->top - at.y, at.y - box->bottom), 0);

  return x * x + y * y;
}

static inline bool
label_segment_meets (const Pixel ends[2], const PixelBox *box)
{
  Pixel cut[2] = { ends[0], ends[1] };

  return clip_to_rectangle ((Pixel){ box->left, box->top },
                            (Pixel){ box->right, box->bottom }, cut);
}

/* Twice the area of a triangle; positive when it turns left. */
static inline double
label_turn (Pixel a, Pixel b, Pixel c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static inline bool
label_segments_cross (Pixel a, Pixel b, Pixel c, Pixel d)
{
  return (label_turn (a, b, c) > 0) != (label_turn (a, b, d) > 0)
         && (label_turn (c, d, a) > 0) != (label_turn (c, d, b) > 0);
}

/* How far a box reaches out of a triangle, over the side that it is furthest
 * from being within. */
static inline double
label_outside (const PixelBox *box, const Pixel corners[3])
{
  const double way = label_turn (corners[0], corners[1], corners[2]);
  double most = -HUGE_VAL;

  for (int i = 0; i < 3; i++) {
    const Pixel a = corners[i], b = corners[(i + 1) % 3];
    /* The outer normal. */
    const double x = way > 0 ? b.y - a.y : a.y - b.y;
    const double y = way > 0 ? a.x - b.x : b.x - a.x;
    const double out = x * ((x > 0 ? box->right : box->left) - a.x)
                       + y * ((y > 0 ? box->bottom : box->top) - a.y);
    const double length = hypot (x, y);

    most = MAX (most, length > 0 ? out / length : 0);
  }
  return most;
}

/* From a place to a segment. */
static inline double
label_distance_from (Pixel at, const Pixel ends[2])
{
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y;
  const double along = (at.x - ends[0].x) * dx + (at.y - ends[0].y) * dy;
  const double length = dx * dx + dy * dy;
  const double part = length > 0 ? CLAMP (along / length, 0, 1) : 0;

  return hypot (ends[0].x + part * dx - at.x, ends[0].y + part * dy - at.y);
}

#endif
