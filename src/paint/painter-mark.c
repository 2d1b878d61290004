/* Marks: as strokes of one pixel, that of their middle; rings of dashes as
 * lines round it. What a site shines through has a ground under all sites, so
 * that no line does. */
#include "painter-private.h"

#include <math.h>

/* Sides of a ring of dashes: none is seen as one. */
#define N_SIDES 40

static bool
find_middle (const Painter *painter, const SceneItem *item, Pixel *at)
{
  const Projection *projection = painter->projection;

  return clip_point (projection, painter->scene->points[item->first], at)
         && at->x >= -PAINTER_MARGIN && at->y >= -PAINTER_MARGIN
         && at->x <= projection->width + PAINTER_MARGIN
         && at->y <= projection->height + PAINTER_MARGIN;
}

static void
add_ring (Painter *painter, StrokeKind kind, uint32_t style, Pixel middle)
{
  Drawing *drawing = painter->drawing;
  const double radius = drawing->styles[style].radius;
  uint32_t i;

  stroke_begin (drawing, kind, style);
  for (i = 0; i <= N_SIDES; i++) {
    const double angle = 2 * M_PI * (i % N_SIDES) / N_SIDES;

    stroke_add (drawing, (Pixel){ middle.x + radius * cos (angle),
                                  middle.y + radius * sin (angle) });
  }
  stroke_end (drawing);
}

void
painter_add_mark (Painter *painter, const SceneItem *item)
{
  const uint32_t style = painter_number_style (painter, item);
  const Style *look = &painter->drawing->styles[style];
  Pixel at;

  if (style_is_unseen (look, item) || !find_middle (painter, item, &at)
      || painter_sketch_mark (painter, item, look, at))
    return;
  if (look->mark == MARK_HOLLOW && look->dash > 0) {
    if (look->casing > 0)
      add_ring (painter, STROKE_CASING, style, at);
    add_ring (painter, STROKE_LINE, style, at);
    return;
  }
  stroke_begin (painter->drawing, STROKE_MARK, style);
  stroke_add (painter->drawing, at);
  stroke_end (painter->drawing);
}

static uint32_t
add_ground_style (Painter *painter, const SceneItem *item)
{
  Style ground = painter_style (painter, item);

  ground.fill.alpha = 1 - item->fade;
  ground.line = ground.fill;
  ground.width = ground.casing = 0;
  return drawing_add_style (painter->drawing, &ground);
}

void
painter_add_grounds (Painter *painter, const PaintOrder *order, uint32_t layer)
{
  uint32_t i, style = INDEX_NONE;
  double fade = 0;
  Pixel at;

  painter->depth = paint_layer_depth (layer);
  for (i = order->starts[layer]; i < order->starts[layer + 1]; i++) {
    const SceneItem *item = &painter->scene->items[order->items[i]];

    if (item->role != ROLE_VORONOI_VERTEX_DYING
        || painter_has_none (painter, item)
        || painter_draw_again (painter,
                               painter_key (painter, item, STROKE_REGION)))
      continue;
    if (style == INDEX_NONE || fade < item->fade || fade > item->fade)
      style = add_ground_style (painter, item);
    fade = item->fade;
    if (style_is_unseen (&painter->drawing->styles[style], item)
        || !find_middle (painter, item, &at))
      continue;
    stroke_begin (painter->drawing, STROKE_MARK, style);
    stroke_add (painter->drawing, at);
    stroke_end (painter->drawing);
    painter_note_new (painter);
  }
}
