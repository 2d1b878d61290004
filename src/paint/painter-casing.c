/* What lies under lines: the casings that part them from all else. */
#include "painter-private.h"

void
painter_begin_item (Painter *painter, uint32_t item, uint32_t anchor)
{
  painter->drawing->next.item = item;
  painter->drawing->next.anchor = anchor;
}

/* Lines that run along edges, or leave a site close beside them. */
static bool
has_low_casing (const SceneItem *item)
{
  return item->role == ROLE_HORIZON || item->role == ROLE_HORIZON_UPPER
         || item->role == ROLE_CIRCLE_VISIBLE
         || item->role == ROLE_CIRCLE_UPPER;
}

/* Edges of the old triangulation, on which the horizon lies. */
static bool
is_old_edge (const SceneItem *item)
{
  return item->role == ROLE_DELAUNAY_EDGE || item->role == ROLE_VISIBLE_EDGE
         || item->role == ROLE_FREE_EDGE;
}

/* Adds the casing of a line, if it has one.
 *
 * Returns: whether it has. */
static bool
add_casing (Painter *painter, uint32_t number, uint32_t anchor)
{
  const SceneItem *item = &painter->scene->items[number];
  /* To find a style may move all of them. */
  const uint32_t style = painter_number_style (painter, item);

  if (!(painter->drawing->styles[style].casing > 0))
    return false;
  painter_begin_item (painter, number, anchor);
  if (painter_draw_again (painter, painter_key (painter, item, STROKE_CASING)))
    return true;
  painter_trace (painter, item, STROKE_CASING, style);
  painter_note_new (painter);
  return true;
}

/* An edge that leaves a corner of the horizon or a site on a circle close
 * beside it would begin in mid-air, where the casing ends: it lies under the
 * edges. */
static void
add_low_casings (Painter *painter, const PaintOrder *order, uint32_t first)
{
  const uint32_t end = order->starts[painter->drawing->next.layer + 1];
  uint32_t i;

  for (i = first; i < end; i++)
    if (has_low_casing (&painter->scene->items[order->items[i]]))
      add_casing (painter, order->items[i], order->items[first]);
}

/* The casings of a chain of lines come before all its lines, or they would cut
 * them where they meet. */
static void
add_chain (Painter *painter,
           const PaintOrder *order,
           uint32_t first,
           Casings *casings)
{
  const uint32_t end = order->starts[painter->drawing->next.layer + 1];
  uint32_t i;

  for (i = first; i < end; i++) {
    const SceneItem *item = &painter->scene->items[order->items[i]];

    if (item->shape != SHAPE_PATH)
      break;
    if (casings->has_low && has_low_casing (item))
      continue;
    if (!add_casing (painter, order->items[i], order->items[first]))
      break;
  }
  casings->end = i > first ? i : first + 1;
}

void
painter_add_casings (Painter *painter,
                     const PaintOrder *order,
                     uint32_t i,
                     Casings *casings)
{
  const SceneItem *item = &painter->scene->items[order->items[i]];

  if (!casings->has_low && is_old_edge (item)) {
    add_low_casings (painter, order, i);
    casings->has_low = true;
  }
  if (i >= casings->end)
    add_chain (painter, order, i, casings);
}
