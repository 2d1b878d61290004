/* Why the checks suffice. The lower facets cover a convex polygon once and
 * are convex at every ridge, so they are the graph of a convex function; all
 * active sites are among their corners, so the polygon is the hull in the
 * plane and the graph is the lower hull. The surface is closed, so the upper
 * facets have a shadow of the same area, that is the same polygon; they are
 * the graph of a concave function, on which no lift can lie but those of the
 * polygon's corners: the upper hull. The vertical facets fill what is left
 * between the two; their number is the least that can. */
#include "certify-mesh.h"

#include "memory.h"

#include <stdlib.h>

static bool
check_ridge (const Mesh *mesh,
             uint32_t facet,
             uint32_t k,
             char why[CERTIFY_ROOM])
{
  const Site *sites = mesh->set->sites;
  const uint32_t *corner = mesh->triangles[facet];
  const uint32_t tail = corner[k], head = corner[(k + 1) % 3];
  uint32_t opposite;
  int side;

  if (mesh->neighbours[facet][k] == INDEX_NONE)
    return certify_fault (why, "the hull is open at ridge s%u s%u", tail, head);
  opposite = mesh_opposite (mesh, facet, k);
  side = lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      &sites[opposite]);
  if (side > 0)
    return certify_fault (why, "the hull is dented at ridge s%u s%u", tail,
                          head);
  return true;
}

static bool
check_ridges (const Mesh *mesh, char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < 3 * mesh->n_triangles; i += 1)
    if (!check_ridge (mesh, i / 3, i % 3, why))
      return false;
  return true;
}

/* Marks of sites. */
enum { ACTIVE = 1, ON_LOWER = 2 };

static bool
mark_active (const SiteSet *set,
             const uint32_t *active,
             uint32_t n_active,
             unsigned char *marks,
             char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < n_active; i += 1) {
    if (active[i] >= set->n_sites || set->first[active[i]] != active[i]
        || marks[active[i]] != 0)
      return certify_fault (why, "the active sites are not distinct");
    marks[active[i]] = ACTIVE;
  }
  return true;
}

static bool
check_corners (const Mesh *mesh,
               const uint32_t *active,
               uint32_t n_active,
               unsigned char *marks,
               char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < 3 * mesh->n_triangles; i += 1) {
    const uint32_t site = mesh->triangles[i / 3][i % 3];

    if (marks[site] == 0)
      return certify_fault (why, "s%u of facet %u is not active", site, i / 3);
    if (mesh->facings[i / 3] == FACING_LOWER)
      marks[site] |= ON_LOWER;
  }
  for (uint32_t i = 0; i < n_active; i += 1)
    if ((marks[active[i]] & ON_LOWER) == 0)
      return certify_fault (why, "s%u is on no lower facet", active[i]);
  return true;
}

static bool
check_sites (const Mesh *mesh,
             const uint32_t *active,
             uint32_t n_active,
             char why[CERTIFY_ROOM])
{
  unsigned char *marks = memory_new (mesh->set->n_sites, 1);
  const bool is_good = mark_active (mesh->set, active, n_active, marks, why)
                       && check_corners (mesh, active, n_active, marks, why);

  free (marks);
  return is_good;
}

static bool
check_part (const Mesh *mesh, Facing part, char why[CERTIFY_ROOM])
{
  Border border;
  const bool is_good = mesh_cover (mesh, part, &border, why);

  free (border.sites);
  return is_good;
}

bool
certify_hull (const SiteSet *set,
              const uint32_t (*facets)[3],
              uint32_t n_facets,
              const uint32_t *active,
              uint32_t n_active,
              char why[CERTIFY_ROOM])
{
  Mesh mesh;
  bool is_good;

  if (n_active < 4 || n_facets != 2 * n_active - 4)
    return certify_fault (why, "%u sites cannot have %u facets", n_active,
                          n_facets);
  is_good = mesh_init (&mesh, set, facets, n_facets, why)
            && check_sites (&mesh, active, n_active, why)
            && check_ridges (&mesh, why)
            && check_part (&mesh, FACING_LOWER, why)
            && check_part (&mesh, FACING_UPPER, why);
  mesh_clear (&mesh);
  return is_good;
}
