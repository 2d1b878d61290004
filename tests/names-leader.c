#include "names-judge.h"

#include <math.h>

/* Dots whose middles are nearer to each other than this part of the sum of
 * their radii lie over each other. */
#define OVERLAPPED 1.2

/* From dots to where the name of a facet begins, px. */
#define FROM_DOT 8.0

/* Px between leaders, from them to other dots, and from their names to these.
 */
#define LEADERS_APART 4.0
#define LEADER_TO_DOT 1.0
#define LED_TO_DOT 4.0

static gboolean
is_leader (const Shown *shown, const Stroke *stroke)
{
  return stroke->kind == STROKE_LINE && stroke->n == 2
         && stroke->place.item != INDEX_NONE
         && shown->scene.items[stroke->place.item].shape == SHAPE_MARK;
}

static double
distance_of_lines (const Pixel a[2], const Pixel b[2])
{
  double least = names_is_crossed (a[0], a[1], b[0], b[1])
                     ? 0
                     : names_distance_from_line (a[0], b[0], b[1]);

  for (int i = 0; i < 2; i++) {
    least = MIN (least, names_distance_from_line (a[i], b[0], b[1]));
    least = MIN (least, names_distance_from_line (b[i], a[0], a[1]));
  }
  return least;
}

/* The letters of the name of an item; nowhere when it has none. */
static PixelBox
letters_of_item (const Shown *shown, uint32_t item)
{
  for (uint32_t i = 0; i < shown->drawing->n_placed; i++)
    if (shown->drawing->placed[i].item == item)
      return names_letters_of (&shown->drawing->placed[i]);
  return (PixelBox){ 0, 0, 0, 0 };
}

/* Against the dots of all other sites. */
static const char *
fault_at_dots (const Shown *shown, const Stroke *leader)
{
  const Drawing *drawing = shown->drawing;
  const SceneItem *own = &shown->scene.items[leader->place.item];
  const Pixel *ends = &drawing->pixels[leader->first];
  const Pixel at = names_pixel_of (shown, own);
  const double own_radius = names_radius_at (drawing, at);
  const PixelBox letters = letters_of_item (shown, leader->place.item);

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Pixel middle = drawing->pixels[stroke->first];
    const double radius = drawing->styles[stroke->style].radius;

    if (stroke->kind != STROKE_MARK || stroke->place.item == INDEX_NONE
        || !names_is_of_site (&shown->scene.items[stroke->place.item])
        || hypot (middle.x - at.x, middle.y - at.y)
               < OVERLAPPED * (radius + own_radius))
      continue;
    if (names_distance_from_line (middle, ends[0], ends[1])
        < radius + LEADER_TO_DOT)
      return "has a leader that touches another dot";
    if (names_distance_to (&letters, middle) < radius + LED_TO_DOT)
      return "has a leader, and stands beside another dot";
  }
  return hypot (ends[0].x - at.x, ends[0].y - at.y) > own_radius + LEADER_BEGINS
             ? "has a leader that ends before its dot"
             : NULL;
}

static const char *
fault_at_leaders (const Shown *shown, uint32_t number)
{
  const Drawing *drawing = shown->drawing;
  const Pixel *ends = &drawing->pixels[drawing->strokes[number].first];

  for (uint32_t i = 0; i < number; i++) {
    const Stroke *stroke = &drawing->strokes[i];

    if (is_leader (shown, stroke)
        && distance_of_lines (ends, &drawing->pixels[stroke->first])
               < LEADERS_APART)
      return "has a leader that meets another one";
  }
  return NULL;
}

guint
names_judge_leaders (const Shown *shown, const char *what)
{
  const Drawing *drawing = shown->drawing;
  guint n_leaders = 0;

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const char *fault;

    if (!is_leader (shown, stroke))
      continue;
    fault = fault_at_leaders (shown, i);
    if (fault == NULL
        && names_is_of_site (&shown->scene.items[stroke->place.item]))
      fault = fault_at_dots (shown, stroke);
    if (fault != NULL)
      g_error ("%s: %s %s", what, shown->scene.items[stroke->place.item].label,
               fault);
    n_leaders++;
  }
  return n_leaders;
}

static gboolean
has_name (const Shown *shown, uint32_t item)
{
  for (uint32_t i = 0; i < shown->drawing->n_placed; i++)
    if (shown->drawing->placed[i].item == item)
      return TRUE;
  return FALSE;
}

guint
names_judge_middles (const Shown *shown)
{
  guint n_middles = 0;

  for (uint32_t i = 0; i < shown->scene.n_items; i++) {
    const SceneItem *facet = &shown->scene.items[i];

    if (facet->role != ROLE_FACET_NAME)
      continue;
    n_middles++;
    for (uint32_t k = 0; k < shown->scene.n_items; k++) {
      const SceneItem *site = &shown->scene.items[k];
      const Pixel middle = names_pixel_of (shown, facet);
      const Pixel at = names_pixel_of (shown, site);

      if (site->shape == SHAPE_MARK && names_is_of_site (site)
          && hypot (middle.x - at.x, middle.y - at.y)
                 < names_radius_at (shown->drawing, at) + FROM_DOT)
        g_error ("%s begins at the dot of %s", facet->label, site->label);
    }
  }
  return n_middles;
}

/* Whether dots lie over each other: no name tells which is meant. */
static gboolean
is_overlapped (const Shown *shown, Pixel at)
{
  const Drawing *drawing = shown->drawing;
  const double radius = names_radius_at (drawing, at);

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Pixel middle = drawing->pixels[stroke->first];
    const double apart = hypot (middle.x - at.x, middle.y - at.y);

    if (stroke->kind == STROKE_MARK && stroke->place.item != INDEX_NONE
        && names_is_of_site (&shown->scene.items[stroke->place.item])
        && apart > 0.5
        && apart
               < OVERLAPPED * (radius + drawing->styles[stroke->style].radius))
      return TRUE;
  }
  return FALSE;
}

guint
names_count_nameless (const Shown *shown, const uint32_t sites[3])
{
  guint n_nameless = 0;

  for (uint32_t i = 0; i < shown->scene.stock.n_items; i++) {
    const SceneItem *item = &shown->scene.items[i];
    const uint32_t site = item->object.number;

    if (item->label == NULL || !names_is_of_site (item)
        || (site != sites[0] && site != sites[1] && site != sites[2]))
      continue;
    n_nameless += !has_name (shown, i)
                  && !is_overlapped (shown, names_pixel_of (shown, item));
  }
  return n_nameless;
}
