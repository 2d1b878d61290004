/* Leaders: thin lines from marks to names that had to go further away. */
#include "label-trial.h"
#include "painter-label.h"

#include <math.h>
#include <string.h>

#define LEADER_PX 1.0
#define LEADER_CASING_PX 2.6

static Style
leader_style (const Painter *painter)
{
  const double factor = sqrt (painter->theme->line_factor);
  Style style;

  memset (&style, 0, sizeof style);
  style.line = painter->theme->text;
  style.width = LEADER_PX * factor;
  style.casing = style.width + LEADER_CASING_PX * factor;
  return style;
}

/* The styles of the drawing before are there already: one is enough. */
static uint32_t
number_style (Painter *painter)
{
  const Style style = leader_style (painter);
  const Drawing *drawing = painter->drawing;

  for (uint32_t i = drawing->n_styles; i-- > 0;) {
    const Style *known = &drawing->styles[i];

    if (known->mark == MARK_NONE && !(known->fill.alpha > 0)
        && !(known->dash > 0) && !(known->halo.alpha > 0)
        && !(known->halo_width > 0) && known->width == style.width
        && known->casing == style.casing
        && colour_equal (known->line, style.line))
      return i;
  }
  return drawing_add_style (painter->drawing, &style);
}

bool
painter_is_leader (const Stroke *stroke)
{
  return stroke->place.anchor == INDEX_NONE;
}

void
painter_add_leader (Painter *painter, const Label *label)
{
  static const StrokeKind kinds[2] = { STROKE_CASING, STROKE_LINE };
  const uint32_t style = number_style (painter);
  Drawing *drawing = painter->drawing;
  const PixelBox box = { (float)label->low.x, (float)label->low.y,
                         (float)(label->low.x + label->width),
                         (float)(label->low.y + label->height) };
  Pixel ends[2];

  if (!label_leader (label, &box, ends))
    return;
  drawing->next = (StrokePlace){ label->item, INDEX_NONE, N_PAINT_LAYERS - 1 };
  drawing->key = 0;
  painter->first_new = drawing->n_strokes;
  for (int i = 0; i < 2; i++) {
    stroke_begin (drawing, kinds[i], style);
    stroke_add (drawing, ends[0]);
    stroke_add (drawing, ends[1]);
    stroke_end (drawing);
  }
  painter_note_new (painter);
}
