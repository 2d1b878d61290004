/* What a site under the pointer would change. Nothing of it can be pointed
 * at: it must not be in the way of what is there. */
#include "scene-builder.h"

#include <stddef.h>

static const Object no_object = { OBJECT_NONE, 0 };

static void
add_outline (SceneDiagram *diagram,
             SceneBuilder *builder,
             const Preview *preview)
{
  uint32_t i;

  if (preview->n_cell == 0)
    return;
  scene_add (builder, SHAPE_PATH, ROLE_PREVIEW_CELL, no_object);
  for (i = 0; i <= preview->n_cell; i++)
    scene_add_point (builder, scene_diagram_point (
                                  diagram, preview->cell[i % preview->n_cell]));
}

static void
add_pieces (SceneDiagram *diagram,
            SceneBuilder *builder,
            const Preview *preview)
{
  uint32_t i, k;

  for (i = 0; i < preview->n_pieces; i++) {
    const PreviewPiece *piece = &preview->pieces[i];

    scene_add (builder, SHAPE_POLYGON, ROLE_PREVIEW_STOLEN, no_object)->hue
        = piece->site;
    for (k = 0; k < piece->n; k++)
      scene_add_point (
          builder,
          scene_diagram_point (diagram, preview->corners[piece->first + k]));
  }
}

static void
add_star (SceneBuilder *builder, const Preview *preview, Point3 at)
{
  const Delaunay *delaunay = &builder->frame->delaunay;
  uint32_t i, k;

  for (i = 0; i < preview->n_dying; i++) {
    const uint32_t *site = delaunay->triangles[preview->dying[i]].site;

    scene_add (builder, SHAPE_POLYGON, ROLE_PREVIEW_TRIANGLE, no_object);
    for (k = 0; k < 3; k++)
      scene_add_point (builder, scene_at (builder, site[k], false));
  }
  for (i = 0; delaunay->n_triangles > 0 && i < preview->n_neighbours; i++)
    scene_add_segment (
        builder, ROLE_PREVIEW_EDGE, no_object,
        (Point3[2]){ at, scene_at (builder, preview->neighbours[i], false) });
}

void
scene_add_preview (SceneBuilder *builder, const Point3 box[2])
{
  const SceneLook *look = builder->look;
  const Point3 at = scene_point (look, &look->preview, false);
  SceneDiagram *diagram;
  Preview preview;

  if (!look->has_preview || !scene_has_layer (builder, LAYER_PREVIEW))
    return;
  diagram = scene_diagram_new (builder, box);
  scene_diagram_preview (diagram, look->preview, &preview);
  if (preview.n_neighbours > 0 || builder->frame->delaunay.n_active == 0) {
    add_pieces (diagram, builder, &preview);
    add_star (builder, &preview, at);
    add_outline (diagram, builder, &preview);
    scene_add_mark (builder, ROLE_PREVIEW_SITE, no_object, at, NULL);
  }
  preview_clear (&preview);
  scene_diagram_free (diagram);
}

void
scene_add_preview_lift (SceneBuilder *builder)
{
  const SceneLook *look = builder->look;
  const Point3 ends[2] = { scene_point (look, &look->preview, false),
                           scene_point (look, &look->preview, true) };

  if (!look->has_preview || !scene_has_layer (builder, LAYER_PREVIEW))
    return;
  scene_add_segment (builder, ROLE_LIFT, no_object, ends);
  scene_add_mark (builder, ROLE_PREVIEW_SITE, no_object, ends[1], NULL);
}
