/* Lines of a steps block: a verb of the action registry and its parameter,
 * or expect. The name of an action is written with blanks or hyphens:
 *
 *   next phase                 next-phase
 *   goto before round 1 see    goto with "before round 1 see"
 *   move site 3 0.5 -0.25      move-site with (3, 0.5, -0.25)
 */
#ifndef COMMAND_H
#define COMMAND_H

#include <glib.h>

G_BEGIN_DECLS

/* Reads one line.
 *
 * Returns: FALSE with @error set; else *@verb (transfer full) is the name of
 *          the action or "expect", *@parameter (transfer full) what it takes,
 *          or NULL.
 * Errors:  ACTION_ERROR or LESSON_ERROR, the reason alone. */
gboolean command_parse (const char *text,
                        char **verb,
                        GVariant **parameter,
                        GError **error);

G_END_DECLS

#endif
