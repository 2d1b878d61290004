/* Tables of spreadsheets that write 1,5;2,5 for the point (1.5, 2.5), as German
 * and Spanish ones do. */
#ifndef DECIMAL_COMMA_H
#define DECIMAL_COMMA_H

#include <glib.h>

G_BEGIN_DECLS

typedef enum DecimalComma {
  DECIMAL_COMMA_NONE, /* it is no such table */
  DECIMAL_COMMA_SURE,
  DECIMAL_COMMA_DOUBTFUL, /* every comma may be one of thousands: 1,500 */
} DecimalComma;

/* What the commas of @rows mean: all rows are two numbers with a semicolon
 * between them, and no number has a point. */
DecimalComma decimal_comma_find (const char *rows, gsize length);

/* Returns: (transfer full): the rows with points for commas, of the same
 *          length. */
char *decimal_comma_replace (const char *rows, gsize length);

G_END_DECLS

#endif
