#include "legend-block.h"

#include "legend.h"
#include "painter.h"

/* Samples are as large as in the window, on paper. */
#define PX_PER_PT 1.64
#define SWATCH_WIDTH 20.0
#define SWATCH_HEIGHT 11.0
#define SWATCH_GAP 6.0
#define ROW_GAP 1.5
#define COLUMN_GAP 12.0
#define COLUMN_WIDTH 118.0 /* at least */

typedef struct Swatch {
  SceneItem sample;
  Appearance appearance;
} Swatch;

static void
draw (cairo_t *cr, double width, double height, gpointer data)
{
  const Swatch *swatch = data;
  Theme theme;

  theme_init (&theme, &swatch->appearance);
  cairo_save (cr);
  cairo_rectangle (cr, 0, 0, width, height);
  cairo_set_source_rgb (cr, theme.background.red, theme.background.green,
                        theme.background.blue);
  cairo_fill (cr);
  cairo_scale (cr, 1 / PX_PER_PT, 1 / PX_PER_PT);
  painter_swatch (cr, &swatch->sample, &theme, width * PX_PER_PT,
                  height * PX_PER_PT);
  cairo_restore (cr);
}

static Block *
row_block (const LegendRow *row,
           const Press *press,
           const Appearance *appearance,
           double width)
{
  Block *columns = block_columns (SWATCH_GAP);
  Swatch *swatch = g_new (Swatch, 1);
  g_autofree char *markup = g_markup_escape_text (row->text, -1);

  *swatch = (Swatch){ row->sample, *appearance };
  block_add (columns,
             block_drawing (SWATCH_WIDTH, SWATCH_HEIGHT, draw, swatch, g_free));
  block_add (columns, block_text (press, TEXT_SMALL,
                                  width - SWATCH_WIDTH - SWATCH_GAP, markup));
  return columns;
}

Block *
legend_block (const GPtrArray *rows,
              const Press *press,
              const Appearance *appearance,
              double width)
{
  const guint n_columns
      = MAX (1, (guint)((width + COLUMN_GAP) / (COLUMN_WIDTH + COLUMN_GAP)));
  const guint n_rows = (rows->len + n_columns - 1) / n_columns;
  const double column = (width - (n_columns - 1) * COLUMN_GAP) / n_columns;
  Block *columns = block_columns (COLUMN_GAP);

  for (guint first = 0; first < rows->len; first += n_rows) {
    Block *stack = block_stack (column);

    for (guint i = first; i < MIN (first + n_rows, rows->len); i++)
      block_add_below (
          stack,
          row_block (g_ptr_array_index (rows, i), press, appearance, column),
          ROW_GAP);
    block_add (columns, stack);
  }
  return columns;
}
