#include "certify-mesh.h"

#include "memory.h"

#include <stdlib.h>

static const Site *
site_of (const Delaunay *delaunay, uint32_t site)
{
  return &delaunay->set->sites[site];
}

static bool
check_active (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < delaunay->n_active; i += 1) {
    const uint32_t site = delaunay->active[i];

    if (site >= delaunay->set->n_sites || delaunay->set->first[site] != site)
      return certify_fault (why, "an active site is none or a duplicate");
    if (i > 0 && delaunay->active[i - 1] >= site)
      return certify_fault (why, "the active sites do not ascend");
  }
  return true;
}

static bool
check_count (const char *noun,
             uint32_t n,
             uint32_t expected,
             char why[CERTIFY_ROOM])
{
  if (n != expected)
    return certify_fault (why, "%u %s instead of %u", n, noun, expected);
  return true;
}

/* Checks that corners of triangles are the active sites, all of them. */
static bool
check_corners (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  bool *is_corner = memory_new (delaunay->set->n_sites, sizeof *is_corner);
  uint32_t n_corners = 0, n_active_corners = 0;

  for (uint32_t i = 0; i < 3 * delaunay->n_triangles; i += 1) {
    bool *mark = &is_corner[delaunay->triangles[i / 3].site[i % 3]];

    n_corners += *mark ? 0 : 1;
    *mark = true;
  }
  for (uint32_t i = 0; i < delaunay->n_active; i += 1)
    n_active_corners += is_corner[delaunay->active[i]] ? 1 : 0;
  free (is_corner);
  return check_count ("active corners", n_active_corners, delaunay->n_active,
                      why)
         && check_count ("corners", n_corners, delaunay->n_active, why);
}

/* Returns: how the circle of @triangle lies to the triangle across edge @k:
 *          -1 a corner is inside, 0 one circle for both, +1 outside. */
static int
opposite_side (const Mesh *mesh, uint32_t triangle, uint32_t k)
{
  const Site *sites = mesh->set->sites;
  const uint32_t *corner = mesh->triangles[triangle];

  return lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      &sites[mesh_opposite (mesh, triangle, k)]);
}

static bool
check_side (const Delaunay *delaunay,
            const Mesh *mesh,
            uint32_t triangle,
            uint32_t k,
            char why[CERTIFY_ROOM])
{
  const Triangle *row = &delaunay->triangles[triangle];
  const uint32_t neighbour = mesh->neighbours[triangle][k];
  int side;

  if (row->neighbour[k] != neighbour)
    return certify_fault (why, "triangle %u has a wrong neighbour", triangle);
  if (neighbour == INDEX_NONE)
    return true;
  side = opposite_side (mesh, triangle, k);
  if (side < 0)
    return certify_fault (why, "the circle of triangle %u contains s%u",
                          triangle, mesh_opposite (mesh, triangle, k));
  if ((side == 0) != (row->group == delaunay->triangles[neighbour].group))
    return certify_fault (why,
                          "the circle groups of triangles %u and %u are wrong",
                          triangle, neighbour);
  return true;
}

static bool
check_triangles (const Delaunay *delaunay,
                 const Mesh *mesh,
                 char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < mesh->n_triangles; i += 1) {
    if (mesh->facings[i] != FACING_UPPER)
      return certify_fault (why, "triangle %u does not turn left", i);
    if (delaunay->triangles[i].group >= delaunay->n_groups)
      return certify_fault (why, "triangle %u has no circle group", i);
    for (uint32_t k = 0; k < 3; k += 1)
      if (!check_side (delaunay, mesh, i, k, why))
        return false;
  }
  return true;
}

/* Marks all triangles that have one circle with @start and hang together with
 * it; @stack has room for all. */
static void
flood (const Mesh *mesh, uint32_t start, bool *is_reached, uint32_t *stack)
{
  uint32_t n_waiting = 1;

  stack[0] = start;
  is_reached[start] = true;
  while (n_waiting > 0) {
    const uint32_t triangle = stack[n_waiting - 1];

    n_waiting -= 1;
    for (uint32_t k = 0; k < 3; k += 1) {
      const uint32_t neighbour = mesh->neighbours[triangle][k];

      if (neighbour == INDEX_NONE || is_reached[neighbour]
          || opposite_side (mesh, triangle, k) != 0)
        continue;
      is_reached[neighbour] = true;
      stack[n_waiting] = neighbour;
      n_waiting += 1;
    }
  }
}

/* Returns: the number of connected sets of triangles with one circle. */
static uint32_t
count_groups (const Mesh *mesh)
{
  const uint32_t n = mesh->n_triangles;
  bool *is_reached = memory_new (n, sizeof *is_reached);
  uint32_t *stack = memory_new (n, sizeof *stack);
  uint32_t n_groups = 0;

  for (uint32_t i = 0; i < n; i += 1)
    if (!is_reached[i]) {
      flood (mesh, i, is_reached, stack);
      n_groups += 1;
    }
  free (is_reached);
  free (stack);
  return n_groups;
}

/* Checks that there are as many groups as connected sets of triangles with
 * one circle. Neighbours are in one group iff they have one circle, so that
 * then no number serves two groups. */
static bool
check_groups (const Delaunay *delaunay,
              const Mesh *mesh,
              char why[CERTIFY_ROOM])
{
  const uint32_t n = mesh->n_triangles;
  const uint32_t n_sets = count_groups (mesh);
  bool *is_used = memory_new (delaunay->n_groups, sizeof *is_used);
  uint32_t n_used = 0;

  for (uint32_t i = 0; i < n; i += 1) {
    bool *mark = &is_used[delaunay->triangles[i].group];

    n_used += *mark ? 0 : 1;
    *mark = true;
  }
  free (is_used);
  return check_count ("circle groups", delaunay->n_groups, n_sets, why)
         && check_count ("circle groups in use", n_used, n_sets, why);
}

static uint32_t
corner_index (const Mesh *mesh, uint32_t triangle, uint32_t site)
{
  uint32_t k = 0;

  while (k < 3 && mesh->triangles[triangle][k] != site)
    k += 1;
  return k;
}

/* Checks one edge against the triangle on its left; *@seen has a bit for each
 * edge of each triangle. */
static bool
check_edge (const Mesh *mesh,
            const DelaunayEdge *edge,
            unsigned char *seen,
            char why[CERTIFY_ROOM])
{
  const uint32_t left = edge->triangle[0], right = edge->triangle[1];
  const uint32_t tail = edge->site[0], head = edge->site[1];
  uint32_t k;

  if (left >= mesh->n_triangles)
    return certify_fault (why, "edge s%u s%u has no left side", tail, head);
  k = corner_index (mesh, left, tail);
  if (k == 3 || mesh->triangles[left][(k + 1) % 3] != head
      || mesh->neighbours[left][k] != right)
    return certify_fault (why, "edge s%u s%u is misplaced", tail, head);
  if (edge->is_free
      != (right != INDEX_NONE && opposite_side (mesh, left, k) == 0))
    return certify_fault (why, "edge s%u s%u is wrongly free", tail, head);
  if ((seen[left] >> k & 1) != 0)
    return certify_fault (why, "edge s%u s%u comes twice", tail, head);
  seen[left] |= (unsigned char)(1u << k);
  if (right != INDEX_NONE)
    seen[right] |= (unsigned char)(1u << corner_index (mesh, right, head));
  return true;
}

static bool
check_edges (const Delaunay *delaunay, const Mesh *mesh, char why[CERTIFY_ROOM])
{
  unsigned char *seen = memory_new (mesh->n_triangles, 1);
  bool is_good = true;

  for (uint32_t i = 0; i < delaunay->n_edges && is_good; i += 1)
    is_good = check_edge (mesh, &delaunay->edges[i], seen, why);
  free (seen);
  return is_good;
}

/* Returns: how many sites of the border are corners. */
static uint32_t
count_extreme (const Delaunay *delaunay, const Border *border)
{
  const uint32_t n = border->n_sites;
  const uint32_t *at = border->sites;
  uint32_t n_extreme = 0;

  for (uint32_t i = 0; i < n; i += 1)
    if (orient (site_of (delaunay, at[i]), site_of (delaunay, at[(i + 1) % n]),
                site_of (delaunay, at[(i + 2) % n]))
        != 0)
      n_extreme += 1;
  return n_extreme;
}

/* Checks the boundary against the border that was found, which may start
 * elsewhere. */
static bool
check_boundary (const Delaunay *delaunay,
                const Border *border,
                char why[CERTIFY_ROOM])
{
  const uint32_t n = border->n_sites;
  uint32_t shift = 0;

  if (!check_count ("boundary sites", delaunay->n_boundary, n, why))
    return false;
  while (shift < n && border->sites[shift] != delaunay->boundary[0])
    shift += 1;
  for (uint32_t i = 0; i < n; i += 1)
    if (border->sites[(shift + i) % n] != delaunay->boundary[i])
      return certify_fault (why, "s%u is misplaced on the boundary",
                            delaunay->boundary[i]);
  return check_count ("extreme sites", delaunay->n_extreme,
                      count_extreme (delaunay, border), why);
}

static bool
check_counts (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  const uint32_t d = delaunay->n_active, b = delaunay->n_boundary;
  const int lift_dimension = delaunay->n_groups == 1 ? 2 : 3;

  if (delaunay->lift_dimension != lift_dimension)
    return certify_fault (why, "the dimension of the lifts is wrong");
  return check_count ("triangles", delaunay->n_triangles, 2 * d - 2 - b, why)
         && check_count ("edges", delaunay->n_edges, 3 * d - 3 - b, why);
}

static bool
check_mesh (const Delaunay *delaunay, const Mesh *mesh, char why[CERTIFY_ROOM])
{
  Border border;
  const bool is_good = mesh_cover (mesh, FACING_UPPER, &border, why)
                       && check_boundary (delaunay, &border, why);

  free (border.sites);
  return is_good && check_groups (delaunay, mesh, why)
         && check_edges (delaunay, mesh, why) && check_counts (delaunay, why);
}

static bool
check_plane (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  const uint32_t n = delaunay->n_triangles;
  uint32_t (*triangles)[3] = memory_new (n, sizeof *triangles);
  Mesh mesh;
  bool is_good;

  for (uint32_t i = 0; i < 3 * n; i += 1)
    triangles[i / 3][i % 3] = delaunay->triangles[i / 3].site[i % 3];
  is_good = mesh_init (&mesh, delaunay->set, (const uint32_t (*)[3])triangles,
                       n, why)
            && check_corners (delaunay, why)
            && check_triangles (delaunay, &mesh, why)
            && check_mesh (delaunay, &mesh, why);
  mesh_clear (&mesh);
  free (triangles);
  return is_good;
}

/* Checks that the boundary goes along one line. As many sites as are active,
 * each further than the one before, are all of them. */
static bool
check_order_on_line (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  const uint32_t n = delaunay->n_boundary;
  const uint32_t *at = delaunay->boundary;
  int direction = 0;

  for (uint32_t i = 0; i < n; i += 1)
    if (at[i] >= delaunay->set->n_sites)
      return certify_fault (why, "a site on the line is none");
  for (uint32_t i = 1; i < n; i += 1) {
    const Site *before = site_of (delaunay, at[i - 1]);
    const Site *here = site_of (delaunay, at[i]);
    const int step = site_compare (before, here);

    if (step == 0 || (i > 1 && step != direction))
      return certify_fault (why, "s%u is misplaced on the line", at[i]);
    if (orient (site_of (delaunay, at[0]), here, site_of (delaunay, at[n - 1]))
        != 0)
      return certify_fault (why, "s%u is not on the line", at[i]);
    direction = step;
  }
  return true;
}

static bool
check_line_sites (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  bool *is_there = memory_new (delaunay->set->n_sites, sizeof *is_there);
  bool is_good = true;

  for (uint32_t i = 0; i < delaunay->n_boundary; i += 1)
    is_there[delaunay->boundary[i]] = true;
  for (uint32_t i = 0; i < delaunay->n_active && is_good; i += 1)
    is_good
        = is_there[delaunay->active[i]]
          || certify_fault (why, "s%u is not on the line", delaunay->active[i]);
  free (is_there);
  return is_good;
}

static bool
check_segments (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  const uint32_t n = delaunay->n_active;

  if (!check_count ("segments", delaunay->n_edges, n > 0 ? n - 1 : 0, why))
    return false;
  for (uint32_t i = 0; i < delaunay->n_edges; i += 1) {
    const DelaunayEdge *edge = &delaunay->edges[i];

    if (edge->site[0] != delaunay->boundary[i]
        || edge->site[1] != delaunay->boundary[i + 1])
      return certify_fault (why, "segment %u does not join neighbours", i);
    if (edge->triangle[0] != INDEX_NONE || edge->triangle[1] != INDEX_NONE
        || edge->is_free)
      return certify_fault (why, "segment %u has a triangle", i);
  }
  return true;
}

/* Sites on one line, or one, or none. */
static bool
check_line (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  const uint32_t n = delaunay->n_active;
  const int lift_dimension = n > 3 ? 2 : (int)n - 1;

  if (delaunay->dimension != (n > 2 ? 1 : (int)n - 1))
    return certify_fault (why, "the dimension of the sites is wrong");
  if (delaunay->lift_dimension != lift_dimension)
    return certify_fault (why, "the dimension of the lifts is wrong");
  return check_count ("boundary sites", delaunay->n_boundary, n, why)
         && check_count ("triangles", delaunay->n_triangles, 0, why)
         && check_count ("circle groups", delaunay->n_groups, 0, why)
         && check_count ("extreme sites", delaunay->n_extreme, n < 2 ? n : 2,
                         why)
         && check_order_on_line (delaunay, why)
         && check_line_sites (delaunay, why) && check_segments (delaunay, why);
}

bool
certify_delaunay (const Delaunay *delaunay, char why[CERTIFY_ROOM])
{
  if (!check_active (delaunay, why))
    return false;
  return delaunay->dimension == 2 ? check_plane (delaunay, why)
                                  : check_line (delaunay, why);
}
