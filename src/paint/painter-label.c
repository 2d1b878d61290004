/* Where the names of marks go. */
#include "painter-private.h"

#include <glib.h>
#include <math.h>

#define PADDING 1.5
#define CROWDED 0.75 /* where sites are drawn smaller, few have names */

/* So few names see only the ink near them: px, more than any place of a name
 * is away from its mark. */
#define FEW 24
#define NEAR_PX 60.0

static bool
is_important (const SceneItem *item)
{
  return item->emphasis == EMPHASIS_LOUD || item->lit != LIT_NONE
         || item->role == ROLE_SITE_APEX || item->role == ROLE_POWER;
}

static NameFace
face_of (const SceneItem *item)
{
  if (item->role == ROLE_SITE_APEX)
    return NAME_APEX;
  return item->role == ROLE_FACET_NAME ? NAME_FACET : NAME_PLAIN;
}

/* A name to be placed, and its number. */
typedef struct Wanted {
  uint32_t name;
  const SceneItem *item;
} Wanted;

static bool
is_in_view (const Painter *painter, Pixel at)
{
  return at.x >= 0 && at.x <= painter->projection->width && at.y >= 0
         && at.y <= painter->projection->height;
}

/* Finds the names of all marks in the view: one of @wanted for each label. */
static GArray *
find_labels (const Painter *painter, GArray *wanted)
{
  GArray *labels = g_array_new (FALSE, TRUE, sizeof (Label));
  uint32_t i;

  for (i = 0; i < painter->scene->n_items; i++) {
    const SceneItem *item = &painter->scene->items[i];
    Wanted want = { .item = item };
    Label label = { .text = item->label, .item = i };
    NameSize size;
    Style style;

    if (item->label == NULL || item->fade >= 1
        || (painter->size < CROWDED && !is_important (item))
        || !clip_point (painter->projection,
                        painter->scene->points[item->first], &label.at)
        || !is_in_view (painter, label.at))
      continue;
    style = painter_style (painter, item);
    want.name
        = names_find (painter->drawing->names, item->label, face_of (item));
    size = names_size (painter->drawing->names, want.name);
    label.width = size.width + 2 * PADDING;
    label.height = size.height + 2 * PADDING;
    label.reach = brush_mark_reach (&style);
    label.is_important = is_important (item);
    label.is_centred = item->role == ROLE_FACET_NAME;
    g_array_append_val (labels, label);
    g_array_append_val (wanted, want);
  }
  return labels;
}

static bool
is_near (const Stroke *stroke, const GArray *labels)
{
  guint i;

  for (i = 0; i < labels->len; i++) {
    const Label *label = &g_array_index (labels, Label, i);
    const double reach = label->reach + label->width + NEAR_PX;
    const PixelBox box
        = { (float)(label->at.x - reach), (float)(label->at.y - reach),
            (float)(label->at.x + reach), (float)(label->at.y + reach) };

    if (boxes_meet (&stroke->box, &box))
      return true;
  }
  return false;
}

/* The paraboloid's lines and all others, and marks, are what names avoid. */
static void
add_ink (const Drawing *drawing, const Stroke *stroke, LabelSheet *sheet)
{
  const Pixel *pixels = &drawing->pixels[stroke->first];
  const Style *style = &drawing->styles[stroke->style];
  uint32_t i;

  if (stroke->kind == STROKE_MARK)
    label_sheet_mark (sheet, pixels[0], brush_mark_reach (style));
  if (stroke->kind != STROKE_LINE && stroke->kind != STROKE_CASING)
    return;
  for (i = 0; i + 1 < stroke->n; i++)
    label_sheet_line (sheet, &pixels[i], style->width);
}

/* A name on whole pixels is crisp, and can be painted from a mask. */
static void
add_name (Painter *painter, const Label *label, const Wanted *want)
{
  const Theme *theme = painter->theme;
  const double x = floor (label->low.x + PADDING + 0.5);
  const double y = floor (label->low.y + PADDING + 0.5);
  const NameSize size = names_size (painter->drawing->names, want->name);
  const PlacedName placed = {
    .name = want->name,
    .at = { x, y },
    .colour
    = want->item->role == ROLE_SITE_APEX ? theme->apex_text : theme->text,
    .box = { (float)(x - NAME_CASING), (float)(y - NAME_CASING),
             (float)(x + size.width + NAME_CASING),
             (float)(y + size.height + NAME_CASING) },
  };

  drawing_add_name (painter->drawing, &placed);
}

void
painter_add_names (Painter *painter)
{
  g_autoptr (GArray) wanted = g_array_new (FALSE, FALSE, sizeof (Wanted));
  g_autoptr (GArray) labels = find_labels (painter, wanted);
  const Drawing *drawing = painter->drawing;
  LabelSheet *sheet;
  guint i;

  if (labels->len == 0)
    return;
  sheet = label_sheet_new (drawing->width, drawing->height);
  for (i = 0; i < drawing->n_strokes; i++)
    if (labels->len > FEW || is_near (&drawing->strokes[i], labels))
      add_ink (drawing, &drawing->strokes[i], sheet);
  label_sheet_place (sheet, (Label *)labels->data, labels->len);
  for (i = 0; i < labels->len; i++) {
    const Label *label = &g_array_index (labels, Label, i);

    if (label->is_placed)
      add_name (painter, label, &g_array_index (wanted, Wanted, i));
  }
  label_sheet_free (sheet);
}
