#include "legend-mark.h"

static unsigned char
bit_of (const SceneItem *item)
{
  return (unsigned char)(1u << item->shape);
}

static bool
is_vertex (Role role)
{
  return role >= ROLE_VORONOI_VERTEX && role <= ROLE_FURTHEST_VERTEX;
}

/* Outlines and circles are there only because something is lit. */
static bool
is_only_light (Role role)
{
  return role == ROLE_LIT || role == ROLE_CIRCLE_SELECTED;
}

/* The mark that an item is when it is not lit. */
static int
plain_mark (const SceneItem *item)
{
  switch ((int)item->role) {
  case ROLE_CELL:
    return item->emphasis == EMPHASIS_LOUD ? LEGEND_NEW_CELL : ROLE_CELL;
  case ROLE_RIM:
    return ROLE_SHEET;
  case ROLE_FOOT_APEX:
    return ROLE_SITE_APEX;
  default:
    return (int)item->role;
  }
}

static bool
is_lift (Role role)
{
  return role >= ROLE_LIFT && role <= ROLE_LIFT_OUTSIDE;
}

/* The mark that a lit item is: most are as one knows them, with the same light;
 * what belongs to the object looks like none of them. */
static int
light_mark (const SceneItem *item)
{
  const bool is_selected = item->lit == LIT_SELECTED;

  if (is_vertex (item->role))
    return is_selected ? LEGEND_SELECTED_VERTEX : LEGEND_POINTED_VERTEX;
  if (item->role == ROLE_CELL)
    return is_selected ? LEGEND_SELECTED_CELL : LEGEND_POINTED_CELL;
  if (is_lift (item->role))
    return is_selected ? LEGEND_SELECTED_LIFT : LEGEND_POINTED_LIFT;
  if (is_selected && item->role == ROLE_CIRCLE_SELECTED)
    return ROLE_CIRCLE_SELECTED;
  return is_selected ? ROLE_LIT : LEGEND_POINTED;
}

static void
add_light (LegendMarks *marks, const SceneItem *item)
{
  int mark;

  /* Names are not lit. */
  if (item->lit == LIT_NONE || item->role >= ROLE_POWER)
    return;
  mark = light_mark (item);
  marks->shapes[mark] |= bit_of (item);
  marks->is_strong[mark] = true;
}

static void
add_new_cell (LegendMarks *marks, uint32_t hue)
{
  const bool is_other
      = marks->shapes[LEGEND_NEW_CELL] != 0 && marks->new_hue != hue;

  *(is_other ? &marks->other_new_hue : &marks->new_hue) = hue;
  marks->shapes[is_other ? LEGEND_OTHER_NEW_CELL : LEGEND_NEW_CELL]
      = 1u << SHAPE_POLYGON;
}

static void
add_plain (LegendMarks *marks, const SceneItem *item)
{
  const int mark = plain_mark (item);

  if (mark == LEGEND_NEW_CELL)
    add_new_cell (marks, item->hue);
  else
    marks->shapes[mark] |= bit_of (item);
  marks->is_strong[mark] |= item->emphasis != EMPHASIS_PALE;
}

static bool
is_of_hull (const SceneItem *item)
{
  return item->pass == PASS_HULL && item->shape == SHAPE_POLYGON;
}

void
legend_marks_add_stock (LegendMarks *marks, const Scene *scene)
{
  uint32_t i;

  for (i = 0; i < scene->stock.n_items; i++) {
    add_plain (marks, &scene->items[i]);
    marks->has_hull |= scene->is_space && is_of_hull (&scene->items[i]);
  }
}

void
legend_marks_add_pointed (LegendMarks *marks, const Scene *scene)
{
  uint32_t i;

  for (i = 0; i < scene->n_lit; i++)
    add_light (marks, &scene->items[scene->lit[i]]);
  for (i = scene->stock.n_items; i < scene->n_items; i++) {
    if (!is_only_light (scene->items[i].role))
      add_plain (marks, &scene->items[i]);
    add_light (marks, &scene->items[i]);
  }
}

void
legend_marks_merge (LegendMarks *marks, const LegendMarks *from)
{
  int i;

  marks->has_hull |= from->has_hull;
  if (from->shapes[LEGEND_NEW_CELL] != 0)
    add_new_cell (marks, from->new_hue);
  for (i = 0; i < N_LEGEND_MARKS; i++) {
    if (i != LEGEND_NEW_CELL)
      marks->shapes[i] |= from->shapes[i];
    marks->is_strong[i] |= from->is_strong[i];
  }
}

/* What is lit has the look of most of what is lit with it. */
static SceneItem
lit_sample (ObjectKind kind, Lit lit)
{
  SceneItem item
      = { .shape = SHAPE_PATH, .role = ROLE_LIT, .emphasis = EMPHASIS_NORMAL };

  item.lit = lit;
  if (kind == OBJECT_SITE) {
    item.shape = SHAPE_MARK;
    item.role = ROLE_SITE;
  } else if (kind == OBJECT_RIDGE) {
    item.role = ROLE_DELAUNAY_EDGE;
  }
  return item;
}

static SceneItem
new_cell_sample (uint32_t hue)
{
  SceneItem item = { .shape = SHAPE_POLYGON,
                     .role = ROLE_CELL,
                     .emphasis = EMPHASIS_LOUD };

  item.hue = hue;
  return item;
}

/* Hues of cells are so pale that of what is paler one sees none in a sample. */
static bool
is_pale (const LegendMarks *marks, int mark)
{
  return !marks->is_strong[mark] && mark != ROLE_CELL
         && mark != ROLE_FURTHEST_CELL && mark != ROLE_TANGENT;
}

static Role
role_of (int mark)
{
  switch (mark) {
  case LEGEND_SELECTED_VERTEX:
  case LEGEND_POINTED_VERTEX:
    return ROLE_VORONOI_VERTEX;
  case LEGEND_SELECTED_CELL:
  case LEGEND_POINTED_CELL:
    return ROLE_CELL;
  case LEGEND_SELECTED_LIFT:
  case LEGEND_POINTED_LIFT:
    return ROLE_LIFT;
  default:
    return (Role)mark;
  }
}

SceneItem
legend_mark_sample (const LegendMarks *marks, int mark, ObjectKind kind)
{
  const unsigned int shapes = marks->shapes[mark];
  SceneItem item
      = { .emphasis = is_pale (marks, mark) ? EMPHASIS_PALE : EMPHASIS_NORMAL };

  if (mark == ROLE_LIT)
    return lit_sample (kind, LIT_SELECTED);
  if (mark == LEGEND_POINTED)
    return lit_sample (kind, LIT_HOVER);
  if (mark == LEGEND_NEW_CELL || mark == LEGEND_OTHER_NEW_CELL)
    return new_cell_sample (mark == LEGEND_NEW_CELL ? marks->new_hue
                                                    : marks->other_new_hue);
  item.shape = shapes & 1u << SHAPE_POLYGON ? SHAPE_POLYGON
               : shapes & 1u << SHAPE_PATH  ? SHAPE_PATH
                                            : SHAPE_MARK;
  item.role = role_of (mark);
  item.n = mark == ROLE_SITE && marks->has_hull ? 2 : 1;
  if (mark > LEGEND_POINTED)
    item.lit = LIT_HOVER;
  else if (mark >= LEGEND_SELECTED_VERTEX || mark == ROLE_CIRCLE_SELECTED)
    item.lit = LIT_SELECTED;
  return item;
}
