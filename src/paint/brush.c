#include "brush.h"

#include <math.h>
#include <stddef.h>

#define TURN 6.28318530717958647692
#define HALO_ALPHA 0.5
#define HALO_FILL_ALPHA 0.22
#define HATCH_WIDTH 1.3

void
brush_colour (cairo_t *cr, Colour colour)
{
  cairo_set_source_rgba (cr, colour.red, colour.green, colour.blue,
                         colour.alpha);
}

static Colour
with_alpha (Colour colour, double alpha)
{
  colour.alpha *= alpha;
  return colour;
}

/* A stroke of the hatch: where normal · (x, y) = level crosses the polygon.
 *
 * Returns: false when it misses. */
static bool
hatch_stroke (const Pixel *corners,
              uint32_t n,
              const double line[3],
              Pixel ends[2])
{
  int n_ends = 0;
  uint32_t i;

  for (i = 0; i < n && n_ends < 2; i++) {
    const Pixel a = corners[i], b = corners[(i + 1) % n];
    const double from = line[0] * a.x + line[1] * a.y - line[2];
    const double to = line[0] * b.x + line[1] * b.y - line[2];

    if ((from < 0) == (to < 0))
      continue;
    ends[n_ends].x = a.x + from / (from - to) * (b.x - a.x);
    ends[n_ends].y = a.y + from / (from - to) * (b.y - a.y);
    n_ends++;
  }
  return n_ends == 2;
}

/* How the strokes of a hatch run: normal · (x, y) is a multiple of step. */
typedef struct Strokes {
  double normal[2], step;
} Strokes;

/* Strokes at multiples of the step, so that the hatches of neighbours
 * continue each other. Strokes are cut to the polygon here: a clip or a
 * pattern would not be written the same way twice. */
static void
hatch (cairo_t *cr, const Pixel *corners, uint32_t n, Strokes strokes)
{
  const double x = strokes.normal[0], y = strokes.normal[1];
  double low = INFINITY, high = -INFINITY;
  Pixel ends[2];
  int64_t stroke;
  uint32_t i;

  for (i = 0; i < n; i++) {
    low = fmin (low, x * corners[i].x + y * corners[i].y);
    high = fmax (high, x * corners[i].x + y * corners[i].y);
  }
  for (stroke = (int64_t)ceil (low / strokes.step);
       strokes.step * (double)stroke < high; stroke++) {
    const double level = strokes.step * (double)stroke;

    if (hatch_stroke (corners, n, (double[3]){ x, y, level }, ends)) {
      cairo_move_to (cr, ends[0].x, ends[0].y);
      cairo_line_to (cr, ends[1].x, ends[1].y);
    }
  }
}

static void
hatch_polygon (cairo_t *cr,
               const Style *style,
               const Theme *theme,
               const Pixel *corners,
               uint32_t n)
{
  const double step = theme->hatch_px;
  const double slant = step * sqrt (2);

  switch (style->hatch) {
  case HATCH_NONE:
    return;
  case HATCH_RISING:
    hatch (cr, corners, n, (Strokes){ { 1, 1 }, slant });
    break;
  case HATCH_FALLING:
    hatch (cr, corners, n, (Strokes){ { -1, 1 }, 1.4 * slant });
    break;
  case HATCH_CROSSED:
    hatch (cr, corners, n, (Strokes){ { 1, 1 }, 1.2 * slant });
    hatch (cr, corners, n, (Strokes){ { -1, 1 }, 1.2 * slant });
    break;
  case HATCH_LEVEL:
    hatch (cr, corners, n, (Strokes){ { 0, 1 }, step });
    break;
  case HATCH_UPRIGHT:
    hatch (cr, corners, n, (Strokes){ { 1, 0 }, step });
    break;
  case HATCH_GRID:
    hatch (cr, corners, n, (Strokes){ { 0, 1 }, 1.4 * step });
    hatch (cr, corners, n, (Strokes){ { 1, 0 }, 1.4 * step });
    break;
  }
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_width (cr, HATCH_WIDTH * theme->line_factor);
  brush_colour (cr, style->line);
  cairo_stroke (cr);
}

static void
trace_polygon (cairo_t *cr, const Pixel *corners, uint32_t n)
{
  uint32_t i;

  for (i = 0; i < n; i++)
    cairo_line_to (cr, corners[i].x, corners[i].y);
  cairo_close_path (cr);
}

void
brush_polygon (cairo_t *cr,
               const Style *style,
               const Theme *theme,
               const Pixel *corners,
               uint32_t n)
{
  if (style->fill.alpha > 0) {
    trace_polygon (cr, corners, n);
    brush_colour (cr, style->fill);
    cairo_fill (cr);
  }
  hatch_polygon (cr, style, theme, corners, n);
  if (style->halo.alpha > 0) {
    trace_polygon (cr, corners, n);
    brush_colour (cr, with_alpha (style->halo, HALO_FILL_ALPHA));
    cairo_fill (cr);
    trace_polygon (cr, corners, n);
    brush_colour (cr, style->halo);
    cairo_set_dash (cr, NULL, 0, 0);
    cairo_set_line_width (cr, 0.7 * style->halo_width);
    cairo_stroke (cr);
  }
  if (style->width > 0 && style->line.alpha > 0) {
    trace_polygon (cr, corners, n);
    brush_line (cr, style);
  }
}

void
brush_casing (cairo_t *cr, const Style *style, const Theme *theme)
{
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width (cr, style->casing);
  brush_colour (cr, theme->background);
  cairo_stroke (cr);
}

void
brush_line (cairo_t *cr, const Style *style)
{
  const bool has_dash = style->dash > 0;
  const bool has_dots = has_dash && style->dash < style->width;

  /* Round ends cost cairo twice the time; thin lines end under marks. */
  cairo_set_line_cap (cr, has_dots || (style->casing > 0 && !has_dash)
                              ? CAIRO_LINE_CAP_ROUND
                              : CAIRO_LINE_CAP_BUTT);
  if (style->halo.alpha > 0) {
    cairo_set_dash (cr, NULL, 0, 0);
    cairo_set_line_width (cr, style->width + 2 * style->halo_width);
    brush_colour (cr, with_alpha (style->halo, HALO_ALPHA));
    cairo_stroke_preserve (cr);
  }
  cairo_set_dash (cr, (double[2]){ style->dash, style->gap }, has_dash ? 2 : 0,
                  0);
  cairo_set_line_width (cr, style->width);
  brush_colour (cr, style->line);
  cairo_stroke (cr);
}

static void
trace_circle (cairo_t *cr, Pixel at, double radius)
{
  cairo_new_sub_path (cr);
  cairo_arc (cr, at.x, at.y, radius, 0, TURN);
  cairo_close_path (cr);
}

static void
fill_circle (cairo_t *cr, Pixel at, double radius, Colour colour)
{
  trace_circle (cr, at, radius);
  brush_colour (cr, colour);
  cairo_fill (cr);
}

static void
stroke_circle (cairo_t *cr, Pixel at, double radius, const Style *style)
{
  trace_circle (cr, at, radius);
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_width (cr, style->width);
  brush_colour (cr, style->line);
  cairo_stroke (cr);
}

static void
paint_diamond (cairo_t *cr, const Style *style, Pixel at)
{
  const double r = style->radius;

  cairo_move_to (cr, at.x, at.y - r);
  cairo_line_to (cr, at.x + r, at.y);
  cairo_line_to (cr, at.x, at.y + r);
  cairo_line_to (cr, at.x - r, at.y);
  cairo_close_path (cr);
  brush_colour (cr, style->fill);
  cairo_fill_preserve (cr);
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_width (cr, style->width);
  brush_colour (cr, style->line);
  cairo_stroke (cr);
}

static void
paint_cross (cairo_t *cr, const Style *style, Pixel at)
{
  const double r = style->radius;

  cairo_move_to (cr, at.x - r, at.y - r);
  cairo_line_to (cr, at.x + r, at.y + r);
  cairo_move_to (cr, at.x - r, at.y + r);
  cairo_line_to (cr, at.x + r, at.y - r);
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width (cr, style->width + 2);
  brush_colour (cr, style->fill);
  cairo_stroke_preserve (cr);
  cairo_set_line_width (cr, style->width);
  brush_colour (cr, style->line);
  cairo_stroke (cr);
}

double
brush_mark_reach (const Style *style)
{
  double reach = style->radius + style->width / 2 + style->casing;

  if (style->mark == MARK_RINGED)
    reach += style->ring_gap;
  if (style->halo.alpha > 0)
    reach += style->halo_width;
  return style->mark == MARK_NONE ? 0 : reach;
}

void
brush_mark (cairo_t *cr, const Style *style, const Theme *theme, Pixel at)
{
  const double edge = brush_mark_reach (style);

  if (style->halo.alpha > 0)
    fill_circle (cr, at, edge, style->halo);
  if (style->casing > 0)
    fill_circle (cr, at, edge - (style->halo.alpha > 0 ? style->halo_width : 0),
                 theme->background);
  switch (style->mark) {
  case MARK_NONE:
    break;
  case MARK_DOT:
    fill_circle (cr, at, style->radius, style->line);
    break;
  case MARK_RINGED:
    stroke_circle (cr, at, style->radius + style->ring_gap, style);
    fill_circle (cr, at, style->radius, style->fill);
    stroke_circle (cr, at, style->radius - 0.6, style);
    break;
  case MARK_HOLLOW:
    fill_circle (cr, at, style->radius, style->fill);
    stroke_circle (cr, at, style->radius, style);
    break;
  case MARK_DIAMOND:
    paint_diamond (cr, style, at);
    break;
  case MARK_CROSSED:
    paint_cross (cr, style, at);
    break;
  }
}
