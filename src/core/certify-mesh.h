/* Triangles on sites and what lies across their edges, found from the
 * triangles alone. Private to certify. */
#ifndef CERTIFY_MESH_H
#define CERTIFY_MESH_H

#include "certify.h"

typedef struct Mesh {
  const SiteSet *set;
  const uint32_t (*triangles)[3]; /* borrowed */
  uint32_t n_triangles;
  uint32_t (*neighbours)[3]; /* across the edge from corner k to corner k+1;
                                INDEX_NONE when there is none */
  Facing *facings;           /* a counter-clockwise shadow faces up */
} Mesh;

/* Writes the fault into @why.
 *
 * Returns: false. */
bool certify_fault (char why[CERTIFY_ROOM], const char *format, ...)
    __attribute__ ((format (printf, 2, 3)));

/* Checks that each triangle has three different sites of the set, and that
 * each edge is walked at most once in each direction.
 *
 * Cost: linear. */
bool mesh_init (Mesh *mesh,
                const SiteSet *set,
                const uint32_t (*triangles)[3],
                uint32_t n_triangles,
                char why[CERTIFY_ROOM]);
void mesh_clear (Mesh *mesh);

/* Returns: the corner of the triangle across edge @k that is not on the edge.
 */
uint32_t mesh_opposite (const Mesh *mesh, uint32_t triangle, uint32_t k);

/* A closed polygon. */
typedef struct Border {
  uint32_t *sites; /* counter-clockwise */
  uint32_t n_sites;
} Border;

/* Checks that the shadows of the triangles facing @part, lower or upper,
 * cover a convex polygon exactly once.
 *
 * All of them turn the same way. So each point of the plane is covered as
 * often as the polygon's border, where edges have no partner, winds round it:
 * once if that is one convex polygon, walked once.
 *
 * Owns: the caller frees border->sites, which is set in any case. */
bool mesh_cover (const Mesh *mesh,
                 Facing part,
                 Border *border,
                 char why[CERTIFY_ROOM]);

#endif
