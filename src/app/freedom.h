/* What a person can do without a lesson: the words in its place, for the
 * pictures that are shown. */
#ifndef FREEDOM_H
#define FREEDOM_H

#include "session.h"

G_BEGIN_DECLS

const char *freedom_title (Session *session);

/* @right_button_adds: sites, in place of the left one.
 *
 * Returns: CommonMark. */
const char *freedom_text (Session *session, gboolean right_button_adds);

G_END_DECLS

#endif
