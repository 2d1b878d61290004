/* The furthest-site diagrams in the plane. */
#include "furthest.h"
#include "memory.h"
#include "scene-builder.h"

#include <stdlib.h>

typedef struct Picture {
  SceneBuilder *builder;
  Furthest furthest; /* in scene units */
  Site *sites;
  Box box;
} Picture;

static void
picture_init (Picture *picture, SceneBuilder *builder, const Point3 box[2])
{
  const uint32_t n_sites = builder->frame->n_sites;
  uint32_t i;

  picture->builder = builder;
  picture->sites = memory_new (n_sites, sizeof *picture->sites);
  picture->box = (Box){ { box[0].x, box[0].y }, { box[1].x, box[1].y } };
  for (i = 0; i < n_sites; i++) {
    const Point3 at = scene_at (builder, i, false);

    picture->sites[i] = (Site){ at.x, at.y };
  }
  furthest_init (&picture->furthest, builder->frame, picture->sites);
}

static void
picture_clear (Picture *picture)
{
  furthest_clear (&picture->furthest);
  free (picture->sites);
}

static Point3
in_plane (Site at)
{
  return (Point3){ at.x, at.y, 0 };
}

static void
add_cells (Picture *picture)
{
  const Furthest *furthest = &picture->furthest;
  Site *corners = memory_new (furthest->n_edges + 5, sizeof *corners);
  uint32_t i, k;

  for (i = 0; i < furthest->n_corners; i++) {
    const uint32_t site = furthest->corners[i];
    const uint32_t n = furthest_clip_cell (furthest, i, &picture->box, corners);

    if (n == 0)
      continue;
    scene_add (picture->builder, SHAPE_POLYGON, ROLE_FURTHEST_CELL,
               (Object){ OBJECT_SITE, site })
        ->hue
        = scene_hue (picture->builder, site);
    for (k = 0; k < n; k++)
      scene_add_point (picture->builder, in_plane (corners[k]));
  }
  free (corners);
}

static Object
ridge_object (const FurthestEdge *edge)
{
  if (edge->ridge == INDEX_NONE)
    return (Object){ OBJECT_NONE, 0 };
  return (Object){ OBJECT_RIDGE, edge->ridge };
}

static void
add_edges (Picture *picture)
{
  SceneBuilder *builder = picture->builder;
  const Furthest *furthest = &picture->furthest;
  uint32_t i;

  for (i = 0; i < furthest->n_edges; i++) {
    const FurthestEdge *edge = &furthest->edges[i];

    scene_add_edge (builder,
                    edge->is_free ? ROLE_FREE_EDGE : ROLE_FURTHEST_EDGE,
                    ridge_object (edge), edge->site, false);
  }
  for (i = 0; i < furthest->n_edges; i++) {
    Site ends[2];

    if (furthest_clip_edge (furthest, i, &picture->box, ends))
      scene_add_segment (builder, ROLE_FURTHEST_VORONOI,
                         ridge_object (&furthest->edges[i]),
                         (Point3[2]){ in_plane (ends[0]), in_plane (ends[1]) });
  }
}

static void
add_vertices (Picture *picture)
{
  const Furthest *furthest = &picture->furthest;
  const Box *box = &picture->box;
  uint32_t i;

  for (i = 0; i < furthest->n_vertices; i++) {
    const FurthestVertex *vertex = &furthest->vertices[i];

    if (box->low.x <= vertex->at.x && vertex->at.x <= box->high.x
        && box->low.y <= vertex->at.y && vertex->at.y <= box->high.y)
      scene_add_mark (picture->builder, ROLE_FURTHEST_VERTEX,
                      (Object){ OBJECT_FACET, vertex->facet },
                      in_plane (vertex->at), NULL);
  }
}

void
scene_add_furthest_cells (SceneBuilder *builder, const Point3 box[2])
{
  Picture picture;

  if (!scene_has_layer (builder, LAYER_FURTHEST)
      || scene_has_layer (builder, LAYER_VORONOI))
    return;
  picture_init (&picture, builder, box);
  add_cells (&picture);
  picture_clear (&picture);
}

void
scene_add_furthest (SceneBuilder *builder, const Point3 box[2])
{
  Picture picture;

  if (!scene_has_layer (builder, LAYER_FURTHEST))
    return;
  picture_init (&picture, builder, box);
  add_edges (&picture);
  add_vertices (&picture);
  picture_clear (&picture);
}
