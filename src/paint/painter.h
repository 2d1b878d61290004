/* The cairo painter: draws a scene as a projection shows it. The same code
 * paints the screen, exported pictures and reference images.
 *
 *   const Projection projection = camera_projection (&camera, 400, 400);
 *
 *   painter_paint (cr, &scene, &projection, theme_get (THEME_LIGHT), 0);
 */
#ifndef PAINTER_H
#define PAINTER_H

#include "theme.h"

#include <cairo.h>

typedef enum PainterFlags {
  PAINTER_FAST = 1,  /* something moves: no antialiasing */
  PAINTER_CLEAR = 2, /* leave the background transparent */
} PainterFlags;

/* Paints into the rectangle 0, 0, width, height of @projection. Labels avoid
 * marks, lines and each other; those that find no room are left out, but
 * never the current site, nor what is lit. Nothing further than
 * PAINTER_MARGIN px outside the rectangle reaches @cr.
 *
 * Cost: O(items · layers of paint); 1000 sites in about 20 ms.
 */
void painter_paint (cairo_t *cr,
                    const Scene *scene,
                    const Projection *projection,
                    const Theme *theme,
                    PainterFlags flags);

#define PAINTER_MARGIN 24.0

/* Draws the legend's sample of what an item is, centred in @width × @height:
 * of its role, shape, emphasis, light and hue. */
void painter_swatch (cairo_t *cr,
                     const SceneItem *item,
                     const Theme *theme,
                     double width,
                     double height);

#endif
