/* The order of paint: by depth, in each first surfaces and lines, then marks,
 * and among these as the scene lists them. */
#include "painter-private.h"

#include <glib.h>
#include <string.h>

/* Marks of what is hidden come before those of all that is not. */
static uint32_t
layer_of (const Painter *painter, const SceneItem *item, uint32_t depth)
{
  if (item->shape != SHAPE_MARK)
    return 2 * depth;
  return 2 * (painter_hides (painter, item) ? DEPTH_LINES : depth) + 1;
}

static void
find_depths (const Painter *painter,
             const uint32_t *items,
             uint32_t n,
             unsigned char *depths)
{
  const Scene *scene = painter->scene;
  uint32_t i;

  if (items == NULL) {
    if (n > 0) /* else there may be none to copy */
      memcpy (depths, painter->depths, n);
    return;
  }
  for (i = 0; i < n; i++)
    depths[i] = (unsigned char)scene_depth (scene, &scene->items[items[i]],
                                            painter->projection);
}

static void
sum_up (PaintOrder *order)
{
  uint32_t layer, n, sum = 0;

  for (layer = 0; layer <= N_PAINT_LAYERS; layer++) {
    n = order->starts[layer];
    order->starts[layer] = sum;
    sum += n;
  }
}

void
paint_order_init (PaintOrder *order,
                  const Painter *painter,
                  const uint32_t *items,
                  uint32_t n)
{
  g_autofree unsigned char *layers = g_new (unsigned char, MAX (n, 1));
  uint32_t next[N_PAINT_LAYERS];
  uint32_t i;

  *order = (PaintOrder){ .items = g_new (uint32_t, MAX (n, 1)) };
  find_depths (painter, items, n, layers);
  for (i = 0; i < n; i++) {
    const uint32_t item = items == NULL ? i : items[i];

    layers[i] = (unsigned char)layer_of (painter, &painter->scene->items[item],
                                         layers[i]);
    order->starts[layers[i]] += 1;
  }
  sum_up (order);
  for (i = 0; i < N_PAINT_LAYERS; i++)
    next[i] = order->starts[i];
  for (i = 0; i < n; i++)
    order->items[next[layers[i]]++] = items == NULL ? i : items[i];
}

void
paint_order_clear (PaintOrder *order)
{
  g_free (order->items);
}
