/* The legend's samples: a role as it is drawn, in the weight that the theme
 * gives it as far as there is room. */
#include "brush.h"
#include "painter.h"

#include <glib.h>
#include <math.h>

#define SAMPLE_HATCH 0.7

/* What a role is drawn as. */
typedef enum Sample {
  SAMPLE_AREA,
  SAMPLE_LINE,
  SAMPLE_CIRCLE,
  SAMPLE_SQUARE,
  SAMPLE_TRIANGLE,
  SAMPLE_MARK,
} Sample;

static bool
is_answer (Role role)
{
  return role >= ROLE_ANSWER_CHOSEN && role <= ROLE_ANSWER_MISSED;
}

/* Sites that are answered have a ring, all else an outline. */
static Sample
sample_of (const SceneItem *item)
{
  const Role role = item->role;

  if (role >= ROLE_VORONOI_VERTEX)
    return SAMPLE_MARK;
  if (is_answer (role) && item->shape == SHAPE_MARK)
    return SAMPLE_CIRCLE;
  if (role == ROLE_LIT)
    return SAMPLE_TRIANGLE;
  if (role >= ROLE_CIRCLE && role <= ROLE_ELLIPSE)
    return SAMPLE_CIRCLE;
  if (role == ROLE_SIGN_NODE)
    return SAMPLE_SQUARE;
  if (role == ROLE_GROUND || role == ROLE_RIM || role == ROLE_SELECTED_FACET
      || role == ROLE_RETIRED || role >= ROLE_VORONOI_EDGE)
    return SAMPLE_LINE;
  return SAMPLE_AREA;
}

#define BORDER 1.4 /* px, of an area that has none */
#define BORDER_CONTRAST 3.0

/* A patch of a plane is seen aslant, of the width. */
#define PATCH_SLANT 0.25

/* Returns: a shade of @fill that stands out from the ground. */
static Colour
border_of (Colour fill, const Theme *theme)
{
  double part = 0.35;
  Colour shade = colour_mix (theme->background, fill, fill.alpha), border;

  shade.alpha = 1;
  do {
    border = colour_mix (shade, theme->text, part);
    part += 0.05;
  } while (part <= 1
           && colour_contrast (border, theme->background) < BORDER_CONTRAST);
  return border;
}

/* A facet of the legend has a border in a shade of itself, and its hatch is
 * close enough to be seen to be one. */
static void
paint_area (cairo_t *cr,
            const Style *style,
            const Theme *theme,
            double slant,
            const double size[2])
{
  const double width = MAX (BORDER, style->width);
  const double inset = width / 2;
  const Pixel corners[4]
      = { { inset + slant * size[0], inset },
          { size[0] - inset, inset },
          { size[0] - inset - slant * size[0], size[1] - inset },
          { inset, size[1] - inset } };
  Theme close = *theme;
  Style bordered = *style;

  close.hatch_px *= SAMPLE_HATCH;
  bordered.width = width;
  if (style->line.alpha <= 0)
    bordered.line = border_of (style->fill, theme);
  brush_polygon (cr, &bordered, &close, corners, 4);
}

#define N_CELLS 3

/* Cells have as many hues as there are sites: a few of them. */
static void
paint_cells (cairo_t *cr,
             const SceneItem *item,
             const Theme *theme,
             const double size[2])
{
  Style style = theme_style (theme, item);
  SceneItem cell = *item;

  for (uint32_t i = 0; i < N_CELLS; i++) {
    const double left = 1 + i * (size[0] - 2) / N_CELLS;
    const double right = left + (size[0] - 2) / N_CELLS;
    const Pixel corners[4] = {
      { left, 1 }, { right, 1 }, { right, size[1] - 1 }, { left, size[1] - 1 }
    };

    cell.hue = i;
    style.fill = theme_style (theme, &cell).fill;
    brush_polygon (cr, &style, theme, corners, 4);
  }
  style.line = border_of (style.fill, theme);
  style.fill.alpha = 0;
  paint_area (cr, &style, theme, 0, size);
}

#define N_WIRES 3 /* spaces between upright wires */

static void
trace_wires (cairo_t *cr, const double size[2])
{
  for (int i = 1; i < N_WIRES; i++) {
    cairo_move_to (cr, i * size[0] / N_WIRES, 1);
    cairo_line_to (cr, i * size[0] / N_WIRES, size[1] - 1);
  }
  cairo_move_to (cr, 1, size[1] / 2);
  cairo_line_to (cr, size[0] - 1, size[1] / 2);
}

/* The paraboloid is known by its wires, and by its rim round them. */
static void
paint_sheet (cairo_t *cr,
             const SceneItem *item,
             const Theme *theme,
             const double size[2])
{
  const SceneItem rim_item
      = { .shape = SHAPE_PATH, .role = ROLE_RIM, .emphasis = item->emphasis };
  const Style wire = theme_style (theme, item);
  Style rim = theme_style (theme, &rim_item);

  rim.fill = wire.fill;
  trace_wires (cr, size);
  brush_line (cr, &wire);
  paint_area (cr, &rim, theme, 0, size);
}

#define TICK 4.5           /* px, half of it */
#define TRIANGLE_PART 0.18 /* of the height, for a side */

/* A triangle as it is lit, with its outline. */
static void
paint_triangle (cairo_t *cr,
                const SceneItem *item,
                const Theme *theme,
                const double size[2])
{
  const SceneItem inside = { .shape = SHAPE_POLYGON,
                             .role = ROLE_TRIANGLE,
                             .emphasis = item->emphasis,
                             .lit = item->lit };
  const Style area = theme_style (theme, &inside);
  Style outline = theme_style (theme, item);
  const double width = MIN (outline.width, TRIANGLE_PART * size[1]);
  const double inset = width / 2 + 0.5;
  const Pixel corners[3] = { { 2 * inset, size[1] - inset },
                             { 0.4 * size[0], inset },
                             { size[0] - 2 * inset, size[1] - inset } };

  brush_polygon (cr, &area, theme, corners, 3);
  outline.width = width;
  outline.fill.alpha = 0;
  brush_polygon (cr, &outline, theme, corners, 3);
}

/* Thin lines are sharp when they cover whole pixels. */
static void
trace_sample (cairo_t *cr, Sample sample, double width, const double size[2])
{
  const double sharp = fmod (floor (width + 0.5), 2) / 2;
  const double middle = floor (size[1] / 2) + sharp;
  if (sample == SAMPLE_CIRCLE) {
    const double radius
        = MIN (size[0], size[1]) / 2 - MAX (1.5, 0.5 + width / 2);

    cairo_new_sub_path (cr);
    cairo_arc (cr, size[0] / 2, size[1] / 2, radius, 0, 2 * G_PI);
    return;
  }
  if (sample == SAMPLE_SQUARE) {
    const double side = MIN (size[0], size[1]) / 2;

    cairo_rectangle (cr, (size[0] - side) / 2, (size[1] - side) / 2, side,
                     side);
    return;
  }
  cairo_move_to (cr, 2, middle);
  cairo_line_to (cr, size[0] - 2, middle);
}

static void
scale (Style *style, double factor)
{
  style->width *= factor;
  style->casing *= factor;
  style->dash *= factor;
  style->gap *= factor;
  style->radius *= factor;
  style->ring_gap *= factor;
  style->halo_width *= factor;
}

/* A line may be as heavy as this part of the height; a ring has two. */
#define LINE_PART 0.62
#define RING_PART 0.3

/* A line that is dashed has one dash and a good part of the next. */
#define PERIODS 1.7
#define LEAST_ROUND 2.9 /* round a circle; else there are so many: */
#define ROUND 5

/* Dashes that are no longer than the line is wide would get round ends, which
 * meet, and dots would meet too: the line is made thinner as well. */
static void
shorten (Style *style, double part)
{
  const bool has_dots = brush_has_round_ends (style);
  double narrow;

  style->dash *= part;
  style->gap *= part;
  narrow = has_dots ? part : MIN (1, style->dash / style->width);
  style->width *= narrow;
  style->casing *= narrow;
}

/* Returns: how much of their length dashes keep: all of it where some of them
 *          are seen. */
static double
part_of_dashes (const Style *style, Sample sample, double length)
{
  const double n_periods = length / (style->dash + style->gap);

  if (sample == SAMPLE_CIRCLE)
    return n_periods >= LEAST_ROUND ? 1 : n_periods / ROUND;
  return MIN (1, n_periods / PERIODS);
}

/* Heavy looks are made smaller until a mark is whole and a line leaves ground
 * beside it; and dashes so short that they are seen to be some. */
static void
fit (Style *style, Sample sample, const double size[2])
{
  const double height = MIN (size[0], size[1]);
  const double length
      = sample == SAMPLE_CIRCLE ? G_PI * (height - 3) : size[0] - 4;
  const double most = height * (sample == SAMPLE_LINE ? LINE_PART : RING_PART);

  if (sample == SAMPLE_MARK && brush_mark_reach (style) > 0)
    scale (style, MIN (1, height / 2 / brush_mark_reach (style)));
  if (sample == SAMPLE_MARK || sample == SAMPLE_AREA)
    return;
  if (style->width > 0)
    scale (style, MIN (1, most / style->width));
  if (style->dash > 0)
    shorten (style, part_of_dashes (style, sample, length));
}

/* Ridges and creases lie between areas; others on the ground. */
static void
paint_under (cairo_t *cr,
             const SceneItem *line,
             const Theme *theme,
             const double size[2])
{
  SceneItem item = { .shape = SHAPE_POLYGON, .emphasis = line->emphasis };
  Style style;

  if (line->role != ROLE_RIDGE && line->role != ROLE_TANGENT_EDGE)
    return;
  item.role = line->role == ROLE_RIDGE ? ROLE_LOWER : ROLE_TANGENT;
  style = theme_style (theme, &item);
  paint_area (cr, &style, theme, 0, size);
}

/* A height has ticks at its ends. */
static void
trace_ticks (cairo_t *cr, const double size[2])
{
  for (int i = 0; i <= 1; i++) {
    const double x = i == 0 ? 3 : size[0] - 3;

    cairo_move_to (cr, x, size[1] / 2 - TICK);
    cairo_line_to (cr, x, size[1] / 2 + TICK);
  }
}

static void
paint_line (cairo_t *cr,
            const Style *style,
            Sample sample,
            const Theme *theme,
            const double size[2])
{
  if (style->casing > 0) {
    trace_sample (cr, sample, style->width, size);
    brush_casing (cr, style, theme);
  }
  trace_sample (cr, sample, style->width, size);
  brush_line (cr, style);
}

/* A corner of the horizon is a ring round a site: made as small as the ring. */
static void
paint_corner_site (cairo_t *cr, const Style *ring, const Theme *theme, Pixel at)
{
  const SceneItem corner = { .shape = SHAPE_MARK,
                             .role = ROLE_HORIZON_CORNER,
                             .emphasis = EMPHASIS_NORMAL };
  const SceneItem site
      = { .shape = SHAPE_MARK, .role = ROLE_SITE, .emphasis = EMPHASIS_NORMAL };
  Style dot = theme_style (theme, &site);

  scale (&dot, ring->radius / theme_style (theme, &corner).radius);
  brush_mark (cr, &dot, theme, at);
}

/* Two marks: the second lies behind the hull. */
static void
paint_marks (cairo_t *cr,
             const Style *style,
             const SceneItem *item,
             const Theme *theme,
             const double size[2])
{
  const uint32_t n = item->n;
  const double share = size[0] / (n == 2 ? 2 : 1);
  const double y = size[1] / 2;
  Style behind;

  brush_mark (cr, style, theme, (Pixel){ share / 2, y });
  if (item->role == ROLE_HORIZON_CORNER)
    paint_corner_site (cr, style, theme, (Pixel){ share / 2, y });
  if (n != 2)
    return;
  behind = *style;
  theme_put_behind (theme, &behind);
  brush_mark (cr, &behind, theme, (Pixel){ share * 1.5, y });
}

void
painter_swatch (cairo_t *cr,
                const SceneItem *item,
                const Theme *theme,
                double width,
                double height)
{
  const Sample sample = sample_of (item);
  const double size[2] = { width, height };
  SceneItem drawn = *item;
  Style style;

  drawn.shape = sample == SAMPLE_AREA ? SHAPE_POLYGON : SHAPE_MARK;
  style = theme_style (theme, &drawn);
  fit (&style, sample, size);
  cairo_save (cr);
  cairo_new_path (cr);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  if (sample == SAMPLE_MARK)
    paint_marks (cr, &style, item, theme, size);
  else if (sample == SAMPLE_TRIANGLE)
    paint_triangle (cr, item, theme, size);
  else if (item->role == ROLE_CELL && item->emphasis != EMPHASIS_LOUD
           && item->lit == LIT_NONE)
    paint_cells (cr, item, theme, size);
  else if (item->role == ROLE_SHEET)
    paint_sheet (cr, item, theme, size);
  else if (sample == SAMPLE_AREA)
    paint_area (cr, &style, theme, item->role == ROLE_PLANE ? PATCH_SLANT : 0,
                size);
  else {
    paint_under (cr, item, theme, size);
    paint_line (cr, &style, sample, theme, size);
    if (item->role == ROLE_DROP) {
      trace_ticks (cr, size);
      brush_line (cr, &style);
    }
  }
  cairo_restore (cr);
}
