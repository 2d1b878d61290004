/* Colours as eyes take them, for tests of themes, and the faults they find.
 * The formulas are the tests' own. */
#ifndef SIGHT_H
#define SIGHT_H

#include "theme.h"

#include <cairo.h>
#include <glib.h>

#define N_VISIONS 3

/* Linear light as an eye with all cones takes it, and without the L or the M
 * cones.
 *
 * Source: Machado, Oliveira, Fernandes 2009, severity 1. */
extern const double sight_visions[N_VISIONS][9];
extern const char *const sight_vision_names[N_VISIONS];

/* Returns: 1 … 21. Source: WCAG 2.1. */
double sight_contrast (Colour a, Colour b);

/* Returns: CIE 1976 lightness, 0 … 100. */
double sight_lightness (Colour c);

/* Returns: @top laid over an opaque ground. */
Colour sight_over (Colour top, Colour ground);

/* Returns: how far apart in OKLab, as seen with one of the visions. */
double sight_distance (Colour a, Colour b, const double *vision);

/* Returns: how an item of the role looks that is neither loud nor pale. */
Style sight_style (const Theme *theme, Role role);

/* Returns: a sample of the legend on the theme's ground, RGB24. */
cairo_surface_t *sight_paint_sample (const Theme *theme,
                                     const SceneItem *sample,
                                     int width,
                                     int height);

/* Notes a fault of a theme, for the test to fail in the end. */
void sight_fault (const Theme *theme,
                  const char *what,
                  int role,
                  const char *ground,
                  double value);

/* Fails when a theme has faults. */
void sight_for_each_theme (void (*check) (const Theme *theme));

#endif
