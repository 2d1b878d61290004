/* The gist of a lesson: what a page of it has to say. */
#ifndef GIST_H
#define GIST_H

#include "lesson.h"

G_BEGIN_DECLS

/* What an author prints in bold matters: a term where it is explained, a
 * fact where it is told.
 *
 * Returns: (transfer full) (element-type utf8): the sentences of a text, as
 *          Pango markup, in which something is bold. */
GPtrArray *gist_facts (const char *commonmark);

/* Returns: (transfer full): what the lesson's notes cite after "Sources:" or
 *          "Source:", each as CommonMark, one below another; "" when they cite
 *          nothing. */
char *gist_sources (const Lesson *lesson);

G_END_DECLS

#endif
