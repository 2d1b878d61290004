/* Where sites come from, in words, as in a lesson's "sites" line:
 *
 *   x y; x y; …           as they are written
 *   random N seed S       distinct, on a power-of-two grid
 *   clusters N seed S     crowded round a few centres
 *   grid W H              rows of W sites, H of them
 *   circle N              exactly on one circle
 *   near-circle N seed S  rounded to the grid from a circle
 *   line N                exactly on one line
 *   spiral N              from the middle outwards
 *   kuzmin N seed S       crowded in the middle, few outside
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
