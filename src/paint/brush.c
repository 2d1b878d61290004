#include "brush.h"

#include <math.h>
#include <stddef.h>

#define FINE_STEP 0.375 /* whole pixels of the usual 8 */
#define TURN 6.28318530717958647692

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

int
brush_hatch_directions (const Style *style,
                        const Theme *theme,
                        HatchDirection directions[2])
{
  const double step = theme->hatch_px;
  const double slant = step * sqrt (2);
  const HatchDirection level = { { 0, 1 }, step };
  const HatchDirection upright = { { 1, 0 }, step };
  const HatchDirection rising = { { 1, 1 }, slant };
  const HatchDirection falling = { { -1, 1 }, slant };

  directions[0] = rising;
  switch (style->hatch) {
  case HATCH_NONE:
    return 0;
  case HATCH_RISING:
    return 1;
  case HATCH_FALLING:
    directions[0] = falling;
    directions[0].step *= 1.4;
    return 1;
  case HATCH_LEVEL:
    directions[0] = level;
    return 1;
  case HATCH_UPRIGHT:
    directions[0] = upright;
    return 1;
  case HATCH_CLOSE:
    directions[0] = upright;
    directions[0].step /= 2;
    return 1;
  case HATCH_FINE:
    directions[0] = level;
    directions[0].step *= FINE_STEP;
    return 1;
  case HATCH_CROSSED:
    directions[1] = falling;
    break;
  }
  directions[0].step *= 1.2;
  directions[1].step *= 1.2;
  return 2;
}

/* A hatch while it is drawn. */
typedef struct Hatching {
  const Pixel *corners;
  uint32_t n;
  BrushHatch on_stroke;
  void *user;
} Hatching;

/* Strokes at multiples of the step, so that the hatches of neighbours
 * continue each other. Strokes are cut to the polygon here: a clip or a
 * pattern would not be written the same way twice. */
static void
hatch (const Hatching *hatching, HatchDirection direction)
{
  const double x = direction.normal[0], y = direction.normal[1];
  double low = INFINITY, high = -INFINITY;
  Pixel ends[2];
  int64_t stroke;
  uint32_t i;

  for (i = 0; i < hatching->n; i++) {
    const Pixel corner = hatching->corners[i];

    low = fmin (low, x * corner.x + y * corner.y);
    high = fmax (high, x * corner.x + y * corner.y);
  }
  for (stroke = (int64_t)ceil (low / direction.step);
       direction.step * (double)stroke < high; stroke++) {
    const double line[3] = { x, y, direction.step * (double)stroke };

    if (hatch_stroke (hatching->corners, hatching->n, line, ends))
      hatching->on_stroke (ends, hatching->user);
  }
}

void
brush_hatch (const Style *style,
             const Theme *theme,
             const Pixel *corners,
             uint32_t n,
             BrushHatch on_stroke,
             void *user)
{
  const Hatching hatching = { corners, n, on_stroke, user };
  HatchDirection directions[2];
  const int n_directions = brush_hatch_directions (style, theme, directions);
  int i;

  for (i = 0; i < n_directions; i++)
    hatch (&hatching, directions[i]);
}

static void
trace_stroke (const Pixel ends[2], void *user)
{
  cairo_t *cr = user;

  cairo_move_to (cr, ends[0].x, ends[0].y);
  cairo_line_to (cr, ends[1].x, ends[1].y);
}

static void
hatch_polygon (cairo_t *cr,
               const Style *style,
               const Theme *theme,
               const Pixel *corners,
               uint32_t n)
{
  if (style->hatch == HATCH_NONE)
    return;
  brush_hatch (style, theme, corners, n, trace_stroke, cr);
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_width (cr, style->hatch_width);
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
    brush_colour (cr, with_alpha (style->halo, BRUSH_HALO_FILL_ALPHA));
    cairo_fill (cr);
    trace_polygon (cr, corners, n);
    brush_colour (cr, style->halo);
    cairo_set_dash (cr, NULL, 0, 0);
    cairo_set_line_width (cr, BRUSH_HALO_OUTLINE * style->halo_width);
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

/* Round ends cost twice the time; thin lines end under marks. */
bool
brush_has_round_ends (const Style *style)
{
  const bool has_dash = style->dash > 0;

  return has_dash ? style->dash < style->width : style->casing > 0;
}

void
brush_line (cairo_t *cr, const Style *style)
{
  const bool has_dash = style->dash > 0;

  cairo_set_line_cap (cr, brush_has_round_ends (style) ? CAIRO_LINE_CAP_ROUND
                                                       : CAIRO_LINE_CAP_BUTT);
  if (style->halo.alpha > 0) {
    cairo_set_dash (cr, NULL, 0, 0);
    cairo_set_line_width (cr, style->width + 2 * style->halo_width);
    brush_colour (cr, with_alpha (style->halo, BRUSH_HALO_ALPHA));
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

/* A site may lie under it: its casing is no more than an outline. */
static void
paint_diamond (cairo_t *cr, const Style *style, const Theme *theme, Pixel at)
{
  const double r = style->radius;

  cairo_move_to (cr, at.x, at.y - r);
  cairo_line_to (cr, at.x + r, at.y);
  cairo_line_to (cr, at.x, at.y + r);
  cairo_line_to (cr, at.x - r, at.y);
  cairo_close_path (cr);
  cairo_set_dash (cr, NULL, 0, 0);
  if (style->casing > 0) {
    cairo_set_line_width (cr, style->width + 2 * style->casing);
    brush_colour (cr, theme->background);
    cairo_stroke_preserve (cr);
  }
  brush_colour (cr, style->fill);
  cairo_fill_preserve (cr);
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
  if (style->casing > 0 && style->mark != MARK_DIAMOND)
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
    paint_diamond (cr, style, theme, at);
    break;
  case MARK_CROSSED:
    paint_cross (cr, style, at);
    break;
  }
}
