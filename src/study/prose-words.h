/* The words in blocks of CommonMark, for what reads and translates it. */
#ifndef PROSE_WORDS_H
#define PROSE_WORDS_H

#include "prose.h"

#include <cmark.h>

G_BEGIN_DECLS

/* Returns: (transfer full): the words of a paragraph or heading as CommonMark
 *          on one line, with its emphasis and code; NULL when @block is none
 *          of these. Read again, they are written the same. */
char *prose_block_words (cmark_node *block);

/* Returns: (transfer full): the words of a heading, without markup. */
char *prose_plain_words (cmark_node *heading);

/* Puts the words of a block, or of all blocks in it, into another language. */
void prose_translate_block (cmark_node *block, ProseTranslate translate);

/* Makes @words all that a heading says. */
void prose_set_words (cmark_node *heading, const char *words);

G_END_DECLS

#endif
