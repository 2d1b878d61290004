/* Sites: the points of the plane that everything starts from.
 *
 *   Site corners[] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 1 } };
 *   SiteSet *set = site_set_new (corners, 4);
 *
 *   set->n_sites == 4; set->n_distinct == 3; set->first[3] == 2;
 *
 * A SiteSet never changes; an edit makes a new one.
 */
#ifndef SITE_H
#define SITE_H

#include <stdbool.h>
#include <stdint.h>

#define INDEX_NONE UINT32_MAX

/* A point of the plane. Its lift is (x, y, x² + y²), which is never stored:
 * the predicates take the site, so that z is never rounded. */
typedef struct Site {
  double x, y; /* plane units, always finite */
} Site;

typedef struct SiteSet {
  Site *sites;         /* the given coordinates times 2^-exponent, exactly */
  uint32_t *first;     /* first[i]: the lowest index of a site equal to i */
  uint32_t n_sites;    /* as given, duplicates included */
  uint32_t n_distinct; /* sites that are their own first */
  int exponent;        /* 0 unless the magnitudes are extreme */
} SiteSet;

/* The signs of predicate.h are exact while all non-zero magnitudes lie within
 * 2^-SITE_RANGE … 2^SITE_RANGE (and a little beyond: below twice the latter).
 */
#define SITE_RANGE 145

/* Whether @site, in the units of SiteSet.sites, lies in the range. */
bool site_is_in_range (const Site *site);

/* A square around the sites: all that views need to know to fill themselves,
 * whatever the scale and the offset. */
typedef struct Extent {
  Site centre;
  double radius; /* half the side, never 0 */
} Extent;

/* Order from left to right, and upwards among sites of one x.
 *
 * Returns: -1, 0 or +1. */
int site_compare (const Site *a, const Site *b);

/* Copies @sites; a negative zero becomes zero.
 *
 * Returns: the set, or NULL when no power of two brings all non-zero
 *          magnitudes into the range, or a coordinate is not finite.
 * Cost:    O(n log n).
 */
SiteSet *site_set_new (const Site *sites, uint32_t n_sites);
void site_set_free (SiteSet *set);

/* Returns: the site's coordinates as they were given. */
Site site_set_given (const SiteSet *set, uint32_t site);

/* Returns: the smallest square around all sites; radius 1 around a lone
 *          site, the square of radius 1 around the origin for none. */
Extent site_set_extent (const SiteSet *set);

/* The magnitudes seen so far, to find the line on which a file leaves the
 * range. */
typedef struct SiteRange {
  int lowest, highest; /* binary exponents; lowest > highest: none yet */
} SiteRange;

#define SITE_RANGE_INIT                                                        \
  {                                                                            \
    INT32_MAX, INT32_MIN                                                       \
  }

/* Returns: false when no exact scaling fits @site and all before it. */
bool site_range_add (SiteRange *range, const Site *site);

#endif
