/* Numbers of facets and ridges follow from the order of insertion: a site that
 * is moved a little may change them all. Scenes list them by their sites, so
 * that what stays where it is stays where it is in the order of paint too, and
 * need not be painted again. */
#include "memory.h"
#include "scene-builder.h"

#include <stdlib.h>
#include <string.h>

#define N_CORNERS 3

/* The sites of a row, ascending; of two the last one is 0. */
typedef struct Corners {
  uint32_t site[N_CORNERS];
} Corners;

typedef struct Sorter {
  Corners *rows;
  uint32_t n, n_sites;
  uint32_t *order, *other; /* row numbers; room for the next pass */
  uint32_t *starts;        /* per site */
} Sorter;

static void
put_in_order (uint32_t *a, uint32_t *b)
{
  const uint32_t larger = *a;

  if (*b < larger) {
    *a = *b;
    *b = larger;
  }
}

static Corners
corners_of (const uint32_t *site, int n)
{
  Corners corners = { { site[0], site[1], n == N_CORNERS ? site[2] : 0 } };

  put_in_order (&corners.site[0], &corners.site[1]);
  if (n < N_CORNERS)
    return corners;
  put_in_order (&corners.site[1], &corners.site[2]);
  put_in_order (&corners.site[0], &corners.site[1]);
  return corners;
}

/* Sorts by one corner; rows that have the same one keep their order. */
static void
sort_by_corner (Sorter *sorter, int corner)
{
  uint32_t *const order = sorter->order;
  uint32_t i, sum = 0;

  memset (sorter->starts, 0, sorter->n_sites * sizeof *sorter->starts);
  for (i = 0; i < sorter->n; i++)
    sorter->starts[sorter->rows[i].site[corner]] += 1;
  for (i = 0; i < sorter->n_sites; i++) {
    const uint32_t size = sorter->starts[i];

    sorter->starts[i] = sum;
    sum += size;
  }
  for (i = 0; i < sorter->n; i++) {
    const uint32_t site = sorter->rows[order[i]].site[corner];

    sorter->other[sorter->starts[site]++] = order[i];
  }
  sorter->order = sorter->other;
  sorter->other = order;
}

uint32_t *
scene_order (const SceneBuilder *builder,
             uint32_t n,
             int n_corners,
             SceneCorners get_corners)
{
  Sorter sorter = { .n = n, .n_sites = builder->frame->n_sites };
  uint32_t i;
  int k;

  sorter.rows = memory_room (n, sizeof *sorter.rows);
  sorter.order = memory_room (n, sizeof *sorter.order);
  sorter.other = memory_room (n, sizeof *sorter.other);
  sorter.starts = memory_room (sorter.n_sites, sizeof *sorter.starts);
  for (i = 0; i < n; i++) {
    sorter.rows[i] = corners_of (get_corners (builder, i), n_corners);
    sorter.order[i] = i;
  }
  for (k = n_corners; k-- > 0;)
    sort_by_corner (&sorter, k);
  free (sorter.rows);
  free (sorter.other);
  free (sorter.starts);
  return sorter.order;
}

static const uint32_t *
triangle_corners (const SceneBuilder *builder, uint32_t triangle)
{
  return builder->frame->delaunay.triangles[triangle].site;
}

const uint32_t *
scene_order_triangles (SceneBuilder *builder)
{
  const uint32_t n = builder->frame->delaunay.n_triangles;

  if (builder->triangles == NULL)
    builder->triangles = scene_order (builder, n, 3, triangle_corners);
  return builder->triangles;
}
