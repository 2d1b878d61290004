/* For the last row of a lit room: twice the width, large names, and inks that
 * a weak lamp does not wash out. */
#include "theme-private.h"

static const Palette palette = { {
    [INK_BACKGROUND] = 0xffffff,    [INK_PAPER] = 0xffffff,
    [INK_TEXT] = 0x000000,          [INK_SITE] = 0x000000,
    [INK_APEX] = 0xb0006d,          [INK_HOVER] = 0x6a2fb0,
    [INK_VISIBLE] = 0xb84a00,       [INK_VISIBLE_UPPER] = 0x8f3900,
    [INK_CONE] = 0x009e73,          [INK_CONE_LINE] = 0x004a36,
    [INK_SELECTED] = 0x003f87,      [INK_HORIZON] = 0x000000,
    [INK_DELAUNAY] = 0x0050a8,      [INK_VORONOI] = 0x444444,
    [INK_CIRCLE] = 0x2a6cab,        [INK_LOWER] = 0x56b4e9,
    [INK_UPPER] = 0x2f7d33,         [INK_VERTICAL] = 0x9a9996,
    [INK_VERTICAL_LINE] = 0x3a3a3a, [INK_RIDGE] = 0x12324f,
    [INK_SHEET] = 0xe8b923,         [INK_SHEET_LINE] = 0x7a5f0c,
    [INK_LIFT] = 0x444449,          [INK_GROUND] = 0x5e5e66,
    [INK_FURTHEST] = 0x1f5a22,
} };

void
theme_projector (Theme *theme)
{
  theme_dip (theme, &palette);
  theme->text_px = 24;
  theme->line_factor = 2;
  theme->mark_factor = 1.6;
  theme->hatch_px = 14;
  theme->cell_lightness = 0.95;
  theme->cell_chroma = 0.04;
  theme->styles[ROLE_SHEET].line.alpha = 0.6;
  theme->styles[ROLE_LIFT_APEX].line = theme_colour (0x860053, 1);
}
