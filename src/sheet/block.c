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

/* Every block that is higher than @most and has parts, those that hold others
 * before these. */
static GPtrArray *
find_high (Block *block, double most)
{
  GPtrArray *high = g_ptr_array_new ();

  g_ptr_array_add (high, block);
  for (guint i = 0; i < high->len; i++) {
    const Block *holder = g_ptr_array_index (high, i);

    for (guint k = 0; k < holder->parts->len; k++) {
      Block *part = g_ptr_array_index (holder->parts, k);

      if (part->height > most && part->parts->len > 0)
        g_ptr_array_add (high, part);
    }
  }
  return high;
}

static void
stand (Block *block)
{
  for (guint i = 0; block->kind == BLOCK_COLUMNS && i < block->parts->len; i++)
    ((Block *)g_ptr_array_index (block->parts, i))->above = block->gap;
  block->kind = BLOCK_STACK;
  measure (block);
}

void
block_unfold (Block *block, double most)
{
  g_autoptr (GPtrArray) high = NULL;

  if (block->height <= most || block->parts->len == 0)
    return;
  high = find_high (block, most);
  for (guint i = high->len; i-- > 0;)
    stand (g_ptr_array_index (high, i));
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

/* The first part of a stack that does not fit. */
typedef struct Tear {
  Block *stack;
  guint part;
} Tear;

/* Goes down to the innermost block that does not fit.
 *
 * Returns: what of it does not fit, or NULL: it cannot be parted. */
static Block *
tear_down (Block *block, double height, GArray *tears)
{
  while (block->kind == BLOCK_STACK) {
    const Tear tear = { block, count_fitting (block, height) };

    if (tear.part == block->parts->len)
      return NULL;
    g_array_append_val (tears, tear);
    height -= height_of_parts (block, tear.part) + block->padding
              + (tear.part > 0 ? get_part (block, tear.part)->above : 0);
    block = g_ptr_array_index (block->parts, tear.part);
  }
  return block->kind == BLOCK_TEXT ? block_split_text (block, height) : NULL;
}

/* A part that cannot be parted goes on with those before it that want to be
 * kept with it. */
static Block *
tear_off (const Tear *tear, Block *torn)
{
  guint part = tear->part;

  if (torn != NULL)
    return take_rest (tear->stack, part + 1, torn);
  while (part > 0 && get_part (tear->stack, part - 1)->keeps)
    part -= 1;
  return part == 0 ? NULL : take_rest (tear->stack, part, NULL);
}

Block *
block_split (Block *block, double height)
{
  g_autoptr (GArray) tears = g_array_new (FALSE, FALSE, sizeof (Tear));
  Block *rest = tear_down (block, height, tears);

  for (guint i = tears->len; i-- > 0;)
    rest = tear_off (&g_array_index (tears, Tear, i), rest);
  return rest;
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
begin_tag (cairo_t *cr, const char *tag, const char *format, const char *name)
{
  g_autofree char *attributes
      = format == NULL ? NULL : g_strdup_printf (format, name);

  cairo_tag_begin (cr, tag, attributes);
}

static void
paint_own (const Block *block, cairo_t *cr)
{
  cairo_set_source_rgb (cr, 0, 0, 0);
  if (block->has_frame)
    paint_frame (block, cr);
  if (block->kind == BLOCK_TEXT)
    block_paint_text (block, cr);
  else if (block->kind == BLOCK_DRAWING)
    block->draw (cr, block->width, block->height, block->data);
}

static void
enter (const Block *block, cairo_t *cr, double x, double y)
{
  cairo_save (cr);
  cairo_translate (cr, x, y);
  if (block->tag != NULL)
    begin_tag (cr, block->tag, NULL, NULL);
  if (block->name != NULL)
    begin_tag (cr, CAIRO_TAG_DEST, "name='%s'", block->name);
  if (block->link != NULL)
    begin_tag (cr, CAIRO_TAG_LINK, "dest='%s'", block->link);
  paint_own (block, cr);
}

static void
leave (const Block *block, cairo_t *cr)
{
  if (block->link != NULL)
    cairo_tag_end (cr, CAIRO_TAG_LINK);
  if (block->name != NULL)
    cairo_tag_end (cr, CAIRO_TAG_DEST);
  if (block->tag != NULL)
    cairo_tag_end (cr, block->tag);
  cairo_restore (cr);
}

/* A block that is being painted, and the part of it that comes next. */
typedef struct Visit {
  const Block *block;
  guint part;
  double x, y; /* of that part */
} Visit;

static void
visit (GArray *visits, const Block *block, cairo_t *cr, double x, double y)
{
  const Visit visit = { block, 0, block->padding, block->padding };

  enter (block, cr, x, y);
  g_array_append_val (visits, visit);
}

/* Returns: the next part; *@x and *@y are where it goes. */
static const Block *
next_part (Visit *visit, double *x, double *y)
{
  const Block *part = get_part (visit->block, visit->part);
  const gboolean is_stack = visit->block->kind == BLOCK_STACK;

  if (is_stack && visit->part > 0)
    visit->y += part->above;
  *x = visit->x;
  *y = visit->y;
  visit->part += 1;
  visit->x += is_stack ? 0 : part->width + visit->block->gap;
  visit->y += is_stack ? part->height : 0;
  return part;
}

void
block_paint (const Block *block, cairo_t *cr, double x, double y)
{
  g_autoptr (GArray) visits = g_array_new (FALSE, FALSE, sizeof (Visit));

  visit (visits, block, cr, x, y);
  while (visits->len > 0) {
    Visit *last = &g_array_index (visits, Visit, visits->len - 1);

    if (last->part < last->block->parts->len) {
      const Block *part = next_part (last, &x, &y);

      visit (visits, part, cr, x, y);
    } else {
      leave (last->block, cr);
      g_array_set_size (visits, visits->len - 1);
    }
  }
}
