/* What lies under the light: pixels of the stock, kept where something is lit,
 * so that they need not be painted again when the light moves on. */
#ifndef UNDERLAY_H
#define UNDERLAY_H

#include "squares.h"

typedef struct Underlay Underlay;

Underlay *underlay_new (void);
void underlay_free (Underlay *underlay);

/* @picture is another one, or shows another stock; it is lit in @lit. Nothing
 * is kept of it. */
void underlay_begin (Underlay *underlay,
                     cairo_surface_t *picture,
                     const Squares *lit);

/* The light moves: it will be in @lit, of the same squares, and @changed is to
 * be painted. Keeps what will be lit, and puts back what no longer is: that is
 * marked no more. */
void underlay_move (Underlay *underlay,
                    cairo_surface_t *picture,
                    const Squares *lit,
                    Squares *changed);

#endif
