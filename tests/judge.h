/* An independent judge for the tests: brute force over integers of any size
 * (GMP). It shares no arithmetic and no data structure with the engine; it
 * knows only the definitions. */
#ifndef JUDGE_H
#define JUDGE_H

#include "site.h"

#include <gmp.h>

typedef struct Judge {
  uint32_t n_sites;
  mpz_t *x, *y; /* all coordinates times one power of two: integers */
} Judge;

Judge *judge_new (const SiteSet *set);
void judge_free (Judge *judge);

/* Returns: +1 left turn, -1 right turn, 0 collinear. */
int judge_orient (const Judge *judge, uint32_t a, uint32_t b, uint32_t c);

/* Compares the turns a, b, p and a, b, q: twice the areas, with their signs.
 *
 * Returns: the sign of the first minus the second. */
int judge_compare_areas (const Judge *judge,
                         const uint32_t line[2],
                         uint32_t p,
                         uint32_t q);

/* The power of @site with respect to the circle through three sites, times a
 * positive number that depends on the circle alone. Through the centre, not
 * through the determinant that the engine uses.
 *
 * Returns: its sign: -1 strictly inside, 0 on the circle, +1 outside. */
int judge_power (const Judge *judge,
                 const uint32_t circle[3],
                 uint32_t site,
                 mpz_t power);
int judge_circle (const Judge *judge, const uint32_t circle[3], uint32_t site);

/* The convex hull in the plane of the sites listed in @active (distinct).
 * @corners has room for n_active + 1: strictly extreme sites,
 * counter-clockwise.
 *
 * Returns: their number; 2 when the sites are collinear. */
uint32_t judge_hull (const Judge *judge,
                     const uint32_t *active,
                     uint32_t n_active,
                     uint32_t *corners);

/* Returns: +1 when @site lies strictly inside the polygon, 0 on its border,
 *          -1 outside. Shape: convex, counter-clockwise. */
int judge_inside (const Judge *judge,
                  const uint32_t *corners,
                  uint32_t n_corners,
                  uint32_t site);

/* Returns: whether two segments cross in a point inside both. */
bool judge_cross (const Judge *judge, const uint32_t p[2], const uint32_t q[2]);

/* Adds twice the area of the polygon to @area; negative when clockwise. */
void judge_add_area (const Judge *judge,
                     const uint32_t *corners,
                     uint32_t n_corners,
                     mpz_t area);

#endif
