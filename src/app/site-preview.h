/* What a click would do, shown before it: while the pointer is over the plane
 * and on no site, both views show the cell that a new site would get and the
 * triangles that would die. */
#ifndef SITE_PREVIEW_H
#define SITE_PREVIEW_H

#include "canvas.h"

G_BEGIN_DECLS

/* Follows the pointer over @canvas, a plane view, for as long as it lives. */
void site_preview_attach (Canvas *canvas);

/* Returns: whether a pixel is on the mark of a site. */
gboolean site_preview_is_on_site (Canvas *canvas, const double at_px[2]);

G_END_DECLS

#endif
