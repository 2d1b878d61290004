/* What the parts of the painter's front half share. */
#ifndef PAINTER_PRIVATE_H
#define PAINTER_PRIVATE_H

#include "brush.h"
#include "drawing.h"
#include "label.h"
#include "painter.h"
#include "squares.h"

/* Layers of paint: of each depth first surfaces and lines, then marks. */
#define N_PAINT_LAYERS (2 * N_SCENE_DEPTHS)

static inline SceneDepth
paint_layer_depth (uint32_t layer)
{
  return (SceneDepth)(layer / 2);
}

static inline bool
paint_layer_is_marks (uint32_t layer)
{
  return layer % 2 == 1;
}

/* The style last given to a sort of items: to those of one role, emphasis, lit,
 * shape and depth, which do or do not stand for a Voronoi vertex. */
typedef struct PainterSort {
  uint32_t sort;  /* its number + 1; 0: none yet */
  uint32_t style; /* its number */
  double fade;    /* of the items that it is for */
} PainterSort;

#define N_PAINTER_SORTS 1024 /* a power of two; sorts share places */

typedef struct Painter {
  Drawing *drawing;
  const Scene *scene;
  const Projection *projection;
  const Theme *theme;
  Point3 lamp;      /* painter_lamp() */
  bool is_plain;    /* paints as if nothing were lit */
  bool is_hasty;    /* draws a sketch where there is much to draw, */
  bool is_sketch;   /* and does so, */
  double scale;     /* device pixels per px */
  SceneDepth depth; /* of the current items */
  bool is_behind;   /* the current item is a site that the hull hides */
  const unsigned char *depths; /* SceneDepths of the stock */
  const HiddenCorners *hidden; /* NULL: it hides none */
  PainterSort *sorts; /* N_PAINTER_SORTS of them; NULL where few are painted */
  const Drawing *before; /* to take strokes from; or NULL */
  uint32_t cursor;       /* the next stroke of it */
  uint32_t first_new;    /* stroke of the current item */
  Squares *changed;      /* where the two differ so far */
  uint64_t last_key;     /* that strokes were looked for with … */
  uint64_t n_same;       /* … so many times before this one */
  Pixel *corners;        /* room for a polygon */
  uint32_t corners_room;
} Painter;

/* Items of a scene back to front. */
typedef struct PaintOrder {
  uint32_t *items;
  uint32_t starts[N_PAINT_LAYERS + 1]; /* where each layer begins */
} PaintOrder;

/* Orders @n items, ascending; NULL: all @n of the stock. */
void paint_order_init (PaintOrder *order,
                       const Painter *painter,
                       const uint32_t *items,
                       uint32_t n);
void paint_order_clear (PaintOrder *order);

/* Returns: px from site to site, if they lay evenly in the square -1 … 1. */
double painter_room (const Painter *painter);

/* Finds which corners of the hull it hides itself: painter->hidden. They are
 * kept by the drawing. */
void painter_find_hidden (Painter *painter);

/* Whether an item is a site, or its lift, that painter->hidden hides. */
bool painter_hides (const Painter *painter, const SceneItem *item);

/* Light comes from the eye, a little from the upper left.
 *
 * Returns: the way from the eye to the lamp. */
Point3 painter_lamp (const Projection *projection);

/* Returns: the fill of a facet, darker the more it is turned from the light. */
Colour
painter_shade (const Painter *painter, const SceneItem *item, Colour fill);

/* Adds strokes of @n items, ascending. */
void painter_add_items (Painter *painter, const uint32_t *items, uint32_t n);

/* The strokes that follow are of an item; they lie where @anchor is. */
void painter_begin_item (Painter *painter, uint32_t item, uint32_t anchor);

/* Which casings of a layer are there so far: those of the items before @end,
 * in the order of paint; and those that lie under all edges. */
typedef struct Casings {
  uint32_t end;
  bool has_low;
} Casings;

/* Adds the casings that lie under the line at place @i of the order. */
void painter_add_casings (Painter *painter,
                          const PaintOrder *order,
                          uint32_t i,
                          Casings *casings);

/* Returns: the number of the item's style in the drawing. */
uint32_t painter_number_style (Painter *painter, const SceneItem *item);

/* Whether nothing is seen of an item in a style; whether this is known of all
 * items of its sort already. Who looks for strokes that were never there looks
 * long. */
bool style_is_unseen (const Style *style, const SceneItem *item);
bool painter_has_none (const Painter *painter, const SceneItem *item);

/* Returns: the item's style as it is painted: thinner in a crowd, on the
 *          ground of space, and behind the hull. */
Style painter_style (const Painter *painter, const SceneItem *item);

/* Returns: the key of an item's strokes of a kind in the current layer. */
uint64_t
painter_key (const Painter *painter, const SceneItem *item, StrokeKind kind);

/* Adds the strokes with a key as they were before.
 *
 * Returns: false: there are none; then those that are begun next have it, and
 *          painter_note_new() is to be called after them. */
bool painter_draw_again (Painter *painter, uint64_t key);
void painter_note_new (Painter *painter);

/* What comes before @layer, after all layers, was not there any more. */
void painter_begin_layer (Painter *painter, uint32_t layer);
void painter_compare_rest (Painter *painter);

/* Begins with the styles of the drawing before, which the strokes will have.
 *
 * Returns: false: nothing can be taken from it. */
bool painter_take_styles (Painter *painter);

/* Adds the item's path, clipped, as strokes of a kind and style. */
void painter_trace (Painter *painter,
                    const SceneItem *item,
                    StrokeKind kind,
                    uint32_t style);

/* Adds the mark of an item. */
void painter_add_mark (Painter *painter, const SceneItem *item);

/* Adds what lies under the marks of a layer: of a diamond, through which a site
 * is seen, all that is inside it. */
void
painter_add_grounds (Painter *painter, const PaintOrder *order, uint32_t layer);

/* Sketches (painter-sketch.c). Adds an item as bare shapes.
 *
 * Returns: false when strokes are to be made of it. */
bool painter_sketch_polygon (Painter *painter,
                             const SceneItem *item,
                             const Style *style,
                             Colour fill);
bool painter_sketch_path (Painter *painter,
                          const SceneItem *item,
                          const Style *style);
bool painter_sketch_mark (Painter *painter,
                          const SceneItem *item,
                          const Style *style,
                          Pixel at);

/* Adds the lines of the paraboloid on the side that faces the eye, or on the
 * other one. The sheet itself lies behind the hull, both sides of it: a
 * yellow one would turn blue facets into green ones. */
void
painter_add_sheet (Painter *painter, const PaintOrder *order, bool is_near);

/* Adds names of the stock where they find room. */
void painter_add_names (Painter *painter);

/* Whether the name of an item of the stock is not where it was any more: that
 * of what is lit, one under the names of that, and one over a gap. */
bool painter_takes_name (const Scene *scene,
                         const Drawing *lit,
                         const PlacedName *placed);

/* Whether a stroke of the stock is the leader of a name. */
bool painter_is_leader (const Stroke *stroke);

/* Adds the names of @n items that are lit or pointed at, each where it covers
 * least of @stock and of the strokes so far, and the names that make way.
 * @strokes lists those of the stock; NULL: all are looked through. */
void painter_add_lit_names (Painter *painter,
                            const uint32_t *items,
                            uint32_t n,
                            const Drawing *stock,
                            BoxIndex *strokes);

#endif
