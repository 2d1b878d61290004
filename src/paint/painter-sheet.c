/* The paraboloid. It bounds a convex set, so its picture is the convex hull
 * of its rings; the eye sees its inside through the rim and its outside
 * everywhere else, or the other way round from above the rim. */
#include "painter-private.h"

#include <glib.h>
#include <stdlib.h>

/* Rings that make the outline smooth; the scene's own are a few lines. */
#define N_RINGS 24

#define SHEET_LAYER (2 * DEPTH_SHEET_FAR) /* where its own lines are listed */

static bool
is_sheet (const SceneItem *item)
{
  return item->role == ROLE_SHEET || item->role == ROLE_RIM;
}

/* Whether the outside of the paraboloid faces the eye at @point. */
static bool
is_outside_seen (const Projection *projection, Point3 point)
{
  const Point3 eye = projection_to_eye (projection, point);

  return 2 * point.x * eye.x + 2 * point.y * eye.y - eye.z > 0;
}

/* Traces what of a line lies on the wanted side. */
static void
trace_side (Painter *painter,
            const SceneItem *item,
            uint32_t style,
            bool is_near)
{
  const Point3 *points = &painter->scene->points[item->first];
  uint32_t first, last;

  for (first = 0; first + 1 < item->n; first = last) {
    SceneItem part = *item;

    last = first + 1;
    if (is_outside_seen (painter->projection, points[first]) != is_near)
      continue;
    while (last + 1 < item->n
           && is_outside_seen (painter->projection, points[last]) == is_near)
      last++;
    part.first = item->first + first;
    part.n = last - first + 1;
    if (!painter_sketch_path (painter, &part, &painter->drawing->styles[style]))
      painter_trace (painter, &part, STROKE_LINE, style);
  }
}

static int
compare_pixels (const void *a, const void *b)
{
  const Pixel *p = a, *q = b;

  if (p->x != q->x)
    return p->x < q->x ? -1 : 1;
  return (p->y > q->y) - (p->y < q->y);
}

static double
turn (Pixel a, Pixel b, Pixel c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* One chain of the convex hull, from the first pixel to the last, appended to
 * @hull from @start. */
static guint
add_chain (const Pixel *pixels, guint n, int step, Pixel *hull, guint start)
{
  const Pixel *pixel = step > 0 ? pixels : pixels + n - 1;
  guint i, n_hull = start;

  for (i = 0; i < n; i++, pixel += step) {
    while (n_hull >= start + 2
           && turn (hull[n_hull - 2], hull[n_hull - 1], *pixel) <= 0)
      n_hull--;
    hull[n_hull++] = *pixel;
  }
  return n_hull - 1;
}

/* Source: Andrew 1979, monotone chain.
 *
 * Returns: the corners of the convex hull in a new array. */
static GArray *
hull_of (GArray *pixels)
{
  GArray *hull = g_array_new (FALSE, FALSE, sizeof (Pixel));
  guint n;

  g_array_sort (pixels, compare_pixels);
  g_array_set_size (hull, 2 * pixels->len);
  n = add_chain ((Pixel *)pixels->data, pixels->len, 1, (Pixel *)hull->data, 0);
  n = add_chain ((Pixel *)pixels->data, pixels->len, -1, (Pixel *)hull->data,
                 n);
  g_array_set_size (hull, n);
  return hull;
}

/* The rim tells which part of which paraboloid it is. */
static const SceneItem *
find_rim (const Scene *scene, const PaintOrder *order)
{
  uint32_t i;

  for (i = order->starts[SHEET_LAYER]; i < order->starts[SHEET_LAYER + 1]; i++)
    if (scene->items[order->items[i]].role == ROLE_RIM)
      return &scene->items[order->items[i]];
  return NULL;
}

/* Adds the pixels of the rim, shrunk to @part of its radius. */
static void
add_ring (const Painter *painter,
          const SceneItem *rim,
          double part,
          GArray *pixels)
{
  uint32_t i;

  for (i = 0; i + 1 < rim->n; i++) {
    Point3 point = painter->scene->points[rim->first + i];
    const double squared = point.x * point.x + point.y * point.y;
    Pixel pixel;

    point.x *= part;
    point.y *= part;
    point.z -= (1 - part * part) * squared;
    if (clip_point (painter->projection, point, &pixel))
      g_array_append_val (pixels, pixel);
  }
}

/* Returns: pixels all over the paraboloid, or of its rim alone. */
static GArray *
pixels_of (const Painter *painter, const SceneItem *rim, int n_rings)
{
  GArray *pixels = g_array_new (FALSE, FALSE, sizeof (Pixel));
  int i;

  for (i = 0; i < n_rings; i++)
    add_ring (painter, rim, 1 - (double)i / n_rings, pixels);
  return pixels;
}

/* Adds the convex hull of @pixels, cut to the view, to the current stroke. */
static void
add_hull (Painter *painter, GArray *pixels)
{
  const Pixel low = { -PAINTER_MARGIN, -PAINTER_MARGIN };
  const Pixel high = { painter->projection->width + PAINTER_MARGIN,
                       painter->projection->height + PAINTER_MARGIN };
  g_autoptr (GArray) hull = NULL;
  uint32_t i, n, n_corners;
  Pixel *corners;

  if (pixels->len < 3)
    return;
  hull = hull_of (pixels);
  n = hull->len;
  g_array_set_size (hull, n + 4);
  corners = (Pixel *)hull->data;
  n_corners = clip_polygon_to_rectangle (low, high, corners, n);
  for (i = 0; i < n_corners; i++)
    stroke_add (painter->drawing, corners[i]);
}

/* Whether the eye looks into the paraboloid through its rim. */
static bool
looks_into (const Painter *painter, const SceneItem *rim)
{
  const Projection *projection = painter->projection;

  if (projection->is_parallel)
    return projection->eye.z > 0;
  return projection->eye.z > painter->scene->points[rim->first].z;
}

/* Returns: the corners of the picture of all of the paraboloid. */
static GArray *
outline_of (const Painter *painter, const SceneItem *rim)
{
  GArray *pixels = pixels_of (painter, rim, N_RINGS);
  GArray *hull;

  if (pixels->len < 3)
    return pixels;
  hull = hull_of (pixels);
  g_array_unref (pixels);
  return hull;
}

static void
fill_part (Painter *painter, GArray *outer, GArray *inner, double alpha)
{
  Style style = painter->theme->styles[ROLE_SHEET];
  Stroke *stroke;

  style.fill.alpha = alpha;
  stroke = stroke_begin (painter->drawing, STROKE_REGION,
                         drawing_add_style (painter->drawing, &style));
  add_hull (painter, outer);
  stroke->n_outer = stroke->n;
  if (inner != NULL)
    add_hull (painter, inner);
  stroke_end (painter->drawing);
}

/* Through the rim one side is seen, and the other one everywhere else. A sketch
 * fills no pixel twice. */
static void
fill_sides (Painter *painter, const SceneItem *rim, GArray *all)
{
  g_autoptr (GArray) opening = pixels_of (painter, rim, 1);
  const double alpha
      = painter->theme->styles[ROLE_SHEET].fill.alpha * (1 - rim->fade);

  if (painter->is_sketch) {
    fill_part (painter, all, opening, alpha * (2 - alpha));
    fill_part (painter, opening, NULL, alpha);
  } else if (looks_into (painter, rim)) {
    fill_part (painter, all, NULL, alpha);
    fill_part (painter, all, opening, alpha);
  } else {
    fill_part (painter, all, opening, alpha);
    fill_part (painter, all, NULL, alpha);
  }
}

/* Where the sheet turns from one side to the other. */
static void
add_outline (Painter *painter, const SceneItem *rim, GArray *all)
{
  Style style = theme_style (painter->theme, rim);

  style.line.alpha *= 0.75 * (1 - rim->fade);
  stroke_begin (painter->drawing, STROKE_RING,
                drawing_add_style (painter->drawing, &style));
  add_hull (painter, all);
  stroke_end (painter->drawing);
}

/* The whole follows from its lines. */
static uint64_t
key_of (const Painter *painter, const PaintOrder *order)
{
  const Scene *scene = painter->scene;
  uint64_t key = 0;
  uint32_t i;

  for (i = order->starts[SHEET_LAYER]; i < order->starts[SHEET_LAYER + 1]; i++)
    key = (key << 7 | key >> 57)
          ^ painter_key (painter, &scene->items[order->items[i]], STROKE_RING);
  return key;
}

static void
add_lines (Painter *painter, const PaintOrder *order, bool is_near)
{
  const Scene *scene = painter->scene;
  uint32_t i;

  for (i = order->starts[SHEET_LAYER]; i < order->starts[SHEET_LAYER + 1];
       i++) {
    const SceneItem *item = &scene->items[order->items[i]];
    Style style;

    if (!is_sheet (item))
      continue;
    style = theme_style (painter->theme, item);
    trace_side (painter, item, drawing_add_style (painter->drawing, &style),
                is_near);
  }
}

void
painter_add_sheet (Painter *painter, const PaintOrder *order, bool is_near)
{
  const SceneItem *rim = find_rim (painter->scene, order);

  if (rim == NULL || painter_draw_again (painter, key_of (painter, order)))
    return;
  if (!is_near) {
    g_autoptr (GArray) all = outline_of (painter, rim);

    fill_sides (painter, rim, all);
    add_outline (painter, rim, all);
  }
  add_lines (painter, order, is_near);
  painter_note_new (painter);
}
