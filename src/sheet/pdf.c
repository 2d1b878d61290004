#include "pdf.h"

#include <cairo-pdf.h>
#include <errno.h>
#include <glib/gi18n.h>

static const Paper papers[] = {
  { "a4", 595.276, 841.89 },
  { "letter", 612, 792 },
};

const Paper *
paper_find (const char *name)
{
  for (guint i = 0; i < G_N_ELEMENTS (papers); i++)
    if (g_str_equal (papers[i].name, name))
      return &papers[i];
  return NULL;
}

const char *const *
paper_names (void)
{
  static const char *names[G_N_ELEMENTS (papers) + 1];

  for (guint i = 0; i < G_N_ELEMENTS (papers); i++)
    names[i] = papers[i].name;
  return names;
}

static cairo_status_t
append_bytes (void *closure, const unsigned char *data, unsigned length)
{
  g_byte_array_append (closure, data, length);
  return CAIRO_STATUS_SUCCESS;
}

/* The time of making is no matter of the lesson: it is always the same. */
static void
describe (cairo_surface_t *surface, const PdfWords *words)
{
  const struct {
    cairo_pdf_metadata_t kind;
    const char *words;
  } rows[] = {
    { CAIRO_PDF_METADATA_CREATE_DATE, "2004-01-01T00:00:00Z" },
    { CAIRO_PDF_METADATA_CREATOR, "Hull2VD" },
    { CAIRO_PDF_METADATA_TITLE, words->title },
    { CAIRO_PDF_METADATA_AUTHOR, words->author },
    { CAIRO_PDF_METADATA_SUBJECT, words->subject },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    if (rows[i].words != NULL)
      cairo_pdf_surface_set_metadata (surface, rows[i].kind, rows[i].words);
}

void
pdf_begin (Pdf *pdf, const Paper *paper, const PdfWords *words)
{
  pdf->bytes = g_byte_array_new ();
  pdf->surface = cairo_pdf_surface_create_for_stream (
      append_bytes, pdf->bytes, paper->width, paper->height);
  pdf->cr = cairo_create (pdf->surface);
  pdf->page = 1;
  pdf->cancellable = NULL;
  describe (pdf->surface, words);
}

int
pdf_add_outline (Pdf *pdf, int parent, const char *title, double x, double y)
{
  g_autofree char *link
      = g_strdup_printf ("page=%u pos=[%d %d]", pdf->page, (int)x, (int)y);

  return cairo_pdf_surface_add_outline (pdf->surface, parent, title, link, 0);
}

void
pdf_end_page (Pdf *pdf)
{
  cairo_show_page (pdf->cr);
  pdf->page += 1;
}

/* Returns: the status of all that was painted. */
static cairo_status_t
finish (Pdf *pdf)
{
  cairo_status_t status = cairo_status (pdf->cr);

  cairo_destroy (pdf->cr);
  cairo_surface_finish (pdf->surface);
  if (status == CAIRO_STATUS_SUCCESS)
    status = cairo_surface_status (pdf->surface);
  cairo_surface_destroy (pdf->surface);
  return status;
}

gboolean
pdf_end (Pdf *pdf, FILE *file, GError **error)
{
  const cairo_status_t status = finish (pdf);
  g_autoptr (GByteArray) bytes = pdf->bytes;

  if (file == NULL)
    return TRUE;
  if (g_cancellable_set_error_if_cancelled (pdf->cancellable, error))
    return FALSE;
  if (status != CAIRO_STATUS_SUCCESS) {
    g_set_error (error, G_IO_ERROR, G_IO_ERROR_FAILED,
                 _ ("The pages could not be drawn: %s"),
                 cairo_status_to_string (status));
    return FALSE;
  }
  if (fwrite (bytes->data, 1, bytes->len, file) == bytes->len
      && fflush (file) == 0)
    return TRUE;
  g_set_error (error, G_IO_ERROR, (int)g_io_error_from_errno (errno),
               _ ("The pages could not be written: %s"), g_strerror (errno));
  return FALSE;
}
