/* Inputs on which rounding makes a hull go wrong, by the names of their
 * source.
 *
 * Source: Kettner, Mehlhorn, Pion, Schirra, Yap 2008, "Classroom examples of
 *         robustness problems in geometric computations".
 */
#ifndef ROUNDING_CASE_H
#define ROUNDING_CASE_H

#include "site.h"

#include <glib.h>

G_BEGIN_DECLS

typedef struct RoundingCase {
  const char *name;
  guint n_sites;
  Site sites[9];
} RoundingCase;

/* Returns: all of them. */
const RoundingCase *rounding_cases (guint *n_cases);
const RoundingCase *rounding_case_find (const char *name); /* NULL: none */

G_END_DECLS

#endif
