/* What one more site would change, before it is put there: the triangles that
 * would die, the cell that would be born, and what it would take from the
 * cells around it. The triangulation itself is not touched.
 */
#ifndef PREVIEW_H
#define PREVIEW_H

#include "voronoi.h"

/* What the new cell takes from the cell of a site. */
typedef struct PreviewPiece {
  uint32_t site;
  uint32_t first, n; /* corners[first] … corners[first + n - 1], convex */
} PreviewPiece;

typedef struct Preview {
  uint32_t *dying; /* triangles whose circles strictly contain the site,
                      ascending */
  uint32_t n_dying, dying_room;
  uint32_t *neighbours; /* its neighbours in the triangulation to be; on a
                           line or without triangles: all sites */
  uint32_t n_neighbours;
  Site *cell; /* clipped to the box, counter-clockwise */
  uint32_t n_cell;
  PreviewPiece *pieces; /* together they are the cell */
  uint32_t n_pieces;
  Site *corners; /* of the pieces */
  uint32_t n_corners, corners_room;
} Preview;

/* The site would be at @at, in the units of @set: signs are exact. Cell and
 * pieces are in the units of @voronoi, where it is at @drawn_at, clipped to
 * @box. All is empty when a site is there already, or none can be.
 *
 * Cost: within the triangulation some sqrt(n) signs on the way there, and
 *       O(neighbours); from outside O(n) signs.
 */
void preview_init (Preview *preview,
                   const SiteSet *set,
                   Site at,
                   const Voronoi *voronoi,
                   Site drawn_at,
                   const Box *box);
void preview_clear (Preview *preview);

#endif
