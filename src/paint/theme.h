/* Themes: how each role looks. Painters take every colour, width and dash
 * from here and from nowhere else.
 *
 *   Theme theme;
 *
 *   theme_init (&theme, &appearance);
 *   painter_paint (cr, &scene, &projection, &theme, 0);
 */
#ifndef THEME_H
#define THEME_H

#include "appearance.h"
#include "scene.h"

typedef struct Colour {
  double red, green, blue, alpha; /* 0 … 1, sRGB, not premultiplied */
} Colour;

typedef enum Hatch {
  HATCH_NONE,
  HATCH_RISING,  /* strokes like / */
  HATCH_FALLING, /* strokes like \, further apart */
  HATCH_CROSSED,
  HATCH_LEVEL,
  HATCH_UPRIGHT,
  HATCH_CLOSE, /* upright, twice as close */
  HATCH_FINE,  /* level, so close that it is a tint */
} Hatch;

typedef enum MarkShape {
  MARK_NONE,
  MARK_DOT,
  MARK_HOLLOW, /* a ring */
  MARK_RINGED, /* a ring with a second ring round it */
  MARK_DIAMOND,
  MARK_CROSSED, /* a dot with a cross through it */
} MarkShape;

/* How a role looks. Lengths in px at scale 1. A colour of alpha 0 is not
 * painted. */
typedef struct Style {
  Colour fill; /* of polygons and hollow marks */
  Hatch hatch; /* in the line colour */
  double hatch_width;
  Colour line; /* of outlines, paths, solid marks */
  double width;
  double dash, gap; /* of dashes; dash 0: solid. Dots: dash below width */
  double casing;    /* whole width of a casing in the background colour; of
                       marks: width of the ring round them; 0: none */
  MarkShape mark;
  double radius;     /* of the mark */
  double ring_gap;   /* between the two rings of a ringed mark */
  Colour halo;       /* round an item that is lit */
  double halo_width; /* on every side */
  bool is_shaded;    /* facets: lighter where they face the eye */
} Style;

typedef struct Theme {
  const char *name;
  Colour background, text, selection, hover;
  Colour selected_facet; /* and its circle; else as selection */
  Colour selected_area;  /* inside of a selected triangle; alpha 0: its own */
  Colour apex_text;      /* label of the current site */
  const char *font;      /* Pango family list of labels */
  double text_px;        /* labels; that of the current site is larger */
  double line_factor;    /* theme_style() multiplies widths and dashes by it */
  double mark_factor;    /* and the lengths of marks by this */
  double hatch_px;       /* between two strokes */
  double cell_lightness, cell_chroma; /* of the cells' hues, OKLCh */
  double cell_loudness;               /* by how much a new cell has more */
  double pale_line;                   /* how far what is pale keeps its ink */
  double pale_contrast;               /* but it is never less than this */
  double pale_width;                  /* of lines that are pale */
  double pale_hatch;                  /* of strokes of their hatches */
  double pale_fill;                   /* alpha of areas that are pale */
  double pale_cell; /* of cells, whose hue is still their site's */
  double far_line;  /* alpha of lines behind the hull */
  double far_width;
  double far_casing; /* of sites behind the hull */
  bool has_mat;      /* pure hues: neither the sheet nor far facets may shine
                        through facets and change them */
  bool has_plates;   /* hatches and lines are all over: names lie on plates */
  Style styles[N_ROLES];
  Colour pale_lines[N_ROLES]; /* as far from the ground as must be */
} Theme;

/* Thinner lines would break where pixels are few, px. */
#define HAIRLINE 0.5

/* Returns: a theme in its own sizes; it lasts as long as the program. */
const Theme *theme_get (ThemeKind kind);

/* A theme in the sizes that a person wants. */
void theme_init (Theme *theme, const Appearance *appearance);

/* Returns: whether all looks the same in both. */
bool colour_equal (Colour a, Colour b);
bool theme_equal (const Theme *a, const Theme *b);

/* The style of @item: its role's, made pale or loud, lit or not. Cells take
 * a pale hue of their own, which stays with their site: neighbours in number
 * are a golden angle apart. */
Style theme_style (const Theme *theme, const SceneItem *item);

/* A site that the hull hides is a smaller and paler mark without a ring, so
 * that it does not seem to lie on the facet before it. Where lattices are as
 * bright as sites, a narrow dark ring parts it from them. */
void theme_put_behind (const Theme *theme, Style *style);

/* Whether the fill of a role is that of each item's own hue. */
bool theme_has_hue (Role role);

/* Contrast ratio of two opaque colours, 1 … 21. Source: WCAG 2.1. */
double colour_contrast (Colour a, Colour b);

/* Mixes @part of @b into @a, alpha stays. */
Colour colour_mix (Colour a, Colour b, double part);

/* An opaque colour of equal looks whatever its hue, in turns. Out of gamut
 * it is clamped. Source: Ottosson 2020, OKLCh. */
Colour colour_oklch (double lightness, double chroma, double hue);

#endif
