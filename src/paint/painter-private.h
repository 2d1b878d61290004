/* What the parts of the painter's front half share. */
#ifndef PAINTER_PRIVATE_H
#define PAINTER_PRIVATE_H

#include "brush.h"
#include "drawing.h"
#include "label.h"
#include "painter.h"

/* Sorts of items: one for each role, emphasis, lit, shape, layer of paint, and
 * whether they stand for a Voronoi vertex. */
#define N_PAINTER_SORTS (N_ROLES * 3 * 3 * 3 * N_SCENE_DEPTHS * 2)

/* The style last given to a sort of items. */
typedef struct PainterSort {
  uint32_t style; /* its number + 1; 0: none yet */
  double fade;    /* of the items that it is for */
} PainterSort;

typedef struct Painter {
  Drawing *drawing;
  const Scene *scene;
  const Projection *projection;
  const Theme *theme;
  unsigned char *depths; /* per item */
  Pixel *corners;        /* room for the largest polygon */
  PainterSort *sorts;    /* N_PAINTER_SORTS of them */
  double size;           /* of marks and lines; below 1 where many sites
                            share the view */
} Painter;

/* Returns: the item's style as it is painted: thinner in a crowd, on the
 *          ground of space, and behind the hull. */
Style painter_style (const Painter *painter, const SceneItem *item);

/* Adds the item's path, clipped, as strokes of a kind and style. */
void painter_trace (Painter *painter,
                    const SceneItem *item,
                    StrokeKind kind,
                    uint32_t style);

/* Adds the lines of the paraboloid on the side that faces the eye, or on the
 * other one. The sheet itself lies behind the hull, both sides of it: a
 * yellow one would turn blue facets into green ones. */
void painter_add_sheet (Painter *painter, bool is_near);

/* Adds names where they find room. */
void painter_add_names (Painter *painter);

#endif
