/* Why the checks suffice. The lower facets cover a convex polygon once and
 * are convex at every ridge, so they are the graph of a convex function; all
 * active sites are among their corners, so the polygon is the hull in the
 * plane and the graph is the lower hull. In the same way the upper facets are
 * the graph of a concave function, which lies above all lifts because no lift
 * lies above a chord between others. The surface is closed, so the vertical
 * facets fill exactly what is left between the two, in one direction only,
 * since coplanar neighbours look the same way. */
#include "certify-mesh.h"

#include "memory.h"

#include <stdlib.h>

/* Along the line that is the shadow of a vertical facet.
 *
 * Returns: whether its corners come from left to right, up to rotation. */
static bool
is_ascending (const Mesh *mesh, uint32_t facet)
{
  const Site *sites = mesh->set->sites;
  const uint32_t *corner = mesh->triangles[facet];
  int n_ascents = 0;

  for (uint32_t k = 0; k < 3; k += 1)
    if (site_compare (&sites[corner[k]], &sites[corner[(k + 1) % 3]]) < 0)
      n_ascents += 1;
  return n_ascents == 2;
}

static bool
look_the_same_way (const Mesh *mesh, uint32_t facet, uint32_t neighbour)
{
  if (mesh->facings[facet] != mesh->facings[neighbour])
    return false;
  return mesh->facings[facet] != FACING_VERTICAL
         || is_ascending (mesh, facet) == is_ascending (mesh, neighbour);
}

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
  if (side == 0 && !look_the_same_way (mesh, facet, mesh->neighbours[facet][k]))
    return certify_fault (why, "the hull is folded at ridge s%u s%u", tail,
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
