#include "theme-private.h"

/* After Okabe and Ito 2008, darkened where a mark asks for it. */
static const Palette palette = { {
    [INK_BACKGROUND] = 0xfcfcfb,    [INK_PAPER] = 0xffffff,
    [INK_TEXT] = 0x241f31,          [INK_SITE] = 0x241f31,
    [INK_APEX] = 0xc2187f,          [INK_HOVER] = 0x7a3fc0,
    [INK_VISIBLE] = 0xcc5800,       [INK_VISIBLE_UPPER] = 0xa64900,
    [INK_CONE] = 0x009e73,          [INK_CONE_LINE] = 0x00664a,
    [INK_SELECTED] = 0x0a529b,      [INK_HORIZON] = 0x1a1a1a,
    [INK_DELAUNAY] = 0x0b5cad,      [INK_VORONOI] = 0x555555,
    [INK_CIRCLE] = 0x3f7cbb,        [INK_LOWER] = 0x56b4e9,
    [INK_UPPER] = 0x3d8b40,         [INK_VERTICAL] = 0x9a9996,
    [INK_VERTICAL_LINE] = 0x5e5c64, [INK_RIDGE] = 0x1d3a5a,
    [INK_SHEET] = 0xe8b923,         [INK_SHEET_LINE] = 0x9c7a12,
    [INK_LIFT] = 0x46454b,          [INK_GROUND] = 0x7a7981,
    [INK_FURTHEST] = 0x2f7033,
} };

void
theme_light (Theme *theme)
{
  theme_dip (theme, &palette);
  theme->styles[ROLE_LIFT_APEX].line = theme_colour (0x940f60, 1);
}
