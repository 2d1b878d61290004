/* Scenes: what a view shows, as shapes with roles in flat arrays. The two
 * painters and the picker read nothing else. A scene says what things are;
 * how they look is the theme's matter.
 *
 * Scene coordinates: a site (x, y) stands at u = (x - cx)/r, v = (y - cy)/r
 * for the extent (cx, cy), r, so that the sites fill the square -1 … 1; its
 * lift stands at (u, v, raise + u² + v²). Moving and scaling the plane only
 * shears the paraboloid: facets stay the same.
 */
#ifndef SCENE_H
#define SCENE_H

#include "camera.h"
#include "frame.h"

typedef enum Layer {
  LAYER_HULL = 1 << 0,
  LAYER_PARABOLOID = 1 << 1,
  LAYER_DELAUNAY = 1 << 2,
  LAYER_VORONOI = 1 << 3, /* edges, vertices and cells */
  LAYER_CIRCLES = 1 << 4, /* of all triangles; those of visible facets and of
                             the selection are always shown */
  LAYER_LIFTS = 1 << 5,   /* dashed vectors from sites to lifts */
  LAYER_LABELS = 1 << 6,
} Layer;

#define N_LAYERS 7
#define LAYERS_DEFAULT                                                         \
  (LAYER_HULL | LAYER_PARABOLOID | LAYER_DELAUNAY | LAYER_VORONOI              \
   | LAYER_LIFTS | LAYER_LABELS)

const char *layer_name (Layer layer); /* "circumcircles" … */
bool layer_parse (const char *name, Layer *layer);

/* What a shape is. The order is that of the legend. */
typedef enum Role {
  ROLE_GROUND, /* the plane z = 0 in space: outline */
  ROLE_SHEET,  /* the paraboloid: its rings and meridians */
  ROLE_CELL,   /* Voronoi cell; object is its site */
  ROLE_LOWER,  /* facets of the hull */
  ROLE_UPPER,
  ROLE_VERTICAL,
  ROLE_TRIANGLE,        /* Delaunay triangle; object is its facet */
  ROLE_VISIBLE,         /* visible facet, or its triangle: will go */
  ROLE_VISIBLE_UPPER,   /* visible facet that is not lower */
  ROLE_CONE,            /* new lower facet, or its triangle */
  ROLE_CONE_UPPER,      /* new facet that is not lower */
  ROLE_SELECTED_FACET,  /* the facet whose outside set is used */
  ROLE_CIRCLE,          /* circumcircle */
  ROLE_CIRCLE_VISIBLE,  /* circumcircle that contains the site in hand */
  ROLE_CIRCLE_SELECTED, /* circumcircle of the person's selection */
  ROLE_VORONOI_EDGE,
  ROLE_DELAUNAY_EDGE,
  ROLE_FREE_EDGE, /* inside a circle group: any diagonal would do */
  ROLE_RIDGE,     /* of the hull in space */
  ROLE_HORIZON,
  ROLE_HORIZON_UPPER, /* its part between facets that are not lower */
  ROLE_LIFT,          /* from a site to its lift */
  ROLE_LIFT_APEX,
  ROLE_LIFT_OUTSIDE,
  ROLE_VORONOI_VERTEX,
  ROLE_VORONOI_VERTEX_DYING,
  ROLE_SITE,
  ROLE_SITE_WAITING,
  ROLE_SITE_OUTSIDE,
  ROLE_SITE_APEX,
  ROLE_SITE_DUPLICATE,
} Role;

#define N_ROLES (ROLE_SITE_DUPLICATE + 1)

typedef enum Emphasis {
  EMPHASIS_PALE, /* not the matter of this step */
  EMPHASIS_NORMAL,
  EMPHASIS_LOUD, /* the active set of this step */
} Emphasis;

typedef enum Lit {
  LIT_NONE,
  LIT_HOVER,    /* the pointer is on it or on a counterpart */
  LIT_SELECTED, /* the person selected it or a counterpart */
} Lit;

typedef enum SceneShape {
  SHAPE_POLYGON, /* filled, closed, convex, planar */
  SHAPE_PATH,    /* open line; a closed one repeats its first point */
  SHAPE_MARK,    /* one point; label may name it */
} SceneShape;

/* Back to front; within a pass as listed. The paraboloid bounds a convex set
 * that contains the hull, so this order needs no sorting (gl and cairo). */
typedef enum ScenePass {
  PASS_GROUND,    /* plane and all in it; last when the eye is below */
  PASS_SHEET_FAR, /* drawn where the sheet faces away from the eye */
  PASS_HULL,      /* facets: those facing away first, then the others */
  PASS_SHEET_NEAR,
  PASS_LINES, /* horizon, cone edges, lifts: on top */
  PASS_MARKS,
} ScenePass;

typedef struct SceneItem {
  SceneShape shape;
  Role role;
  Emphasis emphasis;
  Lit lit;
  ScenePass pass;
  Object object;     /* what a click on it means */
  uint32_t first, n; /* points[first] … points[first + n - 1] */
  uint32_t hue;      /* ROLE_CELL: stays with its site */
  const char *label; /* marks: "s7", or NULL; owned by the scene */
} SceneItem;

typedef struct Scene {
  SceneItem *items;
  uint32_t n_items, items_room;
  Point3 *points;
  uint32_t n_points, points_room;
  bool is_space; /* else plane: all z are 0 and passes do not matter */
  char (*labels)[12];
  uint32_t n_labels, labels_room;
} Scene;

/* Which of the active roles is loud. */
typedef enum Focus {
  FOCUS_ACTIVE, /* the active set of the step; the rest pale */
  FOCUS_NONE,   /* nothing pale */
  FOCUS_VISIBLE,
  FOCUS_HORIZON,
  FOCUS_CONE,
} Focus;

const char *focus_name (Focus focus);
bool focus_parse (const char *name, Focus *focus);

/* How a person looks at a frame; no part of it changes the frame. */
typedef struct SceneLook {
  uint32_t layers; /* Layer bits */
  Focus focus;
  Extent extent;
  double raise; /* of the paraboloid above the plane, scene units */
  Object selection, hover;
  Point3 low, high; /* plane scene: the visible rectangle, to clip to */
} SceneLook;

#define RAISE_DEFAULT 0.7

void scene_plane (Scene *scene, const Frame *frame, const SceneLook *look);
void scene_space (Scene *scene, const Frame *frame, const SceneLook *look);
void scene_clear (Scene *scene);

/* Returns: the scene point of @site; its lift when @lifted. */
Point3 scene_point (const SceneLook *look, const Site *site, bool lifted);

/* Returns: the site, in SiteSet.sites units, at a point of the plane scene.
 */
Site scene_site (const SceneLook *look, Point3 point);

/* What lies under a pixel: the nearest mark within reach_px, else the nearest
 * line with an object, else the topmost polygon.
 *
 * Returns: OBJECT_NONE when nothing does. */
Object scene_pick (const Scene *scene,
                   const Projection *projection,
                   const double at_px[2],
                   double reach_px);

#endif
