/* Site sets made by rule and seed, all on one power-of-two grid. */
#ifndef GENERATOR_H
#define GENERATOR_H

#include "site.h"

#include <glib.h>

G_BEGIN_DECLS

/* Each returns @n sites (transfer full), or NULL with @error set when there
 * is no such set; the message names the nearest n that exists. */
Site *generator_random (guint n, guint64 seed, GError **error);
Site *generator_grid (guint width, guint height, GError **error);

/* Exactly co-circular: integer points of one circle, over a power of two. */
Site *generator_circle (guint n, GError **error);

/* Exactly collinear, not level, not evenly spaced. */
Site *generator_line (guint n, GError **error);

G_END_DECLS

#endif
