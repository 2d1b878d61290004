/* Which corners of the hull it hides itself: no facet at them faces the eye.
 * Corners are known by their place, which all facets at a lift and its mark
 * have to the last bit. */
#include "memory.h"
#include "painter-private.h"

#include <stdlib.h>
#include <string.h>

#define FADED 0.5 /* what is paler hides nothing */

typedef struct Corner {
  uint64_t place; /* 0: none */
  bool is_seen;
} Corner;

struct HiddenCorners {
  Corner *corners; /* mask + 1 of them */
  uint32_t mask;
};

static uint64_t
stir (uint64_t sum, double number)
{
  uint64_t bits;

  memcpy (&bits, &number, sizeof bits);
  sum = (sum ^ bits) * 0x9fb21c651e98df25U;
  return sum ^ sum >> 32;
}

/* Two places are the same number by chance as rarely as two keys of strokes. */
static uint64_t
place_of (Point3 point)
{
  return stir (stir (stir (1, point.x), point.y), point.z) | 1;
}

/* Returns: the corner there, or where it would be. */
static Corner *
corner_at (const HiddenCorners *hidden, uint64_t place)
{
  uint32_t i = (uint32_t)(place >> 32) & hidden->mask;

  while (hidden->corners[i].place != 0 && hidden->corners[i].place != place)
    i = (i + 1) & hidden->mask;
  return &hidden->corners[i];
}

/* What the round in hand is about is drawn over the hull, and so are its
 * corners: horizon, cone, facet f. */
static bool
is_active (const SceneItem *item)
{
  if (item->shape == SHAPE_PATH)
    return item->pass == PASS_LINES
           && (item->role < ROLE_LIFT || item->role > ROLE_DROP);
  return item->pass == PASS_HULL
         && (item->role == ROLE_VISIBLE || item->role == ROLE_VISIBLE_UPPER
             || item->role == ROLE_CONE || item->role == ROLE_CONE_UPPER);
}

static bool
is_facet (const SceneItem *item)
{
  return item->pass == PASS_HULL && item->shape == SHAPE_POLYGON
         && item->role >= ROLE_FACET && item->role <= ROLE_VERTICAL;
}

/* Whether an item has a say in which corners are seen. */
static bool
counts (const SceneItem *item)
{
  return (is_facet (item) || is_active (item)) && item->fade < 1;
}

static void
add_item (HiddenCorners *hidden, const Painter *painter, const SceneItem *item)
{
  const bool is_seen
      = is_active (item) || item->is_two_sided || item->fade >= FADED
        || scene_faces_eye (painter->scene, item, painter->projection);
  uint32_t i;

  for (i = 0; i < item->n; i++) {
    const uint64_t place = place_of (painter->scene->points[item->first + i]);
    Corner *corner = corner_at (hidden, place);

    corner->place = place;
    corner->is_seen |= is_seen;
  }
}

HiddenCorners *
hidden_corners_new (const Painter *painter)
{
  const Scene *scene = painter->scene;
  HiddenCorners *hidden;
  uint32_t i, n = 0, room = 16;

  if (!scene->is_space)
    return NULL;
  for (i = 0; i < scene->stock.n_items; i++)
    n += counts (&scene->items[i]) ? scene->items[i].n : 0;
  while (room < 2 * (n + 1))
    room *= 2;
  hidden = memory_new (1, sizeof *hidden);
  hidden->corners = memory_new (room, sizeof *hidden->corners);
  hidden->mask = room - 1;
  for (i = 0; i < scene->stock.n_items; i++)
    if (counts (&scene->items[i]))
      add_item (hidden, painter, &scene->items[i]);
  return hidden;
}

void
hidden_corners_free (HiddenCorners *hidden)
{
  if (hidden != NULL)
    free (hidden->corners);
  free (hidden);
}

static bool
is_hidden_at (const HiddenCorners *hidden, Point3 point)
{
  const Corner *corner = corner_at (hidden, place_of (point));

  return corner->place != 0 && !corner->is_seen;
}

bool
painter_hides (const Painter *painter, const SceneItem *item)
{
  const bool can_hide = item->role == ROLE_SITE || item->role == ROLE_LIFT;

  /* A lift ends at the hull. */
  return can_hide && painter->hidden != NULL && item->emphasis != EMPHASIS_LOUD
         && is_hidden_at (painter->hidden,
                          painter->scene->points[item->first + item->n - 1]);
}
