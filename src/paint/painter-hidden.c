/* Which corners of the hull it hides itself: no facet at them faces the eye.
 * Corners are known by their place, which all facets at a lift and its mark
 * have to the last bit. They are numbered once for each scene, so that the
 * camera turns without a search. */
#include "memory.h"
#include "painter-private.h"

#include <stdlib.h>
#include <string.h>

#define FADED 0.5 /* what is paler hides nothing */

/* What is known of a corner. */
enum { CORNER_OF_HULL = 1, CORNER_SEEN = 2 };

struct HiddenCorners {
  uint64_t edition;         /* of the stock whose corners are numbered */
  uint32_t *numbers;        /* of each point of the stock, or INDEX_NONE */
  uint32_t *items, n_items; /* that have a say in which corners are seen */
  unsigned char *states;    /* of each corner, at this projection */
  uint32_t n_corners;
};

#define FEW_SPOTS 1024 /* a power of two */

/* A place and its number, while corners are numbered. */
typedef struct Spot {
  uint64_t hash; /* 0: none */
  uint32_t number;
} Spot;

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

/* What the current round is about is drawn over the hull, and so are its
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

static bool
can_hide (const SceneItem *item)
{
  return item->role == ROLE_SITE || item->role == ROLE_LIFT;
}

/* Numbers of an item's points that may be corners: of a lift its end. */
static uint32_t
first_corner (const SceneItem *item)
{
  return can_hide (item) ? item->n - 1 : 0;
}

typedef struct Spots {
  Spot *spots;
  uint32_t room, n; /* room: a power of two */
} Spots;

/* Returns: the spot of a place, or the free one that is for it. */
static Spot *
find_spot (const Spots *spots, uint64_t hash)
{
  uint32_t i = (uint32_t)(hash >> 32) & (spots->room - 1);

  while (spots->spots[i].hash != 0 && spots->spots[i].hash != hash)
    i = (i + 1) & (spots->room - 1);
  return &spots->spots[i];
}

static void
double_room (Spots *spots)
{
  const Spots old = *spots;
  uint32_t i;

  spots->room *= 2;
  spots->spots = memory_new (spots->room, sizeof *spots->spots);
  for (i = 0; i < old.room; i++)
    if (old.spots[i].hash != 0)
      *find_spot (spots, old.spots[i].hash) = old.spots[i];
  free (old.spots);
}

/* Gives a place its number, the next one when it is new. */
static uint32_t
number_place (Spots *spots, uint64_t hash)
{
  Spot *spot = find_spot (spots, hash);
  const uint32_t number = spots->n;

  if (spot->hash != 0)
    return spot->number;
  *spot = (Spot){ hash, number };
  spots->n += 1;
  if (2 * spots->n > spots->room)
    double_room (spots);
  return number;
}

static void
number_corners (HiddenCorners *hidden, const Scene *scene)
{
  Spots spots = { memory_new (FEW_SPOTS, sizeof *spots.spots), FEW_SPOTS, 0 };
  uint32_t i, k;

  for (i = 0; i < scene->stock.n_items; i++) {
    const SceneItem *item = &scene->items[i];
    const bool has_say = counts (item);

    if (!has_say && !can_hide (item))
      continue;
    if (has_say)
      hidden->items[hidden->n_items++] = i;
    for (k = item->first + first_corner (item); k < item->first + item->n; k++)
      hidden->numbers[k] = number_place (&spots, place_of (scene->points[k]));
  }
  hidden->n_corners = spots.n;
  free (spots.spots);
}

static void
begin_scene (HiddenCorners *hidden, const Scene *scene)
{
  const SceneStock *stock = &scene->stock;

  free (hidden->numbers);
  free (hidden->items);
  free (hidden->states);
  *hidden = (HiddenCorners){ .edition = stock->edition };
  hidden->numbers = memory_room (stock->n_points, sizeof *hidden->numbers);
  hidden->items = memory_room (stock->n_items, sizeof *hidden->items);
  number_corners (hidden, scene);
  hidden->states = memory_room (hidden->n_corners, sizeof *hidden->states);
}

static void
look_at (HiddenCorners *hidden, const SceneItem *item, SceneDepth depth)
{
  const bool is_seen = is_active (item) || item->fade >= FADED
                       || depth == DEPTH_HULL_NEAR || depth == DEPTH_CONE_NEAR;
  const unsigned char state = CORNER_OF_HULL | (is_seen ? CORNER_SEEN : 0);
  uint32_t i;

  for (i = 0; i < item->n; i++)
    hidden->states[hidden->numbers[item->first + i]] |= state;
}

void
painter_find_hidden (Painter *painter)
{
  const Scene *scene = painter->scene;
  Drawing *drawing = painter->drawing;
  HiddenCorners *hidden;
  uint32_t i;

  painter->hidden = NULL;
  if (!scene->is_space)
    return;
  if (drawing->hidden == NULL)
    drawing->hidden = memory_new (1, sizeof *drawing->hidden);
  hidden = drawing->hidden;
  if (hidden->edition != scene->stock.edition)
    begin_scene (hidden, scene);
  memset (hidden->states, 0, hidden->n_corners);
  for (i = 0; i < hidden->n_items; i++)
    look_at (hidden, &scene->items[hidden->items[i]],
             (SceneDepth)painter->depths[hidden->items[i]]);
  painter->hidden = hidden;
}

void
hidden_corners_free (HiddenCorners *hidden)
{
  if (hidden == NULL)
    return;
  free (hidden->numbers);
  free (hidden->items);
  free (hidden->states);
  free (hidden);
}

bool
painter_hides (const Painter *painter, const SceneItem *item)
{
  const SceneStock *stock = &painter->scene->stock;
  const HiddenCorners *hidden = painter->hidden;

  /* A lift ends at the hull, but that of a site to be. */
  return hidden != NULL && item < painter->scene->items + stock->n_items
         && can_hide (item) && item->emphasis != EMPHASIS_LOUD
         && hidden->states[hidden->numbers[item->first + item->n - 1]]
                == CORNER_OF_HULL;
}
