/* Themes: how each role looks. Painters take every colour, width and dash
 * from here and from nowhere else. */
#ifndef THEME_H
#define THEME_H

#include "scene.h"

typedef struct Colour {
  double red, green, blue, alpha; /* 0 … 1, not premultiplied */
} Colour;

typedef enum Hatch {
  HATCH_NONE,
  HATCH_RISING, /* strokes like / */
  HATCH_CROSSED,
} Hatch;

typedef enum MarkShape {
  MARK_DOT,
  MARK_RING, /* a dot with a ring round it */
  MARK_DIAMOND,
  MARK_CROSS,
} MarkShape;

/* How a role looks. Lengths in px at scale 1. */
typedef struct Style {
  Colour fill; /* alpha 0: not filled */
  Hatch hatch; /* in the line colour */
  Colour line; /* alpha 0: no outline */
  double width;
  double dash;   /* length of dashes, 0: solid */
  double casing; /* whole width of a casing in the background colour, 0: none */
  MarkShape mark;
  double mark_radius;
} Style;

typedef struct Theme {
  const char *name;
  Colour background, text, selection, hover;
  double text_px;     /* labels */
  double line_factor; /* all widths are multiplied by it */
  Style styles[N_ROLES];
} Theme;

typedef enum ThemeKind {
  THEME_LIGHT,
} ThemeKind;

const Theme *theme_get (ThemeKind kind);

/* The style of @item: its role's, made pale or loud, lit or not. Cells take
 * a pale hue of their own. */
Style theme_style (const Theme *theme, const SceneItem *item);

/* Contrast ratio of two opaque colours, 1 … 21. Source: WCAG 2.1. */
double colour_contrast (Colour a, Colour b);

#endif
