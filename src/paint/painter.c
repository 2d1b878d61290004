#include "painter.h"

#include "lit-drawing.h"
#include "memory.h"
#include "painter-private.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Between the sites of a crowd; where there is less room, all is smaller. Where
 * marks are larger they need more, but a person may want them so large that
 * they meet. */
#define ROOMY_PX 32.0
#define FACTOR_MOST 2.0

/* How much is seen of the square that the sites lie in: in space they are
 * lifted, and stand before each other. The same from wherever one looks, so
 * that nothing grows or goes while space is turned. */
#define PART_SEEN 0.6
#define SIZE_LEAST 0.25

/* A scene of so many items may be drawn as a sketch. With fewer of them each
 * is looked at, and they take little time. */
#define MANY_ITEMS 2000

/* Ridges behind the hull with no more ink across than this, opaque px, are left
 * out of a sketch: in a crowd that is half of all lines. */
#define FAINT 0.25

void
painter_trace (Painter *painter,
               const SceneItem *item,
               StrokeKind kind,
               uint32_t style)
{
  const Point3 *points = &painter->scene->points[item->first];
  Drawing *drawing = painter->drawing;
  Pixel at = { NAN, NAN };
  uint32_t i;

  stroke_begin (drawing, kind, style);
  for (i = 0; i + 1 < item->n; i++) {
    Pixel ends[2];

    if (!clip_segment (painter->projection, &points[i], PAINTER_MARGIN, ends))
      continue;
    if (at.x != ends[0].x || at.y != ends[0].y) {
      stroke_end (drawing);
      stroke_begin (drawing, kind, style);
      stroke_add (drawing, ends[0]);
    }
    stroke_add (drawing, ends[1]);
    at = ends[1];
  }
  stroke_end (drawing);
}

/* Gives the current stroke the corners of a polygon. */
static void
add_corners (Painter *painter, const SceneItem *item)
{
  uint32_t i, n;

  if (CLIP_ROOM (item->n) > painter->corners_room)
    painter->corners
        = memory_grow (painter->corners, &painter->corners_room,
                       CLIP_ROOM (item->n), sizeof *painter->corners);
  n = clip_polygon (painter->projection, &painter->scene->points[item->first],
                    item->n, PAINTER_MARGIN, painter->corners);

  for (i = 0; i < n; i++)
    stroke_add (painter->drawing, painter->corners[i]);
  stroke_end (painter->drawing);
}

/* Returns: the fill of a polygon: of cells their own hue, of facets as the
 *          light falls on them. */
static Colour
fill_of (const Painter *painter, const SceneItem *item, const Style *look)
{
  const Colour fill = theme_has_hue (item->role)
                          ? painter_style (painter, item).fill
                          : look->fill;

  if (look->is_shaded && painter->scene->is_space && item->pass == PASS_HULL)
    return painter_shade (painter, item, fill);
  return fill;
}

static void
add_polygon (Painter *painter, const SceneItem *item)
{
  Drawing *drawing = painter->drawing;
  const uint32_t style = painter_number_style (painter, item);
  const Style *look = &drawing->styles[style];
  Colour fill;

  if (style_is_unseen (look, item))
    return;
  fill = fill_of (painter, item, look);
  if (painter_sketch_polygon (painter, item, look, fill))
    return;
  stroke_begin (drawing, STROKE_POLYGON, style)->fill = fill;
  add_corners (painter, item);
}

static void
add_path (Painter *painter, const SceneItem *item)
{
  const uint32_t style = painter_number_style (painter, item);
  const Style *look = &painter->drawing->styles[style];
  const bool may_lack
      = painter->drawing->is_sketch && painter->depth == DEPTH_HULL_FAR;

  if (!style_is_unseen (look, item)
      && look->line.alpha > (may_lack ? FAINT / look->width : 0)
      && !painter_sketch_path (painter, item, look))
    painter_trace (painter, item, STROKE_LINE, style);
}

static void
add_item (Painter *painter, const SceneItem *item)
{
  if (painter_has_none (painter, item)
      || painter_draw_again (painter, painter_key (painter, item, STROKE_LINE)))
    return;
  if (item->shape == SHAPE_POLYGON)
    add_polygon (painter, item);
  else if (item->shape == SHAPE_PATH)
    add_path (painter, item);
  else
    painter_add_mark (painter, item);
  painter_note_new (painter);
}

/* Adds the items of a layer. */
static void
add_layer (Painter *painter, const PaintOrder *order, uint32_t layer)
{
  Casings casings = { 0, false };
  uint32_t i;

  painter->depth = paint_layer_depth (layer);
  painter->drawing->next.layer = layer;
  for (i = order->starts[layer]; i < order->starts[layer + 1]; i++) {
    const uint32_t number = order->items[i];
    const SceneItem *item = &painter->scene->items[number];

    if (item->shape == SHAPE_PATH)
      painter_add_casings (painter, order, i, &casings);
    painter_begin_item (painter, number, number);
    painter->is_behind = painter_hides (painter, item);
    add_item (painter, item);
    painter->is_behind = false;
  }
}

void
painter_add_items (Painter *painter, const uint32_t *items, uint32_t n)
{
  uint32_t layer;
  PaintOrder order;

  paint_order_init (&order, painter, items, n);
  for (layer = 0; layer < N_PAINT_LAYERS; layer++)
    add_layer (painter, &order, layer);
  paint_order_clear (&order);
}

/* Whether a facet keeps what lies behind it out of sight. Those that face the
 * eye cover all that the hull covers. */
static bool
needs_mat (const Painter *painter, const SceneItem *item)
{
  return item->pass == PASS_HULL && item->shape == SHAPE_POLYGON
         && item->fade < 1
         && (item->is_two_sided
             || scene_faces_eye (painter->scene, item, painter->projection));
}

static uint32_t
add_mat_style (Painter *painter, double fade)
{
  Colour colour = painter->theme->background;
  Style mat = { .width = 1 };

  colour.alpha *= 1 - fade;
  mat.fill = mat.line = colour;
  return drawing_add_style (painter->drawing, &mat);
}

/* Background where the hull will be, so that the sheet behind it shines
 * through no facet, but through those that a person wants to see through. */
static void
add_mat (Painter *painter)
{
  static const Style bare = { .mark = MARK_NONE };
  const Scene *scene = painter->scene;
  double fade = 1;
  uint32_t i, style = 0;

  for (i = 0; i < scene->stock.n_items; i++) {
    const SceneItem *item = &scene->items[i];

    if (!needs_mat (painter, item))
      continue;
    if (painter_draw_again (painter,
                            painter_key (painter, item, STROKE_REGION)))
      continue;
    if (fade < item->fade || fade > item->fade)
      style = add_mat_style (painter, item->fade);
    fade = item->fade;
    if (painter_sketch_polygon (painter, item, &bare,
                                painter->drawing->styles[style].fill))
      continue;
    stroke_begin (painter->drawing, STROKE_POLYGON, style);
    add_corners (painter, item);
    painter_note_new (painter);
  }
}

/* Adds what is no item's own: the paraboloid, the mat under the hull, and the
 * grounds of marks. */
static void
add_bodies (Painter *painter, const PaintOrder *order, uint32_t layer)
{
  const SceneDepth depth = paint_layer_depth (layer);

  painter->drawing->next = (StrokePlace){ INDEX_NONE, 0, layer };
  if (paint_layer_is_marks (layer)) {
    painter_add_grounds (painter, order, layer);
    return;
  }
  if (depth == DEPTH_CONE_FAR && painter->theme->has_mat)
    add_mat (painter);
  if (depth == DEPTH_SHEET_FAR || depth == DEPTH_SHEET_NEAR)
    painter_add_sheet (painter, order, depth == DEPTH_SHEET_NEAR);
}

static void
add_stock (Painter *painter)
{
  const uint32_t n_items = painter->scene->stock.n_items;
  g_autofree unsigned char *depths = g_new (unsigned char, MAX (n_items, 1));
  PaintOrder order;
  uint32_t layer;

  scene_stock_depths (painter->scene, painter->projection, depths);
  painter->depths = depths;
  painter_find_hidden (painter);
  paint_order_init (&order, painter, NULL, n_items);
  for (layer = 0; layer < N_PAINT_LAYERS; layer++) {
    const SceneDepth depth = paint_layer_depth (layer);

    painter_begin_layer (painter, layer);
    add_bodies (painter, &order, layer);
    if (depth != DEPTH_SHEET_FAR && depth != DEPTH_SHEET_NEAR)
      add_layer (painter, &order, layer);
  }
  paint_order_clear (&order);
  painter->depths = NULL;
}

double
painter_room (const Painter *painter)
{
  const double *m = painter->projection->matrix;
  const double side
      = hypot (hypot (m[0], m[4]), m[8]) * painter->projection->width;
  const uint32_t n_sites = painter->scene->stock.n_sites;
  const double part = painter->scene->is_space ? PART_SEEN : 1;

  return side * sqrt (part / MAX (n_sites, 1));
}

/* How large marks and lines may be, that one can still tell them apart where
 * so many sites share the view. */
static double
size_in_crowd (const Painter *painter)
{
  const double factor = CLAMP (painter->theme->mark_factor, 1, FACTOR_MOST);

  return CLAMP (painter_room (painter) / (ROOMY_PX * factor), SIZE_LEAST, 1);
}

static void
begin_stock (Painter *painter)
{
  Drawing *drawing = painter->drawing;

  drawing_begin (drawing, painter->projection, painter->theme, NULL);
  drawing->is_sketch = painter->is_sketch
      = painter->is_hasty && painter->scene->stock.n_items >= MANY_ITEMS;
  drawing->scale = painter->scale;
  drawing->size = size_in_crowd (painter);
  if (drawing->sorts == NULL)
    drawing->sorts = memory_new (N_PAINTER_SORTS, sizeof *drawing->sorts);
  memset (drawing->sorts, 0, N_PAINTER_SORTS * sizeof *drawing->sorts);
  painter->sorts = drawing->sorts;
  painter->lamp = painter_lamp (painter->projection);
  painter->is_plain = true;
}

/* Returns: whether strokes were taken from the drawing before. */
static bool
set_stock (Painter *painter)
{
  begin_stock (painter);
  if (!painter_take_styles (painter))
    painter->before = NULL;
  add_stock (painter);
  if (painter->scene->stock.n_labels > 0)
    painter_add_names (painter);
  painter->hidden = NULL;
  painter_compare_rest (painter);
  free (painter->corners);
  return painter->before != NULL;
}

bool
drawing_set_stock_again (Drawing *drawing,
                         const Drawing *before,
                         const Scene *scene,
                         const Projection *projection,
                         const Theme *theme,
                         Squares *changed)
{
  Painter painter = { .drawing = drawing,
                      .scene = scene,
                      .projection = projection,
                      .theme = theme,
                      .before = before,
                      .changed = changed };

  return set_stock (&painter);
}

void
drawing_set_stock (Drawing *drawing,
                   const Scene *scene,
                   const Projection *projection,
                   const Theme *theme)
{
  drawing_set_stock_again (drawing, NULL, scene, projection, theme, NULL);
}

/* Sets the stock that @painter is for, or both it and what is lit. */
static void
set (Painter *painter)
{
  Drawing *drawing = painter->drawing, *stock;
  LitDrawing *light;

  if (!scene_has_light (painter->scene)) {
    set_stock (painter);
    return;
  }
  painter->drawing = stock = drawing_new (drawing->names);
  light = lit_drawing_new (drawing->names);
  set_stock (painter);
  lit_drawing_set (light, stock, painter->scene, painter->projection, NULL);
  lit_drawing_merge (light, stock, painter->scene, NULL, stock->n_strokes,
                     drawing);
  lit_drawing_free (light);
  drawing_free (stock);
}

void
drawing_set (Drawing *drawing,
             const Scene *scene,
             const Projection *projection,
             const Theme *theme)
{
  Painter painter = {
    .drawing = drawing, .scene = scene, .projection = projection, .theme = theme
  };

  set (&painter);
}

void
drawing_set_sketch (Drawing *drawing,
                    const Scene *scene,
                    const Projection *projection,
                    const Theme *theme,
                    double scale)
{
  Painter painter = { .drawing = drawing,
                      .scene = scene,
                      .projection = projection,
                      .theme = theme,
                      .is_hasty = true,
                      .scale = scale };

  set (&painter);
}

static void
paint_background (cairo_t *cr, const Drawing *drawing)
{
  brush_colour (cr, drawing->theme->background);
  cairo_rectangle (cr, 0, 0, drawing->width, drawing->height);
  cairo_fill (cr);
}

void
painter_paint (cairo_t *cr,
               const Scene *scene,
               const Projection *projection,
               const Theme *theme,
               PainterFlags flags)
{
  Names *names = names_new ();
  Drawing *drawing = drawing_new (names);

  drawing_set (drawing, scene, projection, theme);
  cairo_save (cr);
  cairo_new_path (cr);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_antialias (cr, flags & PAINTER_FAST ? CAIRO_ANTIALIAS_NONE
                                                : CAIRO_ANTIALIAS_GOOD);
  if (!(flags & PAINTER_CLEAR))
    paint_background (cr, drawing);
  drawing_to_cairo (drawing, cr);
  cairo_restore (cr);
  drawing_free (drawing);
  names_free (names);
}
