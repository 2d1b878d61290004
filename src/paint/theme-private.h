/* How themes are put together: one table says for each role which ink it is
 * drawn in, how wide, how dashed, with which mark (theme-roles.c); a theme is
 * a palette of inks, and what it does otherwise. */
#ifndef THEME_PRIVATE_H
#define THEME_PRIVATE_H

#include "theme.h"

typedef enum Ink {
  INK_NONE,
  INK_BACKGROUND, /* of the picture; casings */
  INK_PAPER,      /* of the plane in space; inside hollow marks */
  INK_TEXT,
  INK_SITE,
  INK_APEX, /* the current site, and the person's selection */
  INK_HOVER,
  INK_VISIBLE, /* what the current site sees */
  INK_VISIBLE_UPPER,
  INK_CONE, /* what is new */
  INK_CONE_LINE,
  INK_SELECTED, /* the facet whose outside set is used, and that set */
  INK_HORIZON,
  INK_DELAUNAY,
  INK_VORONOI,
  INK_CIRCLE,
  INK_LOWER,
  INK_UPPER,
  INK_VERTICAL,
  INK_VERTICAL_LINE,
  INK_RIDGE,
  INK_SHEET,
  INK_SHEET_LINE,
  INK_LIFT,
  INK_GROUND,
  INK_FURTHEST, /* furthest-site diagrams */
  N_INKS,
} Ink;

/* 0xrrggbb for each ink. */
typedef struct Palette {
  uint32_t inks[N_INKS];
} Palette;

/* A theme with the styles of theme-roles.c in the inks of @palette. */
void theme_dip (Theme *theme, const Palette *palette);

/* 0xrrggbb as a colour. */
Colour theme_colour (uint32_t rgb, double alpha);

/* One file each. */
void theme_light (Theme *theme);
void theme_paper (Theme *theme);
void theme_projector (Theme *theme);
void theme_dark (Theme *theme);
void theme_print (Theme *theme);
void theme_contrast (Theme *theme);

#endif
