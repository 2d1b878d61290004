/* Fresh sites for a performance: a source with a seed, "random 7 seed 15". The
 * same seed makes the same sites; the next one others. */
#ifndef FRESH_SITES_H
#define FRESH_SITES_H

#include "run.h"

G_BEGIN_DECLS

/* Reads a source with a seed, at most QUESTION_MAX_SITES sites: *@source
 * (transfer full) is what stands before the seed, "random 7".
 *
 * Errors: ACTION_ERROR_PARAMETER, *@fault the offset of what is wrong. */
gboolean fresh_sites_parse (const char *text,
                            char **source,
                            guint64 *seed,
                            gsize *fault,
                            GError **error);

/* Returns: (transfer full): "random 7 seed 15". */
char *fresh_sites_text (const char *source, guint64 seed);

/* Finds the first seed after *@seed whose sites allow so many insertions and
 * lie so far apart that each can be pointed at; where no such seed is near, the
 * last one that allows the insertions.
 *
 * Returns: (transfer full): the run of these sites, or NULL. */
Run *fresh_sites_next (const char *source, guint n_insertions, guint64 *seed);

G_END_DECLS

#endif
