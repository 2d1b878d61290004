/* Scenes: what a view shows, as shapes with roles in flat arrays. The two
 * painters and the picker read nothing else. A scene says what things are;
 * how they look is the theme's matter.
 *
 * Scene coordinates: a site (x, y) stands at u = (x - cx)/r, v = (y - cy)/r
 * for the extent (cx, cy), r, so that the sites fill the square -1 … 1; its
 * lift stands at (u, v, raise + u² + v²), or on the way there. Moving and
 * scaling the plane only shears the paraboloid: facets stay the same.
 *
 *   Scene scene = { 0 };
 *
 *   scene_look_init (&look, frame);
 *   scene_space (&scene, frame, &look);
 *   … scene.items[i] …
 *   scene_clear (&scene);
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
  LAYER_FURTHEST = 1 << 7, /* what the upper hull is in the plane: furthest-site
                              Delaunay and Voronoi */
  LAYER_TANGENTS = 1 << 8, /* upper envelope of the tangent planes at the
                              lifts: from above, the Voronoi diagram */
  LAYER_WHY = 1 << 9,      /* plane, ellipse and gap of a facet: why.h */
  LAYER_PREVIEW = 1 << 10, /* what a site under the pointer would change */
} Layer;

#define N_LAYERS 11
#define LAYERS_ALL ((1 << N_LAYERS) - 1)
#define LAYERS_DEFAULT                                                         \
  (LAYER_HULL | LAYER_PARABOLOID | LAYER_DELAUNAY | LAYER_VORONOI              \
   | LAYER_LIFTS | LAYER_LABELS | LAYER_PREVIEW)

const char *layer_name (Layer layer); /* "circumcircles" … */
bool layer_parse (const char *name, Layer *layer);

/* What a shape is. The order is that of the legend. */
typedef enum Role {
  ROLE_GROUND, /* outline of the plane: the square z = 0 in space, the frame
                  of the plane view */
  ROLE_SHEET,  /* the paraboloid: its rings and meridians; the outward normal
                  at a point is (2x, 2y, -1) */
  ROLE_RIM,    /* where the paraboloid is cut off */
  ROLE_CELL,   /* Voronoi cell; object is its site */
  ROLE_FURTHEST_CELL, /* of the sites' furthest-site diagram */
  ROLE_TANGENT,       /* what is seen from above of a site's tangent plane */
  ROLE_FACET,         /* a facet of which it is not told which kind it is */
  ROLE_LOWER,         /* facets of the hull */
  ROLE_UPPER,
  ROLE_VERTICAL,
  ROLE_SIGN_LEFT,        /* of a sign map: p, q, r turn left there */
  ROLE_SIGN_ZERO,        /* they are in line */
  ROLE_SIGN_RIGHT,       /* they turn right */
  ROLE_HULL_AREA,        /* inside of a hull in the plane */
  ROLE_TRIANGLE,         /* Delaunay triangle; object is its facet */
  ROLE_VISIBLE,          /* visible facet, or its triangle: will go */
  ROLE_VISIBLE_UPPER,    /* visible facet that is not lower */
  ROLE_RETIRED,          /* visible facet that is gone from the hull */
  ROLE_CONE,             /* new lower facet, or its triangle */
  ROLE_CONE_UPPER,       /* new facet that is not lower */
  ROLE_SELECTED_FACET,   /* the facet whose outside set is used */
  ROLE_PREVIEW_TRIANGLE, /* would die if a site were put at the pointer */
  ROLE_PREVIEW_STOLEN,   /* what the new cell would take from another */
  ROLE_PLANE,            /* patch of the plane through a facet */
  ROLE_CIRCLE,           /* circumcircle */
  ROLE_CIRCLE_VISIBLE,   /* circumcircle that contains the current site */
  ROLE_CIRCLE_UPPER,     /* circle of a visible upper facet: the current site
                            is outside it */
  ROLE_CIRCLE_SELECTED,  /* circumcircle of the person's selection */
  ROLE_ELLIPSE,          /* where that plane cuts the paraboloid */
  ROLE_VORONOI_EDGE,
  ROLE_TANGENT_EDGE, /* where two tangent planes meet, over a Voronoi edge */
  ROLE_DELAUNAY_EDGE,
  ROLE_FURTHEST_EDGE,    /* furthest-site Delaunay edge */
  ROLE_FURTHEST_VORONOI, /* furthest-site Voronoi edge; rays run inwards */
  ROLE_PREVIEW_EDGE,     /* Delaunay edge of the site at the pointer */
  ROLE_PREVIEW_CELL,     /* outline of its cell */
  ROLE_CONTOUR,          /* plane view: equal heights, while lifts glide */
  ROLE_FREE_EDGE,        /* inside a circle group: any diagonal would do */
  ROLE_RIDGE,            /* of the hull in space */
  ROLE_HULL_EDGE,        /* of a hull in the plane */
  ROLE_ROUNDED_EDGE,     /* of a hull by rounded signs */
  ROLE_SIGN_NODE,        /* outline of the current node */
  ROLE_EDGE_LINE,        /* all along the line of such an edge */
  ROLE_VISIBLE_EDGE,     /* ridge or Delaunay edge of a visible facet */
  ROLE_SEEN_EDGE, /* in the plane: hull edge of a visible vertical facet */
  ROLE_CONE_EDGE, /* ridge or Delaunay edge from the new site */
  ROLE_HORIZON,
  ROLE_HORIZON_UPPER, /* its part between facets that are not lower */
  ROLE_LIFT,          /* from a site to its lift */
  ROLE_LIFT_APEX,
  ROLE_LIFT_OUTSIDE,
  ROLE_DROP,          /* from an outside site's lift to the facet's plane */
  ROLE_GAP,           /* from a site's lift straight to the plane of a facet */
  ROLE_LIT,           /* outline of a lit facet or triangle */
  ROLE_ANSWER_CHOSEN, /* what a person has chosen as an answer: outlines of
                         facets, ridges, rings round sites */
  ROLE_ANSWER_RIGHT,
  ROLE_ANSWER_WRONG,
  ROLE_ANSWER_MISSED, /* right, but not chosen */
  ROLE_VORONOI_VERTEX,
  ROLE_VORONOI_VERTEX_TIED, /* of a circle through four sites or more */
  ROLE_VORONOI_VERTEX_DYING,
  ROLE_FURTHEST_VERTEX,
  ROLE_PREVIEW_SITE,
  ROLE_HORIZON_CORNER, /* of a hull in the plane */
  ROLE_FOOT,           /* a site in the plane, in the space view */
  ROLE_FOOT_APEX,
  ROLE_SITE,
  ROLE_SITE_WAITING,
  ROLE_SITE_OUTSIDE,
  ROLE_SITE_APEX,
  ROLE_SITE_DUPLICATE,
  ROLE_SITE_LOST,    /* outside, but dropped by rounded signs */
  ROLE_SITE_IGNORED, /* inside a hull in the plane */
  ROLE_POWER,        /* no mark: the power beside a gap, as a number */
  ROLE_FACET_NAME,   /* no mark: the label of a facet in its middle */
  ROLE_ANSWER_NAME,  /* no mark: that of a facet that is an answer, and how
                        right it is */
} Role;

#define N_ROLES (ROLE_ANSWER_NAME + 1)

const char *role_name (Role role); /* "lower", "horizon", "voronoi-edge" … */
bool role_parse (const char *name, Role *role);

/* What of the space view can be made transparent as a whole. */
typedef enum Body {
  BODY_PARABOLOID,
  BODY_HULL,
  BODY_PLANE, /* the plane z = 0 and all in it */
} Body;

#define N_BODIES (BODY_PLANE + 1)

const char *body_name (Body body); /* "paraboloid" … */
bool body_parse (const char *name, Body *body);

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
  PASS_OUTER,     /* surfaces round the paraboloid: tangent planes */
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
  Object object;      /* what a click on it means */
  uint32_t first, n;  /* points[first] … points[first + n - 1] */
  uint32_t beside[2]; /* lines: items of the facets on both sides, or
                         INDEX_NONE */
  uint32_t hue;       /* of cells: stays with its site */
  double fade;        /* 0: as the theme says … 1: not to be seen */
  bool is_two_sided;  /* a polygon that bounds nothing */
  bool is_corner;     /* marks: of a site that is a corner of what the step
                         speaks of, or makes: its name comes first */
  const char *label;  /* marks: "s7", or NULL; owned by the scene */
} SceneItem;

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

/* What is not shown while a question is open. */
typedef enum SceneMask {
  MASK_ROUND = 1 << 0,  /* what the current round has found: all facets only
                           stand; the current site is shown */
  MASK_FACING = 1 << 1, /* lower, upper, vertical; and the diagrams, which are
                           the lower facets */
  MASK_WHY = 1 << 2,    /* whatever explains and foretells: layers why and
                           preview */
} SceneMask;

/* An object that a person has chosen as an answer, or that the question speaks
 * of. */
typedef enum AnswerKind {
  ANSWER_NAMED, /* spoken of: a facet has its name, and no mark */
  ANSWER_CHOSEN,
  ANSWER_RIGHT,
  ANSWER_WRONG,
  ANSWER_MISSED,
} AnswerKind;

typedef struct SceneAnswer {
  Object object;
  AnswerKind kind;
  uint32_t place; /* in an order, from 1; 0: in none */
} SceneAnswer;

/* How a person looks at a frame; no part of it changes the frame. */
typedef struct SceneLook {
  uint32_t layers;            /* Layer bits */
  uint32_t mask;              /* SceneMask bits */
  const SceneAnswer *answers; /* borrowed, n_answers of them */
  uint32_t n_answers;
  Focus focus;
  Extent extent;
  double raise; /* of the paraboloid above the plane, scene units */
  double lift;  /* of the sites: 0 in the plane … 1 on the paraboloid */
  double body_fade[N_BODIES], role_fade[N_ROLES]; /* SceneItem.fade */
  Object selection, hover;
  Object measured; /* LAYER_WHY: the site whose power is told, when the
                      pointer is on none */
  /* While a step is on its way: of what came after step `since` this part is
   * still to be drawn. The horizon grows round its loop, cone facets from
   * their ridge to the apex. 0: at rest. */
  double moving;
  uint32_t since;
  bool has_preview;
  Site preview; /* LAYER_PREVIEW: where the site would be, as SiteSet.sites */
  const uint32_t *hues; /* SceneItem.hue of each site's cell, n_hues of them;
                           borrowed; NULL: a site's own number */
  uint32_t n_hues;
  const uint32_t *selected; /* sites, ascending; borrowed; NULL: none but */
  uint32_t n_selected;      /* the selection */
  Point3 low, high; /* plane scene: the visible rectangle, to clip to; see
                       scene_look_fit() */
} SceneLook;

/* How much of a scene is its stock. It is never lit but in SceneItem.lit. */
typedef struct SceneStock {
  uint64_t edition; /* another one whenever a scene is filled; 0: never */
  uint32_t n_items, n_points, n_labels;
  uint32_t n_sites; /* marks of sites */
} SceneStock;

/* Which items of the stock have an object; private to scene-index.c. */
typedef struct SceneIndex {
  uint32_t *heads, *next; /* item + 1; 0: none */
  uint32_t mask, next_room;
  uint64_t edition; /* of the stock */
} SceneIndex;

#define LABEL_ROOM 24

/* The items of a scene: first its stock, all that there is to show; then what
 * is there only because something is selected or under the pointer, as it is
 * now. */
typedef struct Scene {
  SceneItem *items;
  uint32_t n_items, items_room;
  Point3 *points;
  uint32_t n_points, points_room;
  bool is_space; /* else plane: all z are 0 and passes do not matter */
  char (*labels)[LABEL_ROOM];
  uint32_t n_labels, labels_room;
  SceneLook look; /* that it is filled for, but what that borrows */
  SceneStock stock;
  uint32_t *lit; /* items of the stock that are lit, ascending, n_lit of them */
  uint32_t n_lit, lit_room;
  SceneIndex index;
} Scene;

#define RAISE_DEFAULT 0.7
#define RAISE_MOST 2.0

/* Returns: whether @site is selected, alone or among others. */
bool scene_is_selected (const SceneLook *look, uint32_t site);

/* The default look at all sites of a frame. */
void scene_look_init (SceneLook *look, const Frame *frame);

/* Fill @scene anew; its room is used again. */
void scene_plane (Scene *scene, const Frame *frame, const SceneLook *look);
void scene_space (Scene *scene, const Frame *frame, const SceneLook *look);
void scene_clear (Scene *scene);

/* Brings a scene of the same frame to a look that differs from its own only in
 * what a person points at: hover, selection, measured site, preview. @frame is
 * NULL for a scene that was made of none.
 *
 * Returns: false, and nothing has changed, when it differs in more.
 * Cost:    O(items that are lit, before or now); the first time, and where a
 *          preview is, O(items). */
bool scene_relight (Scene *scene, const Frame *frame, const SceneLook *look);

/* Does now what the first scene_relight() would do once. */
void scene_prepare_light (Scene *scene);

/* Sets low and high to what @projection, one of the plane view, shows within
 * @inset_px of its border. */
void
scene_look_fit (SceneLook *look, const Projection *projection, double inset_px);

/* Layers of paint, back to front. Each is one of nested convex surfaces or
 * one side of it, so that items of one layer need no order. */
typedef enum SceneDepth {
  DEPTH_GROUND,     /* the plane seen from above */
  DEPTH_OUTER_FAR,  /* planes round the paraboloid, facing away */
  DEPTH_SHEET_FAR,  /* the paraboloid where it faces away from the eye */
  DEPTH_CONE_FAR,   /* cone facets facing away */
  DEPTH_HULL_FAR,   /* other facets facing away */
  DEPTH_HULL_NEAR,  /* other facets facing the eye */
  DEPTH_CONE_NEAR,  /* cone facets facing the eye */
  DEPTH_SHEET_NEAR, /* the paraboloid where it faces the eye */
  DEPTH_OUTER_NEAR, /* planes round the paraboloid, facing the eye */
  DEPTH_UNDER,      /* the plane seen from below */
  DEPTH_LINES,
  DEPTH_MARKS,
} SceneDepth;

#define N_SCENE_DEPTHS (DEPTH_MARKS + 1)

/* Returns: the layer of paint of an item. Those of the paraboloid are
 *          DEPTH_SHEET_FAR, though parts of them may face the eye. In the
 *          plane view all items but marks are DEPTH_GROUND. */
SceneDepth scene_depth (const Scene *scene,
                        const SceneItem *item,
                        const Projection *projection);

/* The depths of all items of the stock, a byte each: each facet is looked at
 * once, not for each of its ridges too. */
void scene_stock_depths (const Scene *scene,
                         const Projection *projection,
                         unsigned char *depths);

/* Returns: whether the planar polygon @item faces the eye. */
bool scene_faces_eye (const Scene *scene,
                      const SceneItem *item,
                      const Projection *projection);

/* Returns: the scene point of @site; its lift when @lifted, as far as it is
 *          lifted. */
Point3 scene_point (const SceneLook *look, const Site *site, bool lifted);

/* Returns: the site, in SiteSet.sites units, at a point of the plane scene.
 */
Site scene_site (const SceneLook *look, Point3 point);

/* What lies under a pixel: the nearest mark within reach_px, else the nearest
 * edge or ridge within half of it that no facet hides, else the topmost
 * polygon.
 *
 * Returns: OBJECT_NONE when nothing does. */
Object scene_pick (const Scene *scene,
                   const Projection *projection,
                   const double at_px[2],
                   double reach_px);

/* The same, again and again: a picker lists the stock of a scene by place, and
 * keeps the list as long as scene and projection stay. Nobody can pick what is
 * there only because of what is pointed at.
 *
 * Cost: O(items near the pixel); the first time O(items). */
typedef struct ScenePicker ScenePicker;

ScenePicker *scene_picker_new (void);
void scene_picker_free (ScenePicker *picker);

/* Does now what is done the first time. */
void scene_picker_prepare (ScenePicker *picker,
                           const Scene *scene,
                           const Projection *projection);
Object scene_picker_pick (ScenePicker *picker,
                          const Scene *scene,
                          const Projection *projection,
                          const double at_px[2],
                          double reach_px);

#endif
