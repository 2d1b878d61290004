/* Prose as blocks: CommonMark set in paragraphs, items that hang on their
 * markers, and code. */
#ifndef BLOCK_PROSE_H
#define BLOCK_PROSE_H

#include "block.h"

G_BEGIN_DECLS

/* Returns: (transfer full): a stack, empty when there are no words. */
Block *block_prose (const Press *press,
                    TextStyle style,
                    double width,
                    const char *commonmark);

G_END_DECLS

#endif
