/* Tables of spreadsheets that write 1,5;2,5 for the point (1.5, 2.5), as German
 * and Spanish ones do. */
#ifndef DECIMAL_COMMA_H
#define DECIMAL_COMMA_H

#include <glib.h>

G_BEGIN_DECLS

/* Whether all commas of @rows are of decimals for sure: all rows are two
 * numbers with a semicolon between them, no number has a point, and not every
 * comma may be one of thousands, as that of 1,500. */
gboolean decimal_comma_is_sure (const char *rows, gsize length);

/* Returns: (transfer full): the rows with points for commas, of the same
 *          length. */
char *decimal_comma_replace (const char *rows, gsize length);

G_END_DECLS

#endif
