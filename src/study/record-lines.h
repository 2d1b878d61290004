/* The commands that lead from one state of a session to another; inside of
 * session-record.c. */
#ifndef RECORD_LINES_H
#define RECORD_LINES_H

#include "stop-state.h"

G_BEGIN_DECLS

/* Carries out in @shadow, and returns, the commands after which it shows what
 * @to and @theme say.
 *
 * Returns: (transfer full) (element-type utf8) */
GPtrArray *record_lines (Session *shadow, const StopState *to, ThemeKind theme);

/* Returns: (transfer full): "x y; x y", as the line "sites" has them. */
char *record_sites_text (const Site *sites, guint n_sites);

G_END_DECLS

#endif
