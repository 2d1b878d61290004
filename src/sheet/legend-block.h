/* The legend of a document, as a block of its pages. */
#ifndef LEGEND_BLOCK_H
#define LEGEND_BLOCK_H

#include "appearance.h"
#include "block.h"

G_BEGIN_DECLS

/* @rows: of LegendRow; in columns, one below the other.
 *
 * Returns: (transfer full): nothing of @rows is kept. */
Block *legend_block (const GPtrArray *rows,
                     const Press *press,
                     const Appearance *appearance,
                     double width);

G_END_DECLS

#endif
