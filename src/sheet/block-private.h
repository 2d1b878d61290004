/* What block.c and block-text.c share. */
#ifndef BLOCK_PRIVATE_H
#define BLOCK_PRIVATE_H

#include "block.h"

G_BEGIN_DECLS

/* Returns: (transfer full): a block without parts and height. */
Block *block_new (BlockKind kind, double width);

/* block_split() and block_paint() of a text. */
Block *block_split_text (Block *block, double height);
void block_paint_text (const Block *block, cairo_t *cr);

G_END_DECLS

#endif
