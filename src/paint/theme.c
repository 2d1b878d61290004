#include "theme.h"

/* A colour from its hexadecimal notation. */
#define HEX(rgb, alpha)                                                        \
  {                                                                            \
    ((rgb) >> 16 & 0xff) / 255.0, ((rgb) >> 8 & 0xff) / 255.0,                 \
        ((rgb)&0xff) / 255.0, (alpha)                                          \
  }

#define GOLDEN_ANGLE 0.38196601125010515 /* turns */

/* How much the look changes for what is lit, and for a new cell. */
#define HALO_WIDTH 4.0
#define LOUD_CHROMA 2.0
#define LOUD_LIGHTNESS 0.97

#define SITE_BLACK 0x241f31
#define APEX_MAGENTA 0xc2187f
#define VISIBLE_ORANGE 0xd55e00
#define CONE_GREEN 0x009e73
#define CONE_DARK 0x00664a
#define DELAUNAY_BLUE 0x0b5cad
#define VORONOI_GREY 0x555555
#define SHEET_GOLD 0x9c7a12
#define PAPER 0xfcfcfb

static const Theme light = {
  .name = "light",
  .background = HEX (PAPER, 1),
  .text = HEX (SITE_BLACK, 1),
  .selection = HEX (APEX_MAGENTA, 1),
  .hover = HEX (0x7a3fc0, 1),
  .apex_text = HEX (APEX_MAGENTA, 1),
  .font = "DejaVu Sans, sans",
  .text_px = 15,
  .line_factor = 1,
  .hatch_px = 8,
  .cell_lightness = 0.955,
  .cell_chroma = 0.028,
  .pale_line = 0.55,
  .pale_fill = 0.32,
  .styles = {
    [ROLE_GROUND] = { .fill = HEX (0xffffff, 0.6), .line = HEX (0x83828a, 1),
                      .width = 1.3 },
    [ROLE_SHEET] = { .fill = HEX (0xe8b923, 0.04),
                     .line = HEX (SHEET_GOLD, 0.42), .width = 1 },
    [ROLE_RIM] = { .line = HEX (SHEET_GOLD, 1), .width = 1.3 },
    [ROLE_CELL] = { .fill = HEX (0xffffff, 1) },
    [ROLE_FURTHEST_CELL] = { .fill = HEX (0xffffff, 1) },
    [ROLE_TANGENT] = { .fill = HEX (0xffffff, 0.85), .is_shaded = true },
    [ROLE_LOWER] = { .fill = HEX (0x56b4e9, 0.66), .is_shaded = true },
    [ROLE_UPPER] = { .fill = HEX (0x3d8b40, 0.42), .is_shaded = true },
    [ROLE_VERTICAL] = { .fill = HEX (0x9a9996, 0.4), .hatch = HATCH_CROSSED,
                        .line = HEX (0x5e5c64, 0.75), .is_shaded = true },
    [ROLE_VISIBLE] = { .fill = HEX (VISIBLE_ORANGE, 0.17),
                       .hatch = HATCH_RISING,
                       .line = HEX (VISIBLE_ORANGE, 1) },
    [ROLE_VISIBLE_UPPER] = { .fill = HEX (VISIBLE_ORANGE, 0.1),
                             .hatch = HATCH_FALLING,
                             .line = HEX (0xb34f00, 1) },
    [ROLE_RETIRED] = { .line = HEX (VISIBLE_ORANGE, 1), .width = 1.4,
                       .dash = 3, .gap = 4 },
    [ROLE_CONE] = { .fill = HEX (CONE_GREEN, 0.42), .is_shaded = true },
    [ROLE_CONE_UPPER] = { .fill = HEX (CONE_GREEN, 0.2),
                          .hatch = HATCH_FALLING,
                          .line = HEX (CONE_DARK, 0.8), .is_shaded = true },
    [ROLE_SELECTED_FACET] = { .line = HEX (DELAUNAY_BLUE, 1), .width = 4,
                              .casing = 7 },
    [ROLE_SELECTED] = { .fill = HEX (0xe01b6a, 0.2) },
    [ROLE_PREVIEW_TRIANGLE] = { .fill = HEX (0x7a3fc0, 0.1) },
    [ROLE_PREVIEW_STOLEN] = { .fill = HEX (0x7a3fc0, 0.16) },
    [ROLE_PLANE] = { .fill = HEX (0xb39ddb, 0.3),
                     .line = HEX (0x7a3fc0, 1), .width = 1.2 },
    [ROLE_CIRCLE] = { .line = HEX (0x4a86c5, 1), .width = 1.1 },
    [ROLE_CIRCLE_VISIBLE] = { .line = HEX (VISIBLE_ORANGE, 1), .width = 2,
                              .dash = 8, .gap = 5 },
    [ROLE_CIRCLE_UPPER] = { .line = HEX (0xb34f00, 1), .width = 2,
                            .dash = 0.5, .gap = 5 },
    [ROLE_CIRCLE_SELECTED] = { .line = HEX (APEX_MAGENTA, 1), .width = 2,
                               .dash = 12, .gap = 4 },
    [ROLE_ELLIPSE] = { .line = HEX (APEX_MAGENTA, 1), .width = 2.6 },
    [ROLE_VORONOI_EDGE] = { .line = HEX (VORONOI_GREY, 1), .width = 1.3 },
    [ROLE_DELAUNAY_EDGE] = { .line = HEX (DELAUNAY_BLUE, 1), .width = 2.6 },
    [ROLE_TANGENT_EDGE] = { .line = HEX (VORONOI_GREY, 1), .width = 1.5 },
    [ROLE_FURTHEST_EDGE] = { .line = HEX (0x2f7033, 1), .width = 2.4,
                             .dash = 10, .gap = 3 },
    [ROLE_FURTHEST_VORONOI] = { .line = HEX (0x8a5a00, 1), .width = 1.8,
                                .dash = 7, .gap = 3 },
    [ROLE_PREVIEW_EDGE] = { .line = HEX (0x7a3fc0, 1), .width = 1.8,
                            .dash = 5, .gap = 4 },
    [ROLE_PREVIEW_CELL] = { .line = HEX (0x7a3fc0, 1), .width = 1.8,
                            .dash = 2, .gap = 3 },
    [ROLE_CONTOUR] = { .line = HEX (SHEET_GOLD, 1), .width = 1 },
    [ROLE_FREE_EDGE] = { .line = HEX (DELAUNAY_BLUE, 1), .width = 1.8,
                         .dash = 6, .gap = 5 },
    [ROLE_RIDGE] = { .line = HEX (0x27496d, 1), .width = 1.5 },
    [ROLE_VISIBLE_EDGE] = { .line = HEX (VISIBLE_ORANGE, 1), .width = 2.8 },
    [ROLE_CONE_EDGE] = { .line = HEX (CONE_DARK, 1), .width = 3 },
    [ROLE_HORIZON] = { .line = HEX (0x1a1a1a, 1), .width = 5, .casing = 9 },
    [ROLE_HORIZON_UPPER] = { .line = HEX (0x1a1a1a, 1), .width = 3.6,
                             .dash = 9, .gap = 5, .casing = 7 },
    [ROLE_LIFT] = { .line = HEX (0x77767b, 1), .width = 1.1, .dash = 4,
                    .gap = 4 },
    [ROLE_LIFT_APEX] = { .line = HEX (APEX_MAGENTA, 1), .width = 2.2,
                         .dash = 5, .gap = 4 },
    [ROLE_LIFT_OUTSIDE] = { .line = HEX (DELAUNAY_BLUE, 1), .width = 1.3,
                            .dash = 4, .gap = 4 },
    [ROLE_DROP] = { .line = HEX (DELAUNAY_BLUE, 1), .width = 2.6,
                    .dash = 0.1, .gap = 5 },
    [ROLE_GAP] = { .line = HEX (APEX_MAGENTA, 1), .width = 3.6,
                   .casing = 6.5 },
    [ROLE_LIT] = { .line = HEX (APEX_MAGENTA, 1), .width = 3, .casing = 5.5 },
    [ROLE_VORONOI_VERTEX] = { .line = HEX (VORONOI_GREY, 1),
                              .mark = MARK_DOT, .radius = 2.3 },
    [ROLE_VORONOI_VERTEX_DYING] = { .fill = HEX (0xffffff, 1),
                                    .line = HEX (VISIBLE_ORANGE, 1),
                                    .width = 2, .mark = MARK_DIAMOND,
                                    .radius = 6.5 },
    [ROLE_FURTHEST_VERTEX] = { .fill = HEX (0xffffff, 1),
                               .line = HEX (0x8a5a00, 1), .width = 1.8,
                               .mark = MARK_HOLLOW, .radius = 3.4 },
    [ROLE_PREVIEW_SITE] = { .fill = HEX (0xffffff, 1),
                            .line = HEX (0x7a3fc0, 1), .width = 2,
                            .casing = 1.4, .mark = MARK_HOLLOW,
                            .radius = 5 },
    [ROLE_FOOT] = { .line = HEX (0x5e5c64, 1), .mark = MARK_DOT,
                    .radius = 2.8 },
    [ROLE_FOOT_APEX] = { .line = HEX (APEX_MAGENTA, 1), .mark = MARK_DOT,
                         .radius = 4.6 },
    [ROLE_SITE] = { .line = HEX (SITE_BLACK, 1), .casing = 1.8,
                    .mark = MARK_DOT, .radius = 5 },
    [ROLE_SITE_WAITING] = { .fill = HEX (0xffffff, 1),
                            .line = HEX (SITE_BLACK, 1), .width = 1.8,
                            .casing = 1.4, .mark = MARK_HOLLOW,
                            .radius = 4.4 },
    [ROLE_SITE_OUTSIDE] = { .fill = HEX (0xffffff, 1),
                            .line = HEX (DELAUNAY_BLUE, 1), .width = 2,
                            .casing = 1.4, .mark = MARK_RINGED,
                            .radius = 4.4 },
    [ROLE_SITE_APEX] = { .line = HEX (APEX_MAGENTA, 1), .casing = 2.2,
                         .mark = MARK_DOT, .radius = 8.5 },
    [ROLE_SITE_DUPLICATE] = { .fill = HEX (0xffffff, 1),
                              .line = HEX (SITE_BLACK, 1), .width = 1.6,
                              .mark = MARK_CROSSED, .radius = 7 },
    [ROLE_POWER] = { .mark = MARK_NONE },
    [ROLE_FACET_NAME] = { .mark = MARK_NONE },
  },
};

static const Theme *const themes[N_THEMES] = {
  [THEME_LIGHT] = &light,
};

const Theme *
theme_get (ThemeKind kind)
{
  return themes[kind];
}

static bool
is_cell (const SceneItem *item)
{
  return item->role == ROLE_CELL || item->role == ROLE_FURTHEST_CELL
         || item->role == ROLE_TANGENT;
}

static Colour
cell_colour (const Theme *theme, const SceneItem *item)
{
  const bool is_loud = item->emphasis == EMPHASIS_LOUD;
  const double chroma = theme->cell_chroma * (is_loud ? LOUD_CHROMA : 1);
  const double lightness
      = theme->cell_lightness * (is_loud ? LOUD_LIGHTNESS : 1);

  return colour_oklch (lightness, chroma, GOLDEN_ANGLE * item->hue);
}

static void
take_hue (const Theme *theme, const SceneItem *item, Style *style)
{
  const double alpha = style->fill.alpha;

  style->fill = cell_colour (theme, item);
  style->fill.alpha = alpha;
}

static void
make_fade (double fade, Style *style)
{
  style->fill.alpha *= 1 - fade;
  style->line.alpha *= 1 - fade;
  style->halo.alpha *= 1 - fade;
}

static void
make_pale (const Theme *theme, Style *style)
{
  style->line.alpha *= theme->pale_line;
  style->fill.alpha *= theme->pale_fill;
}

/* Outlines and circles of what is lit change their colour; all other shapes
 * keep their look and get a halo. */
static void
make_lit (const Theme *theme, const SceneItem *item, Style *style)
{
  const bool is_selected = item->lit == LIT_SELECTED;
  const Colour colour = is_selected ? theme->selection : theme->hover;
  const bool is_thin
      = item->role >= ROLE_LIFT && item->role <= ROLE_LIFT_OUTSIDE;

  if (item->role == ROLE_LIT || item->role == ROLE_CIRCLE_SELECTED) {
    style->line = colour;
    return;
  }
  style->halo = colour;
  style->halo_width = is_selected ? HALO_WIDTH : 0.7 * HALO_WIDTH;
  if (is_thin || item->role == ROLE_CIRCLE_VISIBLE)
    style->halo_width /= 2;
}

Style
theme_style (const Theme *theme, const SceneItem *item)
{
  Style style = theme->styles[item->role];

  if (is_cell (item))
    take_hue (theme, item, &style);
  if (item->emphasis == EMPHASIS_PALE && item->lit == LIT_NONE)
    make_pale (theme, &style);
  if (item->lit != LIT_NONE)
    make_lit (theme, item, &style);
  make_fade (item->fade, &style);
  if (item->fade >= 1)
    style.casing = 0;
  style.width *= theme->line_factor;
  style.casing *= theme->line_factor;
  return style;
}
