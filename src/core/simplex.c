/* The first simplex: the first three distinct sites in the order of
 * insertion and the first one whose lift is not coplanar with theirs, so that
 * an author chooses it by the order of the sites. No three lifts are
 * collinear, so any three distinct sites will do as its base. */
#include "hull-builder.h"
#include "predicate.h"

#include <stddef.h>

bool
simplex_find (HullBuilder *b)
{
  const Site *sites = b->set->sites;
  uint32_t *found = b->simplex;
  uint32_t n_found = 0;
  uint32_t i;

  for (i = 0; i < b->set->n_sites && n_found < 4; i++) {
    const uint32_t site = b->list != NULL ? b->list[i] : i;

    if (b->set->first[site] != site)
      continue;
    if (n_found == 3
        && lift_orient (&sites[found[0]], &sites[found[1]], &sites[found[2]],
                        &sites[site])
               == 0)
      continue;
    found[n_found++] = site;
  }
  return n_found == 4;
}

/* Turns the base so that the top lies behind it. */
static void
orient_base (HullBuilder *b)
{
  const Site *sites = b->set->sites;
  uint32_t *site = b->simplex;
  const uint32_t second = site[1];

  if (lift_orient (&sites[site[0]], &sites[site[1]], &sites[site[2]],
                   &sites[site[3]])
      < 0)
    return;
  site[1] = site[2];
  site[2] = second;
}

/* Facet 0 is the base; facet 1 + i joins the top to the base's edge i, which
 * is its edge 2. */
static void
link_facets (HullBuilder *b)
{
  uint32_t i;

  for (i = 0; i < 3; i++) {
    HullFacet *side = &b->facets[1 + i];

    b->facets[0].across[i] = (1 + i) << 2 | 2;
    side->across[0] = (1 + (i + 2) % 3) << 2 | 1;
    side->across[1] = (1 + (i + 1) % 3) << 2 | 0;
    side->across[2] = i;
  }
}

void
simplex_build (HullBuilder *b)
{
  const uint32_t *s = b->simplex;
  uint32_t i;

  orient_base (b);
  for (i = 0; i < 4; i++) {
    const uint32_t side[3] = { s[(i + 2) % 3], s[3], s[i % 3] };
    const uint32_t *site = i == 0 ? s : side;
    const uint32_t facet = hull_add_facet (b, site);

    hull_tell (b,
               (Event){ EVENT_SIMPLEX, facet, site[2], { site[0], site[1] } });
  }
  link_facets (b);
}
