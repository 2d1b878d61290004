/* Light on dark, no part of it glaring. */
#include "theme-private.h"

static const Palette palette = { {
    [INK_BACKGROUND] = 0x1e1e23,    [INK_PAPER] = 0x2a2a31,
    [INK_TEXT] = 0xf1eff6,          [INK_SITE] = 0xf1eff6,
    [INK_APEX] = 0xff7cc4,          [INK_HOVER] = 0xc9a0ff,
    [INK_VISIBLE] = 0xff9a45,       [INK_VISIBLE_UPPER] = 0xffb879,
    [INK_CONE] = 0x19a67d,          [INK_CONE_LINE] = 0x62d8b4,
    [INK_SELECTED] = 0x8cc8ff,      [INK_HORIZON] = 0xffffff,
    [INK_DELAUNAY] = 0x6fb1ff,      [INK_VORONOI] = 0xb4b2bd,
    [INK_CIRCLE] = 0x86aed6,        [INK_LOWER] = 0x2a7ab0,
    [INK_UPPER] = 0x2f6e3a,         [INK_VERTICAL] = 0x6a6872,
    [INK_VERTICAL_LINE] = 0xc4c2cc, [INK_RIDGE] = 0xbfe0f7,
    [INK_SHEET] = 0xe8b923,         [INK_SHEET_LINE] = 0xd0ac45,
    [INK_LIFT] = 0xb0aeb9,          [INK_GROUND] = 0x96949e,
    [INK_FURTHEST] = 0x7fd18a,
} };

void
theme_dark (Theme *theme)
{
  theme_dip (theme, &palette);
  theme->far_casing = 0.8;
  theme->cell_lightness = 0.31;
  theme->cell_chroma = 0.03;
  /* Paler, a lower facet would look like an upper one. */
  theme->pale_fill = 0.5;
  theme->styles[ROLE_SIGN_RIGHT].fill = theme_colour (0x7d6415, 1);
  theme->styles[ROLE_LIFT_APEX].line = theme_colour (0xff9fd4, 1);
}
