/* Where sites come from, in words, as in a lesson's "sites" line:
 *
 *   x y; x y; …        as they are written
 *   random N seed S    distinct, on a power-of-two grid
 *   grid W H           rows of W sites, H of them
 *   circle N           exactly on one circle
 *   line N             exactly on one line
 */
#ifndef SITE_SOURCE_H
#define SITE_SOURCE_H

#include "site.h"

#include <glib.h>

G_BEGIN_DECLS

/* Makes the sites that @text tells of, at most GENERATOR_MAX.
 *
 * Returns: (transfer full): the sites, *@n_sites of them, or NULL with @error
 *          (ACTION_ERROR_PARAMETER) set; then *@fault is the offset in @text,
 *          in bytes, of what is wrong. */
Site *site_source_make (const char *text,
                        guint *n_sites,
                        gsize *fault,
                        GError **error);

G_END_DECLS

#endif
