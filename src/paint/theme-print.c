/* Black ink on white paper, for printers and copiers that know no grey: what
 * other themes say in colours is said in hatches, dashes, widths and shapes.
 * What is pale elsewhere is a little thinner here, but keeps its place in the
 * order of widths, which tells what it is. One grey is left, of the current
 * facet, whose heavy line is no other's. */
#include "theme-private.h"

static const Palette palette = { {
    [INK_BACKGROUND] = 0xffffff,    [INK_PAPER] = 0xffffff,
    [INK_TEXT] = 0x000000,          [INK_SITE] = 0x000000,
    [INK_APEX] = 0x000000,          [INK_HOVER] = 0x5a5a5a,
    [INK_VISIBLE] = 0x000000,       [INK_VISIBLE_UPPER] = 0x000000,
    [INK_CONE] = 0xffffff,          [INK_CONE_LINE] = 0x000000,
    [INK_SELECTED] = 0x000000,      [INK_HORIZON] = 0x000000,
    [INK_DELAUNAY] = 0x000000,      [INK_VORONOI] = 0x000000,
    [INK_CIRCLE] = 0x000000,        [INK_LOWER] = 0xffffff,
    [INK_UPPER] = 0xffffff,         [INK_VERTICAL] = 0xffffff,
    [INK_VERTICAL_LINE] = 0x000000, [INK_RIDGE] = 0x000000,
    [INK_SHEET] = 0xffffff,         [INK_SHEET_LINE] = 0x000000,
    [INK_LIFT] = 0x000000,          [INK_GROUND] = 0x000000,
    [INK_FURTHEST] = 0x000000,
} };

/* Of what is pale: still closer to its own pen than to the next thinner one. */
#define PALE_WIDTH 0.82

/* A pen for each line that is told by its width alone. */
static const struct {
  Role role;
  double width;
} pens[] = {
  { ROLE_GROUND, 0.75 },
  { ROLE_SHEET, 0.5 },
  { ROLE_RIM, 0.75 },
  { ROLE_TANGENT, 0.5 },
  { ROLE_PLANE, 1 },
  { ROLE_CIRCLE, 0.5 },
  { ROLE_CIRCLE_VISIBLE, 1.5 },
  { ROLE_VORONOI_EDGE, 1 },
  { ROLE_TANGENT_EDGE, 2 },
  { ROLE_DELAUNAY_EDGE, 2.5 },
  { ROLE_CONTOUR, 0.5 },
  { ROLE_HORIZON, 7 },
  { ROLE_LIFT, 0.75 },
  { ROLE_LIFT_APEX, 3.2 },
  { ROLE_GAP, 4.8 },
};

static void
hatch (Theme *theme, Role role, Hatch hatch, double width)
{
  theme->styles[role].hatch = hatch;
  theme->styles[role].hatch_width = width;
  theme->styles[role].line = theme_colour (0x000000, 1);
}

static void
dash (Theme *theme, Role role, double dash, double gap)
{
  theme->styles[role].dash = dash;
  theme->styles[role].gap = gap;
}

/* A hatch seen through another one must not look like a third: none but the
 * cone's are upright, and its two kinds differ in how close they are. */
static void
set_hatches (Theme *theme)
{
  hatch (theme, ROLE_UPPER, HATCH_LEVEL, 0.7);
  hatch (theme, ROLE_VERTICAL, HATCH_CROSSED, 0.7);
  hatch (theme, ROLE_CONE, HATCH_UPRIGHT, 1);
  hatch (theme, ROLE_CONE_UPPER, HATCH_CLOSE, 1);
  hatch (theme, ROLE_SIGN_LEFT, HATCH_FINE, 0.6);
  hatch (theme, ROLE_PREVIEW_STOLEN, HATCH_LEVEL, 0.7);
  theme->styles[ROLE_PREVIEW_STOLEN].line
      = theme->styles[ROLE_PREVIEW_TRIANGLE].line;
  theme->styles[ROLE_SIGN_LEFT].fill = theme_colour (0xffffff, 1);
}

static void
set_areas (Theme *theme)
{
  int role;

  for (role = 0; role < N_ROLES; role++)
    theme->styles[role].is_shaded = false;
  theme->styles[ROLE_SHEET].fill.alpha = 0;
  theme->styles[ROLE_PLANE].fill.alpha = 0;
  theme->styles[ROLE_VISIBLE].fill.alpha = 0;
  theme->styles[ROLE_VISIBLE_UPPER].fill.alpha = 0;
  theme->styles[ROLE_PREVIEW_TRIANGLE].fill.alpha = 0;
  theme->styles[ROLE_PREVIEW_STOLEN].fill.alpha = 0;
  set_hatches (theme);
}

/* The edges of the hull are those of both triangulations: black on black, one
 * is seen on the other as beads on a string. */
static void
set_beads (Theme *theme)
{
  theme->styles[ROLE_FURTHEST_EDGE].width = 5.5;
  dash (theme, ROLE_FURTHEST_EDGE, 0.1, 11);
}

static void
set_lines (Theme *theme)
{
  size_t i;

  for (i = 0; i < sizeof pens / sizeof *pens; i++)
    theme->styles[pens[i].role].width = pens[i].width;
  theme->styles[ROLE_SHEET].line.alpha = 1;
  theme->styles[ROLE_SITE_IGNORED].radius = 2.6;
  theme->styles[ROLE_FOOT].radius = 2.8;
  theme->styles[ROLE_VORONOI_VERTEX].radius = 1.7;
  dash (theme, ROLE_SHEET, 1.5, 3);
  dash (theme, ROLE_CONTOUR, 1.5, 3);
  dash (theme, ROLE_PREVIEW_CELL, 2, 5);
  dash (theme, ROLE_LIFT, 3, 3);
  dash (theme, ROLE_LIFT_APEX, 4, 3.5);
  dash (theme, ROLE_GAP, 7, 2);
  dash (theme, ROLE_VISIBLE_EDGE, 7, 4.5);
  dash (theme, ROLE_CIRCLE_VISIBLE, 5, 3.5);
  dash (theme, ROLE_CIRCLE_SELECTED, 18, 3);
  set_beads (theme);
  theme->styles[ROLE_HORIZON].casing = 11;
  theme->styles[ROLE_SELECTED_FACET].line = theme_colour (0x707070, 1);
  theme->styles[ROLE_SELECTED_FACET].width = 6;
  theme->styles[ROLE_SELECTED_FACET].casing = 8.5;
}

void
theme_print (Theme *theme)
{
  theme_dip (theme, &palette);
  theme->cell_lightness = 1;
  theme->cell_chroma = 0;
  theme->has_plates = true;
  theme->pale_line = 1;
  theme->pale_width = PALE_WIDTH;
  theme->pale_hatch = 0.5;
  theme->far_line = 1;
  theme->far_width = 0.5;
  set_areas (theme);
  set_lines (theme);
}
