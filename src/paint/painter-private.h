/* What the parts of the painter share. */
#ifndef PAINTER_PRIVATE_H
#define PAINTER_PRIVATE_H

#include "brush.h"
#include "label.h"
#include "painter.h"

typedef struct Painter {
  cairo_t *cr;
  const Scene *scene;
  const Projection *projection;
  const Theme *theme;
  unsigned char *depths; /* per item */
  Pixel *corners;        /* room for the largest polygon */
  LabelSheet *sheet;     /* ink that labels avoid; NULL: no labels */
  double size;           /* of marks and lines; below 1 where many sites
                            share the view */
} Painter;

/* Returns: the item's style as it is painted: thinner in a crowd, on the
 *          ground of space, and behind the hull. */
Style painter_style (const Painter *painter, const SceneItem *item);

/* Adds the item's path, clipped, to that of the context and to the ink. */
void painter_trace (Painter *painter, const SceneItem *item, double width);

/* Paints the lines of the paraboloid on the side that faces the eye, or on the
 * other one. The sheet itself lies behind the hull, both sides of it: a
 * yellow one would turn blue facets into green ones. */
void painter_paint_sheet (Painter *painter, bool is_near);

void painter_paint_labels (Painter *painter);

#endif
