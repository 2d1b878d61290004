#include "storyboard.h"

#include "legend-block.h"
#include "legend.h"
#include "moment.h"
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
#define LEGEND_PT 10.5

typedef struct Board {
  Session *session;
  const Appearance *appearance;
  Pdf pdf;
  const char *title;
  guint n_panels, n_pages;
  GPtrArray *legend; /* of LegendRow: what the panels so far show */
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
paint_panel (Board *board, guint index, const cairo_rectangle_t *area)
{
  g_autoptr (Panel) panel = panel_new (board->session, index);
  LegendMarks marks = { 0 };
  Theme theme;

  pdf_add_outline (&board->pdf, CAIRO_PDF_OUTLINE_ROOT, panel->title, area->x,
                   area->y);
  panel_paint (panel, board->session, board->appearance, board->pdf.cr, area);
  theme_init (&theme, board->appearance);
  moment_add_marks (board->session, MOMENT_SHOWN, MOMENT_VIEWS, &marks);
  legend_gather (board->legend, board->session, &marks, &theme);
}

/* After the last panel, in the place of another one. */
static void
paint_legend (Board *board, const cairo_rectangle_t *area)
{
  const char *title = _ ("Legend");
  g_autofree char *markup = g_markup_printf_escaped ("<b>%s</b>", title);
  g_auto (Press) press;
  g_autoptr (Block) block = NULL;
  double top, part;

  press_init (&press);
  block = legend_block (board->legend, &press, board->appearance, area->width);
  pdf_add_outline (&board->pdf, CAIRO_PDF_OUTLINE_ROOT, title, area->x,
                   area->y);
  top = panel_paint_text (board->pdf.cr, markup, LEGEND_PT, area) + 4;
  part = MIN (1, (area->height - top) / block->height);
  cairo_save (board->pdf.cr);
  cairo_translate (board->pdf.cr, area->x, area->y + top);
  cairo_scale (board->pdf.cr, part, part);
  block_paint (block, board->pdf.cr, 0, 0);
  cairo_restore (board->pdf.cr);
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

    if (index < board->n_panels)
      paint_panel (board, index, &area);
    else if (index == board->n_panels)
      paint_legend (board, &area);
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
  board.n_pages = board.n_panels / PER_PAGE + 1;
  board.legend = legend_new ();
  pdf_begin (&board.pdf, paper_find ("a4"),
             &(PdfWords){ .title = board.title });
  board.pdf.cancellable = cancellable;
  for (guint page = 0;
       page < board.n_pages && !g_cancellable_is_cancelled (cancellable);
       page++)
    paint_page (&board, page);
  g_ptr_array_unref (board.legend);
  if (session_get_n_stops (session) > 0)
    session_set_stop (session, stop);
  session_set_step (session, step);
  return pdf_end (&board.pdf, file, error);
}
