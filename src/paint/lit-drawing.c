#include "lit-drawing.h"

#include "memory.h"
#include "painter-private.h"

#include <stdlib.h>
#include <string.h>

LitDrawing *
lit_drawing_new (Names *names)
{
  LitDrawing *light = memory_new (1, sizeof *light);

  light->lit = drawing_new (names);
  light->plain = drawing_new (names);
  return light;
}

void
lit_drawing_free (LitDrawing *light)
{
  if (light == NULL)
    return;
  drawing_free (light->lit);
  drawing_free (light->plain);
  free (light);
}

bool
scene_has_light (const Scene *scene)
{
  return scene->n_lit > 0 || scene->n_items > scene->stock.n_items;
}

/* What is lit of the stock, then what is pointed at: ascending. */
static uint32_t *
list_items (const Scene *scene, uint32_t *n_items)
{
  const uint32_t n_pointed = scene->n_items - scene->stock.n_items;
  uint32_t *items = memory_new (scene->n_lit + n_pointed, sizeof *items);
  uint32_t i;

  if (scene->n_lit > 0)
    memcpy (items, scene->lit, scene->n_lit * sizeof *items);
  for (i = 0; i < n_pointed; i++)
    items[scene->n_lit + i] = scene->stock.n_items + i;
  *n_items = scene->n_lit + n_pointed;
  return items;
}

static bool
is_hidden (const LitDrawing *light,
           const Scene *scene,
           const PlacedName *placed)
{
  return painter_takes_name (scene, light->lit, placed);
}

/* Whether the stroke leads to a name that is hidden. */
static bool
is_hidden_leader (const LitDrawing *light,
                  const Drawing *stock,
                  const Scene *scene,
                  const Stroke *stroke)
{
  uint32_t i;

  if (!painter_is_leader (stroke))
    return false;
  for (i = 0; i < stock->n_placed; i++)
    if (stock->placed[i].item == stroke->place.item)
      return is_hidden (light, scene, &stock->placed[i]);
  return false;
}

static void
hide_names (LitDrawing *light, const Drawing *stock, const Scene *scene)
{
  uint32_t i;

  for (i = 0; i < stock->n_placed; i++)
    if (is_hidden (light, scene, &stock->placed[i]))
      drawing_add_name (light->plain, &stock->placed[i]);
  /* They are the last strokes. */
  for (i = stock->n_strokes;
       i > 0 && painter_is_leader (&stock->strokes[i - 1]); i--) {
    const Stroke *stroke = &stock->strokes[i - 1];

    if (is_hidden_leader (light, stock, scene, stroke))
      drawing_add_copy (light->plain, stock, stroke)->style
          = drawing_add_style (light->plain, &stock->styles[stroke->style]);
  }
}

void
lit_drawing_set (LitDrawing *light,
                 const Drawing *stock,
                 const Scene *scene,
                 const Projection *projection,
                 BoxIndex *strokes)
{
  Painter painter = { .drawing = light->plain,
                      .scene = scene,
                      .projection = projection,
                      .theme = stock->theme,
                      .lamp = painter_lamp (projection),
                      .is_plain = true };
  uint32_t n_items;
  uint32_t *items = list_items (scene, &n_items);

  drawing_begin (light->plain, projection, stock->theme, stock);
  painter_add_items (&painter, scene->lit, scene->n_lit);
  painter.drawing = light->lit;
  painter.is_plain = false;
  drawing_begin (light->lit, projection, stock->theme, stock);
  painter_add_items (&painter, items, n_items);
  painter_add_lit_names (&painter, items, n_items, stock, strokes);
  hide_names (light, stock, scene);
  free (items);
  free (painter.corners);
}

void
lit_drawing_compare (const LitDrawing *before,
                     const LitDrawing *after,
                     Squares *squares)
{
  drawing_compare (before->plain, after->plain, squares);
  drawing_compare (before->lit, after->lit, squares);
}

void
lit_drawing_mark (const LitDrawing *light, Squares *squares)
{
  const Drawing *const drawings[2] = { light->plain, light->lit };
  uint32_t i;
  int k;

  for (k = 0; k < 2; k++) {
    for (i = 0; i < drawings[k]->n_strokes; i++)
      squares_mark_stroke (squares, drawings[k], &drawings[k]->strokes[i]);
    for (i = 0; i < drawings[k]->n_placed; i++)
      squares_mark (squares, &drawings[k]->placed[i].box);
  }
}

/* Merging */

static bool
is_before (const Stroke *a, const Stroke *b)
{
  if (a->place.layer != b->place.layer)
    return a->place.layer < b->place.layer;
  return a->place.anchor < b->place.anchor;
}

static void
add_styles (Drawing *to, const Drawing *from)
{
  uint32_t i;

  for (i = 0; i < from->n_styles; i++)
    drawing_add_style (to, &from->styles[i]);
}

/* Adds a stroke of a drawing whose styles begin at @styles here. */
static void
copy_stroke (Drawing *to,
             const Drawing *from,
             const Stroke *stroke,
             uint32_t styles)
{
  drawing_add_copy (to, from, stroke)->style += styles;
}

static bool
is_lit (const Scene *scene, const Stroke *stroke)
{
  return stroke->place.item != INDEX_NONE
         && scene->items[stroke->place.item].lit != LIT_NONE;
}

/* Where both lie at the same place, there is what has become of a casing of
 * the stock, and then a line that is lit. */
static void
merge_stroke (const LitDrawing *light,
              const Drawing *stock,
              const Stroke *stroke,
              uint32_t *n_merged,
              Drawing *to)
{
  const Drawing *lit = light->lit;

  while (*n_merged < lit->n_strokes
         && is_before (&lit->strokes[*n_merged], stroke))
    copy_stroke (to, lit, &lit->strokes[(*n_merged)++], stock->n_styles);
  copy_stroke (to, stock, stroke, 0);
}

/* What is bare before a stroke, from *@run on. What is lit comes over its whole
 * layer. */
static void
merge_bare (const LitDrawing *light,
            const Drawing *stock,
            uint32_t stroke,
            uint32_t *run,
            uint32_t *n_merged,
            Drawing *to)
{
  const Drawing *lit = light->lit;
  const Bare *bare = &stock->bare;

  for (; *run < bare->n_runs && bare->runs[*run].place.before <= stroke;
       ++*run) {
    const BareRun *next = &bare->runs[*run];

    while (*n_merged < lit->n_strokes
           && lit->strokes[*n_merged].place.layer < next->place.layer)
      copy_stroke (to, lit, &lit->strokes[(*n_merged)++], stock->n_styles);
    bare_copy (&to->bare, (BarePlace){ to->n_strokes, next->place.layer }, bare,
               next);
  }
}

static void
merge_names (const LitDrawing *light,
             const Drawing *stock,
             const Scene *scene,
             Drawing *to)
{
  uint32_t i;

  for (i = 0; i < stock->n_placed; i++)
    if (!is_hidden (light, scene, &stock->placed[i]))
      drawing_add_name (to, &stock->placed[i]);
  for (i = 0; i < light->lit->n_placed; i++)
    drawing_add_name (to, &light->lit->placed[i]);
}

void
lit_drawing_merge (const LitDrawing *light,
                   const Drawing *stock,
                   const Scene *scene,
                   const uint32_t *strokes,
                   uint32_t n,
                   Drawing *to)
{
  const Projection size = { .width = stock->width, .height = stock->height };
  const Drawing *lit = light->lit;
  uint32_t i, n_merged = 0, run = 0;

  drawing_begin (to, &size, stock->theme, stock);
  add_styles (to, stock);
  add_styles (to, lit);
  for (i = 0; i < n; i++) {
    const uint32_t number = strokes == NULL ? i : strokes[i];
    const Stroke *stroke = &stock->strokes[number];

    merge_bare (light, stock, number, &run, &n_merged, to);
    if (!is_lit (scene, stroke)
        && !is_hidden_leader (light, stock, scene, stroke))
      merge_stroke (light, stock, stroke, &n_merged, to);
  }
  merge_bare (light, stock, stock->n_strokes, &run, &n_merged, to);
  while (n_merged < lit->n_strokes)
    copy_stroke (to, lit, &lit->strokes[n_merged++], stock->n_styles);
  merge_names (light, stock, scene, to);
}
