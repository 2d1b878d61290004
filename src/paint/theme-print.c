/* Black ink on white paper: what other themes say in colours is said in
 * hatches, dashes, widths and shapes. */
#include "theme-private.h"

static const Palette palette = { {
    [INK_BACKGROUND] = 0xffffff,    [INK_PAPER] = 0xffffff,
    [INK_TEXT] = 0x000000,          [INK_SITE] = 0x000000,
    [INK_APEX] = 0x000000,          [INK_HOVER] = 0x5a5a5a,
    [INK_VISIBLE] = 0x000000,       [INK_VISIBLE_UPPER] = 0x000000,
    [INK_CONE] = 0xffffff,          [INK_CONE_LINE] = 0x000000,
    [INK_IN_HAND] = 0x000000,       [INK_HORIZON] = 0x000000,
    [INK_DELAUNAY] = 0x303030,      [INK_VORONOI] = 0x6a6a6a,
    [INK_CIRCLE] = 0x757575,        [INK_LOWER] = 0xe4e4e4,
    [INK_UPPER] = 0xffffff,         [INK_VERTICAL] = 0xffffff,
    [INK_VERTICAL_LINE] = 0x505050, [INK_RIDGE] = 0x303030,
    [INK_SHEET] = 0xffffff,         [INK_SHEET_LINE] = 0x808080,
    [INK_LIFT] = 0x6a6a6a,          [INK_FOOT] = 0x404040,
    [INK_GROUND] = 0x808080,        [INK_FURTHEST] = 0x000000,
} };

static void
hatch (Theme *theme, Role role, Hatch hatch, uint32_t rgb)
{
  theme->styles[role].hatch = hatch;
  theme->styles[role].line = theme_colour (rgb, 1);
}

static void
dash (Theme *theme, Role role, double dash, double gap)
{
  theme->styles[role].dash = dash;
  theme->styles[role].gap = gap;
}

void
theme_print (Theme *theme)
{
  theme_dip (theme, &palette);
  theme->cell_lightness = 1;
  theme->cell_chroma = 0;
  theme->styles[ROLE_SHEET].fill.alpha = 0;
  theme->styles[ROLE_VISIBLE].fill.alpha = 0;
  theme->styles[ROLE_VISIBLE_UPPER].fill.alpha = 0;
  hatch (theme, ROLE_UPPER, HATCH_LEVEL, 0x808080);
  hatch (theme, ROLE_CONE, HATCH_UPRIGHT, 0x505050);
  hatch (theme, ROLE_CONE_UPPER, HATCH_GRID, 0x505050);
  theme->styles[ROLE_SELECTED_FACET].line = theme_colour (0x808080, 1);
  theme->styles[ROLE_SELECTED_FACET].width = 6;
  theme->styles[ROLE_SELECTED_FACET].casing = 8.5;
  dash (theme, ROLE_VISIBLE_EDGE, 10, 4);
  dash (theme, ROLE_CIRCLE_SELECTED, 18, 3);
}
