/* For eyes that need it: pure bright inks on black. */
#include "theme-private.h"

static const Palette palette = { {
    [INK_BACKGROUND] = 0x000000,    [INK_PAPER] = 0x000000,
    [INK_TEXT] = 0xffffff,          [INK_SITE] = 0xffffff,
    [INK_APEX] = 0xff8cc8,          [INK_HOVER] = 0xd0b8ff,
    [INK_VISIBLE] = 0xffb000,       [INK_VISIBLE_UPPER] = 0xffd27a,
    [INK_CONE] = 0x008a63,          [INK_CONE_LINE] = 0x00b884,
    [INK_SELECTED] = 0x7fd4ff,      [INK_HORIZON] = 0xffffff,
    [INK_DELAUNAY] = 0x7ab8ff,      [INK_VORONOI] = 0xd8d8d8,
    [INK_CIRCLE] = 0x9ad0ff,        [INK_LOWER] = 0x1a5c9c,
    [INK_UPPER] = 0x125c22,         [INK_VERTICAL] = 0x303030,
    [INK_VERTICAL_LINE] = 0xe0e0e0, [INK_RIDGE] = 0xffffff,
    [INK_SHEET] = 0xffff00,         [INK_SHEET_LINE] = 0xe6d060,
    [INK_LIFT] = 0xd8d8d8,          [INK_GROUND] = 0xc8c8c8,
    [INK_FURTHEST] = 0x8fe09a,
} };

void
theme_contrast (Theme *theme)
{
  theme_dip (theme, &palette);
  theme->far_casing = 0.8;
  theme->line_factor = 1.3;
  theme->mark_factor = 1.2;
  theme->text_px = 18;
  theme->cell_lightness = 0.27;
  theme->cell_chroma = 0.04;
  theme->pale_cell = 0.6;
  /* Less of it would be black on black. */
  theme->pale_fill = 0.7;
  theme->styles[ROLE_LOWER].fill.alpha = 0.8;
  theme->styles[ROLE_UPPER].fill.alpha = 0.8;
  theme->styles[ROLE_CONE].fill.alpha = 0.5;
  theme->styles[ROLE_HULL_AREA].fill.alpha = 0.8;
  theme->styles[ROLE_UPPER].hatch = HATCH_LEVEL;
  theme->styles[ROLE_UPPER].line = theme_colour (0x8fe09a, 1);
  theme->styles[ROLE_SHEET].line.alpha = 0.6;
  theme->styles[ROLE_SIGN_LEFT].fill = theme_colour (0x2f7fd0, 1);
  theme->styles[ROLE_SIGN_RIGHT].fill = theme_colour (0x6e5c00, 1);
  theme->pale_line = 0.75;
  theme->pale_contrast = 4.6;
}
