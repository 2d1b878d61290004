#include "drawing.h"

#include "brush.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

Drawing *
drawing_new (Names *names)
{
  Drawing *drawing = memory_new (1, sizeof *drawing);

  drawing->names = names;
  return drawing;
}

void
drawing_free (Drawing *drawing)
{
  if (drawing == NULL)
    return;
  free (drawing->strokes);
  free (drawing->pixels);
  free (drawing->styles);
  free (drawing->placed);
  bare_clear (&drawing->bare);
  free (drawing->sorts);
  hidden_corners_free (drawing->hidden);
  free (drawing);
}

void
drawing_begin (Drawing *drawing,
               const Projection *projection,
               const Theme *theme,
               const Drawing *stock)
{
  drawing->n_strokes = drawing->n_pixels = 0;
  drawing->n_styles = drawing->n_placed = 0;
  bare_begin (&drawing->bare);
  drawing->theme = theme;
  drawing->width = projection->width;
  drawing->height = projection->height;
  drawing->edition
      = stock != NULL ? stock->edition : names_begin (drawing->names, theme);
  drawing->size = stock != NULL ? stock->size : 1;
  drawing->next = (StrokePlace){ INDEX_NONE, 0, 0 };
  drawing->key = 0;
  drawing->is_sketch = stock != NULL && stock->is_sketch;
  drawing->scale = stock != NULL ? stock->scale : 1;
}

uint32_t
drawing_add_style (Drawing *drawing, const Style *style)
{
  if (drawing->n_styles == drawing->styles_room)
    drawing->styles
        = memory_grow (drawing->styles, &drawing->styles_room,
                       drawing->n_styles + 1, sizeof *drawing->styles);
  drawing->styles[drawing->n_styles] = *style;
  return drawing->n_styles++;
}

void
drawing_add_name (Drawing *drawing, const PlacedName *placed)
{
  if (drawing->n_placed == drawing->placed_room)
    drawing->placed
        = memory_grow (drawing->placed, &drawing->placed_room,
                       drawing->n_placed + 1, sizeof *drawing->placed);
  drawing->placed[drawing->n_placed++] = *placed;
}

static Stroke *
add_stroke (Drawing *drawing)
{
  if (drawing->n_strokes == drawing->strokes_room)
    drawing->strokes
        = memory_grow (drawing->strokes, &drawing->strokes_room,
                       drawing->n_strokes + 1, sizeof *drawing->strokes);
  return &drawing->strokes[drawing->n_strokes++];
}

Stroke *
drawing_add_copy (Drawing *drawing, const Drawing *from, const Stroke *stroke)
{
  const Pixel *pixels = &from->pixels[stroke->first];
  Stroke *copy = add_stroke (drawing);
  uint32_t i;

  if (drawing->pixels_room - drawing->n_pixels < stroke->n)
    drawing->pixels
        = memory_grow (drawing->pixels, &drawing->pixels_room,
                       drawing->n_pixels + stroke->n, sizeof *drawing->pixels);
  *copy = *stroke;
  copy->first = drawing->n_pixels;
  /* They are few: to call memcpy() would take longer. */
  for (i = 0; i < stroke->n; i++)
    drawing->pixels[copy->first + i] = pixels[i];
  drawing->n_pixels += stroke->n;
  return copy;
}

Stroke *
stroke_begin (Drawing *drawing, StrokeKind kind, uint32_t style)
{
  Stroke *stroke = add_stroke (drawing);

  /* Two drawings are compared by their bytes: no room between the members
   * may be left to chance. */
  memset (stroke, 0, sizeof *stroke);
  stroke->kind = kind;
  stroke->style = style;
  stroke->first = drawing->n_pixels;
  stroke->place = drawing->next;
  stroke->key = drawing->key;
  stroke->fill = drawing->styles[style].fill;
  return stroke;
}

void
stroke_add (Drawing *drawing, Pixel pixel)
{
  if (drawing->n_pixels == drawing->pixels_room)
    drawing->pixels
        = memory_grow (drawing->pixels, &drawing->pixels_room,
                       drawing->n_pixels + 1, sizeof *drawing->pixels);
  drawing->pixels[drawing->n_pixels++] = pixel;
  drawing->strokes[drawing->n_strokes - 1].n += 1;
}

/* fmin() and fmax(), without asking the library. */
static double
least (double a, double b)
{
  return a < b ? a : b;
}

static double
most (double a, double b)
{
  return a > b ? a : b;
}

double
stroke_reach (const Drawing *drawing, const Stroke *stroke)
{
  const Style *style = &drawing->styles[stroke->style];

  switch (stroke->kind) {
  case STROKE_POLYGON:
    return 1
           + most (style->width / 2 + style->halo_width,
                   style->hatch == HATCH_NONE ? 0 : 2 * style->hatch_width);
  case STROKE_CASING:
    return 1 + style->casing / 2;
  case STROKE_LINE:
  case STROKE_RING:
    return 1 + style->width / 2 + style->halo_width;
  case STROKE_MARK:
    return 1 + brush_mark_reach (style) + style->width;
  case STROKE_REGION:
    break;
  }
  return 1;
}

void
stroke_end (Drawing *drawing)
{
  Stroke *stroke = &drawing->strokes[drawing->n_strokes - 1];
  const double reach = stroke_reach (drawing, stroke);
  const Pixel *pixels;
  Pixel low, high;
  uint32_t i;

  if (stroke->n == 0) {
    drawing->n_strokes -= 1;
    return;
  }
  pixels = &drawing->pixels[stroke->first];
  low = high = pixels[0];
  for (i = 1; i < stroke->n; i++) {
    low.x = least (low.x, pixels[i].x);
    low.y = least (low.y, pixels[i].y);
    high.x = most (high.x, pixels[i].x);
    high.y = most (high.y, pixels[i].y);
  }
  stroke->box = (PixelBox){ (float)(low.x - reach), (float)(low.y - reach),
                            (float)(high.x + reach), (float)(high.y + reach) };
}

/* Long lines have large boxes, in which they are nearly nowhere. */
static bool
segments_meet (const Drawing *drawing,
               const Stroke *stroke,
               const PixelBox *box)
{
  const Pixel *pixels = &drawing->pixels[stroke->first];
  const double reach = stroke_reach (drawing, stroke);
  const Pixel low = { box->left - reach, box->top - reach };
  const Pixel high = { box->right + reach, box->bottom + reach };
  uint32_t i;

  for (i = 0; i + 1 < stroke->n; i++) {
    Pixel ends[2] = { pixels[i], pixels[i + 1] };

    if (clip_to_rectangle (low, high, ends))
      return true;
  }
  return stroke->n < 2;
}

bool
stroke_meets (const Drawing *drawing, const Stroke *stroke, const PixelBox *box)
{
  if (!boxes_meet (&stroke->box, box))
    return false;
  if (stroke->kind != STROKE_LINE && stroke->kind != STROKE_CASING)
    return true;
  return segments_meet (drawing, stroke, box);
}
