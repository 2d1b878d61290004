/* An easel holds the picture of one view on the screen and keeps it up to
 * date: only what has changed is painted again, with the same pixels as if all
 * were. It may go from one thread to another.
 *
 *   Easel *easel = easel_new ();
 *   cairo_region_t *region;
 *
 *   region = easel_paint (easel, &scene, &projection, theme, 1);
 *   … easel_get_surface (easel) …
 */
#ifndef EASEL_H
#define EASEL_H

#include "theme.h"

#include <cairo.h>

typedef struct Easel Easel;

Easel *easel_new (void);
void easel_free (Easel *easel);

/* Brings the picture up to date, at @scale device pixels to a px. Scenes are
 * known by the editions of their stocks, wherever they lie.
 *
 * Cost:    where only the light has changed, O(what is lit, before and now,
 *          and what lies there), and once O(strokes); else O(items).
 * Returns: (transfer full): what of it has changed, in device pixels. */
cairo_region_t *easel_paint (Easel *easel,
                             const Scene *scene,
                             const Projection *projection,
                             const Theme *theme,
                             double scale);

/* Returns: whether the picture shows the scene's stock like this already: then
 *          easel_paint() has no more to do than what is lit. */
bool easel_has_stock (const Easel *easel,
                      const Scene *scene,
                      const Projection *projection,
                      const Theme *theme,
                      double scale);

/* Does now what is done once when something is lit over the picture. */
void easel_prepare_light (Easel *easel);

/* Returns: the picture, borrowed, until the next one is painted; NULL before
 *          the first. */
cairo_surface_t *easel_get_surface (Easel *easel);

#endif
