/* What the generators share, for the files generator*.c alone. */
#ifndef GENERATOR_PRIVATE_H
#define GENERATOR_PRIVATE_H

#include "generator.h"

G_BEGIN_DECLS

/* Returns: whether @n is 1 … @most; else FALSE with @error set. */
gboolean generator_check_count (guint64 n, guint most, GError **error);

/* Returns: the bits of the finest grid needed to keep @n random sites apart,
 *          at least six: few enough digits to read. */
int generator_bits (guint n);

/* Returns: a number from 0 to @most. */
guint32 generator_below (guint64 *state, guint32 most);

G_END_DECLS

#endif
