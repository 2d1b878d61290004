/* Prose of lessons: CommonMark to Pango markup, and into other languages,
 * through libcmark. */
#ifndef PROSE_H
#define PROSE_H

#include <glib.h>

G_BEGIN_DECLS

/* Returns: (transfer full): markup that pango_parse_markup() accepts;
 *          paragraphs are separated by an empty line, list items begin with
 *          a bullet or their number, links become their words, raw HTML is
 *          left out. */
char *prose_to_markup (const char *commonmark);

/* Returns: (transfer full): XHTML; raw HTML is left out. */
char *prose_to_html (const char *commonmark);

/* The same of a part of a document that libcmark has read. */
struct cmark_node;
char *prose_tree_to_markup (struct cmark_node *tree);

/* Returns: (transfer full): the words alone. */
char *prose_to_text (const char *commonmark);

/* Notes go on after "Note:", so they begin as a clause does.
 *
 * Returns: (transfer full): @words with a capital at their beginning. */
char *prose_capitalize (const char *words);

/* Returns: the translation, borrowed, or NULL when there is none. */
typedef const char *(*ProseTranslate) (const char *words);

/* Puts one paragraph and heading after the other into another language.
 *
 * Returns: (transfer full): CommonMark; blocks that have no translation, and
 *          those whose translation is no single paragraph, are as they
 *          were. */
char *prose_translate (const char *commonmark, ProseTranslate translate);

G_END_DECLS

#endif
