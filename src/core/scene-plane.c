#include "scene-builder.h"

void
scene_add_frame (SceneBuilder *builder)
{
  const Point3 low = builder->look->low, high = builder->look->high;
  const Point3 corners[5]
      = { low, { high.x, low.y, 0 }, high, { low.x, high.y, 0 }, low };
  int i;

  scene_add (builder, SHAPE_PATH, ROLE_GROUND, (Object){ OBJECT_NONE, 0 });
  for (i = 0; i < 5; i++)
    scene_add_point (builder, corners[i]);
}

/* The current site is drawn last, over all others. */
static void
add_sites (SceneBuilder *builder)
{
  const Frame *frame = builder->frame;
  uint32_t i, apex = INDEX_NONE;

  for (i = 0; i < frame->n_sites; i++) {
    if (frame->sites[i].state == SITE_APEX)
      apex = i;
    else
      scene_add_site (builder, i, false);
  }
  if (apex != INDEX_NONE)
    scene_add_site (builder, apex, false);
}

void
scene_add_pointed_plane (SceneBuilder *builder)
{
  const Point3 box[2] = { builder->look->low, builder->look->high };

  builder->pass = PASS_GROUND;
  scene_add_lit_circles (builder, box);
  scene_add_lit_facets (builder, false);
  scene_add_why (builder, false);
  scene_add_preview (builder, box);
  builder->pass = PASS_MARKS;
  scene_add_selected_name (builder, false);
}

void
scene_plane (Scene *scene, const Frame *frame, const SceneLook *look)
{
  const Point3 box[2] = { look->low, look->high };
  SceneBuilder builder;
  SceneDiagram *diagram;

  scene_builder_init (&builder, scene, frame, look);
  scene->is_space = false;
  diagram = scene_diagram_new (&builder, box);
  builder.pass = PASS_GROUND;
  if (scene_has_layer (&builder, LAYER_VORONOI))
    scene_add_cells (diagram);
  else if (scene_has_layer (&builder, LAYER_TANGENTS))
    scene_add_tangents (&builder, diagram);
  scene_add_furthest_cells (&builder, box);
  scene_add_contours (&builder, box);
  scene_add_triangles (&builder);
  if (scene_has_layer (&builder, LAYER_VORONOI))
    scene_add_voronoi_edges (diagram);
  scene_add_circles (&builder, box, false);
  scene_add_cone_shadow (&builder);
  scene_add_delaunay_edges (&builder);
  scene_add_seen_edges (&builder);
  scene_add_furthest (&builder, box);
  scene_add_circles (&builder, box, true);
  scene_add_cone_edges (&builder, false);
  scene_add_selected_facet (&builder, false);
  scene_add_horizon (&builder, false);
  scene_add_frame (&builder); /* the casings of others would cut it */
  builder.pass = PASS_MARKS;
  scene_add_voronoi_vertices (diagram);
  add_sites (&builder);
  scene_add_dying_vertices (diagram);
  scene_add_step_name (&builder, false);
  scene_add_answers (&builder, false);
  scene_diagram_free (diagram);
  scene_light (&builder);
  scene_add_pointed_plane (&builder);
  scene_builder_clear (&builder);
}
