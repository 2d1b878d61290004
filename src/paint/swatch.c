#include "brush.h"
#include "painter.h"

#include <glib.h>

#define SAMPLE_HATCH 0.7

/* What a role is drawn as. */
typedef enum Sample {
  SAMPLE_AREA,
  SAMPLE_LINE,
  SAMPLE_CIRCLE,
  SAMPLE_SQUARE,
  SAMPLE_MARK,
} Sample;

static Sample
sample_of (Role role)
{
  if (role >= ROLE_VORONOI_VERTEX)
    return SAMPLE_MARK;
  if (role >= ROLE_CIRCLE && role <= ROLE_ELLIPSE)
    return SAMPLE_CIRCLE;
  if (role == ROLE_SIGN_NODE)
    return SAMPLE_SQUARE;
  if (role == ROLE_GROUND || role == ROLE_RIM || role == ROLE_SELECTED_FACET
      || role == ROLE_RETIRED || role >= ROLE_VORONOI_EDGE)
    return SAMPLE_LINE;
  return SAMPLE_AREA;
}

/* A facet of the legend has a border in a shade of itself that stands out, and
 * its hatch is close enough to be seen to be one. */
static void
paint_area (cairo_t *cr,
            const Style *style,
            const Theme *theme,
            const double size[2])
{
  const Pixel corners[4] = { { 1, 1 },
                             { size[0] - 1, 1 },
                             { size[0] - 1, size[1] - 1 },
                             { 1, size[1] - 1 } };
  Theme close = *theme;
  Style bordered = *style;

  close.hatch_px *= SAMPLE_HATCH;
  bordered.width = 1.4;
  if (style->line.alpha <= 0) {
    bordered.line = colour_mix (style->fill, theme->text, 0.35);
    bordered.line.alpha = 1;
  }
  brush_polygon (cr, &bordered, &close, corners, 4);
}

static void
trace_sample (cairo_t *cr, Sample sample, const double size[2])
{
  if (sample == SAMPLE_CIRCLE) {
    const double radius = MIN (size[0], size[1]) / 2 - 1.5;

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
  cairo_move_to (cr, 2, size[1] / 2);
  cairo_line_to (cr, size[0] - 2, size[1] / 2);
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

/* Heavy looks are made smaller until a mark is whole, a line leaves ground
 * beside it, and dashes are seen to be some. */
static void
fit (Style *style, Sample sample, const double size[2])
{
  const double height = MIN (size[0], size[1]);
  const double length
      = sample == SAMPLE_CIRCLE ? G_PI * (height - 3) : size[0] - 4;
  const double period = style->dash + style->gap;
  /* A line may be as heavy as this part of the height; a ring has two. */
  const double most = sample == SAMPLE_LINE ? 2.6 : 5.2;

  if (sample == SAMPLE_MARK && brush_mark_reach (style) > 0)
    scale (style, MIN (1, height / 2 / brush_mark_reach (style)));
  if (sample == SAMPLE_MARK || sample == SAMPLE_AREA)
    return;
  if (style->width > 0)
    scale (style, MIN (1, height / most / style->width));
  if (style->dash > 0)
    scale (style, MIN (1, length / 3 / period));
}

void
painter_swatch (cairo_t *cr,
                Role role,
                Lit lit,
                const Theme *theme,
                double width,
                double height)
{
  const Sample sample = sample_of (role);
  const SceneItem item
      = { .role = role,
          .shape = sample == SAMPLE_AREA ? SHAPE_POLYGON : SHAPE_MARK,
          .emphasis = EMPHASIS_NORMAL,
          .lit = lit };
  Style style = theme_style (theme, &item);
  const double size[2] = { width, height };

  fit (&style, sample, size);
  cairo_save (cr);
  cairo_new_path (cr);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  if (sample == SAMPLE_MARK) {
    brush_mark (cr, &style, theme, (Pixel){ width / 2, height / 2 });
  } else if (sample == SAMPLE_AREA) {
    paint_area (cr, &style, theme, size);
  } else {
    if (style.casing > 0) {
      trace_sample (cr, sample, size);
      brush_casing (cr, &style, theme);
    }
    trace_sample (cr, sample, size);
    brush_line (cr, &style);
  }
  cairo_restore (cr);
}
