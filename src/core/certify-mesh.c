#include "certify-mesh.h"

#include "memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool
certify_fault (char why[CERTIFY_ROOM], const char *format, ...)
{
  va_list arguments;

  va_start (arguments, format);
  vsnprintf (why, CERTIFY_ROOM, format, arguments);
  va_end (arguments);
  return false;
}

/* One side of an edge. */
typedef struct HalfEdge {
  uint32_t site[2]; /* tail and head */
  uint32_t triangle, k;
} HalfEdge;

static uint32_t
lower_site (const HalfEdge *edge)
{
  return edge->site[0] < edge->site[1] ? edge->site[0] : edge->site[1];
}

static uint32_t
higher_site (const HalfEdge *edge)
{
  return edge->site[0] < edge->site[1] ? edge->site[1] : edge->site[0];
}

/* Copies @n edges from @from to @to, sorted by @key; those of one key stay in
 * their order. */
static void
sort_by_counting (const HalfEdge *from,
                  HalfEdge *to,
                  uint32_t n,
                  uint32_t n_sites,
                  uint32_t (*key) (const HalfEdge *edge))
{
  uint32_t *place = memory_new ((size_t)n_sites + 1, sizeof *place);

  for (uint32_t i = 0; i < n; i += 1)
    place[key (&from[i]) + 1] += 1;
  for (uint32_t i = 0; i < n_sites; i += 1)
    place[i + 1] += place[i];
  for (uint32_t i = 0; i < n; i += 1) {
    to[place[key (&from[i])]] = from[i];
    place[key (&from[i])] += 1;
  }
  free (place);
}

/* Returns: all sides of edges, those of one edge next to each other. */
static HalfEdge *
sorted_half_edges (const Mesh *mesh)
{
  const uint32_t n = 3 * mesh->n_triangles;
  HalfEdge *edges = memory_new (n, sizeof *edges);
  HalfEdge *sorted = memory_new (n, sizeof *sorted);

  for (uint32_t i = 0; i < n; i += 1) {
    const uint32_t *corner = mesh->triangles[i / 3];

    edges[i]
        = (HalfEdge){ { corner[i % 3], corner[(i + 1) % 3] }, i / 3, i % 3 };
  }
  sort_by_counting (edges, sorted, n, mesh->set->n_sites, higher_site);
  sort_by_counting (sorted, edges, n, mesh->set->n_sites, lower_site);
  free (sorted);
  return edges;
}

static bool
match_edges (Mesh *mesh, const HalfEdge *edges, char why[CERTIFY_ROOM])
{
  const uint32_t n = 3 * mesh->n_triangles;

  for (uint32_t i = 0; i + 1 < n; i += 1) {
    const HalfEdge *a = &edges[i], *b = &edges[i + 1];

    if (lower_site (a) != lower_site (b) || higher_site (a) != higher_site (b))
      continue;
    /* A third side of one edge meets one that has its partner already. */
    if (a->site[0] == b->site[0]
        || mesh->neighbours[a->triangle][a->k] != INDEX_NONE)
      return certify_fault (why, "edge s%u s%u has two triangles on one side",
                            a->site[0], a->site[1]);
    mesh->neighbours[a->triangle][a->k] = b->triangle;
    mesh->neighbours[b->triangle][b->k] = a->triangle;
  }
  return true;
}

static bool
check_corners (const Mesh *mesh, char why[CERTIFY_ROOM])
{
  for (uint32_t i = 0; i < mesh->n_triangles; i += 1) {
    const uint32_t *corner = mesh->triangles[i];

    for (uint32_t k = 0; k < 3; k += 1) {
      if (corner[k] >= mesh->set->n_sites)
        return certify_fault (why, "triangle %u has a site that is none", i);
      if (corner[k] == corner[(k + 1) % 3])
        return certify_fault (why, "triangle %u has one site twice", i);
    }
  }
  return true;
}

bool
mesh_init (Mesh *mesh,
           const SiteSet *set,
           const uint32_t (*triangles)[3],
           uint32_t n_triangles,
           char why[CERTIFY_ROOM])
{
  HalfEdge *edges;
  bool is_matched;

  *mesh = (Mesh){ set, triangles, n_triangles, NULL, NULL };
  if (!check_corners (mesh, why))
    return false;

  mesh->neighbours = memory_new (n_triangles, sizeof *mesh->neighbours);
  mesh->facings = memory_new (n_triangles, sizeof *mesh->facings);
  memset (mesh->neighbours, 0xff, n_triangles * sizeof *mesh->neighbours);
  for (uint32_t i = 0; i < n_triangles; i += 1)
    mesh->facings[i]
        = facing (&set->sites[triangles[i][0]], &set->sites[triangles[i][1]],
                  &set->sites[triangles[i][2]]);
  edges = sorted_half_edges (mesh);
  is_matched = match_edges (mesh, edges, why);
  free (edges);
  return is_matched;
}

void
mesh_clear (Mesh *mesh)
{
  free (mesh->neighbours);
  free (mesh->facings);
}

uint32_t
mesh_opposite (const Mesh *mesh, uint32_t triangle, uint32_t k)
{
  const uint32_t *edge = mesh->triangles[triangle];
  const uint32_t tail = edge[k], head = edge[(k + 1) % 3];
  const uint32_t *across = mesh->triangles[mesh->neighbours[triangle][k]];
  uint32_t i = 0;

  while (across[i] == tail || across[i] == head)
    i += 1;
  return across[i];
}

static bool
is_on_border (const Mesh *mesh, uint32_t triangle, uint32_t k)
{
  const uint32_t neighbour = mesh->neighbours[triangle][k];

  return neighbour == INDEX_NONE
         || mesh->facings[neighbour] != mesh->facings[triangle];
}

/* Fills @next, one for each site: its follower on the border, with the part
 * on the left in the plane, or INDEX_NONE.
 *
 * Returns: the number of border edges, 0 with a fault. */
static uint32_t
link_border (const Mesh *mesh,
             Facing part,
             uint32_t *next,
             char why[CERTIFY_ROOM])
{
  uint32_t n_edges = 0;

  for (uint32_t i = 0; i < 3 * mesh->n_triangles; i += 1) {
    const uint32_t *corner = mesh->triangles[i / 3];
    const uint32_t from = corner[i % 3], to = corner[(i + 1) % 3];
    /* Seen from below, the plane turns the other way. */
    const uint32_t tail = part == FACING_LOWER ? to : from;

    if (mesh->facings[i / 3] != part || !is_on_border (mesh, i / 3, i % 3))
      continue;
    if (next[tail] != INDEX_NONE) {
      certify_fault (why, "the border passes s%u twice", tail);
      return 0;
    }
    next[tail] = tail == from ? to : from;
    n_edges += 1;
  }
  if (n_edges == 0)
    certify_fault (why, "there is no border");
  return n_edges;
}

/* Returns: whether the border is one loop. */
static bool
walk_border (const uint32_t *next,
             uint32_t n_edges,
             Border *border,
             char why[CERTIFY_ROOM])
{
  uint32_t site = 0;

  while (next[site] == INDEX_NONE)
    site += 1;
  border->sites = memory_new (n_edges, sizeof *border->sites);
  do {
    border->sites[border->n_sites] = site;
    border->n_sites += 1;
    site = next[site];
  } while (border->n_sites < n_edges && site != INDEX_NONE
           && site != border->sites[0]);
  if (border->n_sites != n_edges || site != border->sites[0])
    return certify_fault (why, "the border is not one loop");
  return true;
}

/* Checks that the border never turns right and changes only twice between
 * going right and going left. */
static bool
check_border (const SiteSet *set, const Border *border, char why[CERTIFY_ROOM])
{
  const uint32_t n = border->n_sites;
  uint32_t n_changes = 0;

  for (uint32_t i = 0; i < n; i += 1) {
    const uint32_t site = border->sites[(i + 1) % n];
    const Site *a = &set->sites[border->sites[i]];
    const Site *b = &set->sites[site];
    const Site *c = &set->sites[border->sites[(i + 2) % n]];
    const int turn = orient (a, b, c);
    const bool is_change = site_compare (a, b) != site_compare (b, c);

    if (turn < 0)
      return certify_fault (why, "the border turns right at s%u", site);
    if (turn == 0 && is_change)
      return certify_fault (why, "the border turns back at s%u", site);
    n_changes += is_change ? 1 : 0;
  }
  if (n_changes != 2)
    return certify_fault (why, "the border winds more than once");
  return true;
}

bool
mesh_cover (const Mesh *mesh,
            Facing part,
            Border *border,
            char why[CERTIFY_ROOM])
{
  const uint32_t n_sites = mesh->set->n_sites;
  uint32_t *next = memory_new (n_sites, sizeof *next);
  uint32_t n_edges;
  bool is_loop;

  memset (next, 0xff, n_sites * sizeof *next);
  *border = (Border){ NULL, 0 };
  n_edges = link_border (mesh, part, next, why);
  is_loop = n_edges > 0 && walk_border (next, n_edges, border, why);
  free (next);
  return is_loop && check_border (mesh->set, border, why);
}
