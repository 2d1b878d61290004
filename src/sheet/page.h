/* Pages: blocks one below another on sheets of paper, and the file of them.
 *
 *   Pages *pages = pages_new (paper_find ("a4"));
 *
 *   pages_add (pages, block, 12);
 *   pages_write (pages, &words, file, &error);
 *
 * No block is torn that fits on a page; what is to be kept with the block
 * after it is, and pages that are nearly full are filled.
 */
#ifndef PAGE_H
#define PAGE_H

#include "block.h"
#include "pdf.h"

G_BEGIN_DECLS

typedef struct Pages Pages;

Pages *pages_new (const Paper *paper);
void pages_free (Pages *pages);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Pages, pages_free)

/* What blocks have to fit into. Units: pt. */
double pages_width (const Pages *pages);
double pages_height (const Pages *pages);

/* Sets @block, which it takes, @above pt below the last one, or on a page of
 * its own. */
void pages_add (Pages *pages, Block *block, double above);

/* Lets the next block begin a page. */
void pages_break (Pages *pages);

/* Returns: how many pages there are; blocks that are too high for one are
 *          parted now. */
guint pages_count (Pages *pages);

/* Returns: the room that is left on the last page. */
double pages_room (Pages *pages);

/* Paints a page, from 0, on white, with its running heading and number. */
void pages_paint (Pages *pages,
                  guint page,
                  const Press *press,
                  const PdfWords *words,
                  cairo_t *cr);

/* Writes all pages, with a running heading and numbers. Between two pages it is
 * asked whether @cancellable, unless NULL, still wants them.
 *
 * Returns: FALSE with @error set when writing failed, or nobody wants it. */
gboolean pages_write (Pages *pages,
                      const Press *press,
                      const PdfWords *words,
                      FILE *file,
                      GCancellable *cancellable,
                      GError **error);

G_END_DECLS

#endif
