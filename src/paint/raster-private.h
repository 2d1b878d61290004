/* What the parts of the raster share. */
#ifndef RASTER_PRIVATE_H
#define RASTER_PRIVATE_H

#include "coverage.h"
#include "raster.h"

/* Who paints a band of the picture. */
typedef struct Hand {
  uint32_t *pixels; /* of the picture */
  int stride;       /* in pixels */
  double scale;
  const Theme *theme; /* of the current drawing */
  Coverage coverage;  /* its clip is that of the band */
  Pixel *scaled;      /* room for one stroke in device pixels */
  uint32_t scaled_room;
} Hand;

/* Paints what of a stroke lies within the clip. */
void
hand_paint_stroke (Hand *hand, const Drawing *drawing, const Stroke *stroke);

/* Returns: a colour as a pixel, premultiplied. */
uint32_t hand_pixel (Colour colour);

#endif
