/* Where the names of marks go. */
#include "painter-label.h"

#include <math.h>

#define PADDING 1.5
#define PLATE_PADDING 6.0 /* at the sides: two answers are no one word */

/* From site to site, for each letter of a name, times the size of type; in
 * space, where more lines meet, times so much more. */
#define LETTER_ROOM 0.75
#define SPACE_ROOM 1.15
#define LARGE_TEXT_PX 18.0

/* With less room than this part of it, only what is important has a name. */
#define ROOM_FOR_SOME 0.7

/* With more than this each of a few has one, if need be with a leader. */
#define ROOM_FOR_ALL 1.25
#define FEW_SITES 40

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

void
wanted_init (Wanted *wanted)
{
  wanted->labels = g_array_new (FALSE, TRUE, sizeof (Label));
  wanted->names = g_array_new (FALSE, FALSE, sizeof (uint32_t));
}

void
wanted_clear (Wanted *wanted)
{
  g_array_unref (wanted->labels);
  g_array_unref (wanted->names);
}

const SceneItem *
painter_item_of (const Painter *painter, const Label *label)
{
  return &painter->scene->items[label->item];
}

static bool
is_in_view (const Painter *painter, Pixel at)
{
  return at.x >= 0 && at.x <= painter->projection->width && at.y >= 0
         && at.y <= painter->projection->height;
}

/* How far the mark of an item is painted round its place. */
static void
measure_mark (Painter *painter, const SceneItem *item, Label *label)
{
  Style style;

  painter->depth = scene_depth (painter->scene, item, painter->projection);
  style = painter_style (painter, item);
  label->radius = painter_mark_radius (&style);
  label->reach = brush_mark_reach (&style);
}

/* The facet itself, not its triangle in the plane below. */
static bool
is_facet_of (const SceneItem *item, const SceneItem *name, bool is_space)
{
  return item->shape == SHAPE_POLYGON && item->n == 3
         && object_equal (item->object, name->object)
         && !(is_space && item->pass == PASS_GROUND);
}

/* A facet that is out of sight, or reaches behind the eye, has none. */
static void
find_corners (const Painter *painter, const SceneItem *name, Label *label)
{
  const Scene *scene = painter->scene;

  for (uint32_t i = 0; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];

    if (!is_facet_of (item, name, scene->is_space))
      continue;
    label->is_of_facet = true;
    for (uint32_t k = 0; k < 3; k++)
      label->is_of_facet
          = clip_point (painter->projection, scene->points[item->first + k],
                        &label->corners[k])
            && label->is_of_facet;
    return;
  }
}

void
painter_want (Painter *painter, Wanted *wanted, uint32_t number)
{
  const SceneItem *item = &painter->scene->items[number];
  Names *names = painter->drawing->names;
  Label label = { .item = number };
  uint32_t name;
  NameSize size;

  if (item->label == NULL || item->fade >= 1
      || !clip_point (painter->projection, painter->scene->points[item->first],
                      &label.at)
      || !is_in_view (painter, label.at))
    return;
  name = names_find (names, item->label, face_of (item));
  size = names_size (names, name);
  label.width = size.width
                + 2 * (face_of (item) == NAME_ANSWER ? PLATE_PADDING : PADDING);
  label.height = size.height + 2 * PADDING;
  measure_mark (painter, item, &label);
  label.is_centred = is_facet_name (item);
  label.is_number = item->role == ROLE_POWER;
  label.is_behind = painter_hides (painter, item);
  if (is_facet_name (item) && item->object.kind == OBJECT_FACET)
    find_corners (painter, item, &label);
  g_array_append_val (wanted->labels, label);
  g_array_append_val (wanted->names, name);
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
  const NameSize size = names_size (painter->drawing->names, name);
  const double x = floor (label->low.x + (label->width - size.width) / 2 + 0.5);
  const double y = floor (label->low.y + PADDING + 0.5);
  const PlacedName placed = {
    .name = name,
    .item = label->item,
    .mark = label->at,
    .at = { x, y },
    .colour = colour_of (theme, painter->scene->items[label->item].role),
    .box = { (float)(x - NAME_CASING), (float)(y - NAME_CASING),
             (float)(x + size.width + NAME_CASING),
             (float)(y + size.height + NAME_CASING) },
  };

  drawing_add_name (painter->drawing, &placed);
}

void
painter_add_wanted (Painter *painter, const Wanted *wanted)
{
  guint i;

  for (i = 0; i < wanted->labels->len; i++) {
    const Label *label = &g_array_index (wanted->labels, Label, i);

    if (label->is_settled && label->place.is_led)
      painter_add_leader (painter, label);
    if (label->is_settled)
      add_name (painter, label, g_array_index (wanted->names, uint32_t, i));
  }
}

static void
place_in_stock (Painter *painter, const Wanted *wanted, bool is_crowd)
{
  const Drawing *drawing = painter->drawing;
  const GArray *labels = wanted->labels;
  NamePlaces *places = names_places (drawing->names);
  LabelSheet *sheet = painter_sheet_new (painter);

  for (guint i = 0; i < labels->len; i++) {
    Label *label = &g_array_index (labels, Label, i);

    label->place = name_places_find (places, painter_item_of (painter, label));
  }
  painter_add_ink_near (painter, sheet, &(InkSource){ drawing, NULL, is_crowd },
                        labels);
  label_sheet_place (sheet, (Label *)labels->data, labels->len);
  label_sheet_free (sheet);
  for (guint i = 0; i < labels->len; i++) {
    const Label *label = &g_array_index (labels, Label, i);

    name_places_keep (places, painter_item_of (painter, label), label->place);
  }
}

/* Where sites are so near each other that names would be all that is seen, only
 * those have theirs that stand free; where they are nearer still, few have.
 *
 * Returns: the room that there is for names, as a part of what all need. Who
 *          has them set large wants them. */
static double
room_for_names (const Painter *painter)
{
  const double text_px = MIN (painter->theme->text_px, LARGE_TEXT_PX);
  const double n_digits
      = 1 + floor (log10 (MAX (painter->scene->stock.n_sites, 2) - 1));
  const double need = LETTER_ROOM * (1 + n_digits) * text_px
                      * (painter->scene->is_space ? SPACE_ROOM : 1);

  return painter_room (painter) / need;
}

void
painter_set_needs (const Painter *painter,
                   const Wanted *wanted,
                   bool is_crowd,
                   LabelNeed need)
{
  for (guint i = 0; i < wanted->labels->len; i++) {
    Label *label = &g_array_index (wanted->labels, Label, i);
    const SceneItem *item = painter_item_of (painter, label);

    if (is_important (item))
      label->need = is_crowd ? LABEL_MUST_NEAR : LABEL_MUST;
    else
      label->need = item->is_corner ? LABEL_SHOULD : need;
    label->is_behind = label->is_behind && label->need < LABEL_SHOULD;
  }
}

void
painter_add_names (Painter *painter)
{
  const Scene *scene = painter->scene;
  const double room = room_for_names (painter);
  const bool is_crowd
      = room < ROOM_FOR_SOME && painter_is_crowd (painter->drawing);
  Wanted wanted;

  wanted_init (&wanted);
  name_places_begin (names_places (painter->drawing->names), scene,
                     painter->projection);
  for (uint32_t i = 0; i < scene->stock.n_items; i++)
    if (room >= ROOM_FOR_SOME || is_important (&scene->items[i]))
      painter_want (painter, &wanted, i);
  painter_set_needs (painter, &wanted, is_crowd,
                     room < 1 ? LABEL_SHY
                     : room < ROOM_FOR_ALL || scene->stock.n_sites > FEW_SITES
                         ? LABEL_PLAIN
                         : LABEL_MAY_BE_LED);
  for (guint i = 0; i < wanted.labels->len; i++) {
    const Label *label = &g_array_index (wanted.labels, Label, i);

    name_places_tell (names_places (painter->drawing->names),
                      painter_item_of (painter, label), label->at);
  }
  if (wanted.labels->len > 0)
    place_in_stock (painter, &wanted, is_crowd);
  painter_add_wanted (painter, &wanted);
  wanted_clear (&wanted);
}
