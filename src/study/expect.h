/* Expectations: what a lesson says must hold, "expect KEY VALUE". */
#ifndef EXPECT_H
#define EXPECT_H

#include "session.h"

G_BEGIN_DECLS

/* Checks that @text is an expectation: a known key with a value of its kind.
 *
 * Errors: LESSON_ERROR_BROKEN, the reason alone. */
gboolean expect_parse (const char *text, GError **error);

/* Returns: whether @text, which expect_parse() accepts, holds now; *@actual
 *          (transfer full) says what was found. */
gboolean expect_check (Session *session, const char *text, char **actual);

/* Returns: the keys, ending with NULL. */
const char *const *expect_keys (void);

G_END_DECLS

#endif
