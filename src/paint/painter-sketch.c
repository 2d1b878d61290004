/* Sketches: items that are bare shapes as they are projected, without strokes
 * in between. What is not so simple, or reaches behind the eye, stays a stroke,
 * and so does what is lit, in whose place something else will be laid. */
#include "painter-private.h"

#include <math.h>

/* What has more points stays a stroke. */
#define MOST 128

/* Farther away floats have no place for a pixel. */
#define FAR_PX 1e5

static bool
is_near (Pixel at)
{
  return fabs (at.x) < FAR_PX && fabs (at.y) < FAR_PX;
}

/* Projects all points of an item.
 *
 * Returns: false when one of them is not before the eye. */
static bool
project (const Painter *painter, const SceneItem *item, Pixel pixels[MOST])
{
  const Point3 *points = &painter->scene->points[item->first];
  uint32_t i;

  for (i = 0; i < item->n; i++)
    if (!clip_point (painter->projection, points[i], &pixels[i])
        || !is_near (pixels[i]))
      return false;
  return true;
}

static BarePlace
place_of (const Drawing *drawing)
{
  return (BarePlace){ drawing->n_strokes, drawing->next.layer };
}

static bool
may_be_bare (const Painter *painter, const SceneItem *item)
{
  return painter->is_sketch && item->n <= MOST && item->lit == LIT_NONE;
}

bool
painter_sketch_polygon (Painter *painter,
                        const SceneItem *item,
                        const Style *style,
                        Colour fill)
{
  Drawing *drawing = painter->drawing;
  Pixel corners[MOST];

  if (!may_be_bare (painter, item) || style->line.alpha > 0
      || style->halo.alpha > 0 || !project (painter, item, corners))
    return false;
  bare_polygon (&drawing->bare, place_of (drawing), corners, item->n,
                drawing->scale, fill);
  return true;
}

bool
painter_sketch_path (Painter *painter,
                     const SceneItem *item,
                     const Style *style)
{
  Drawing *drawing = painter->drawing;
  Pixel pixels[MOST];
  Colour colour;

  if (!may_be_bare (painter, item)
      || !bare_line_colour (style, drawing->scale, &colour)
      || !project (painter, item, pixels))
    return false;
  bare_path (&drawing->bare, place_of (drawing), pixels, item->n, false,
             drawing->scale, colour);
  return true;
}

bool
painter_sketch_mark (Painter *painter,
                     const SceneItem *item,
                     const Style *style,
                     Pixel at)
{
  Drawing *drawing = painter->drawing;
  const double reach = brush_mark_reach (style);
  const double radii[2] = { style->radius, style->casing > 0 ? reach : 0 };

  if (!may_be_bare (painter, item) || style->mark != MARK_DOT
      || style->halo.alpha > 0 || reach * drawing->scale > BARE_LARGEST)
    return false;
  bare_mark (&drawing->bare, place_of (drawing), at, radii, drawing->scale,
             style->line);
  return true;
}
