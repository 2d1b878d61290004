/* How large and in which theme a person wants the pictures. Here are the
 * names alone: what a theme looks like is the matter of paint/theme.h, and no
 * scene depends on it. */
#ifndef APPEARANCE_H
#define APPEARANCE_H

#include <stdbool.h>

typedef enum ThemeKind {
  THEME_LIGHT,
  THEME_PAPER,     /* the colours of the paper of 2004 */
  THEME_PROJECTOR, /* heavy lines, large names */
  THEME_DARK,
  THEME_PRINT,    /* black and white: hatches, dashes, shapes */
  THEME_CONTRAST, /* bright on black, 7:1 at least */
} ThemeKind;

#define N_THEMES (THEME_CONTRAST + 1)

const char *theme_kind_name (ThemeKind kind); /* "light" … */
bool theme_kind_parse (const char *name, ThemeKind *kind);

typedef struct Appearance {
  ThemeKind theme;
  double line_scale; /* of the theme's widths, SCALE_LEAST … SCALE_MOST */
  double mark_scale; /* of its marks */
  double text_scale; /* of its names */
} Appearance;

#define SCALE_LEAST 0.5
#define SCALE_MOST 3.0

/* The light theme as it is. */
void appearance_init (Appearance *appearance);
bool appearance_equal (const Appearance *a, const Appearance *b);

#endif
