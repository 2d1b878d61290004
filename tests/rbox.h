/* Sets in the spirit of qhull's rbox: what hulls are usually tried on, and
 * what has broken other programs. Only sums, products, quotients and square
 * roots make them, which are rounded alike everywhere, so that a seed is the
 * same set on every machine. */
#ifndef RBOX_H
#define RBOX_H

#include "site.h"

#include <glib.h>

typedef enum Rbox {
  RBOX_CUBE,      /* uniform in a square */
  RBOX_DIAMOND,   /* corners of many diamonds */
  RBOX_BALL,      /* uniform in a disc */
  RBOX_SPHERE,    /* on a circle, as near as doubles come */
  RBOX_SHELL,     /* between two circles 2^-30 apart */
  RBOX_REGULAR,   /* a regular polygon, rounded */
  RBOX_SPIRAL,    /* outwards, a little turn each */
  RBOX_LENS,      /* on two large circles that meet */
  RBOX_MESH,      /* a grid of integers */
  RBOX_ROTATED,   /* the same turned by 3:4:5 and rounded */
  RBOX_COSPHERE,  /* exactly on a few circles around one centre */
  RBOX_INTEGERS,  /* few integers: ties and duplicates */
  RBOX_MIRRORED,  /* each site four times: (±x, ±y) */
  RBOX_LINE,      /* exactly on one line, and a few beside it */
  RBOX_NEAR_LINE, /* on a line as near as doubles come */
  RBOX_PARABOLA,  /* on y = x² */
  RBOX_CLUSTERS,  /* knots 2^-40 across */
  RBOX_KUZMIN,    /* dense in the middle, without a border */
  RBOX_TWINS,     /* each site and its neighbours one ulp away */
  RBOX_POWERS,    /* powers of two from 2^-145 to 2^145 */
  RBOX_OFFSET,    /* a small square far away */
  RBOX_BOX,       /* a small square inside a huge one's corners */
  RBOX_WIDTH,     /* within 2^-20 of a square's border */
  RBOX_SUBNORMAL, /* a few units of the smallest double */
  RBOX_HUGE,      /* up to the largest doubles */
} Rbox;

#define N_RBOXES (RBOX_HUGE + 1)

/* Returns: (transfer full): about @n sites. */
SiteSet *rbox_new (Rbox kind, guint32 seed, guint n);

/* Returns: "cube" and so on. */
const char *rbox_name (Rbox kind);

/* Calls @check for fixture_n_seeds (@n) seeds of every kind with at most
 * @most sites. @name names kind and seed. */
void rbox_for_each (guint n,
                    guint most,
                    void (*check) (const SiteSet *set, const char *name));

#endif
