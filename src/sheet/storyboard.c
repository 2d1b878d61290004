#include "storyboard.h"

#include "panel.h"
#include "prose.h"

#include <cairo-pdf.h>
#include <errno.h>
#include <glib/gi18n.h>

/* A4 in points, upright. */
#define PAGE_WIDTH 595.0
#define PAGE_HEIGHT 842.0
#define MARGIN 34.0
#define PER_PAGE 4
#define HEADER 26.0
#define FIRST_HEADER 62.0 /* with the lesson's own words */
#define FOOTER 22.0
#define GAP 11.0

typedef struct Board {
  Session *session;
  cairo_surface_t *surface;
  cairo_t *cr;
  const char *title;
  guint n_panels, n_pages;
} Board;

static cairo_status_t
append_bytes (void *closure, const unsigned char *data, unsigned length)
{
  g_byte_array_append (closure, data, length);
  return CAIRO_STATUS_SUCCESS;
}

static void
describe (Board *board)
{
  cairo_surface_t *surface = board->surface;

  cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                  "2004-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_CREATOR,
                                  "Hull2VD");
  cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_TITLE,
                                  board->title);
}

static void
paint_first_header (Board *board)
{
  Lesson *lesson = session_get_lesson (board->session);
  const double width = PAGE_WIDTH - 2 * MARGIN;
  cairo_rectangle_t area = { MARGIN, MARGIN - 8, width, 22 };
  g_autofree char *title = g_markup_printf_escaped ("<b>%s</b>", board->title);
  g_autofree char *prose = NULL;

  area.y += panel_paint_text (board->cr, title, 17, &area) + 4;
  if (lesson == NULL || lesson->prose == NULL)
    return;
  prose = prose_to_markup (lesson->prose);
  area.height = MARGIN + FIRST_HEADER - 10 - area.y;
  panel_paint_text (board->cr, prose, 9, &area);
}

static void
paint_margins (Board *board, guint page)
{
  const double width = PAGE_WIDTH - 2 * MARGIN;
  const cairo_rectangle_t header = { MARGIN, MARGIN - 8, width, 16 };
  const cairo_rectangle_t footer
      = { MARGIN, PAGE_HEIGHT - MARGIN - 6, width, 14 };
  g_autofree char *title = g_markup_escape_text (board->title, -1);
  /* Translators: page number and number of pages, at the foot of a page. */
  g_autofree char *number
      = g_strdup_printf (_ ("Page %u of %u"), page + 1, board->n_pages);
  g_autofree char *escaped = g_markup_escape_text (number, -1);

  if (page == 0)
    paint_first_header (board);
  else
    panel_paint_text (board->cr, title, 9, &header);
  panel_paint_text (board->cr, escaped, 8, &footer);
}

/* Each panel is an entry of the outline, which leads to its place. */
static void
add_outline (Board *board, const Panel *panel, guint page, double y)
{
  g_autofree char *link
      = g_strdup_printf ("page=%u pos=[%d %d]", page + 1, (int)MARGIN, (int)y);

  cairo_pdf_surface_add_outline (board->surface, CAIRO_PDF_OUTLINE_ROOT,
                                 panel->title, link, 0);
}

static double
header_height (const Board *board, guint page)
{
  const Lesson *lesson = session_get_lesson (board->session);
  const gboolean has_prose
      = lesson != NULL && lesson->prose != NULL && lesson->prose[0] != '\0';

  return page == 0 && has_prose ? FIRST_HEADER : HEADER;
}

static void
paint_page (Board *board, guint page)
{
  const double top = MARGIN + header_height (board, page);
  const double room = PAGE_HEIGHT - MARGIN - FOOTER - top;
  const double height = (room - (PER_PAGE - 1) * GAP) / PER_PAGE;
  guint i;

  paint_margins (board, page);
  for (i = 0; i < PER_PAGE; i++) {
    const guint index = PER_PAGE * page + i;
    const cairo_rectangle_t area
        = { MARGIN, top + i * (height + GAP), PAGE_WIDTH - 2 * MARGIN, height };
    g_autoptr (Panel) panel = NULL;

    if (index >= board->n_panels)
      break;
    panel = panel_new (board->session, index);
    add_outline (board, panel, page, area.y);
    panel_paint (panel, board->session, board->cr, &area);
  }
  cairo_show_page (board->cr);
}

/* Returns: the status of all that was painted. */
static cairo_status_t
paint (Session *session, GByteArray *bytes)
{
  Lesson *lesson = session_get_lesson (session);
  cairo_status_t status;
  Board board = { .session = session };
  guint page;

  board.title = lesson != NULL && lesson->title != NULL
                    ? lesson->title
                    : _ ("A run of QuickHull");
  board.n_panels = panel_count (session);
  board.n_pages = (board.n_panels + PER_PAGE - 1) / PER_PAGE;
  board.surface = cairo_pdf_surface_create_for_stream (append_bytes, bytes,
                                                       PAGE_WIDTH, PAGE_HEIGHT);
  board.cr = cairo_create (board.surface);
  describe (&board);
  for (page = 0; page < board.n_pages; page++)
    paint_page (&board, page);
  status = cairo_status (board.cr);
  cairo_destroy (board.cr);
  cairo_surface_finish (board.surface);
  if (status == CAIRO_STATUS_SUCCESS)
    status = cairo_surface_status (board.surface);
  cairo_surface_destroy (board.surface);
  return status;
}

gboolean
storyboard_write (Session *session, FILE *file, GError **error)
{
  g_autoptr (GByteArray) bytes = g_byte_array_new ();
  const guint stop = session_get_stop (session);
  const guint step = session_get_step (session);
  const cairo_status_t status = paint (session, bytes);

  if (session_get_n_stops (session) > 0)
    session_set_stop (session, stop);
  session_set_step (session, step);
  if (status != CAIRO_STATUS_SUCCESS) {
    g_set_error (error, G_IO_ERROR, G_IO_ERROR_FAILED,
                 _ ("The storyboard could not be drawn: %s"),
                 cairo_status_to_string (status));
    return FALSE;
  }
  if (fwrite (bytes->data, 1, bytes->len, file) == bytes->len
      && fflush (file) == 0)
    return TRUE;
  g_set_error (error, G_IO_ERROR, (int)g_io_error_from_errno (errno),
               _ ("The storyboard could not be written: %s"),
               g_strerror (errno));
  return FALSE;
}
