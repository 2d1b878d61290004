/* A PDF file in the making: in memory, until it is whole. The same pages give
 * the same bytes. */
#ifndef PDF_H
#define PDF_H

#include <cairo.h>
#include <gio/gio.h>
#include <stdio.h>

G_BEGIN_DECLS

typedef struct Paper {
  const char *name;
  double width, height; /* pt, upright */
} Paper;

/* Returns: NULL: there is no such paper. */
const Paper *paper_find (const char *name);

/* Returns: the names, ending with NULL; "a4" is the first. */
const char *const *paper_names (void);

/* What a reader of the file shows of it; NULL: nothing. */
typedef struct PdfWords {
  const char *title, *author, *subject;
} PdfWords;

typedef struct Pdf {
  cairo_t *cr; /* paints on the current page */
  cairo_surface_t *surface;
  GByteArray *bytes;
  guint page;                /* the current one, from 1 */
  GCancellable *cancellable; /* whether it is wanted; NULL at first: it is */
} Pdf;

void pdf_begin (Pdf *pdf, const Paper *paper, const PdfWords *words);

/* Adds an entry to the outline, of a place on the current page.
 *
 * Returns: the entry, for those under it. */
int
pdf_add_outline (Pdf *pdf, int parent, const char *title, double x, double y);
void pdf_end_page (Pdf *pdf);

/* Writes the file, unless @file is NULL, and lets it go.
 *
 * Returns: FALSE with @error set when painting or writing failed, or it is not
 *          wanted any more. */
gboolean pdf_end (Pdf *pdf, FILE *file, GError **error);

G_END_DECLS

#endif
