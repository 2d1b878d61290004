#include "theme-private.h"

/* A role's look in words: inks, and lengths in px. */
typedef struct Row {
  Ink fill, line;
  double fill_alpha, line_alpha; /* 0: opaque */
  Style style;                   /* all but the colours */
} Row;

#define HATCH_WIDTH 1.3 /* px */

/* Of what is pale. Source: WCAG 2.1, 1.4.11. */
#define PALE_CONTRAST 3.06

static const Row rows[N_ROLES] = {
  [ROLE_GROUND] = { .fill = INK_PAPER,
                    .fill_alpha = 0.6,
                    .line = INK_GROUND,
                    .style = { .width = 1.3 } },
  [ROLE_SHEET] = { .fill = INK_SHEET,
                   .fill_alpha = 0.04,
                   .line = INK_SHEET_LINE,
                   .line_alpha = 0.42,
                   .style = { .width = 1 } },
  [ROLE_RIM] = { .line = INK_SHEET_LINE, .style = { .width = 1.3 } },
  [ROLE_CELL] = { .fill = INK_PAPER },
  [ROLE_FURTHEST_CELL] = { .fill = INK_PAPER },
  [ROLE_TANGENT] = { .fill = INK_PAPER,
                     .fill_alpha = 0.6,
                     .line = INK_VORONOI,
                     .style = { .width = 0.7, .is_shaded = true } },
  [ROLE_FACET] = { .fill = INK_VERTICAL,
                   .fill_alpha = 0.45,
                   .style = { .is_shaded = true } },
  [ROLE_LOWER]
  = { .fill = INK_LOWER, .fill_alpha = 0.66, .style = { .is_shaded = true } },
  [ROLE_UPPER]
  = { .fill = INK_UPPER, .fill_alpha = 0.55, .style = { .is_shaded = true } },
  [ROLE_VERTICAL] = { .fill = INK_VERTICAL,
                      .fill_alpha = 0.4,
                      .line = INK_VERTICAL_LINE,
                      .style = { .hatch = HATCH_CROSSED, .is_shaded = true } },
  [ROLE_SIGN_LEFT] = { .fill = INK_LOWER },
  [ROLE_SIGN_ZERO] = { .fill = INK_HORIZON },
  [ROLE_SIGN_RIGHT] = { .fill = INK_SHEET },
  [ROLE_HULL_AREA] = { .fill = INK_LOWER, .fill_alpha = 0.22 },
  [ROLE_VISIBLE] = { .fill = INK_VISIBLE,
                     .fill_alpha = 0.12,
                     .line = INK_VISIBLE,
                     .style = { .hatch = HATCH_RISING } },
  [ROLE_VISIBLE_UPPER] = { .fill = INK_VISIBLE,
                           .fill_alpha = 0.1,
                           .line = INK_VISIBLE_UPPER,
                           .style = { .hatch = HATCH_FALLING } },
  [ROLE_RETIRED]
  = { .line = INK_VISIBLE,
      .style = { .width = 1.4, .dash = 3, .gap = 4, .casing = 3.4 } },
  [ROLE_CONE]
  = { .fill = INK_CONE, .fill_alpha = 0.42, .style = { .is_shaded = true } },
  [ROLE_CONE_UPPER]
  = { .fill = INK_CONE,
      .fill_alpha = 0.2,
      .line = INK_CONE_LINE,
      .style = { .hatch = HATCH_FALLING, .is_shaded = true } },
  [ROLE_SELECTED_FACET]
  = { .line = INK_SELECTED, .style = { .width = 4, .casing = 7 } },
  [ROLE_PREVIEW_TRIANGLE]
  = { .fill = INK_HOVER,
      .fill_alpha = 0.08,
      .line = INK_HOVER,
      .style = { .hatch = HATCH_RISING, .hatch_width = 0.6 } },
  [ROLE_PREVIEW_STOLEN] = { .fill = INK_HOVER, .fill_alpha = 0.16 },
  [ROLE_PLANE] = { .fill = INK_HOVER,
                   .fill_alpha = 0.14,
                   .line = INK_HOVER,
                   .style = { .width = 1.2 } },
  [ROLE_CIRCLE] = { .line = INK_CIRCLE, .style = { .width = 1 } },
  [ROLE_CIRCLE_VISIBLE]
  = { .line = INK_VISIBLE,
      .style = { .width = 2, .dash = 8, .gap = 5, .casing = 4 } },
  [ROLE_CIRCLE_UPPER]
  = { .line = INK_VISIBLE_UPPER,
      .style = { .width = 2, .dash = 0.5, .gap = 5, .casing = 4 } },
  [ROLE_CIRCLE_SELECTED]
  = { .line = INK_APEX,
      .style = { .width = 2, .dash = 12, .gap = 4, .casing = 4 } },
  [ROLE_ELLIPSE]
  = { .line = INK_APEX, .style = { .width = 2.6, .casing = 4.6 } },
  [ROLE_VORONOI_EDGE] = { .line = INK_VORONOI, .style = { .width = 1.3 } },
  [ROLE_DELAUNAY_EDGE] = { .line = INK_DELAUNAY, .style = { .width = 2.6 } },
  [ROLE_TANGENT_EDGE] = { .line = INK_VORONOI, .style = { .width = 2.4 } },
  /* On the hull it lies on a Delaunay edge, and is seen on both sides of it. */
  [ROLE_FURTHEST_EDGE]
  = { .line = INK_FURTHEST, .style = { .width = 3.6, .dash = 9, .gap = 6 } },
  [ROLE_FURTHEST_VORONOI]
  = { .line = INK_FURTHEST, .style = { .width = 1.5, .dash = 4, .gap = 3 } },
  [ROLE_PREVIEW_EDGE]
  = { .line = INK_HOVER, .style = { .width = 1.8, .dash = 5, .gap = 4 } },
  [ROLE_PREVIEW_CELL]
  = { .line = INK_HOVER, .style = { .width = 1.8, .dash = 2, .gap = 3 } },
  [ROLE_CONTOUR]
  = { .line = INK_SHEET_LINE, .style = { .width = 1, .dash = 2, .gap = 2 } },
  [ROLE_FREE_EDGE]
  = { .line = INK_DELAUNAY,
      .style = { .width = 1.8, .dash = 6, .gap = 5, .casing = 3.8 } },
  [ROLE_RIDGE] = { .line = INK_RIDGE, .style = { .width = 1.5 } },
  [ROLE_HULL_EDGE] = { .line = INK_RIDGE, .style = { .width = 3 } },
  [ROLE_ROUNDED_EDGE] = { .line = INK_VISIBLE_UPPER,
                          .style = { .width = 3, .dash = 10, .gap = 5 } },
  [ROLE_SIGN_NODE]
  = { .line = INK_HORIZON, .style = { .width = 2, .casing = 4.5 } },
  [ROLE_EDGE_LINE]
  = { .line = INK_SELECTED, .style = { .width = 1.3, .dash = 7, .gap = 5 } },
  [ROLE_VISIBLE_EDGE]
  = { .line = INK_VISIBLE, .style = { .width = 2.8, .casing = 5 } },
  [ROLE_SEEN_EDGE]
  = { .line = INK_VISIBLE_UPPER,
      .style = { .width = 5, .dash = 5, .gap = 3, .casing = 8 } },
  [ROLE_CONE_EDGE]
  = { .line = INK_CONE_LINE, .style = { .width = 3.8, .casing = 6 } },
  [ROLE_HORIZON]
  = { .line = INK_HORIZON, .style = { .width = 5, .casing = 9 } },
  [ROLE_HORIZON_UPPER]
  = { .line = INK_HORIZON,
      .style = { .width = 3.6, .dash = 9, .gap = 5, .casing = 7 } },
  [ROLE_LIFT]
  = { .line = INK_LIFT, .style = { .width = 1.1, .dash = 4, .gap = 4 } },
  [ROLE_LIFT_APEX]
  = { .line = INK_APEX, .style = { .width = 2.2, .dash = 5, .gap = 4 } },
  [ROLE_LIFT_OUTSIDE]
  = { .line = INK_SELECTED, .style = { .width = 1.6, .dash = 2, .gap = 3 } },
  [ROLE_DROP] = { .line = INK_SELECTED, .style = { .width = 1.8 } },
  [ROLE_GAP] = { .line = INK_APEX, .style = { .width = 3.6, .casing = 6.5 } },
  [ROLE_LIT] = { .line = INK_APEX, .style = { .width = 3, .casing = 5.5 } },
  [ROLE_ANSWER_CHOSEN]
  = { .line = INK_HOVER,
      .style = { .width = 4, .mark = MARK_HOLLOW, .radius = 10 } },
  [ROLE_ANSWER_RIGHT]
  = { .line = INK_CONE_LINE,
      .style = { .width = 5.5, .mark = MARK_HOLLOW, .radius = 10 } },
  [ROLE_ANSWER_WRONG] = { .line = INK_VISIBLE,
                          .style = { .width = 4,
                                     .dash = 7,
                                     .gap = 5,
                                     .mark = MARK_HOLLOW,
                                     .radius = 10 } },
  /* Its dots stand out from the horizon as well. */
  [ROLE_ANSWER_MISSED] = { .line = INK_HORIZON,
                           .style = { .width = 3,
                                      .casing = 8,
                                      .dash = 0.5,
                                      .gap = 5.5,
                                      .mark = MARK_HOLLOW,
                                      .radius = 10 } },
  [ROLE_VORONOI_VERTEX]
  = { .line = INK_VORONOI, .style = { .mark = MARK_DOT, .radius = 2.3 } },
  [ROLE_VORONOI_VERTEX_TIED]
  = { .fill = INK_PAPER,
      .line = INK_VORONOI,
      .style = { .width = 1.8, .mark = MARK_RINGED, .radius = 3 } },
  [ROLE_VORONOI_VERTEX_DYING]
  = { .fill = INK_PAPER,
      .fill_alpha = 0.84,
      .line = INK_VISIBLE,
      .style
      = { .width = 2, .casing = 1.2, .mark = MARK_DIAMOND, .radius = 7 } },
  [ROLE_FURTHEST_VERTEX]
  = { .fill = INK_PAPER,
      .line = INK_FURTHEST,
      .style = { .width = 1.8, .mark = MARK_HOLLOW, .radius = 3.4 } },
  [ROLE_PREVIEW_SITE]
  = { .fill = INK_PAPER,
      .line = INK_HOVER,
      .style
      = { .width = 2, .casing = 1.4, .mark = MARK_HOLLOW, .radius = 5 } },
  [ROLE_HORIZON_CORNER]
  = { .fill = INK_PAPER,
      .line = INK_HORIZON,
      .style
      = { .width = 3.5, .casing = 1.8, .mark = MARK_HOLLOW, .radius = 10 } },
  [ROLE_FOOT]
  = { .line = INK_SITE, .style = { .mark = MARK_DOT, .radius = 2.8 } },
  [ROLE_FOOT_APEX]
  = { .line = INK_APEX,
      .style = { .casing = 1, .mark = MARK_DOT, .radius = 4.6 } },
  [ROLE_SITE] = { .line = INK_SITE,
                  .style = { .casing = 1.8, .mark = MARK_DOT, .radius = 5 } },
  [ROLE_SITE_WAITING]
  = { .fill = INK_PAPER,
      .line = INK_SITE,
      .style
      = { .width = 1.8, .casing = 1.4, .mark = MARK_HOLLOW, .radius = 4.4 } },
  [ROLE_SITE_OUTSIDE]
  = { .fill = INK_PAPER,
      .line = INK_SELECTED,
      .style
      = { .width = 2, .casing = 1.4, .mark = MARK_RINGED, .radius = 4.4 } },
  [ROLE_SITE_APEX]
  = { .line = INK_APEX,
      .style = { .casing = 2.2, .mark = MARK_DOT, .radius = 8.5 } },
  [ROLE_SITE_DUPLICATE]
  = { .fill = INK_PAPER,
      .line = INK_SITE,
      .style = { .width = 1.6, .mark = MARK_CROSSED, .radius = 7 } },
  [ROLE_POWER] = { .style = { .mark = MARK_NONE } },
  [ROLE_SITE_LOST]
  = { .fill = INK_PAPER,
      .line = INK_VISIBLE_UPPER,
      .style = { .width = 2, .mark = MARK_CROSSED, .radius = 9 } },
  [ROLE_SITE_IGNORED]
  = { .line = INK_GROUND, .style = { .mark = MARK_DOT, .radius = 4 } },
  [ROLE_FACET_NAME] = { .style = { .mark = MARK_NONE } },
  [ROLE_ANSWER_NAME] = { .style = { .mark = MARK_NONE } },
};

Colour
theme_colour (uint32_t rgb, double alpha)
{
  return (Colour){ (rgb >> 16 & 0xff) / 255.0, (rgb >> 8 & 0xff) / 255.0,
                   (rgb & 0xff) / 255.0, alpha };
}

static Colour
dip (const Palette *palette, Ink ink, double alpha)
{
  if (ink == INK_NONE)
    return (Colour){ 0, 0, 0, 0 };
  return theme_colour (palette->inks[ink], alpha > 0 ? alpha : 1);
}

void
theme_dip (Theme *theme, const Palette *palette)
{
  int role;

  *theme = (Theme){
    .background = dip (palette, INK_BACKGROUND, 1),
    .text = dip (palette, INK_TEXT, 1),
    .selection = dip (palette, INK_APEX, 1),
    .selected_facet = dip (palette, INK_APEX, 1),
    .hover = dip (palette, INK_HOVER, 1),
    .apex_text = dip (palette, INK_APEX, 1),
    .font = "DejaVu Sans, sans",
    .text_px = 15,
    .line_factor = 1,
    .mark_factor = 1,
    .hatch_px = 8,
    .cell_lightness = 0.955,
    .cell_chroma = 0.028,
    .cell_loudness = 2,
    .pale_line = 0.55,
    .pale_contrast = PALE_CONTRAST,
    .pale_width = 0.8,
    .pale_hatch = 0.8,
    .pale_fill = 0.32,
    .pale_cell = 0.32,
    .far_line = 0.5,
    .far_width = 0.75,
  };
  for (role = 0; role < N_ROLES; role++) {
    theme->styles[role] = rows[role].style;
    theme->styles[role].fill
        = dip (palette, rows[role].fill, rows[role].fill_alpha);
    theme->styles[role].line
        = dip (palette, rows[role].line, rows[role].line_alpha);
    if (!(rows[role].style.hatch_width > 0))
      theme->styles[role].hatch_width = HATCH_WIDTH;
  }
}
