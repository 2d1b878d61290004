/* Results: what a person's progress says, in forms that others read: lesson by
 * lesson, in the order of its stops. */
#ifndef RESULTS_H
#define RESULTS_H

#include "progress.h"

G_BEGIN_DECLS

/* Returns: (transfer full): a row for each question, with a heading; @name is
 *          what the person wants to be called, or NULL: the learner's random
 *          name.
 * Source:  RFC 4180. */
char *results_csv (const Progress *progress, const char *name);

/* Returns: (transfer full): a statement for each question that was answered
 *          and each lesson that is done, one a line, the same each time.
 * Source:  Experience API 1.0.3, IEEE 9274.1.1. */
char *results_xapi (const Progress *progress, const char *name);

G_END_DECLS

#endif
