/* What both scenes are put together with. Private to scene*.c. */
#ifndef SCENE_BUILDER_H
#define SCENE_BUILDER_H

#include "scene.h"

typedef struct SceneBuilder {
  Scene *scene;
  const Frame *frame;
  const SceneLook *look;
  const Event *event; /* that led to the step, or NULL at the start */
  bool is_round;      /* a round is in hand */
  uint32_t parts;     /* of the active set that are loud, Part bits */
  uint32_t *ridge_of; /* per Delaunay edge: its row of Trace.ridges; flat
                         input: its own number */
  ScenePass pass;     /* of the items that are added next */
} SceneBuilder;

void scene_builder_init (SceneBuilder *builder,
                         Scene *scene,
                         const Frame *frame,
                         const SceneLook *look);
void scene_builder_clear (SceneBuilder *builder);

/* Adds an item of no points yet; points added after it are its own.
 *
 * Owns: the pointer is valid until the next item is added. */
SceneItem *
scene_add (SceneBuilder *builder, SceneShape shape, Role role, Object object);
void scene_add_point (SceneBuilder *builder, Point3 point);
void scene_add_segment (SceneBuilder *builder,
                        Role role,
                        Object object,
                        const Point3 ends[2]);
void scene_add_mark (SceneBuilder *builder,
                     Role role,
                     Object object,
                     Point3 at,
                     const char *label);

/* Returns: "s7" or "f9", owned by the scene; NULL when labels are hidden. */
const char *scene_label (SceneBuilder *builder, char letter, uint32_t number);

/* Returns: how @object or a counterpart of it is lit. */
Lit scene_lit (const SceneBuilder *builder, Object object);

/* Returns: the circle group of a facet's triangle, or INDEX_NONE. */
uint32_t scene_group (const SceneBuilder *builder, uint32_t facet);

/* Returns: the object that stands for a circle group's Voronoi vertex. */
Object scene_vertex_object (const SceneBuilder *builder, uint32_t group);

/* What a standing facet is at this step; its shadow, when @is_triangle. */
Role
scene_facet_role (const SceneBuilder *builder, uint32_t facet, uint32_t roles);

bool scene_has_layer (const SceneBuilder *builder, Layer layer);

/* The sites of facet @facet, or of triangle @facet of flat input. */
const uint32_t *scene_facet_sites (const SceneBuilder *builder, uint32_t facet);

/* Returns: the scene point of site number @site. */
Point3 scene_at (const SceneBuilder *builder, uint32_t site, bool lifted);

/* The Voronoi diagram in the plane, cut off at the rectangle box[0] …
 * box[1]. */
typedef struct SceneDiagram SceneDiagram;

SceneDiagram *scene_diagram_new (SceneBuilder *builder, const Point3 box[2]);
void scene_diagram_free (SceneDiagram *diagram);
void scene_add_cells (SceneDiagram *diagram);
void scene_add_voronoi_edges (SceneDiagram *diagram);
void scene_add_voronoi_vertices (SceneDiagram *diagram);

/* Parts that plane and space have in common: all that lies in the plane. */
void scene_add_circles (SceneBuilder *builder, const Point3 box[2]);
void scene_add_triangles (SceneBuilder *builder);
void scene_add_delaunay_edges (SceneBuilder *builder);
void scene_add_cone_shadow (SceneBuilder *builder);

/* The same in the plane, or in space when @lifted. */
SceneItem *scene_add_polygon (SceneBuilder *builder,
                              Role role,
                              uint32_t facet,
                              bool lifted);
void scene_add_edge (SceneBuilder *builder,
                     Role role,
                     Object object,
                     const uint32_t site[2],
                     bool lifted);
void scene_add_cone_edges (SceneBuilder *builder, bool lifted);
void scene_add_horizon (SceneBuilder *builder, bool lifted);
void scene_add_selected_facet (SceneBuilder *builder, bool lifted);
void scene_add_lit_facets (SceneBuilder *builder, bool lifted);
void scene_add_facet_names (SceneBuilder *builder, bool lifted);

/* Returns: the facet whose outside set is shown, or INDEX_NONE. */
uint32_t scene_selected_facet (const SceneBuilder *builder);

/* Returns: whether the hull shown is that after the round in hand and @site
 *          is the site that the round inserted. */
bool scene_is_new_apex (const SceneBuilder *builder, uint32_t site);

/* Returns: the roles of a facet at this step; those of flat input stand. */
uint32_t scene_roles (const SceneBuilder *builder, uint32_t facet);

/* Returns: the role of a site's mark. */
Role scene_site_role (SiteState state);

#endif
