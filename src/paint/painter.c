#include "painter.h"

#include "painter-private.h"

#include <glib.h>
#include <math.h>

/* In space what lies in the plane is drawn thinner than in the plane view, and
 * lines behind the hull thinner and paler than those before it. */
#define GROUND_WIDTH 0.62
#define UNDER_ALPHA 0.12
#define FAR_WIDTH 0.75
#define FAR_ALPHA 0.5
#define FAR_FILL 0.45

/* Between the sites of a crowd; where there is less room, all is smaller. */
#define ROOMY_PX 38.0
#define SIZE_LEAST 0.25
#define DASH_LEAST 2.8   /* of the lifts */
#define LEAST_RADIUS 1.3 /* of a mark; what is smaller is left out */

/* Shade of a facet seen edge-on; face-on it is 1. */
#define SHADE_LEAST 0.78

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

static void
scale_style (Style *style, double size)
{
  style->width *= size;
  style->casing *= size;
  style->dash *= size;
  style->gap *= size;
}

static void
adapt_to_depth (const Painter *painter, const SceneItem *item, Style *style)
{
  const SceneDepth depth = painter->depths[item - painter->scene->items];

  if (!painter->scene->is_space)
    return;
  if (depth == DEPTH_GROUND || depth == DEPTH_UNDER) {
    scale_style (style, GROUND_WIDTH);
    if (item->object.kind == OBJECT_VERTEX)
      style->radius *= GROUND_WIDTH;
    /* Seen from below the plane is glass: the hull is what one looks at. */
    if (depth == DEPTH_UNDER && item->shape == SHAPE_POLYGON) {
      style->fill.alpha *= UNDER_ALPHA;
      style->hatch = HATCH_NONE;
    }
  }
  if (depth != DEPTH_HULL_FAR && depth != DEPTH_CONE_FAR)
    return;
  if (item->shape == SHAPE_PATH) {
    style->width *= FAR_WIDTH;
    style->line.alpha *= FAR_ALPHA;
    style->casing = 0;
  } else if (item->emphasis != EMPHASIS_LOUD) {
    style->fill.alpha *= painter->theme->has_mat ? 0 : FAR_FILL;
    style->line.alpha *= FAR_FILL;
  }
}

/* The active set stays larger than the crowd. */
static void
adapt_to_crowd (const Painter *painter, const SceneItem *item, Style *style)
{
  const bool is_loud = item->emphasis == EMPHASIS_LOUD || item->lit != LIT_NONE;
  const double size = is_loud ? sqrt (painter->size) : painter->size;

  scale_style (style, size);
  style->radius *= size;
  if (item->role != ROLE_LIFT || is_loud)
    return;
  style->line.alpha *= size * size;
  /* So many dashes, so short, are a paler line. */
  if (style->dash < DASH_LEAST && style->dash > 0) {
    style->line.alpha *= style->dash / (style->dash + style->gap);
    style->dash = style->gap = 0;
  }
}

Style
painter_style (const Painter *painter, const SceneItem *item)
{
  Style style = theme_style (painter->theme, item);

  if (painter->size < 1)
    adapt_to_crowd (painter, item, &style);
  adapt_to_depth (painter, item, &style);
  return style;
}

/* Items of one sort share a style, but for the hue of a cell.
 *
 * Returns: the number of the style. */
static uint32_t
style_of (Painter *painter, const SceneItem *item)
{
  const uint32_t index = (uint32_t)(item - painter->scene->items);
  uint32_t sort = (uint32_t)item->role;
  PainterSort *known;

  sort = (3 * sort + (uint32_t)item->emphasis) * 3 + (uint32_t)item->lit;
  sort = 3 * sort + (uint32_t)item->shape;
  sort = N_SCENE_DEPTHS * sort + painter->depths[index];
  sort = 2 * sort + (item->object.kind == OBJECT_VERTEX);
  known = &painter->sorts[sort];
  if (known->style == 0 || known->fade < item->fade
      || known->fade > item->fade) {
    const Style style = painter_style (painter, item);

    known->style = 1 + drawing_add_style (painter->drawing, &style);
    known->fade = item->fade;
  }
  return known->style - 1;
}

static Point3
normal_of (const Point3 *points)
{
  const Point3 a = points[0], b = points[1], c = points[2];
  const Point3 d = { b.x - a.x, b.y - a.y, b.z - a.z };
  const Point3 e = { c.x - a.x, c.y - a.y, c.z - a.z };
  const Point3 normal
      = { d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z, d.x * e.y - d.y * e.x };
  const double length
      = sqrt (normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);

  return (Point3){ normal.x / length, normal.y / length, normal.z / length };
}

/* Light comes from the eye, a little from the upper left. */
static Point3
light_at (const Painter *painter, Point3 point)
{
  const double *m = painter->projection->matrix;
  Point3 light = projection_to_eye (painter->projection, point);
  const double right = hypot (m[0], hypot (m[4], m[8]));
  const double up = hypot (m[1], hypot (m[5], m[9]));
  double length;

  light.x += 0.45 * m[1] / up - 0.35 * m[0] / right;
  light.y += 0.45 * m[5] / up - 0.35 * m[4] / right;
  light.z += 0.45 * m[9] / up - 0.35 * m[8] / right;
  length = sqrt (light.x * light.x + light.y * light.y + light.z * light.z);
  return (Point3){ light.x / length, light.y / length, light.z / length };
}

static Colour
shaded (const Painter *painter, const SceneItem *item, Colour fill)
{
  const Point3 *points = &painter->scene->points[item->first];
  const Point3 normal = normal_of (points);
  const Point3 light = light_at (painter, points[0]);
  const double cosine
      = fabs (normal.x * light.x + normal.y * light.y + normal.z * light.z);
  const Colour black = { 0, 0, 0, 1 };

  if (!isfinite (cosine))
    return fill;
  return colour_mix (fill, black, (1 - SHADE_LEAST) * (1 - cosine));
}

/* Gives the stroke in hand the corners of a polygon. */
static void
add_corners (Painter *painter, const SceneItem *item)
{
  const uint32_t n
      = clip_polygon (painter->projection, &painter->scene->points[item->first],
                      item->n, PAINTER_MARGIN, painter->corners);
  uint32_t i;

  for (i = 0; i < n; i++)
    stroke_add (painter->drawing, painter->corners[i]);
  stroke_end (painter->drawing);
}

static void
add_polygon (Painter *painter, const SceneItem *item)
{
  Drawing *drawing = painter->drawing;
  const uint32_t style = style_of (painter, item);
  const Style *look = &drawing->styles[style];
  Stroke *stroke;

  if (look->fill.alpha <= 0 && look->line.alpha <= 0 && look->halo.alpha <= 0)
    return;
  stroke = stroke_begin (drawing, STROKE_POLYGON, style);
  if (theme_has_hue (item->role))
    stroke->fill = painter_style (painter, item).fill;
  if (look->is_shaded && painter->scene->is_space && item->pass == PASS_HULL)
    stroke->fill = shaded (painter, item, stroke->fill);
  add_corners (painter, item);
}

/* The casings of a chain of lines of one depth come before all its lines, or
 * they would cut them where they meet.
 *
 * Returns: the item after the chain that begins at @first. */
static uint32_t
add_casings (Painter *painter, uint32_t first)
{
  const Scene *scene = painter->scene;
  uint32_t i;

  for (i = first; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];
    uint32_t style;

    if (item->shape != SHAPE_PATH)
      break;
    if (painter->depths[i] != painter->depths[first])
      continue;
    /* To find a style may move all of them. */
    style = style_of (painter, item);
    if (!(painter->drawing->styles[style].casing > 0))
      break;
    painter_trace (painter, item, STROKE_CASING, style);
  }
  return i;
}

static void
add_path (Painter *painter, const SceneItem *item)
{
  const uint32_t style = style_of (painter, item);

  if (painter->drawing->styles[style].line.alpha > 0)
    painter_trace (painter, item, STROKE_LINE, style);
}

static void
add_mark (Painter *painter, const SceneItem *item)
{
  const uint32_t style = style_of (painter, item);
  const Style *look = &painter->drawing->styles[style];
  Pixel at;

  if (look->mark == MARK_NONE || item->fade >= 1 || look->radius < LEAST_RADIUS
      || !clip_point (painter->projection, painter->scene->points[item->first],
                      &at)
      || at.x < -PAINTER_MARGIN || at.y < -PAINTER_MARGIN
      || at.x > painter->projection->width + PAINTER_MARGIN
      || at.y > painter->projection->height + PAINTER_MARGIN)
    return;
  stroke_begin (painter->drawing, STROKE_MARK, style);
  stroke_add (painter->drawing, at);
  stroke_end (painter->drawing);
}

static void
add_depth (Painter *painter, SceneDepth depth)
{
  const Scene *scene = painter->scene;
  uint32_t i, cased = 0;

  for (i = 0; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];

    if (painter->depths[i] != (unsigned char)depth)
      continue;
    switch (item->shape) {
    case SHAPE_POLYGON:
      add_polygon (painter, item);
      break;
    case SHAPE_PATH:
      if (i >= cased)
        cased = MAX (add_casings (painter, i), i + 1);
      add_path (painter, item);
      break;
    case SHAPE_MARK:
      add_mark (painter, item);
      break;
    }
  }
}

/* Background where the hull will be, so that the sheet behind it shines
 * through no facet. */
static void
add_mat (Painter *painter)
{
  const Colour background = painter->theme->background;
  const Style mat = { .fill = background, .line = background, .width = 1 };
  const uint32_t style = drawing_add_style (painter->drawing, &mat);
  const Scene *scene = painter->scene;
  uint32_t i;

  for (i = 0; i < scene->n_items; i++) {
    if (scene->items[i].pass != PASS_HULL
        || scene->items[i].shape != SHAPE_POLYGON)
      continue;
    stroke_begin (painter->drawing, STROKE_POLYGON, style);
    add_corners (painter, &scene->items[i]);
  }
}

/* How large marks and lines may be, that one can still tell them apart where
 * @n_sites share the view. */
static double
size_in_crowd (const Painter *painter, uint32_t n_sites)
{
  const double area = painter->projection->width * painter->projection->height;
  const double spacing = sqrt (area / MAX (n_sites, 1));

  return CLAMP (spacing / ROOMY_PX, SIZE_LEAST, 1);
}

static void
painter_init (Painter *painter)
{
  const Scene *scene = painter->scene;
  uint32_t i, n_corners = 0, n_sites = 0;

  painter->depths = g_new (unsigned char, MAX (scene->n_items, 1));
  for (i = 0; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];

    painter->depths[i]
        = (unsigned char)scene_depth (scene, item, painter->projection);
    if (item->shape == SHAPE_POLYGON)
      n_corners = MAX (n_corners, item->n);
    if (item->shape == SHAPE_MARK && item->role >= ROLE_SITE)
      n_sites++;
  }
  painter->size = size_in_crowd (painter, n_sites);
  painter->corners = g_new (Pixel, CLIP_ROOM (n_corners));
  painter->sorts = g_new0 (PainterSort, N_PAINTER_SORTS);
}

static void
painter_clear (Painter *painter)
{
  g_free (painter->depths);
  g_free (painter->corners);
  g_free (painter->sorts);
}

static void
drawing_begin (Drawing *drawing,
               const Projection *projection,
               const Theme *theme)
{
  drawing->n_strokes = drawing->n_pixels = 0;
  drawing->n_styles = drawing->n_placed = 0;
  drawing->theme = theme;
  drawing->width = projection->width;
  drawing->height = projection->height;
  drawing->edition = names_begin (drawing->names, theme);
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
  int depth;

  drawing_begin (drawing, projection, theme);
  painter_init (&painter);
  for (depth = 0; depth < N_SCENE_DEPTHS; depth++) {
    if (depth == DEPTH_CONE_FAR && theme->has_mat)
      add_mat (&painter);
    if (depth == DEPTH_SHEET_FAR || depth == DEPTH_SHEET_NEAR)
      painter_add_sheet (&painter, depth == DEPTH_SHEET_NEAR);
    else
      add_depth (&painter, (SceneDepth)depth);
  }
  if (scene->n_labels > 0)
    painter_add_names (&painter);
  painter_clear (&painter);
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
                                                : CAIRO_ANTIALIAS_FAST);
  if (!(flags & PAINTER_CLEAR))
    paint_background (cr, drawing);
  drawing_to_cairo (drawing, cr);
  cairo_restore (cr);
  drawing_free (drawing);
  names_free (names);
}
