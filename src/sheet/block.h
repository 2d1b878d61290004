/* Blocks: what pages are made of. A block knows its width and its height
 * before it is painted; others hold it, or a page sets it below the last one
 * (page.h).
 *
 *   Block *block = block_stack (width);
 *
 *   block_add (block, block_text (press, TEXT_HEADING, width, "The horizon"));
 *   block_add (block, block_drawing (width, 120, draw, data, g_free));
 *
 * Units: pt.
 */
#ifndef BLOCK_H
#define BLOCK_H

#include <cairo.h>
#include <glib.h>
#include <pango/pango.h>

G_BEGIN_DECLS

typedef enum TextStyle {
  TEXT_TITLE,
  TEXT_HEADING, /* of a stop */
  TEXT_LABEL,   /* of a part: small, bold */
  TEXT_BODY,
  TEXT_SMALL, /* captions, notes, reasons */
  TEXT_CODE,
} TextStyle;

/* What letters are set with. */
typedef struct Press {
  PangoContext *context;
  double scale; /* of all letters; 1: as they should be */
} Press;

void press_init (Press *press);
void press_clear (Press *press);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Press, press_clear)

typedef struct Block Block;

/* Draws in a rectangle of the block's size whose upper left corner is the
 * origin. */
typedef void (*BlockDraw) (cairo_t *cr,
                           double width,
                           double height,
                           gpointer data);

typedef enum BlockKind {
  BLOCK_TEXT,
  BLOCK_DRAWING,
  BLOCK_STACK,   /* parts one below another */
  BLOCK_COLUMNS, /* parts side by side, their tops level */
} BlockKind;

struct Block {
  BlockKind kind;
  double width, height;
  double above;        /* space over it, but for the first of a page */
  double gap, padding; /* between columns; inside a frame */
  gboolean has_frame;
  gboolean keeps;      /* stands on the page of what follows it */
  const char *tag;     /* of the PDF's structure: "P", "H1"; or NULL */
  char *name;          /* a place that links lead to, or NULL */
  char *link;          /* the place that it leads to, or NULL */
  char *title;         /* its entry in the outline, or NULL */
  guint level;         /* of that entry, from 1 */
  GPtrArray *parts;    /* of Block */
  PangoLayout *layout; /* of a text; its lines first … last - 1 */
  int first, last;
  BlockDraw draw;
  gpointer data;
  GDestroyNotify free_data;
};

/* Shape: as wide as @width; a word that is wider is broken. */
Block *block_text (const Press *press,
                   TextStyle style,
                   double width,
                   const char *markup);

/* Code, whose lines should not be broken: smaller where that helps, down to
 * three quarters. */
Block *block_code (const Press *press, double width, const char *markup);

/* A text as wide as its words, on one line. */
Block *block_word (const Press *press, TextStyle style, const char *markup);

/* Takes @data. */
Block *block_drawing (double width,
                      double height,
                      BlockDraw draw,
                      gpointer data,
                      GDestroyNotify free_data);
Block *block_stack (double width);

/* A stack in a fine frame, whose parts are narrower: block_inner_width(). */
Block *block_frame (double width, double padding);
double block_inner_width (const Block *block);
Block *block_columns (double gap);

/* Puts @part, which it takes, after the others. */
void block_add (Block *block, Block *part);

/* The same, @above pt below the others. */
void block_add_below (Block *block, Block *part, double above);

/* Lets columns that are higher than @most stand one below another, so that
 * they can be parted. */
void block_unfold (Block *block, double most);

/* Returns: (transfer full): the parts or lines of @block that do not fit into
 *          @height, which it then has no more; NULL when it cannot be parted
 *          there. */
Block *block_split (Block *block, double height);

/* Paints it with its upper left corner there. */
void block_paint (const Block *block, cairo_t *cr, double x, double y);

void block_free (Block *block);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Block, block_free)

G_END_DECLS

#endif
