#include "storyboard.h"

#include "panel.h"
#include "pdf.h"
#include "prose.h"

#include <cairo-pdf.h>
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
  const Appearance *appearance;
  Pdf pdf;
  const char *title;
  guint n_panels, n_pages;
} Board;

static void
paint_first_header (Board *board)
{
  Lesson *lesson = session_get_lesson (board->session);
  const double width = PAGE_WIDTH - 2 * MARGIN;
  cairo_rectangle_t area = { MARGIN, MARGIN - 8, width, 22 };
  g_autofree char *title = g_markup_printf_escaped ("<b>%s</b>", board->title);
  g_autofree char *prose = NULL;

  area.y += panel_paint_text (board->pdf.cr, title, 17, &area) + 4;
  if (lesson == NULL || lesson->prose == NULL)
    return;
  prose = prose_to_markup (lesson->prose);
  area.height = MARGIN + FIRST_HEADER - 10 - area.y;
  panel_paint_text (board->pdf.cr, prose, 9, &area);
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
    panel_paint_text (board->pdf.cr, title, 9, &header);
  panel_paint_text (board->pdf.cr, escaped, 8, &footer);
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
    pdf_add_outline (&board->pdf, CAIRO_PDF_OUTLINE_ROOT, panel->title, area.x,
                     area.y);
    panel_paint (panel, board->session, board->appearance, board->pdf.cr,
                 &area);
  }
  pdf_end_page (&board->pdf);
}

gboolean
storyboard_write (Session *session,
                  const Appearance *appearance,
                  FILE *file,
                  GCancellable *cancellable,
                  GError **error)
{
  const Lesson *lesson = session_get_lesson (session);
  const guint stop = session_get_stop (session);
  const guint step = session_get_step (session);
  Board board = { .session = session, .appearance = appearance };

  board.title = lesson != NULL && lesson->title != NULL
                    ? lesson->title
                    : _ ("A run of QuickHull");
  board.n_panels = panel_count (session);
  board.n_pages = (board.n_panels + PER_PAGE - 1) / PER_PAGE;
  pdf_begin (&board.pdf, paper_find ("a4"),
             &(PdfWords){ .title = board.title });
  board.pdf.cancellable = cancellable;
  for (guint page = 0;
       page < board.n_pages && !g_cancellable_is_cancelled (cancellable);
       page++)
    paint_page (&board, page);
  if (session_get_n_stops (session) > 0)
    session_set_stop (session, stop);
  session_set_step (session, step);
  return pdf_end (&board.pdf, file, error);
}
