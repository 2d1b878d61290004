/* The colours that the paper of 2004 names: cells in colours, black Voronoi
 * edges, heavy blue Delaunay edges, a transparent yellow paraboloid, cyan
 * lower and green upper facets, magenta for what is selected, light blue
 * circumcircles and a red one for the selected triangle, which is light red.
 * Where pure colours could not be seen on white, they are darker. */
#include "theme-private.h"

/* A yellow sheet seen through a cyan facet, or a cyan facet through it, would
 * be the green of upper facets: the hull is cut out of the sheet. */

static const Palette palette = { {
    [INK_BACKGROUND] = 0xffffff,    [INK_PAPER] = 0xffffff,
    [INK_TEXT] = 0x000000,          [INK_SITE] = 0x000000,
    [INK_APEX] = 0xb800b8,          [INK_HOVER] = 0x6a2fb0,
    [INK_VISIBLE] = 0xb34700,       [INK_VISIBLE_UPPER] = 0x8f3900,
    [INK_CONE] = 0xb45cf0,          [INK_CONE_LINE] = 0x3d0c80,
    [INK_SELECTED] = 0x4a2200,      [INK_HORIZON] = 0x000000,
    [INK_DELAUNAY] = 0x0000d8,      [INK_VORONOI] = 0x000000,
    [INK_CIRCLE] = 0x1a6ea6,        [INK_LOWER] = 0x00ffff,
    [INK_UPPER] = 0x00bb00,         [INK_VERTICAL] = 0xb4b4b4,
    [INK_VERTICAL_LINE] = 0x404040, [INK_RIDGE] = 0x001a33,
    [INK_SHEET] = 0xffff00,         [INK_SHEET_LINE] = 0x6e6500,
    [INK_LIFT] = 0x222222,          [INK_GROUND] = 0x666666,
    [INK_FURTHEST] = 0x008000,
} };

void
theme_paper (Theme *theme)
{
  theme_dip (theme, &palette);
  theme->cell_lightness = 0.9;
  theme->cell_chroma = 0.06;
  theme->cell_loudness = 1.3;
  theme->has_mat = true;
  /* The facets before what is hidden are of full colours. */
  theme->far_casing = 0.8;
  theme->styles[ROLE_SHEET].fill.alpha = 0.13;
  theme->styles[ROLE_CONE].fill.alpha = 0.6;
  theme->selected_area = theme_colour (0xffb3b3, 0.85);
  /* A green veil before the violet of the cone would be grey. */
  theme->pale_fill = 0.08;
  theme->styles[ROLE_LOWER].fill.alpha = 1;
  theme->styles[ROLE_UPPER].fill.alpha = 1;
  theme->styles[ROLE_HULL_AREA].fill.alpha = 0.5;
  theme->styles[ROLE_DELAUNAY_EDGE].width = 3.6;
  theme->styles[ROLE_FURTHEST_EDGE].width = 5;
  theme->styles[ROLE_CONE_EDGE].width = 5;
  theme->styles[ROLE_CONE_EDGE].casing = 7;
  /* Feet are as black. */
  theme->styles[ROLE_VORONOI_VERTEX].radius = 1.8;
  theme->selected_facet = theme_colour (0xd00000, 1);
  theme->styles[ROLE_LIFT_APEX].line = theme_colour (0x5a005a, 1);
}
