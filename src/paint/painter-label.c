/* Where the names of marks go. */
#include "painter-private.h"
#include "squares.h"

#include <glib.h>
#include <math.h>

#define PADDING 1.5
#define CROWDED 0.75 /* where sites are drawn smaller, few have names */

/* From site to site, for each letter of a name, times the size of type; in
 * space, where more lines meet, times so much more. */
#define LETTER_ROOM 0.75
#define SPACE_ROOM 1.15
#define LARGE_TEXT_PX 18.0

#define BODY_INK 0.45 /* of the paraboloid's lines */

#define FEW 24   /* so many that are lit are all shown, whatever they cover */
#define MANY 200 /* and of more than so many, none reads the names */
#define NEAR_SQUARE 24 /* side, px: ink is looked for in such squares */

/* What has its name also in a crowd. */
static bool
is_important (const SceneItem *item)
{
  return item->emphasis == EMPHASIS_LOUD || item->role == ROLE_SITE_APEX;
}

static bool
is_facet_name (const SceneItem *item)
{
  return item->role == ROLE_FACET_NAME || item->role == ROLE_ANSWER_NAME;
}

static NameFace
face_of (const SceneItem *item)
{
  if (item->role == ROLE_SITE_APEX)
    return NAME_APEX;
  if (item->role == ROLE_ANSWER_NAME
      || (item->role >= ROLE_ANSWER_CHOSEN && item->role <= ROLE_ANSWER_MISSED))
    return NAME_ANSWER;
  return item->role == ROLE_FACET_NAME ? NAME_FACET : NAME_PLAIN;
}

/* Names to be placed. */
typedef struct Wanted {
  GArray *labels; /* Label */
  GArray *names;  /* the number of each */
} Wanted;

static void
wanted_init (Wanted *wanted)
{
  wanted->labels = g_array_new (FALSE, TRUE, sizeof (Label));
  wanted->names = g_array_new (FALSE, FALSE, sizeof (uint32_t));
}

static void
wanted_clear (Wanted *wanted)
{
  g_array_unref (wanted->labels);
  g_array_unref (wanted->names);
}

static bool
is_in_view (const Painter *painter, Pixel at)
{
  return at.x >= 0 && at.x <= painter->projection->width && at.y >= 0
         && at.y <= painter->projection->height;
}

/* How far the mark of an item is painted round its place. */
static double
reach_of_mark (Painter *painter, const SceneItem *item)
{
  Style style;

  painter->depth = scene_depth (painter->scene, item, painter->projection);
  style = painter_style (painter, item);
  return brush_mark_reach (&style);
}

/* Wants the name of an item, if it has one and is in the view. */
static void
want (Painter *painter, Wanted *wanted, uint32_t number)
{
  const SceneItem *item = &painter->scene->items[number];
  Names *names = painter->drawing->names;
  Label label = { .text = item->label, .item = number };
  uint32_t name;
  NameSize size;

  if (item->label == NULL || item->fade >= 1
      || !clip_point (painter->projection, painter->scene->points[item->first],
                      &label.at)
      || !is_in_view (painter, label.at))
    return;
  name = names_find (names, item->label, face_of (item));
  size = names_size (names, name);
  label.width = size.width + 2 * PADDING;
  label.height = size.height + 2 * PADDING;
  label.reach = reach_of_mark (painter, item);
  label.is_important = is_important (item);
  label.is_centred = is_facet_name (item);
  label.is_number = item->role == ROLE_POWER;
  g_array_append_val (wanted->labels, label);
  g_array_append_val (wanted->names, name);
}

/* All that can be of concern to a name. */
static PixelBox
box_near (const Label *label)
{
  const double reach
      = label->reach + MAX (label->width, label->height) + LABEL_NEAR_PX;

  return (PixelBox){ (float)(label->at.x - reach), (float)(label->at.y - reach),
                     (float)(label->at.x + reach),
                     (float)(label->at.y + reach) };
}

/* The paraboloid's lines and all others, and marks, are what names avoid. */
static void
add_ink (const Drawing *drawing, const Stroke *stroke, LabelSheet *sheet)
{
  const Pixel *pixels = &drawing->pixels[stroke->first];
  const Style *style = &drawing->styles[stroke->style];
  double width = style->width * style->line.alpha;
  uint32_t i;

  if (stroke->kind == STROKE_MARK)
    label_sheet_mark (sheet, pixels[0], brush_mark_reach (style));
  if (stroke->kind != STROKE_LINE && stroke->kind != STROKE_CASING)
    return;
  /* What shines through is as easily covered as what is thin, and so is what
   * tells nothing but its form. */
  if (stroke->place.item == INDEX_NONE)
    width *= BODY_INK;
  for (i = 0; i + 1 < stroke->n; i++)
    label_sheet_line (sheet, &pixels[i], width);
}

/* A power is told in the colour of its gap, or it would seem to name what it
 * is next to. */
static Colour
colour_of (const Theme *theme, Role role)
{
  return role == ROLE_SITE_APEX || role == ROLE_POWER ? theme->apex_text
                                                      : theme->text;
}

/* A name on whole pixels is crisp, and can be painted from a mask. */
static void
add_name (Painter *painter, const Label *label, uint32_t name)
{
  const Theme *theme = painter->theme;
  const double x = floor (label->low.x + PADDING + 0.5);
  const double y = floor (label->low.y + PADDING + 0.5);
  const NameSize size = names_size (painter->drawing->names, name);
  const PlacedName placed = {
    .name = name,
    .item = label->item,
    .at = { x, y },
    .colour = colour_of (theme, painter->scene->items[label->item].role),
    .box = { (float)(x - NAME_CASING), (float)(y - NAME_CASING),
             (float)(x + size.width + NAME_CASING),
             (float)(y + size.height + NAME_CASING) },
  };

  drawing_add_name (painter->drawing, &placed);
}

static void
add_placed (Painter *painter, const Wanted *wanted)
{
  guint i;

  for (i = 0; i < wanted->labels->len; i++) {
    const Label *label = &g_array_index (wanted->labels, Label, i);

    if (label->is_placed)
      add_name (painter, label, g_array_index (wanted->names, uint32_t, i));
  }
}

static PixelBox
area_of (const GArray *labels)
{
  PixelBox area = box_near (&g_array_index (labels, Label, 0));
  guint i;

  for (i = 1; i < labels->len; i++) {
    const PixelBox near = box_near (&g_array_index (labels, Label, i));

    area.left = MIN (area.left, near.left);
    area.top = MIN (area.top, near.top);
    area.right = MAX (area.right, near.right);
    area.bottom = MAX (area.bottom, near.bottom);
  }
  return area;
}

/* A sheet for labels, and what is near them. */
static LabelSheet *
sheet_new (const Drawing *drawing, const GArray *labels)
{
  const PixelBox area = area_of (labels);

  return label_sheet_new (drawing->width, drawing->height, &area);
}

/* Adds the ink of all strokes that are near a label; that of some others does
 * no harm. */
static void
add_ink_near (LabelSheet *sheet, const Drawing *drawing, const GArray *labels)
{
  const SquareGrid grid
      = square_grid_of (drawing->width, drawing->height, 1, NEAR_SQUARE);
  Squares squares;
  PixelBox all;
  uint32_t i;

  squares_init (&squares, &grid);
  for (i = 0; i < labels->len; i++) {
    const PixelBox near = box_near (&g_array_index (labels, Label, i));

    squares_mark (&squares, &near);
  }
  all = squares_extents (&squares);
  for (i = 0; i < drawing->n_strokes; i++)
    if (boxes_meet (&drawing->strokes[i].box, &all)
        && squares_meet (&squares, &drawing->strokes[i].box))
      add_ink (drawing, &drawing->strokes[i], sheet);
  squares_clear (&squares);
}

/* There is ink everywhere then: a name is best next to its mark, but for what
 * is loud. */
static bool
is_crowd (const Drawing *drawing)
{
  return drawing->size < CROWDED;
}

/* Adds the ink of what is loud alone, near the labels. */
static void
add_loud_ink (LabelSheet *sheet,
              const Drawing *drawing,
              const Scene *scene,
              const GArray *labels)
{
  const PixelBox area = area_of (labels);
  uint32_t i;

  for (i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const uint32_t item = stroke->place.item;

    if (item != INDEX_NONE && boxes_meet (&stroke->box, &area)
        && scene->items[item].emphasis == EMPHASIS_LOUD)
      add_ink (drawing, stroke, sheet);
  }
}

/* A site's foot has no name: that of a lift should not seem to be it. */
static void
add_feet (Painter *painter, LabelSheet *sheet)
{
  const Scene *scene = painter->scene;
  uint32_t i;

  for (i = 0; i < scene->stock.n_items; i++) {
    const SceneItem *item = &scene->items[i];
    Pixel at;

    if ((item->role == ROLE_FOOT || item->role == ROLE_FOOT_APEX)
        && clip_point (painter->projection, scene->points[item->first], &at))
      label_sheet_named (sheet, at, reach_of_mark (painter, item));
  }
}

static void
place_in_stock (Painter *painter, const Wanted *wanted)
{
  const Drawing *drawing = painter->drawing;
  const GArray *labels = wanted->labels;
  LabelSheet *sheet = sheet_new (drawing, labels);

  if (is_crowd (drawing))
    add_loud_ink (sheet, drawing, painter->scene, labels);
  else {
    add_ink_near (sheet, drawing, labels);
    add_feet (painter, sheet);
  }
  label_sheet_place (sheet, (Label *)labels->data, labels->len);
  label_sheet_free (sheet);
}

/* Where sites are so near each other that names would be all that is seen,
 * few have theirs. Who has them set large wants them. */
static bool
has_room_for_names (const Painter *painter)
{
  const double text_px = MIN (painter->theme->text_px, LARGE_TEXT_PX);
  const double n_digits
      = 1 + floor (log10 (MAX (painter->scene->stock.n_sites, 2) - 1));
  const double room = LETTER_ROOM * (1 + n_digits) * text_px
                      * (painter->scene->is_space ? SPACE_ROOM : 1);

  return !is_crowd (painter->drawing) && painter_room (painter) >= room;
}

void
painter_add_names (Painter *painter)
{
  const Scene *scene = painter->scene;
  const bool has_room = has_room_for_names (painter);
  Wanted wanted;
  uint32_t i;

  wanted_init (&wanted);
  for (i = 0; i < scene->stock.n_items; i++)
    if (has_room || is_important (&scene->items[i]))
      want (painter, &wanted, i);
  if (wanted.labels->len > 0)
    place_in_stock (painter, &wanted);
  add_placed (painter, &wanted);
  wanted_clear (&wanted);
}

/* Names of what is lit */

/* The same of strokes that may be listed. */
static void
add_ink_of_listed (LabelSheet *sheet,
                   const Drawing *stock,
                   const GArray *labels,
                   BoxIndex *strokes)
{
  uint32_t i;

  if (is_crowd (stock))
    return;
  if (strokes == NULL) {
    add_ink_near (sheet, stock, labels);
    return;
  }
  for (i = 0; i < labels->len; i++) {
    const PixelBox near = box_near (&g_array_index (labels, Label, i));

    box_index_find (strokes, &near);
  }
  for (i = box_index_next (strokes, 0); i != INDEX_NONE;
       i = box_index_next (strokes, i + 1))
    add_ink (stock, &stock->strokes[i], sheet);
  box_index_forget (strokes);
}

/* What is lit has its name placed anew. */
static void
add_names_of (const Drawing *stock, const Scene *scene, LabelSheet *sheet)
{
  uint32_t i;

  for (i = 0; i < stock->n_placed; i++)
    if (scene->items[stock->placed[i].item].lit == LIT_NONE)
      label_sheet_name (sheet, &stock->placed[i].box);
}

/* Marks that have their name in the stock. */
static void
add_named (Painter *painter, const Drawing *stock, LabelSheet *sheet)
{
  const Scene *scene = painter->scene;
  uint32_t i;

  for (i = 0; i < stock->n_placed; i++) {
    const SceneItem *item = &scene->items[stock->placed[i].item];
    Pixel at;

    if (item->lit == LIT_NONE && item->shape == SHAPE_MARK
        && !is_facet_name (item)
        && clip_point (painter->projection, scene->points[item->first], &at))
      label_sheet_named (sheet, at, reach_of_mark (painter, item));
  }
}

/* Places what is wanted over the strokes of @stock and those so far. */
static void
place_over (Painter *painter,
            const GArray *labels,
            const Drawing *stock,
            BoxIndex *strokes)
{
  const Drawing *drawing = painter->drawing;
  LabelSheet *sheet = sheet_new (drawing, labels);
  uint32_t i;

  add_ink_of_listed (sheet, stock, labels, strokes);
  for (i = 0; i < drawing->n_strokes; i++)
    add_ink (drawing, &drawing->strokes[i], sheet);
  add_names_of (stock, painter->scene, sheet);
  add_named (painter, stock, sheet);
  if (!is_crowd (stock))
    add_feet (painter, sheet);
  if (labels->len > FEW)
    label_sheet_place (sheet, (Label *)labels->data, labels->len);
  else
    label_sheet_place_over (sheet, (Label *)labels->data, labels->len);
  label_sheet_free (sheet);
}

static bool
are_many (const Scene *scene, const uint32_t *items, uint32_t n)
{
  uint32_t n_names = 0;

  for (uint32_t i = 0; i < n; i++)
    n_names += scene->items[items[i]].label != NULL;
  return n_names > MANY;
}

void
painter_add_lit_names (Painter *painter,
                       const uint32_t *items,
                       uint32_t n,
                       const Drawing *stock,
                       BoxIndex *strokes)
{
  const bool skips = are_many (painter->scene, items, n);
  Wanted wanted;
  uint32_t i;

  /* What is only there because of the light comes first. */
  wanted_init (&wanted);
  for (i = n; i-- > 0;)
    if (!skips || painter->scene->items[items[i]].role == ROLE_SITE_APEX)
      want (painter, &wanted, items[i]);
  if (wanted.labels->len > 0)
    place_over (painter, wanted.labels, stock, strokes);
  add_placed (painter, &wanted);
  wanted_clear (&wanted);
}
