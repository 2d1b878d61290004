/* Location by walking: from the last cone, through the shadows of the lower
 * facets, towards the site. The triangulation is Delaunay, so the walk never
 * returns to a facet (Edelsbrunner 1990): it ends. */
#include "hull-builder.h"

#include <assert.h>
#include <math.h>

/* orient(), with a filter for the whole set first. */
static inline int
side_of (const HullBuilder *b,
         const Site *tail,
         const Site *head,
         const Site *p)
{
  const double area = (tail->x - p->x) * (head->y - p->y)
                      - (tail->y - p->y) * (head->x - p->x);

  if (fabs (area) > b->orient_doubt || b->is_whole)
    return (area > 0) - (area < 0);
  return orient (tail, head, p);
}

/* The shadow of a lower facet turns clockwise. */
static inline bool
is_lower (const HullBuilder *b, uint32_t facet)
{
  const uint32_t *site = b->facets[facet].site;

  if (hull_is_unbounded (b, facet))
    return false;
  return side_of (b, &b->sites[site[0]], &b->sites[site[1]], &b->sites[site[2]])
         < 0;
}

/* A cone's facets lie round its apex, their site 2, which is a vertex of some
 * lower facet, as every site is. */
static uint32_t
start (const HullBuilder *b)
{
  uint32_t facet = b->near;
  uint32_t n_turns;

  for (n_turns = 0; n_turns <= b->n_facets; n_turns++) {
    if (is_lower (b, facet))
      return facet;
    facet = b->facets[facet].across[1] >> 2;
  }
  assert (false && "a lower facet lies round every site");
  return INDEX_NONE;
}

static bool
is_corner (const HullBuilder *b, uint32_t facet, const Site *p)
{
  const uint32_t *corner = b->facets[facet].site;
  uint32_t k;

  for (k = 0; k < 3; k++)
    if (b->sites[corner[k]].x == p->x && b->sites[corner[k]].y == p->y)
      return true;
  return false;
}

/* An edge of a lower facet's shadow that has the site beyond it, on its left;
 * 3 when there is none. Edge @from, by which it was entered, is not asked. */
static inline uint32_t
edge_towards (const HullBuilder *b,
              uint32_t facet,
              uint32_t from,
              const Site *p)
{
  const uint32_t *corner = b->facets[facet].site;
  uint32_t k;

  for (k = 0; k < 3; k++)
    if (k != from
        && side_of (b, &b->sites[corner[k]],
                    &b->sites[corner[k == 2 ? 0 : k + 1]], p)
               > 0)
      break;
  return k;
}

uint32_t
walk_to (HullBuilder *b, uint32_t site)
{
  const Site p = b->sites[site];
  uint32_t facet = start (b);
  uint32_t from = 3;
  uint32_t n_steps;

  for (n_steps = 0; n_steps <= b->n_facets; n_steps++) {
    const uint32_t k = edge_towards (b, facet, from, &p);
    HullEdge across;

    b->counts.walk_steps += 1;
    b->near = facet;
    if (k == 3)
      return is_corner (b, facet, &p) ? INDEX_NONE : facet;
    across = b->facets[facet].across[k];
    /* Beyond the hull in the plane it sees one of the two facets here: the
     * other one for certain, where none leans inwards. */
    if (!is_lower (b, across >> 2))
      return !HULL_IS_LOWER && hull_sees (b, site, facet) ? facet : across >> 2;
    facet = across >> 2;
    from = across & 3;
  }
  assert (false && "a walk through a Delaunay triangulation ends");
  return INDEX_NONE;
}
