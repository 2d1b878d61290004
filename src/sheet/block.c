#include "block.h"

#include <pango/pangocairo.h>

/* The condensed cut is what long words of some languages need; where it is
 * not installed the wide one stands in. */
#define FAMILY "DejaVu Sans Condensed, DejaVu Sans, sans"
#define CODE_FAMILY "DejaVu Sans Mono, monospace"

#define FRAME_WIDTH 0.5
#define FRAME_GREY 0.5

/* Nobody reads a first or last line that stands alone. */
#define LEAST_LINES 2

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

static void
part_free (gpointer part)
{
  block_free (part);
}

static Block *
block_new (BlockKind kind, double width)
{
  Block *block = g_new0 (Block, 1);

  block->kind = kind;
  block->width = width;
  block->parts = g_ptr_array_new_with_free_func (part_free);
  return block;
}

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
block_drawing (double width,
               double height,
               BlockDraw draw,
               gpointer data,
               GDestroyNotify free_data)
{
  Block *block = block_new (BLOCK_DRAWING, width);

  block->height = height;
  block->draw = draw;
  block->data = data;
  block->free_data = free_data;
  return block;
}

Block *
block_stack (double width)
{
  return block_new (BLOCK_STACK, width);
}

Block *
block_frame (double width, double padding)
{
  Block *block = block_stack (width);

  block->has_frame = TRUE;
  block->padding = padding;
  block->height = 2 * padding;
  return block;
}

double
block_inner_width (const Block *block)
{
  return block->width - 2 * block->padding;
}

Block *
block_columns (double gap)
{
  Block *block = block_new (BLOCK_COLUMNS, 0);

  block->gap = gap;
  return block;
}

void
block_free (Block *block)
{
  g_ptr_array_unref (block->parts);
  g_clear_object (&block->layout);
  if (block->free_data != NULL)
    block->free_data (block->data);
  g_free (block->name);
  g_free (block->link);
  g_free (block->title);
  g_free (block);
}

/* Holding */

static void
measure (Block *block)
{
  const gboolean is_stack = block->kind == BLOCK_STACK;

  block->height = 0;
  if (!is_stack)
    block->width = 0;
  for (guint i = 0; i < block->parts->len; i++) {
    const Block *part = g_ptr_array_index (block->parts, i);

    if (is_stack) {
      block->height += part->height + (i > 0 ? part->above : 0);
    } else {
      block->height = MAX (block->height, part->height);
      block->width += part->width + (i > 0 ? block->gap : 0);
    }
  }
  block->height += 2 * block->padding;
}

void
block_add (Block *block, Block *part)
{
  g_ptr_array_add (block->parts, part);
  measure (block);
}

void
block_add_below (Block *block, Block *part, double above)
{
  part->above = above;
  block_add (block, part);
}

/* Parting */

void
block_unfold (Block *block, double most)
{
  if (block->height <= most || block->parts->len == 0)
    return;
  for (guint i = 0; i < block->parts->len; i++) {
    Block *part = g_ptr_array_index (block->parts, i);

    block_unfold (part, most);
    if (block->kind == BLOCK_COLUMNS)
      part->above = block->gap;
  }
  block->kind = BLOCK_STACK;
  measure (block);
}

static Block *
split_text (Block *block, double height)
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

static const Block *
get_part (const Block *block, guint index)
{
  return g_ptr_array_index (block->parts, index);
}

static double
height_of_parts (const Block *block, guint n)
{
  double height = block->padding;

  for (guint i = 0; i < n; i++)
    height += get_part (block, i)->height
              + (i > 0 ? get_part (block, i)->above : 0);
  return height;
}

static guint
count_fitting (const Block *block, double height)
{
  guint n = 0;

  while (n < block->parts->len
         && height_of_parts (block, n + 1) + block->padding <= height)
    n += 1;
  return n;
}

/* Moves the parts from @first on into another stack of the same kind, below
 * @torn, which may be NULL. */
static Block *
take_rest (Block *block, guint first, Block *torn)
{
  Block *rest = block_stack (block->width);

  rest->padding = block->padding;
  rest->has_frame = block->has_frame;
  if (torn != NULL)
    block_add (rest, torn);
  while (first < block->parts->len)
    block_add (rest, g_ptr_array_steal_index (block->parts, first));
  measure (block);
  return rest;
}

/* The first part that does not fit is parted itself, or goes on with those
 * before it that want to be kept with it. */
static Block *
split_stack (Block *block, double height)
{
  guint n = count_fitting (block, height);
  Block *torn;

  if (n == block->parts->len)
    return NULL;
  torn = block_split (g_ptr_array_index (block->parts, n),
                      height - height_of_parts (block, n)
                          - (n > 0 ? get_part (block, n)->above : 0)
                          - block->padding);
  if (torn != NULL)
    return take_rest (block, n + 1, torn);
  while (n > 0 && get_part (block, n - 1)->keeps)
    n -= 1;
  return n == 0 ? NULL : take_rest (block, n, NULL);
}

Block *
block_split (Block *block, double height)
{
  switch (block->kind) {
  case BLOCK_TEXT:
    return split_text (block, height);
  case BLOCK_STACK:
    return split_stack (block, height);
  case BLOCK_DRAWING:
  case BLOCK_COLUMNS:
    break;
  }
  return NULL;
}

/* Painting */

static void
paint_text (const Block *block, cairo_t *cr)
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

static void
paint_frame (const Block *block, cairo_t *cr)
{
  cairo_rectangle (cr, 0, 0, block->width, block->height);
  cairo_set_line_width (cr, FRAME_WIDTH);
  cairo_set_source_rgb (cr, FRAME_GREY, FRAME_GREY, FRAME_GREY);
  cairo_stroke (cr);
  cairo_set_source_rgb (cr, 0, 0, 0);
}

static void
paint_parts (const Block *block, cairo_t *cr)
{
  double x = block->padding, y = block->padding;

  for (guint i = 0; i < block->parts->len; i++) {
    const Block *part = g_ptr_array_index (block->parts, i);

    if (block->kind == BLOCK_STACK && i > 0)
      y += part->above;
    block_paint (part, cr, x, y);
    if (block->kind == BLOCK_STACK)
      y += part->height;
    else
      x += part->width + block->gap;
  }
}

static void
paint_content (const Block *block, cairo_t *cr)
{
  cairo_set_source_rgb (cr, 0, 0, 0);
  if (block->has_frame)
    paint_frame (block, cr);
  if (block->kind == BLOCK_TEXT)
    paint_text (block, cr);
  else if (block->kind == BLOCK_DRAWING)
    block->draw (cr, block->width, block->height, block->data);
  else
    paint_parts (block, cr);
}

static void
begin_tag (cairo_t *cr, const char *tag, const char *format, const char *name)
{
  g_autofree char *attributes
      = format == NULL ? NULL : g_strdup_printf (format, name);

  cairo_tag_begin (cr, tag, attributes);
}

void
block_paint (const Block *block, cairo_t *cr, double x, double y)
{
  cairo_save (cr);
  cairo_translate (cr, x, y);
  if (block->tag != NULL)
    begin_tag (cr, block->tag, NULL, NULL);
  if (block->name != NULL)
    begin_tag (cr, CAIRO_TAG_DEST, "name='%s'", block->name);
  if (block->link != NULL)
    begin_tag (cr, CAIRO_TAG_LINK, "dest='%s'", block->link);
  paint_content (block, cr);
  if (block->link != NULL)
    cairo_tag_end (cr, CAIRO_TAG_LINK);
  if (block->name != NULL)
    cairo_tag_end (cr, CAIRO_TAG_DEST);
  if (block->tag != NULL)
    cairo_tag_end (cr, block->tag);
  cairo_restore (cr);
}
