/* Names of what is lit, and of what is there only because a person points at
 * it, over those of the stock. */
#include "painter-label.h"

#include <math.h>

#define FEW 24   /* so many that are lit are all shown, whatever they cover */
#define MANY 200 /* and of more than so many, none reads the names */

/* What is lit is wider: its name need not go away for that. */
#define LIT_SLACK 100.0

/* What names are laid over. */
typedef struct Ground {
  const Drawing *stock;
  BoxIndex *strokes; /* of the stock; or NULL */
} Ground;

/* The ink alone: casings may touch. */
static PixelBox
letters_of (const PlacedName *placed)
{
  PixelBox box = placed->box;

  box.left += (float)NAME_CASING - 1;
  box.top += (float)NAME_CASING - 1;
  box.right -= (float)NAME_CASING - 1;
  box.bottom -= (float)NAME_CASING - 1;
  return box;
}

static bool
is_covered (const PlacedName *placed, const Drawing *lit)
{
  const PixelBox box = letters_of (placed);

  for (uint32_t i = 0; i < lit->n_placed; i++) {
    const PixelBox over = letters_of (&lit->placed[i]);

    if (boxes_meet (&box, &over))
      return true;
  }
  return false;
}

/* Whether two segments cross, further than @apart px from where the first
 * begins. */
static bool
segments_cross (const Pixel a[2], const Pixel b[2], double apart)
{
  const double ux = a[1].x - a[0].x, uy = a[1].y - a[0].y;
  const double vx = b[1].x - b[0].x, vy = b[1].y - b[0].y;
  const double by = ux * vy - uy * vx;
  const double wx = b[0].x - a[0].x, wy = b[0].y - a[0].y;
  const double t = (wx * vy - wy * vx) / by, s = (wx * uy - wy * ux) / by;

  return isfinite (t) && isfinite (s) && t * hypot (ux, uy) > apart && t < 1
         && s > 0 && s < 1;
}

static bool
is_between (const Drawing *lit, const Stroke *stroke, const Pixel way[2])
{
  const Pixel *pixels = &lit->pixels[stroke->first];

  for (uint32_t i = 0; i + 1 < stroke->n; i++)
    if (segments_cross (way, &pixels[i], 1))
      return true;
  return false;
}

/* Whether a gap that is measured lies under a name, or it or the ellipse in its
 * plane between the name and its mark. A gap that begins there does not. */
static bool
is_crossed (const Scene *scene, const Drawing *lit, const PlacedName *placed)
{
  const PixelBox *box = &placed->box;
  const Pixel way[2]
      = { placed->mark,
          { (box->left + box->right) / 2, (box->top + box->bottom) / 2 } };

  for (uint32_t i = 0; i < lit->n_strokes; i++) {
    const Stroke *stroke = &lit->strokes[i];
    Role role;

    if (stroke->kind != STROKE_LINE || stroke->place.item == INDEX_NONE)
      continue;
    role = scene->items[stroke->place.item].role;
    if ((role == ROLE_GAP && stroke_meets (lit, stroke, box))
        || ((role == ROLE_GAP || role == ROLE_ELLIPSE)
            && is_between (lit, stroke, way)))
      return true;
  }
  return false;
}

bool
painter_takes_name (const Scene *scene,
                    const Drawing *lit,
                    const PlacedName *placed)
{
  return scene->items[placed->item].lit != LIT_NONE || is_covered (placed, lit)
         || is_crossed (scene, lit, placed);
}

/* The names of the stock that stay, and those so far. */
static void
add_names (const Painter *painter, const Drawing *stock, LabelSheet *sheet)
{
  const Drawing *lit = painter->drawing;

  for (uint32_t i = 0; i < stock->n_placed; i++)
    if (!painter_takes_name (painter->scene, lit, &stock->placed[i]))
      label_sheet_name (sheet, &stock->placed[i].box, lit->n_placed > 0);
  for (uint32_t i = 0; i < lit->n_placed; i++)
    label_sheet_name (sheet, &lit->placed[i].box, true);
}

/* Places what is wanted over the ground and what is lit, where it stands in the
 * stock if it can. */
static void
place_over (Painter *painter, const Wanted *wanted, const Ground *ground)
{
  const Drawing *stock = ground->stock;
  const GArray *labels = wanted->labels;
  const NamePlaces *places = names_places (stock->names);
  LabelSheet *sheet;

  if (labels->len == 0)
    return;
  sheet = painter_sheet_new (painter);
  for (guint i = 0; i < labels->len; i++) {
    Label *label = &g_array_index (labels, Label, i);

    label->place = name_places_get (places, painter_item_of (painter, label));
    label->place.cost += LIT_SLACK;
  }
  painter_add_ink_near (
      painter, sheet,
      &(InkSource){ stock, ground->strokes, painter_is_crowd (stock) }, labels);
  painter_add_all_ink (painter, sheet, painter->drawing);
  add_names (painter, stock, sheet);
  label_sheet_place (sheet, (Label *)labels->data, labels->len);
  label_sheet_free (sheet);
  painter_add_wanted (painter, wanted);
}

static bool
are_many (const Scene *scene, const uint32_t *items, uint32_t n)
{
  uint32_t n_names = 0;

  for (uint32_t i = 0; i < n; i++)
    n_names += scene->items[items[i]].label != NULL;
  return n_names > MANY;
}

static bool
has_name (const Drawing *drawing, uint32_t item)
{
  for (uint32_t i = 0; i < drawing->n_placed; i++)
    if (drawing->placed[i].item == item)
      return true;
  return false;
}

static bool
is_measured (const Scene *scene, const SceneItem *site)
{
  return scene->look.layers & LAYER_WHY
         && object_equal (scene->look.measured, site->object);
}

/* Wants the name of the site whose power is told, where it has none yet. */
static void
want_measured (Painter *painter, const Drawing *stock, Wanted *wanted)
{
  const Scene *scene = painter->scene;

  if (!(scene->look.layers & LAYER_WHY)
      || scene->look.measured.kind != OBJECT_SITE)
    return;
  for (uint32_t i = 0; i < scene->stock.n_items; i++) {
    const SceneItem *item = &scene->items[i];

    if (item->label != NULL && item->lit == LIT_NONE
        && is_measured (scene, item) && !has_name (stock, i))
      painter_want (painter, wanted, i);
  }
}

/* Whether a site is a corner of a facet that is selected. */
static bool
is_corner (const Scene *scene, const SceneItem *site)
{
  const Point3 at = scene->points[site->first];

  for (uint32_t i = scene->stock.n_items; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];

    if (item->role != ROLE_LIT || item->lit != LIT_SELECTED)
      continue;
    for (uint32_t k = item->first; k < item->first + item->n; k++) {
      const Point3 corner = scene->points[k];

      if (!(fabs (corner.x - at.x) + fabs (corner.y - at.y)
                + fabs (corner.z - at.z)
            > 0))
        return true;
    }
  }
  return false;
}

/* Wants the names of corners of what is selected, where they have none yet. */
static void
want_corners (Painter *painter, const Drawing *stock, Wanted *wanted)
{
  const Scene *scene = painter->scene;
  const ObjectKind kind = scene->look.selection.kind;

  if ((kind != OBJECT_FACET && kind != OBJECT_VERTEX)
      || scene->stock.n_sites > MANY)
    return;
  for (uint32_t i = 0; i < scene->stock.n_items; i++) {
    const SceneItem *item = &scene->items[i];

    if (item->label != NULL && item->lit == LIT_NONE
        && item->object.kind == OBJECT_SITE && !is_measured (scene, item)
        && !has_name (stock, i) && is_corner (scene, item))
      painter_want (painter, wanted, i);
  }
}

/* Of all names from @first on. */
static void
set_need (const Wanted *wanted, guint first, LabelNeed need)
{
  for (guint i = first; i < wanted->labels->len; i++)
    g_array_index (wanted->labels, Label, i).need = need;
}

static void
add_lit (Painter *painter,
         const uint32_t *items,
         uint32_t n,
         const Ground *ground)
{
  const bool skips = are_many (painter->scene, items, n);
  const bool is_crowd = painter_is_crowd (ground->stock);
  Wanted wanted;
  guint n_lit;

  /* What is only there because of the light comes first. */
  wanted_init (&wanted);
  for (uint32_t i = n; i-- > 0;)
    if (!skips || painter->scene->items[items[i]].role == ROLE_SITE_APEX)
      painter_want (painter, &wanted, items[i]);
  want_measured (painter, ground->stock, &wanted);
  painter_set_needs (painter, &wanted, is_crowd, LABEL_PLAIN);
  if (wanted.labels->len <= FEW)
    set_need (&wanted, 0, is_crowd ? LABEL_MUST_NEAR : LABEL_MUST);
  n_lit = wanted.labels->len;
  if (!is_crowd)
    want_corners (painter, ground->stock, &wanted);
  set_need (&wanted, n_lit, LABEL_SHOULD);
  place_over (painter, &wanted, ground);
  wanted_clear (&wanted);
}

/* Names of the stock that lie under those, or over a gap that is measured, get
 * out of the way. */
static void
add_displaced (Painter *painter, const Ground *ground)
{
  const Drawing *stock = ground->stock;
  const bool is_crowd = painter_is_crowd (stock);
  Wanted wanted;

  wanted_init (&wanted);
  for (uint32_t i = 0; i < stock->n_placed; i++) {
    const PlacedName *placed = &stock->placed[i];

    if (painter->scene->items[placed->item].lit == LIT_NONE
        && painter_takes_name (painter->scene, painter->drawing, placed))
      painter_want (painter, &wanted, placed->item);
  }
  painter_set_needs (painter, &wanted, is_crowd,
                     is_crowd ? LABEL_PLAIN : LABEL_MAY_BE_LED);
  place_over (painter, &wanted, ground);
  wanted_clear (&wanted);
}

void
painter_add_lit_names (Painter *painter,
                       const uint32_t *items,
                       uint32_t n,
                       const Drawing *stock,
                       BoxIndex *strokes)
{
  const Ground ground = { stock, strokes };

  add_lit (painter, items, n, &ground);
  add_displaced (painter, &ground);
}
