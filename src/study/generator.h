/* Site sets made by rule and seed, all on one power-of-two grid, inside the
 * square -1 … 1. */
#ifndef GENERATOR_H
#define GENERATOR_H

#include "site.h"

#include <glib.h>

G_BEGIN_DECLS

#define GENERATOR_MAX 20000       /* sites */
#define GENERATOR_CIRCLE_MAX 8192 /* sites on one circle */

#define GENERATOR_ERROR (generator_error_quark ())
GQuark generator_error_quark (void);
typedef enum GeneratorError {
  GENERATOR_ERROR_COUNT, /* there is no such set */
} GeneratorError;

/* Each returns @n sites (transfer full), or NULL with @error set when there
 * is no such set; the message names the nearest n that exists. */

/* Distinct sites, uniform in the square. The same everywhere. */
Site *generator_random (guint n, guint64 seed, GError **error);

/* Distinct sites crowded round a few centres. */
Site *generator_clusters (guint n, guint64 seed, GError **error);

/* Distinct sites as near to the circle of radius 1 as the grid allows: rounded
 * to it, so that hardly four of them lie on one circle. */
Site *generator_near_circle (guint n, guint64 seed, GError **error);

/* Distinct sites, crowded in the middle and few outside, as stars in a
 * galaxy.
 *
 * Source: the Kuzmin distribution, as in Shewchuk 1996: a share
 *         1 - 1/√(1 + r²) of them lies within r. */
Site *generator_kuzmin (guint n, guint64 seed, GError **error);

/* From the middle outwards, evenly spaced. */
Site *generator_spiral (guint n, GError **error);

/* Rows from below, each from the left. */
Site *generator_grid (guint width, guint height, GError **error);

/* Exactly co-circular: integer points of one circle, over a power of two,
 * counter-clockwise. */
Site *generator_circle (guint n, GError **error);

/* Exactly collinear, not level, not evenly spaced. */
Site *generator_line (guint n, GError **error);

G_END_DECLS

#endif
