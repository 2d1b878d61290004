#include "block-private.h"

#define FRAME_WIDTH 0.5
#define FRAME_GREY 0.5

/* Making */

static void
part_free (gpointer part)
{
  block_free (part);
}

Block *
block_new (BlockKind kind, double width)
{
  Block *block = g_new0 (Block, 1);

  block->kind = kind;
  block->width = width;
  block->parts = g_ptr_array_new_with_free_func (part_free);
  return block;
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
    return block_split_text (block, height);
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
    block_paint_text (block, cr);
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
