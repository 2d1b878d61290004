/* Blocks of text: measured, parted and painted by lines. */
#include "block-private.h"

#include <pango/pangocairo.h>

/* The condensed cut is what long words of some languages need; where it is
 * not installed the wide one stands in. */
#define FAMILY "DejaVu Sans Condensed, DejaVu Sans, sans"
#define CODE_FAMILY "DejaVu Sans Mono, monospace"

/* Nobody reads a first or last line that stands alone. */
#define LEAST_LINES 2

/* So small code may be beside other code. */
#define LEAST_CODE 0.78

typedef struct Letters {
  const char *family;
  double size, leading; /* pt; of lines, as a factor */
  PangoWeight weight;
} Letters;

static const Letters letters[] = {
  [TEXT_TITLE] = { FAMILY, 20, 1.0, PANGO_WEIGHT_BOLD },
  [TEXT_HEADING] = { FAMILY, 11.5, 1.0, PANGO_WEIGHT_BOLD },
  [TEXT_LABEL] = { FAMILY, 8.5, 1.0, PANGO_WEIGHT_BOLD },
  [TEXT_BODY] = { FAMILY, 9.25, 1.08, PANGO_WEIGHT_NORMAL },
  [TEXT_SMALL] = { FAMILY, 8, 1.06, PANGO_WEIGHT_NORMAL },
  [TEXT_CODE] = { CODE_FAMILY, 7.5, 1.06, PANGO_WEIGHT_NORMAL },
};

/* Press */

/* Letters are measured as a printer sets them, not as a screen does. */
void
press_init (Press *press)
{
  PangoFontMap *map = pango_cairo_font_map_get_default ();
  cairo_font_options_t *options = cairo_font_options_create ();

  press->scale = 1;
  press->context = pango_font_map_create_context (map);
  cairo_font_options_set_hint_style (options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics (options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options (press->context, options);
  pango_cairo_context_set_resolution (press->context, 72);
  pango_context_set_round_glyph_positions (press->context, FALSE);
  cairo_font_options_destroy (options);
}

void
press_clear (Press *press)
{
  g_clear_object (&press->context);
}

/* Making */

static PangoLayout *
layout_new (const Press *press, TextStyle style, const char *markup)
{
  const Letters *row = &letters[style];
  PangoLayout *layout = pango_layout_new (press->context);
  PangoFontDescription *font = pango_font_description_from_string (row->family);

  pango_font_description_set_weight (font, row->weight);
  pango_font_description_set_absolute_size (font, press->scale * row->size
                                                      * PANGO_SCALE);
  pango_layout_set_font_description (layout, font);
  pango_layout_set_line_spacing (layout, (float)row->leading);
  pango_layout_set_wrap (layout, PANGO_WRAP_WORD_CHAR);
  pango_layout_set_markup (layout, markup, -1);
  pango_font_description_free (font);
  return layout;
}

/* Where lines @first … @last - 1 begin and end, or as many of them as end
 * within @most.
 *
 * Returns: the line after them. */
static int
measure_lines (
    PangoLayout *layout, int first, int last, double most, double *height)
{
  PangoLayoutIter *iter = pango_layout_get_iter (layout);
  PangoRectangle extents;
  int line = 0, top = 0;

  *height = 0;
  do {
    pango_layout_iter_get_line_extents (iter, NULL, &extents);
    if (line == first)
      top = extents.y;
    if (line >= first) {
      const double bottom
          = (double)(extents.y + extents.height - top) / PANGO_SCALE;

      if (bottom > most)
        break;
      *height = bottom;
    }
    line += 1;
  } while (line < last && pango_layout_iter_next_line (iter));
  pango_layout_iter_free (iter);
  return line;
}

static Block *
text_new (PangoLayout *layout, double width)
{
  Block *block = block_new (BLOCK_TEXT, width);

  block->layout = layout;
  block->last = pango_layout_get_line_count (layout);
  measure_lines (layout, 0, block->last, G_MAXDOUBLE, &block->height);
  block->tag = "P";
  return block;
}

Block *
block_text (const Press *press,
            TextStyle style,
            double width,
            const char *markup)
{
  PangoLayout *layout = layout_new (press, style, markup);

  pango_layout_set_width (layout, (int)(width * PANGO_SCALE));
  return text_new (layout, width);
}

Block *
block_word (const Press *press, TextStyle style, const char *markup)
{
  PangoLayout *layout = layout_new (press, style, markup);
  int width;

  pango_layout_get_size (layout, &width, NULL);
  return text_new (layout, (double)width / PANGO_SCALE);
}

Block *
block_code (const Press *press, double width, const char *markup)
{
  g_autoptr (Block) line = block_word (press, TEXT_CODE, markup);
  const Press smaller
      = { press->context,
          press->scale * CLAMP (width / line->width, LEAST_CODE, 1) };

  return block_text (line->width > width ? &smaller : press, TEXT_CODE, width,
                     markup);
}

/* Parting and painting */

Block *
block_split_text (Block *block, double height)
{
  double taken;
  const int fitting = measure_lines (block->layout, block->first, block->last,
                                     height, &taken);
  const int line = MIN (fitting, block->last - LEAST_LINES);
  Block *rest;

  if (line < block->first + LEAST_LINES)
    return NULL;
  rest = block_new (BLOCK_TEXT, block->width);
  rest->layout = g_object_ref (block->layout);
  rest->first = line;
  rest->last = block->last;
  rest->tag = block->tag;
  measure_lines (rest->layout, line, rest->last, G_MAXDOUBLE, &rest->height);
  block->last = line;
  measure_lines (block->layout, block->first, line, G_MAXDOUBLE,
                 &block->height);
  return rest;
}

void
block_paint_text (const Block *block, cairo_t *cr)
{
  PangoLayoutIter *iter = pango_layout_get_iter (block->layout);
  int top = 0, line = 0;
  PangoRectangle extents;

  do {
    pango_layout_iter_get_line_extents (iter, NULL, &extents);
    if (line == block->first)
      top = extents.y;
    if (line >= block->first) {
      cairo_move_to (cr, (double)extents.x / PANGO_SCALE,
                     (double)(pango_layout_iter_get_baseline (iter) - top)
                         / PANGO_SCALE);
      pango_cairo_show_layout_line (cr,
                                    pango_layout_iter_get_line_readonly (iter));
    }
    line += 1;
  } while (line < block->last && pango_layout_iter_next_line (iter));
  pango_layout_iter_free (iter);
}
