/* What both scenes are put together with. Private to scene*.c. */
#ifndef SCENE_BUILDER_H
#define SCENE_BUILDER_H

#include "frame-mask.h"
#include "preview.h"
#include "scene.h"

/* What all items of a role have in common. */
typedef struct RoleLook {
  uint32_t pass; /* that it is true of, + 1; 0: not known */
  Emphasis emphasis;
  double fade;
} RoleLook;

typedef struct SceneBuilder {
  Scene *scene;
  const Frame *frame;
  const SceneLook *look;
  FrameMask mask;   /* its frame is the frame, when the look masks the round */
  SceneLook masked; /* is the look, when it masks anything */
  const Event *event;  /* that led to the step, or NULL at the start */
  Event said;          /* what it points to */
  bool is_round;       /* there is a current round */
  uint32_t parts;      /* of the active set that are loud, Part bits */
  uint32_t *ridge_of;  /* per Delaunay edge: its row of Trace.ridges; flat
                          input: its own number; for the stock alone */
  uint32_t *roles;     /* per facet of the trace: see scene_roles(); or NULL */
  Point3 *lifts;       /* per site: its scene point, lifted; or NULL */
  uint32_t *triangles; /* scene_order_triangles(), once it has been asked */
  RoleLook role_looks[N_ROLES]; /* as they are asked for */
  ScenePass pass;               /* of the items that are added next */
  bool has_stock; /* they are there because of what a person points at */
} SceneBuilder;

void scene_builder_init (SceneBuilder *builder,
                         Scene *scene,
                         const Frame *frame,
                         const SceneLook *look);
void scene_builder_clear (SceneBuilder *builder);

/* Goes on after the stock of a scene that has been filled from @frame. */
void scene_builder_resume (SceneBuilder *builder,
                           Scene *scene,
                           const Frame *frame,
                           const SceneLook *look);

/* All items so far are the stock: lights what of them is lit. What is added
 * after it is there because of that. Scenes without it have no stock. */
void scene_light (SceneBuilder *builder);

/* What is shown only because a person points at it. */
void scene_add_pointed_plane (SceneBuilder *builder);
void scene_add_pointed_space (SceneBuilder *builder);

/* The same for scenes without a frame: objects are sites alone. @n_labels: at
 * most so many; they must not move once they are pointed to. Nothing to
 * clear. */
void scene_builder_open (SceneBuilder *builder,
                         Scene *scene,
                         const SceneLook *look,
                         uint32_t n_labels);

/* There is a current round, and @phase says what is loud. */
void scene_builder_round (SceneBuilder *builder, Phase phase);

/* Adds an item of no points yet; points added after it are its own.
 *
 * Owns: the pointer is valid until the next item is added. */
SceneItem *
scene_add (SceneBuilder *builder, SceneShape shape, Role role, Object object);
void scene_add_point (SceneBuilder *builder, Point3 point);
void scene_add_points (SceneBuilder *builder, const Point3 *points, uint32_t n);

/* Takes back the item that was added last. */
void scene_drop_item (SceneBuilder *builder);
void scene_add_segment (SceneBuilder *builder,
                        Role role,
                        Object object,
                        const Point3 ends[2]);

/* Puts a measure so short, for who looks along @gaze, that the mark of its site
 * would hide it, beside that mark, as draughtsmen do. */
void scene_put_aside (Point3 ends[2], Point3 across, Point3 gaze);

/* A height or distance: ROLE_DROP, with a tick along @across at both ends, so
 * that it is one however short it is. */
void scene_add_measure (SceneBuilder *builder,
                        Object object,
                        const Point3 ends[2],
                        Point3 across);
void scene_add_mark (SceneBuilder *builder,
                     Role role,
                     Object object,
                     Point3 at,
                     const char *label);

/* Returns: "s7" or "f9", owned by the scene; NULL when labels are hidden. */
const char *scene_label (SceneBuilder *builder, char letter, uint32_t number);

/* Returns: a copy of @text, cut to LABEL_ROOM, owned by the scene; shown even
 * when names are hidden. */
const char *scene_text (SceneBuilder *builder, const char *text);

/* Returns: how @object or a counterpart of it is lit. */
Lit scene_lit (const SceneBuilder *builder, Object object);

/* Returns: how loud a role is at this step. */
Emphasis scene_emphasis (const SceneBuilder *builder, Role role);

/* Items of the stock by object: the first one, the next one after @item that
 * has the same object; or INDEX_NONE. */
void scene_index_renew (Scene *scene);
uint32_t scene_index_first (const Scene *scene, Object object);
uint32_t scene_index_next (const Scene *scene, uint32_t item);
void scene_index_clear (SceneIndex *index);

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

/* Returns: the hue of a site's cell. */
uint32_t scene_hue (const SceneBuilder *builder, uint32_t site);

/* Returns: the scene point of site number @site. */
Point3 scene_at (const SceneBuilder *builder, uint32_t site, bool lifted);

/* Rows of the frame, and the sites at their corners. */
typedef const uint32_t *(*SceneCorners) (const SceneBuilder *builder,
                                         uint32_t row);

/* Returns: the numbers of @n rows with 2 or 3 corners, by their sites; free
 *          with free(). */
uint32_t *scene_order (const SceneBuilder *builder,
                       uint32_t n,
                       int n_corners,
                       SceneCorners get_corners);

/* Returns: the numbers of the triangles by their sites, borrowed. */
const uint32_t *scene_order_triangles (SceneBuilder *builder);

/* The frame of the plane view: the rectangle that it shows. */
void scene_add_frame (SceneBuilder *builder);

/* The Voronoi diagram in the plane, cut off at the rectangle box[0] …
 * box[1]. */
typedef struct SceneDiagram SceneDiagram;

SceneDiagram *scene_diagram_new (SceneBuilder *builder, const Point3 box[2]);
void scene_diagram_free (SceneDiagram *diagram);

/* Its cells and edges, cut off, in scene units. @corners has room for
 * scene_diagram_room().
 *
 * Returns: the number of corners, 0 when there is no cell; whether a part of
 *          the edge is left. */
uint32_t scene_diagram_room (const SceneDiagram *diagram);
uint32_t scene_diagram_cell (const SceneDiagram *diagram,
                             uint32_t site,
                             Point3 *corners);
uint32_t scene_diagram_n_edges (const SceneDiagram *diagram);
bool scene_diagram_edge (const SceneDiagram *diagram,
                         uint32_t edge,
                         uint32_t site[2],
                         Point3 ends[2]);

/* Returns: the scene point of one in the diagram's own units. */
Point3 scene_diagram_point (const SceneDiagram *diagram, Site at);

/* What a site at @at, in units of SiteSet.sites, would change; free with
 * preview_clear(). Cell and pieces are in the diagram's own units. */
void
scene_diagram_preview (const SceneDiagram *diagram, Site at, Preview *preview);

void scene_add_cells (SceneDiagram *diagram);
void scene_add_voronoi_edges (SceneDiagram *diagram);

/* Vertices that stand; those that will go are to be seen over all sites. */
void scene_add_voronoi_vertices (SceneDiagram *diagram);
void scene_add_dying_vertices (SceneDiagram *diagram);

void scene_add_tangents (SceneBuilder *builder, const SceneDiagram *diagram);

/* The layer of the furthest-site diagrams, if it is shown; its cells where no
 * others are. */
void scene_add_furthest_cells (SceneBuilder *builder, const Point3 box[2]);
void scene_add_furthest (SceneBuilder *builder, const Point3 box[2]);

/* What a site under the pointer would change; in space its lift as well. */
void scene_add_preview (SceneBuilder *builder, const Point3 box[2]);
void scene_add_preview_lift (SceneBuilder *builder);

/* Returns: the radius at which the paraboloid is cut off. */
double scene_rim (const SceneBuilder *builder);

/* The layer that tells why: plane and ellipse in space, the circle in the
 * plane, the gap in both. */
void scene_add_why_plane (SceneBuilder *builder);
void scene_add_why (SceneBuilder *builder, bool lifted);

/* The circle through three sites; the ellipse over it on the paraboloid, as
 * far as that is shown. */
void scene_add_circle (SceneBuilder *builder,
                       Role role,
                       Object object,
                       const uint32_t site[3],
                       const Point3 box[2]);
void scene_add_ellipse (SceneBuilder *builder, const uint32_t site[3]);

/* While lifts are on their way, the paraboloid's contours at fixed heights
 * tell how far: the lower the lifts, the further out. */
void scene_add_contours (SceneBuilder *builder, const Point3 box[2]);

/* Parts that plane and space have in common: all that lies in the plane.
 * Circles lie over the shadow of a cone, where there is one, or else under the
 * edges: it is said which of the two places this is. */
void
scene_add_circles (SceneBuilder *builder, const Point3 box[2], bool over_cone);
void scene_add_lit_circles (SceneBuilder *builder, const Point3 box[2]);
void scene_add_triangles (SceneBuilder *builder);
void scene_add_delaunay_edges (SceneBuilder *builder);
void scene_add_seen_edges (SceneBuilder *builder);
void scene_add_cone_shadow (SceneBuilder *builder);
bool scene_has_cone_shadow (const SceneBuilder *builder);

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
SceneItem *scene_add_outline (SceneBuilder *builder,
                              Role role,
                              uint32_t facet,
                              bool lifted);

/* Names the facet that the sentence of the step speaks of; that which is
 * selected. Answers have their names. */
/* Adds the mark of a site, with its name. */
void scene_add_site (SceneBuilder *builder, uint32_t site, bool lifted);

/* Returns: where the name of a facet belongs: in its middle, or away from there
 *          where a corner is too near. */
Point3
scene_name_point (const SceneBuilder *builder, uint32_t facet, bool lifted);
void scene_add_step_name (SceneBuilder *builder, bool lifted);
void scene_add_selected_name (SceneBuilder *builder, bool lifted);

/* How far inside its sides the outline of a chosen facet is drawn. */
#define ANSWER_INSET 0.14

void scene_add_answers (SceneBuilder *builder, bool lifted);

/* Returns: whether a facet is an answer, and so has its name already. */
bool scene_has_answer (const SceneBuilder *builder, uint32_t facet);

/* Returns: the facet whose outside set is shown, or INDEX_NONE. */
uint32_t scene_selected_facet (const SceneBuilder *builder);

/* Returns: whether the hull shown is that after the current round and @site
 *          is the site that the round inserted. */
bool scene_is_new_apex (const SceneBuilder *builder, uint32_t site);

/* Returns: the roles of a facet at this step; those of flat input stand. */
uint32_t scene_roles (const SceneBuilder *builder, uint32_t facet);

/* Returns: the roles of all facets of the frame's trace, 0 for those that are
 *          not in the frame; SceneBuilder.roles. */
uint32_t *scene_roles_new (const Frame *frame);

/* Returns: the role of a site's mark. */
Role scene_site_role (SiteState state);

#endif
