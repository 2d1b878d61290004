#include "form.h"

#define BOX 7.5
#define BOX_COLUMN 14.0
#define ROOMY_BOX 13.0
#define ROOMY_COLUMN 20.0
#define LINE_APART 19.0
#define LINE_WIDTH 0.5
#define NUMBER_WIDTH 44.0 /* of a line to write a number upon */
#define GAP 6.0

static void
set_line (cairo_t *cr)
{
  cairo_set_line_width (cr, LINE_WIDTH);
  cairo_set_source_rgb (cr, 0.35, 0.35, 0.35);
}

/* Boxes */

static void
draw_box (cairo_t *cr, double width, double height, gpointer data)
{
  const FormMark mark = (FormMark)GPOINTER_TO_UINT (data);
  const double side = mark == FORM_ROOMY ? ROOMY_BOX : BOX;
  const double x = 0.5, y = (height - side) / 2;

  (void)width;
  cairo_set_line_width (cr, 0.7);
  if (mark == FORM_SOLID) {
    cairo_new_path (cr);
    cairo_arc (cr, x + BOX / 2, y + BOX / 2, 1.6, 0, 2 * G_PI);
    cairo_fill (cr);
    return;
  }
  cairo_rectangle (cr, x, y, side, side);
  cairo_stroke (cr);
  if (mark != FORM_CROSSED)
    return;
  cairo_set_line_width (cr, 1.3);
  cairo_move_to (cr, x - 1, y - 1);
  cairo_line_to (cr, x + BOX + 1, y + BOX + 1);
  cairo_move_to (cr, x + BOX + 1, y - 1);
  cairo_line_to (cr, x - 1, y + BOX + 1);
  cairo_stroke (cr);
}

Block *
form_choice (const Press *press,
             double width,
             const char *markup,
             FormMark mark)
{
  const double column = mark == FORM_ROOMY ? ROOMY_COLUMN : BOX_COLUMN;
  g_autoptr (Block) line = block_word (press, TEXT_BODY, "x");
  Block *columns = block_columns (0);

  block_add (columns, block_drawing (column, line->height, draw_box,
                                     GUINT_TO_POINTER (mark), NULL));
  block_add (columns, block_text (press, TEXT_BODY, width - column, markup));
  return columns;
}

/* Lines */

static void
draw_lines (cairo_t *cr, double width, double height, gpointer data)
{
  (void)data;
  set_line (cr);
  for (double y = LINE_APART; y <= height + LINE_WIDTH; y += LINE_APART) {
    cairo_move_to (cr, 0, y - LINE_WIDTH);
    cairo_rel_line_to (cr, width, 0);
  }
  cairo_stroke (cr);
}

Block *
form_lines (double width, guint n_lines)
{
  return block_drawing (width, n_lines * LINE_APART, draw_lines, NULL, NULL);
}

guint
form_lines_in (double height)
{
  return height < 0 ? 0 : (guint)(height / LINE_APART);
}

static void
draw_base_line (cairo_t *cr, double width, double height, gpointer data)
{
  (void)data;
  set_line (cr);
  cairo_move_to (cr, 0, height - LINE_WIDTH);
  cairo_rel_line_to (cr, width, 0);
  cairo_stroke (cr);
}

static Block *
entry_line (const Press *press, double width, double height, const char *value)
{
  g_autofree char *markup
      = value == NULL ? NULL : g_markup_printf_escaped ("<b>%s</b>", value);

  return value == NULL
             ? block_drawing (width, height, draw_base_line, NULL, NULL)
             : block_text (press, TEXT_BODY, width, markup);
}

Block *
form_entry (const Press *press, double width, const char *markup)
{
  Block *columns = block_columns (GAP);
  Block *label = block_word (press, TEXT_BODY, markup);

  block_add (columns, label);
  block_add (columns, entry_line (press, width - GAP - label->width,
                                  label->height, NULL));
  return columns;
}

Block *
form_number (const Press *press,
             double width,
             const char *markup,
             const char *value)
{
  Block *columns = block_columns (GAP);
  Block *label
      = block_text (press, TEXT_BODY, width - GAP - NUMBER_WIDTH, markup);

  block_add (columns, label);
  block_add (columns, entry_line (press, NUMBER_WIDTH, label->height, value));
  return columns;
}

/* Frames */

static void
draw_field (cairo_t *cr, double width, double height, gpointer data)
{
  (void)data;
  set_line (cr);
  cairo_rectangle (cr, 0, 0, width, height);
  cairo_stroke (cr);
}

Block *
form_field (double width, double height)
{
  return block_drawing (width, height, draw_field, NULL, NULL);
}

Block *
form_rule (double width)
{
  return block_drawing (width, 1, draw_base_line, NULL, NULL);
}
