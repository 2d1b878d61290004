/* What rounding does to geometry: the sign of an area in plain doubles beside
 * the true one, and the hull that such signs lead to. A demonstration: nothing
 * else in the program uses these signs.
 *
 * Source: Kettner, Mehlhorn, Pion, Schirra, Yap 2008, "Classroom examples of
 *         robustness problems in geometric computations".
 */
#ifndef ROUNDING_H
#define ROUNDING_H

#include "course.h"
#include "narration.h"
#include "pseudocode.h"

/* Sign of (qx - px)(ry - py) - (qy - py)(rx - px), each operation rounded
 * once to a double, as a program without care has it.
 *
 * Returns: +1, 0 or -1; right when the true area is large. */
int rounded_orient (const Site *p, const Site *q, const Site *r);

/* Sites on each side of a sign map. */
#define SIGN_MAP_SIDE 256

/* The signs of the turns p q r for fixed q and r, and for p on every node of
 * a grid round a site: the finest one on which doubles of its size lie. */
typedef struct SignMap {
  Site corner; /* p in the lower left */
  double step; /* of the grid: a unit in the last place */
  Site q, r;
  signed char rounded[SIGN_MAP_SIDE][SIGN_MAP_SIDE]; /* [row][column] */
  signed char exact[SIGN_MAP_SIDE][SIGN_MAP_SIDE];
  uint32_t n_wrong; /* nodes where they differ */
} SignMap;

/* Returns: false when exact signs are not to be had: the grid is finer than
 *          SITE_RANGE allows, or reaches beyond it. */
bool sign_map_init (SignMap *map, const Site *p, const Site *q, const Site *r);

/* Returns: p at a node of the grid. */
Site sign_map_site (const SignMap *map, uint32_t column, uint32_t row);

/* The hull in the plane by insertion, as first written down: find an edge
 * that the site sees, go on from it in both directions while edges are seen or
 * in line, put two edges in the place of all these. Every decision is a
 * rounded sign. */
typedef enum RoundedKind {
  ROUNDED_TRIANGLE, /* the first triangle */
  ROUNDED_INSIDE,   /* the site sees no edge: it is dropped */
  ROUNDED_INSERT,   /* the site is a corner now */
  ROUNDED_STUCK,    /* it seems to see every edge: there is no end to the way
                       round, and the program hangs */
} RoundedKind;

typedef struct RoundedStep {
  RoundedKind kind;
  uint32_t site;     /* that was tried; of the triangle its last */
  uint32_t n_seen;   /* edges in the chain found */
  uint32_t n_wrong;  /* edges on whose turn the rounded sign is wrong */
  uint32_t wrong[2]; /* tail and head of the first of these */
} RoundedStep;

/* More sites than this are not tried: each step is found from the start. */
#define ROUNDED_MOST 500

/* At one step: the hull that rounding leads to beside the true one of the
 * same sites. */
typedef struct RoundedHull {
  const SiteSet *set; /* borrowed */
  uint32_t *order;    /* the distinct sites as they are tried */
  uint32_t n_order;
  uint32_t *corners; /* of the rounded hull, in its order */
  uint32_t n_corners;
  uint32_t *true_corners; /* counter-clockwise */
  uint32_t n_true;
  RoundedStep *steps; /* step i + 1; the first triangle is step 1 */
  uint32_t n_steps;   /* done */
  uint32_t n_lost;    /* sites tried that lie outside the rounded hull, though
                         it took them to be inside */
} RoundedHull;

/* Does @n_steps steps at most, and none after it is stuck. */
void
rounded_hull_init (RoundedHull *hull, const SiteSet *set, uint32_t n_steps);
void rounded_hull_clear (RoundedHull *hull);

bool rounded_hull_has_tried (const RoundedHull *hull, uint32_t site);

/* Of the true hull, when @is_exact, or of the rounded one. */
bool
rounded_hull_has_corner (const RoundedHull *hull, bool is_exact, uint32_t site);

/* Returns: whether the site was tried and is a corner of the true hull, but
 *          not of the rounded one. */
bool rounded_hull_has_lost (const RoundedHull *hull, uint32_t site);

/* One sentence for the last step; @translate may be NULL. */
void rounded_narration_write (const RoundedHull *hull,
                              NarrationTranslate translate,
                              char text[NARRATION_ROOM]);

const PseudocodeLine *rounded_pseudocode_lines (uint32_t *n_lines);
uint32_t rounded_pseudocode_line (const RoundedHull *hull);

#endif
