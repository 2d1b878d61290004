/* Drawings on cairo: the same strokes as vectors, for files and references. */
#include "brush.h"
#include "drawing.h"

#include <stdbool.h>
#include <stddef.h>

static void
trace (cairo_t *cr, const Pixel *pixels, uint32_t n)
{
  uint32_t i;

  cairo_new_sub_path (cr);
  for (i = 0; i < n; i++)
    cairo_line_to (cr, pixels[i].x, pixels[i].y);
}

static void
fill_region (cairo_t *cr, const Stroke *stroke, const Pixel *pixels)
{
  trace (cr, pixels, stroke->n_outer);
  cairo_close_path (cr);
  if (stroke->n > stroke->n_outer) {
    trace (cr, pixels + stroke->n_outer, stroke->n - stroke->n_outer);
    cairo_close_path (cr);
  }
  cairo_set_fill_rule (cr, CAIRO_FILL_RULE_EVEN_ODD);
  brush_colour (cr, stroke->fill);
  cairo_fill (cr);
  cairo_set_fill_rule (cr, CAIRO_FILL_RULE_WINDING);
}

static void
paint (cairo_t *cr, const Drawing *drawing, const Stroke *stroke)
{
  const Pixel *pixels = &drawing->pixels[stroke->first];
  Style style = drawing->styles[stroke->style];

  style.fill = stroke->fill;
  switch (stroke->kind) {
  case STROKE_POLYGON:
    brush_polygon (cr, &style, drawing->theme, pixels, stroke->n);
    break;
  case STROKE_REGION:
    fill_region (cr, stroke, pixels);
    break;
  case STROKE_CASING:
    trace (cr, pixels, stroke->n);
    brush_casing (cr, &style, drawing->theme);
    break;
  case STROKE_LINE:
    trace (cr, pixels, stroke->n);
    brush_line (cr, &style);
    break;
  case STROKE_RING:
    trace (cr, pixels, stroke->n);
    cairo_close_path (cr);
    brush_line (cr, &style);
    break;
  case STROKE_MARK:
    brush_mark (cr, &style, drawing->theme, pixels[0]);
    break;
  }
}

static bool
takes_text (cairo_t *cr)
{
  return cairo_surface_get_type (cairo_get_target (cr))
         == CAIRO_SURFACE_TYPE_PDF;
}

/* The same outlines on every surface; in a PDF the letters are text, to be
 * searched and copied. */
static void
paint_name (cairo_t *cr, const Drawing *drawing, const PlacedName *placed)
{
  brush_colour (cr, drawing->theme->background);
  names_paint_casing (drawing->names, placed->name, cr, placed->at);
  brush_colour (cr, placed->colour);
  if (!takes_text (cr)) {
    names_trace (drawing->names, placed->name, cr, placed->at);
    cairo_fill (cr);
    return;
  }
  names_show (drawing->names, placed->name, cr, placed->at);
}

void
drawing_to_cairo (const Drawing *drawing, cairo_t *cr)
{
  uint32_t i;

  for (i = 0; i < drawing->n_strokes; i++)
    paint (cr, drawing, &drawing->strokes[i]);
  for (i = 0; i < drawing->n_placed; i++)
    paint_name (cr, drawing, &drawing->placed[i]);
}
