/* Cut into fans, the polygons must be the hull (certify_hull); what is left
 * to check is that cuts are flat and that borders are not: then no polygon is
 * too large, and none too small. */
#include "certify-mesh.h"

#include "memory.h"

#include <stdlib.h>

typedef uint32_t Corners[3];

/* Polygons cut from their first sites. */
typedef struct Fans {
  Corners *triangles;
  uint32_t *polygons; /* whose each triangle is */
  uint32_t n_triangles;
} Fans;

static bool
fans_init (Fans *fans, const Merged *merged, char why[CERTIFY_ROOM])
{
  *fans = (Fans){ NULL, NULL, 0 };
  fans->triangles = memory_new (merged->n_sites, sizeof *fans->triangles);
  fans->polygons = memory_new (merged->n_sites, sizeof *fans->polygons);
  for (uint32_t i = 0; i < merged->n_polygons; i += 1) {
    const Polygon *polygon = &merged->polygons[i];
    const uint32_t *site = merged->sites + polygon->first;

    if (polygon->n_sites < 3 || polygon->first > merged->n_sites
        || polygon->n_sites > merged->n_sites - polygon->first)
      return certify_fault (why, "polygon %u has no three sites", i);
    for (uint32_t k = 2; k < polygon->n_sites; k += 1) {
      uint32_t *corner = fans->triangles[fans->n_triangles];

      if (fans->n_triangles == merged->n_sites)
        return certify_fault (why, "polygon %u has sites of another", i);
      corner[0] = site[0];
      corner[1] = site[k - 1];
      corner[2] = site[k];
      fans->polygons[fans->n_triangles] = i;
      fans->n_triangles += 1;
    }
  }
  return true;
}

static void
fans_clear (Fans *fans)
{
  free (fans->triangles);
  free (fans->polygons);
}

/* Checks that the two triangles at an edge lie in one plane iff they are of
 * one polygon. */
static bool
check_edge (const Fans *fans,
            const Mesh *mesh,
            uint32_t triangle,
            uint32_t k,
            char why[CERTIFY_ROOM])
{
  const Site *sites = mesh->set->sites;
  const uint32_t *corner = mesh->triangles[triangle];
  const uint32_t polygon = fans->polygons[triangle];
  const uint32_t other = fans->polygons[mesh->neighbours[triangle][k]];
  const int side
      = lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                     &sites[mesh_opposite (mesh, triangle, k)]);

  if (polygon == other && side != 0)
    return certify_fault (why, "polygon %u is not flat", polygon);
  if (polygon != other && side == 0)
    return certify_fault (why, "polygons %u and %u lie in one plane", polygon,
                          other);
  return true;
}

static bool
check_edges (const Fans *fans, const Mesh *mesh, char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < 3 * mesh->n_triangles; i += 1)
    if (!check_edge (fans, mesh, i / 3, i % 3, why))
      return false;
  return true;
}

static bool
check_facings (const Merged *merged,
               const Fans *fans,
               const Mesh *mesh,
               char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < fans->n_triangles; i += 1)
    if (mesh->facings[i] != merged->polygons[fans->polygons[i]].facing)
      return certify_fault (why, "polygon %u faces elsewhere",
                            fans->polygons[i]);
  return true;
}

static bool
check_solid (const Merged *merged, const Result *result, char why[CERTIFY_ROOM])
{
  const Delaunay *delaunay = &result->delaunay;
  Mesh mesh = { .set = NULL };
  Fans fans;
  bool is_good
      = fans_init (&fans, merged, why)
        && certify_hull (result->set, (const Corners *)fans.triangles,
                         fans.n_triangles, delaunay->active, delaunay->n_active,
                         why)
        && mesh_init (&mesh, result->set, (const Corners *)fans.triangles,
                      fans.n_triangles, why);

  is_good = is_good && check_edges (&fans, &mesh, why)
            && check_facings (merged, &fans, &mesh, why);
  mesh_clear (&mesh);
  fans_clear (&fans);
  return is_good;
}

/* Checks that side @polygon of a flat hull is the boundary, walked once. */
static bool
check_side (const Merged *merged,
            uint32_t polygon,
            const Delaunay *delaunay,
            char why[CERTIFY_ROOM])
{
  const uint32_t n = delaunay->n_boundary;
  const Polygon *row = &merged->polygons[polygon];
  const bool is_lower = row->facing == FACING_LOWER;
  uint32_t shift = 0;

  if (row->n_sites != n || row->first != polygon * n)
    return certify_fault (why, "side %u has not all sites", polygon);
  while (shift < n && merged->sites[row->first] != delaunay->boundary[shift])
    shift += 1;
  for (uint32_t i = 0; i < n; i += 1)
    if (merged->sites[row->first + i]
        != delaunay->boundary[(shift + (is_lower ? n - i : i)) % n])
      return certify_fault (why, "side %u is disordered", polygon);
  return true;
}

bool
certify_merged (const Merged *merged,
                const Result *result,
                char why[CERTIFY_ROOM])
{
  const Delaunay *delaunay = &result->delaunay;

  if (delaunay->lift_dimension == 3)
    return check_solid (merged, result, why);
  if (merged->n_polygons != (delaunay->dimension == 2 ? 2 : 0)
      || merged->n_sites != merged->n_polygons * delaunay->n_boundary)
    return certify_fault (why, "a flat hull has two sides or none");
  if (merged->n_polygons == 0)
    return true;
  if (merged->polygons[0].facing != FACING_LOWER
      || merged->polygons[1].facing != FACING_UPPER)
    return certify_fault (why, "a side of the flat hull faces elsewhere");
  return check_side (merged, 0, delaunay, why)
         && check_side (merged, 1, delaunay, why);
}
