#include "names-judge.h"

#include <math.h>

/* From the name of an answer to dots, and to names of sites above or below it,
 * parts of its height. */
#define TO_DOT 0.35
#define TO_NAME 0.6

/* From such a place to the sides of the triangle, px: there may be outlines. */
#define TO_SIDE 14.0

#define GRID 4.0 /* places are looked for so near each other, px */

static gboolean
is_far_from_dots (const Shown *shown, const PixelBox *box)
{
  const Drawing *drawing = shown->drawing;
  const double apart = TO_DOT * (box->bottom - box->top);

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];

    if (stroke->kind == STROKE_MARK
        && names_distance_to (box, drawing->pixels[stroke->first])
               < drawing->styles[stroke->style].radius + apart)
      return FALSE;
  }
  return TRUE;
}

static gboolean
is_alone (const Shown *shown, uint32_t name, const PixelBox *box)
{
  const Drawing *drawing = shown->drawing;
  const float apart = (float)(TO_NAME * (box->bottom - box->top));
  const PixelBox tall
      = { box->left, box->top - apart, box->right, box->bottom + apart };

  for (uint32_t i = 0; i < drawing->n_placed; i++) {
    const PixelBox other = names_letters_of (&drawing->placed[i]);

    if (i != name
        && names_is_of_site (&shown->scene.items[drawing->placed[i].item])
        && boxes_meet (&other, &tall))
      return FALSE;
  }
  return TRUE;
}

/* Whether a place lies on the left of a side, all of them turning left, and so
 * far from it. */
static gboolean
is_inside (const Pixel corners[3], Pixel at)
{
  for (int k = 0; k < 3; k++) {
    const Pixel a = corners[k], b = corners[(k + 1) % 3];
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double off = (dx * (at.y - a.y) - dy * (at.x - a.x)) / hypot (dx, dy);

    /* Pixels go down, where the plane goes up. */
    if (-off < TO_SIDE)
      return FALSE;
  }
  return TRUE;
}

static gboolean
is_free (const Shown *shown,
         uint32_t name,
         const Pixel corners[3],
         const PixelBox *box)
{
  const Pixel ends[4] = { { box->left, box->top },
                          { box->right, box->top },
                          { box->right, box->bottom },
                          { box->left, box->bottom } };

  for (int i = 0; i < 4; i++)
    if (!is_inside (corners, ends[i]))
      return FALSE;
  return is_far_from_dots (shown, box) && is_alone (shown, name, box)
         && names_is_apart (shown->drawing, name, box);
}

static gboolean
has_free_place (const Shown *shown, uint32_t name, const Pixel corners[3])
{
  const PlacedName *placed = &shown->drawing->placed[name];
  const PixelBox now = names_letters_of (placed);
  const float width = now.right - now.left, height = now.bottom - now.top;

  for (double y = 0; y < shown->drawing->height; y += GRID)
    for (double x = 0; x < shown->drawing->width; x += GRID) {
      const PixelBox box
          = { (float)x, (float)y, (float)x + width, (float)y + height };

      if (is_free (shown, name, corners, &box))
        return TRUE;
    }
  return FALSE;
}

static void
find_corners (const Shown *shown,
              const Fixture *fixture,
              uint32_t facet,
              Pixel corners[3])
{
  for (uint32_t i = 0; i < shown->scene.stock.n_items; i++) {
    const SceneItem *item = &shown->scene.items[i];

    for (int k = 0; k < 3; k++)
      if (item->shape == SHAPE_MARK && names_is_of_site (item)
          && item->object.number == fixture->trace->facets[facet].site[k])
        corners[k] = names_pixel_of (shown, item);
  }
}

guint
names_judge_answers (const Shown *shown,
                     const Fixture *fixture,
                     const char *what)
{
  guint n_answers = 0;

  for (uint32_t i = 0; i < shown->drawing->n_placed; i++) {
    const PlacedName *placed = &shown->drawing->placed[i];
    const SceneItem *item = &shown->scene.items[placed->item];
    const PixelBox box = names_letters_of (placed);
    Pixel corners[3] = { { 0, 0 }, { 0, 0 }, { 0, 0 } };

    if (item->role != ROLE_ANSWER_NAME)
      continue;
    n_answers++;
    if (is_far_from_dots (shown, &box) && is_alone (shown, i, &box))
      continue;
    find_corners (shown, fixture, item->object.number, corners);
    if (has_free_place (shown, i, corners))
      g_error ("%s: %s stands in bad company", what, item->label);
  }
  return n_answers;
}
