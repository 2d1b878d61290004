/* Drawing again what is as it was: from one step to the next most items look
 * the same, and to copy their strokes is a few times cheaper than to make
 * them. Both drawings list them in the same order, so that each is looked for
 * a little ahead of the one before it. */
#include "painter-private.h"

#include <stdlib.h>
#include <string.h>

/* So far ahead strokes are looked for, in strokes. */
#define AHEAD 24

/* Styles that nothing has any more are not taken out: then all is drawn. */
#define MANY_STYLES 2000

/* A sum over words. Each word is multiplied with the sum so far, and both
 * halves of the product are kept.
 *
 * Source: Wang Yi, wyhash. The first constant is the pattern of no number, so
 *         that no coordinate makes the product 0. */
#define SECRET_A 0xfff2d3c5a1b69e87U
#define SECRET_B 0xe7037ed1a0b428dbU

__extension__ typedef unsigned __int128 Product;

static uint64_t
stir (uint64_t sum, uint64_t a, uint64_t b)
{
  const Product product = (Product)(a ^ SECRET_A) * (b ^ sum ^ SECRET_B);

  return (uint64_t)product ^ (uint64_t)(product >> 64);
}

static uint64_t
bits_of (double number)
{
  uint64_t bits;

  memcpy (&bits, &number, sizeof bits);
  return bits;
}

/* In the plane all z are 0. */
static uint64_t
stir_points (uint64_t sum, const Point3 *points, uint32_t n, bool is_space)
{
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Point3 *point = &points[i];

    sum = stir (sum, bits_of (point->x), bits_of (point->y));
    if (is_space)
      sum = stir (sum, bits_of (point->z), 0);
  }
  return sum;
}

uint64_t
painter_key (const Painter *painter, const SceneItem *item, StrokeKind kind)
{
  const bool is_space = painter->scene->is_space;
  const uint64_t look = (uint64_t)item->role << 32 | (uint64_t)item->shape << 24
                        | (uint64_t)item->emphasis << 16
                        | (uint64_t)item->pass << 8
                        | (uint64_t)painter->is_behind << 1
                        | (uint64_t)(item->object.kind == OBJECT_VERTEX);
  const uint64_t place = (uint64_t)item->n << 32
                         | painter->drawing->next.layer << 8
                         | (uint64_t)kind << 1 | is_space;
  uint64_t sum;

  if (painter->drawing->is_sketch)
    return 0;
  sum = stir (item->hue, look, place);
  sum = stir (sum, bits_of (item->fade), 0);
  return stir_points (sum, &painter->scene->points[item->first], item->n,
                      is_space);
}

/* The strokes up to @end are not in the new drawing. */
static void
leave_out (Painter *painter, uint32_t end)
{
  const Drawing *before = painter->before;

  for (; painter->cursor < end; painter->cursor++)
    squares_mark_stroke (painter->changed, before,
                         &before->strokes[painter->cursor]);
}

static uint32_t
find (const Painter *painter, uint64_t key)
{
  const Drawing *before = painter->before;
  uint32_t i, end = painter->cursor + AHEAD;

  if (end > before->n_strokes)
    end = before->n_strokes;
  for (i = painter->cursor; i < end; i++)
    if (before->strokes[i].key == key)
      return i;
  return INDEX_NONE;
}

/* Items that look all the same and follow each other have keys of their own,
 * so that each has its own strokes. */
static uint64_t
own_key (Painter *painter, uint64_t key)
{
  painter->n_same = key == painter->last_key ? painter->n_same + 1 : 0;
  painter->last_key = key;
  return key + painter->n_same;
}

bool
painter_draw_again (Painter *painter, uint64_t key)
{
  const Drawing *before = painter->before;
  uint32_t i;

  if (painter->drawing->is_sketch)
    return false;
  key = own_key (painter, key);
  painter->drawing->key = key;
  painter->first_new = painter->drawing->n_strokes;
  if (before == NULL)
    return false;
  i = find (painter, key);
  if (i == INDEX_NONE)
    return false;
  leave_out (painter, i);
  for (; i < before->n_strokes && before->strokes[i].key == key; i++)
    drawing_add_copy (painter->drawing, before, &before->strokes[i])->place
        = painter->drawing->next;
  painter->cursor = i;
  return true;
}

void
painter_note_new (Painter *painter)
{
  const Drawing *drawing = painter->drawing;
  uint32_t i;

  if (painter->before == NULL)
    return;
  for (i = painter->first_new; i < drawing->n_strokes; i++)
    squares_mark_stroke (painter->changed, drawing, &drawing->strokes[i]);
}

void
painter_begin_layer (Painter *painter, uint32_t layer)
{
  const Drawing *before = painter->before;
  uint32_t end = painter->cursor;

  if (before == NULL)
    return;
  while (end < before->n_strokes && before->strokes[end].place.layer < layer)
    end++;
  leave_out (painter, end);
}

/* Names are few: each is looked for among all that come after the last. */
static uint32_t
find_name (const Drawing *before, uint32_t from, const PlacedName *placed)
{
  uint32_t i;

  for (i = from; i < before->n_placed && i < from + AHEAD; i++) {
    const PlacedName *other = &before->placed[i];

    if (other->name == placed->name && other->at.x == placed->at.x
        && other->at.y == placed->at.y
        && colour_equal (other->colour, placed->colour))
      return i;
  }
  return INDEX_NONE;
}

static void
compare_names (Painter *painter)
{
  const Drawing *before = painter->before, *drawing = painter->drawing;
  uint32_t i, next = 0;

  for (i = 0; i < drawing->n_placed; i++) {
    const PlacedName *placed = &drawing->placed[i];
    const uint32_t found = find_name (before, next, placed);

    if (found == INDEX_NONE) {
      squares_mark (painter->changed, &placed->box);
      continue;
    }
    for (; next < found; next++)
      squares_mark (painter->changed, &before->placed[next].box);
    next++;
  }
  for (; next < before->n_placed; next++)
    squares_mark (painter->changed, &before->placed[next].box);
}

void
painter_compare_rest (Painter *painter)
{
  if (painter->before == NULL)
    return;
  leave_out (painter, painter->before->n_strokes);
  compare_names (painter);
}

bool
painter_take_styles (Painter *painter)
{
  const Drawing *before = painter->before;
  Drawing *drawing = painter->drawing;
  uint32_t i;

  if (before == NULL || before->sorts == NULL || before->n_styles > MANY_STYLES
      || before->size < drawing->size || before->size > drawing->size
      || before->edition != drawing->edition)
    return false;
  for (i = 0; i < before->n_styles; i++)
    drawing_add_style (drawing, &before->styles[i]);
  memcpy (drawing->sorts, before->sorts,
          N_PAINTER_SORTS * sizeof *drawing->sorts);
  return true;
}
