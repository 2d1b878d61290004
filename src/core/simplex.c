/* The first simplex: the first three distinct sites in the order of
 * insertion and the first one whose lift is not coplanar with theirs, so that
 * an author chooses it by the order of the sites. No three lifts are
 * collinear, so any three distinct sites will do as its base. */
#include "exact-vector.h"
#include "hull-builder.h"
#include "memory.h"

#include <float.h>
#include <math.h>

static bool
is_same (const Site *a, const Site *b)
{
  return a->x == b->x && a->y == b->y;
}

/* Whether the site can join those found so far. */
static bool
is_fit (const HullBuilder *b, uint32_t site, uint32_t n_found)
{
  const Site *sites = b->sites;
  const uint32_t *found = b->simplex;
  uint32_t i;

  if (b->first != NULL && b->first[site] != site)
    return false;
  if (n_found == 3)
    return lift_orient (&sites[found[0]], &sites[found[1]], &sites[found[2]],
                        &sites[site])
           != 0;
  for (i = 0; i < n_found; i++)
    if (is_same (&sites[site], &sites[found[i]]))
      return false;
  return true;
}

bool
simplex_find (HullBuilder *b)
{
  uint32_t n_found = 0;
  uint32_t i;

  for (i = 0; i < b->n_sites && n_found < 4; i++) {
    const uint32_t site = b->list != NULL ? b->list[i] : i;

    if (is_fit (b, site, n_found))
      b->simplex[n_found++] = site;
  }
  return n_found == 4;
}

static inline bool
is_whole_number (double value)
{
  return (double)(int32_t)value == value;
}

/* Whether the sites lie whole steps from the corner @low, exactly, and less
 * than 2^12 of them. Then so do differences of sites, and each term and sum of
 * a determinant is a whole number below 12 · 2^48: none is rounded. */
static bool
is_whole (const HullBuilder *b, Site low, double side)
{
  const double scale = ldexp (1, 11 - ilogb (side));
  uint32_t i;

  for (i = 0; i < b->n_sites; i++) {
    const Vector v = vector_between (&low, &b->sites[i]);

    if (v.x.low != 0 || v.y.low != 0 || !is_whole_number (v.x.high * scale)
        || !is_whole_number (v.y.high * scale))
      return false;
  }
  return true;
}

/* Bounds for the filters, from the side of a square around all sites.
 * Shewchuk 1997, ccwerrboundA and iccerrboundA: 3 and 10 half ulps and a
 * little of the sum of the terms' magnitudes, which is at most 2 side² and
 * 12 side⁴. DBL_MIN is more than underflow can take away. */
static void
set_doubts (HullBuilder *b)
{
  Site low = b->sites[0], high = b->sites[0];
  double side;
  uint32_t i;

  for (i = 1; i < b->n_sites; i++) {
    const Site *site = &b->sites[i];

    low.x = site->x < low.x ? site->x : low.x;
    low.y = site->y < low.y ? site->y : low.y;
    high.x = site->x > high.x ? site->x : high.x;
    high.y = site->y > high.y ? site->y : high.y;
  }
  side = fmax (high.x - low.x, high.y - low.y);
  b->is_whole = is_whole (b, low, side);
  b->orient_doubt = 5 * (DBL_EPSILON / 2) * 2 * side * side + DBL_MIN;
  b->doubt = 16 * (DBL_EPSILON / 2) * 12 * side * side * side * side + DBL_MIN;
}

static void
swap (uint32_t *a, uint32_t *b)
{
  const uint32_t c = *a;

  *a = *b;
  *b = c;
}

/* Turns the base so that the top lies behind it. */
static void
orient_base (HullBuilder *b)
{
  const Site *sites = b->sites;
  uint32_t *site = b->simplex;

  if (lift_orient (&sites[site[0]], &sites[site[1]], &sites[site[2]],
                   &sites[site[3]])
      < 0)
    return;
  swap (&site[1], &site[2]);
}

/* Puts three of the four sites that are not collinear under the site at
 * infinity, clockwise; the fourth waits like all others. */
static void
put_infinity_on_top (HullBuilder *b)
{
  const Site *sites = b->sites;
  uint32_t *site = b->simplex;

  /* If three are collinear, the fourth does not lie on their line. */
  if (orient (&sites[site[0]], &sites[site[1]], &sites[site[2]]) == 0)
    site[2] = site[3];
  if (orient (&sites[site[0]], &sites[site[1]], &sites[site[2]]) > 0)
    swap (&site[1], &site[2]);
  site[3] = b->n_sites;
}

/* Facet 0 is the base; facet 1 + i joins the top to the base's edge i, which
 * is its edge 2. */
void
simplex_build (HullBuilder *b)
{
  const uint32_t *s = b->simplex;
  uint32_t i;

  set_doubts (b);
  if (HULL_IS_LOWER)
    put_infinity_on_top (b);
  else
    orient_base (b);
  if (b->facets_room < 4)
    b->facets = memory_grow (b->facets, &b->facets_room, 4, sizeof *b->facets);
  b->n_facets = 4;
  b->near = HULL_IS_LOWER ? 0 : 1; /* a lower facet, or one of the top */
  b->counts.facets_created = 4;
  b->facets[0] = (HullFacet){
    { s[0], s[1], s[2] }, { 1 << 2 | 2, 2 << 2 | 2, 3 << 2 | 2 }, INDEX_NONE, 0
  };
  for (i = 0; i < 3; i++)
    b->facets[1 + i] = (HullFacet){ { s[i], s[3], s[(i + 1) % 3] },
                                    { (1 + (i + 2) % 3) << 2 | 1,
                                      (1 + (i + 1) % 3) << 2, i },
                                    INDEX_NONE,
                                    0 };
  for (i = 0; i < 4; i++) {
    const uint32_t *site = b->facets[i].site;

    hull_tell (b, (Event){ EVENT_SIMPLEX, i, site[2], { site[0], site[1] } });
  }
}
