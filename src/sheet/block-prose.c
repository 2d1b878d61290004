#include "block-prose.h"

#include "prose-block.h"

#define INDENT 12.0
#define MARKER 11.0 /* the room of "•" and "2." */
#define BETWEEN 5.0
#define BETWEEN_ITEMS 2.0

static Block *
block_of (const Press *press,
          TextStyle style,
          const ProseBlock *row,
          double width)
{
  switch (row->kind) {
  case PROSE_PARAGRAPH:
    break;
  case PROSE_HEADING:
    return block_text (press, TEXT_LABEL, width, row->markup);
  case PROSE_CODE:
    return block_code (press, width, row->markup);
  }
  return block_text (press, style, width, row->markup);
}

/* A block beside its marker, or beside the room of one. */
static Block *
hang (const Press *press, TextStyle style, const ProseBlock *row, double width)
{
  const double indent
      = (row->depth > 0 ? (row->depth - 1) * INDENT : 0)
        + (row->kind == PROSE_CODE && row->depth == 0 ? INDENT : 0);
  const double marker = row->depth > 0 ? MARKER : 0;
  Block *columns = block_columns (0);

  if (indent > 0)
    block_add (columns, block_stack (indent));
  if (marker > 0)
    block_add (columns, row->marker != NULL
                            ? block_text (press, style, marker, row->marker)
                            : block_stack (marker));
  block_add (columns, block_of (press, style, row, width - indent - marker));
  return columns;
}

Block *
block_prose (const Press *press,
             TextStyle style,
             double width,
             const char *commonmark)
{
  g_autoptr (GPtrArray) rows = prose_to_blocks (commonmark);
  Block *stack = block_stack (width);

  for (guint i = 0; i < rows->len; i++) {
    const ProseBlock *row = g_ptr_array_index (rows, i);
    const gboolean hangs = row->depth > 0 || row->kind == PROSE_CODE;
    Block *block = hangs ? hang (press, style, row, width)
                         : block_of (press, style, row, width);

    block->keeps = row->kind == PROSE_HEADING;
    block_add_below (stack, block,
                     row->marker != NULL ? BETWEEN_ITEMS : BETWEEN);
  }
  return stack;
}
