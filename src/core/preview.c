#include "preview.h"

#include "memory.h"
#include "predicate.h"

#include <stdlib.h>
#include <string.h>

typedef struct Maker {
  Preview *preview;
  const SiteSet *set;
  const Delaunay *delaunay;
  const Voronoi *voronoi;
  Site at, drawn_at;
  bool *is_neighbour; /* per site */
  bool *is_seen;      /* per triangle: it is known to die */
} Maker;

static bool
is_taken (const Maker *maker)
{
  const Delaunay *delaunay = maker->delaunay;
  uint32_t i;

  for (i = 0; i < delaunay->n_active; i++) {
    const Site *site = &maker->set->sites[delaunay->active[i]];

    if (site->x == maker->at.x && site->y == maker->at.y)
      return true;
  }
  return false;
}

/* Corners of triangles turn left, so that the lower side of their lifts is
 * seen from behind: inside is where lift_orient() is negative. */
static bool
is_dying (const Maker *maker, uint32_t triangle)
{
  const uint32_t *site = maker->delaunay->triangles[triangle].site;
  const Site *sites = maker->set->sites;

  return lift_orient (&sites[site[0]], &sites[site[1]], &sites[site[2]],
                      &maker->at)
         < 0;
}

static void
add_dying (Maker *maker, uint32_t triangle)
{
  const uint32_t *site = maker->delaunay->triangles[triangle].site;
  Preview *preview = maker->preview;
  int k;

  if (preview->n_dying == preview->dying_room)
    preview->dying = memory_grow (preview->dying, &preview->dying_room,
                                  preview->n_dying + 1, sizeof *preview->dying);
  preview->dying[preview->n_dying++] = triangle;
  maker->is_seen[triangle] = true;
  for (k = 0; k < 3; k++)
    maker->is_neighbour[site[k]] = true;
}

/* Returns: a triangle that the site lies in, by walking towards it; or
 *          INDEX_NONE when it lies outside all. No such walk runs in a circle
 *          in a Delaunay triangulation. */
static uint32_t
find_triangle (const Maker *maker)
{
  const Delaunay *delaunay = maker->delaunay;
  const Site *sites = maker->set->sites;
  uint32_t here = delaunay->n_triangles > 0 ? 0 : INDEX_NONE;
  int k = 0;

  while (here != INDEX_NONE && k < 3) {
    const Triangle *triangle = &delaunay->triangles[here];
    const Site *tail = &sites[triangle->site[k]];
    const Site *head = &sites[triangle->site[(k + 1) % 3]];

    if (orient (tail, head, &maker->at) < 0) {
      here = triangle->neighbour[k];
      k = 0;
    } else {
      k++;
    }
  }
  return here;
}

static int
compare_numbers (const void *a, const void *b)
{
  const uint32_t *p = a, *q = b;

  return (*p > *q) - (*p < *q);
}

/* Between a triangle that would die and the site all would die: they are found
 * by going from neighbour to neighbour. */
static void
spread_dying (Maker *maker, uint32_t first)
{
  Preview *preview = maker->preview;
  uint32_t i;
  int k;

  add_dying (maker, first);
  for (i = 0; i < preview->n_dying; i++) {
    const Triangle *triangle = &maker->delaunay->triangles[preview->dying[i]];

    for (k = 0; k < 3; k++)
      if (triangle->neighbour[k] != INDEX_NONE
          && !maker->is_seen[triangle->neighbour[k]]
          && is_dying (maker, triangle->neighbour[k]))
        add_dying (maker, triangle->neighbour[k]);
  }
  qsort (preview->dying, preview->n_dying, sizeof *preview->dying,
         compare_numbers);
}

/* From outside, those that would die need not be neighbours. */
static void
find_dying (Maker *maker)
{
  const uint32_t first = find_triangle (maker);
  uint32_t i;

  maker->is_seen
      = memory_new (maker->delaunay->n_triangles, sizeof *maker->is_seen);
  if (first != INDEX_NONE)
    spread_dying (maker, first);
  for (i = 0; first == INDEX_NONE && i < maker->delaunay->n_triangles; i++)
    if (is_dying (maker, i))
      add_dying (maker, i);
  free (maker->is_seen);
}

/* From outside, the sites of the hull edges that are seen. */
static void
find_seen (Maker *maker)
{
  const Delaunay *delaunay = maker->delaunay;
  const Site *sites = maker->set->sites;
  uint32_t i;

  for (i = 0; i < delaunay->n_boundary; i++) {
    const uint32_t tail = delaunay->boundary[i];
    const uint32_t head = delaunay->boundary[(i + 1) % delaunay->n_boundary];

    if (orient (&sites[tail], &sites[head], &maker->at) < 0)
      maker->is_neighbour[tail] = maker->is_neighbour[head] = true;
  }
}

static void
list_neighbours (Maker *maker)
{
  const Delaunay *delaunay = maker->delaunay;
  Preview *preview = maker->preview;
  const bool has_all = delaunay->n_triangles == 0;
  uint32_t i;

  preview->neighbours = memory_new (delaunay->n_active, sizeof (uint32_t));
  for (i = 0; i < delaunay->n_active; i++) {
    const uint32_t site = delaunay->active[i];

    if (has_all || maker->is_neighbour[site])
      preview->neighbours[preview->n_neighbours++] = site;
  }
}

static void
make_cell (Maker *maker, const Box *box)
{
  const Site *sites = maker->voronoi->delaunay->set->sites;
  Preview *preview = maker->preview;
  uint32_t i, n = 4;

  preview->cell = memory_new ((size_t)preview->n_neighbours + 5, sizeof (Site));
  box_corners (box, preview->cell);
  for (i = 0; i < preview->n_neighbours && n > 0; i++)
    n = bisector_cut (preview->cell, n, &maker->drawn_at,
                      &sites[preview->neighbours[i]]);
  preview->n_cell = n < 3 ? 0 : n;
}

/* Of the old cell of @site the part that is nearer to the new site. */
static void
make_piece (Maker *maker, uint32_t site, const Box *box)
{
  Preview *preview = maker->preview;
  const uint32_t room = voronoi_cell_room (maker->voronoi, site) + 1;
  const uint32_t first = preview->n_corners;
  uint32_t n;

  if (first + room > preview->corners_room)
    preview->corners = memory_grow (preview->corners, &preview->corners_room,
                                    first + room, sizeof *preview->corners);
  n = voronoi_clip_cell (maker->voronoi, site, box, &preview->corners[first]);
  if (n > 0)
    n = bisector_cut (&preview->corners[first], n, &maker->drawn_at,
                      &maker->voronoi->delaunay->set->sites[site]);
  if (n < 3)
    return;
  preview->pieces[preview->n_pieces++] = (PreviewPiece){ site, first, n };
  preview->n_corners += n;
}

void
preview_init (Preview *preview,
              const SiteSet *set,
              Site at,
              const Voronoi *voronoi,
              Site drawn_at,
              const Box *box)
{
  Maker maker = { .preview = preview,
                  .set = set,
                  .delaunay = voronoi->delaunay,
                  .voronoi = voronoi,
                  .at = at,
                  .drawn_at = drawn_at };
  uint32_t i;

  memset (preview, 0, sizeof *preview);
  if (!site_is_in_range (&at) || is_taken (&maker))
    return;
  maker.is_neighbour = memory_new (set->n_sites, sizeof *maker.is_neighbour);
  find_dying (&maker);
  find_seen (&maker);
  list_neighbours (&maker);
  free (maker.is_neighbour);
  make_cell (&maker, box);
  preview->pieces = memory_new (preview->n_neighbours, sizeof *preview->pieces);
  for (i = 0; i < preview->n_neighbours; i++)
    make_piece (&maker, preview->neighbours[i], box);
}

void
preview_clear (Preview *preview)
{
  free (preview->dying);
  free (preview->neighbours);
  free (preview->cell);
  free (preview->pieces);
  free (preview->corners);
  memset (preview, 0, sizeof *preview);
}
