/* Prose in blocks: what a page sets one below another. */
#ifndef PROSE_BLOCK_H
#define PROSE_BLOCK_H

#include <glib.h>

G_BEGIN_DECLS

typedef enum ProseKind {
  PROSE_PARAGRAPH,
  PROSE_HEADING,
  PROSE_CODE,
} ProseKind;

typedef struct ProseBlock {
  ProseKind kind;
  guint depth;  /* of lists and quotations round it, 0: none */
  char *marker; /* "•" or "2." before the first block of an item, or NULL */
  char *markup; /* as prose_to_markup() writes it */
} ProseBlock;

/* Returns: (transfer full) (element-type ProseBlock): in their order. */
GPtrArray *prose_to_blocks (const char *commonmark);

G_END_DECLS

#endif
