/* Prose of lessons: CommonMark to Pango markup, through libcmark. */
#ifndef PROSE_H
#define PROSE_H

#include <glib.h>

G_BEGIN_DECLS

/* Returns: (transfer full): markup that pango_parse_markup() accepts;
 *          paragraphs are separated by an empty line, list items begin with
 *          a bullet or their number, links become their words, raw HTML is
 *          left out. */
char *prose_to_markup (const char *commonmark);

/* Returns: (transfer full): the words alone. */
char *prose_to_text (const char *commonmark);

G_END_DECLS

#endif
