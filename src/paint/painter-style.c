/* What an item looks like where it is: its style by the theme, changed by the
 * crowd round it and by what it lies behind. */
#include "painter-private.h"

#include <math.h>

/* In space what lies in the plane is drawn thinner than in the plane view, and
 * lines behind the hull thinner and paler than those before it. */
#define GROUND_WIDTH 0.62
#define UNDER_ALPHA 0.12
#define FAR_FILL 0.45

#define LEAST_RADIUS                                                           \
  1.3 /* of a mark; what is smaller is left out,                               \
         unless it is lit */

#define DASH_LEAST 1.6 /* of the lifts; below, so many are hardly seen */

static void
scale_style (Style *style, double size)
{
  style->width *= size;
  style->casing *= size;
  style->dash *= size;
  style->gap *= size;
}

/* What will go is a part of the round, and has a row in the legend, also where
 * it is quiet and seen through what comes in its place. */
static bool
keeps_ink (const SceneItem *item)
{
  return item->role == ROLE_VISIBLE || item->role == ROLE_VISIBLE_UPPER
         || item->role == ROLE_VISIBLE_EDGE;
}

static void
adapt_to_far (const Painter *painter, const SceneItem *item, Style *style)
{
  const Theme *theme = painter->theme;
  const bool is_pale = item->emphasis == EMPHASIS_PALE;

  if (item->shape == SHAPE_PATH) {
    style->width *= theme->far_width;
    style->line.alpha *= is_pale && keeps_ink (item) ? 1 : theme->far_line;
    style->casing = 0;
  } else if (item->emphasis != EMPHASIS_LOUD) {
    /* One hatch behind another would be a third. */
    if (item->role == ROLE_UPPER || item->role == ROLE_VERTICAL)
      style->hatch = HATCH_NONE;
    style->fill.alpha *= theme->has_mat ? 0 : FAR_FILL;
    style->line.alpha *= keeps_ink (item) ? 1 : FAR_FILL;
  }
}

static void
adapt_to_depth (const Painter *painter, const SceneItem *item, Style *style)
{
  const SceneDepth depth = painter->depth;

  if (painter->is_behind)
    theme_put_behind (painter->theme, style);
  if (!painter->scene->is_space)
    return;
  if (depth == DEPTH_GROUND || depth == DEPTH_UNDER) {
    scale_style (style, GROUND_WIDTH);
    if (item->object.kind == OBJECT_VERTEX || item->role == ROLE_PREVIEW_SITE) {
      style->radius *= GROUND_WIDTH;
      style->halo_width *= GROUND_WIDTH;
    }
    /* Seen from below the plane is glass: the hull is what one looks at. */
    if (depth == DEPTH_UNDER && item->shape == SHAPE_POLYGON) {
      style->fill.alpha *= UNDER_ALPHA;
      style->hatch = HATCH_NONE;
    }
  }
  if (depth == DEPTH_HULL_FAR || depth == DEPTH_CONE_FAR)
    adapt_to_far (painter, item, style);
}

/* The active set stays larger than the crowd. */
static void
adapt_to_crowd (const Painter *painter, const SceneItem *item, Style *style)
{
  const bool is_loud = item->emphasis == EMPHASIS_LOUD || item->lit != LIT_NONE;
  const double size
      = is_loud ? sqrt (painter->drawing->size) : painter->drawing->size;

  scale_style (style, size);
  style->radius *= size;
  if (item->role != ROLE_LIFT || is_loud)
    return;
  style->line.alpha *= size;
  /* So many dashes, so short, are a paler line. */
  if (style->dash < DASH_LEAST && style->dash > 0) {
    style->line.alpha *= size * style->dash / (style->dash + style->gap);
    style->dash = style->gap = 0;
  }
}

static Style
style_as_lit (const Painter *painter, const SceneItem *item)
{
  Style style = theme_style (painter->theme, item);

  /* A ring that one sees through hides nothing. */
  if (item->shape == SHAPE_MARK && style.mark == MARK_HOLLOW
      && !(style.fill.alpha > 0))
    style.casing = 0;
  if (painter->drawing->size < 1)
    adapt_to_crowd (painter, item, &style);
  adapt_to_depth (painter, item, &style);
  if (item->shape == SHAPE_PATH && style.width > 0)
    style.width = fmax (style.width, HAIRLINE * painter->drawing->size);
  return style;
}

Style
painter_style (const Painter *painter, const SceneItem *item)
{
  SceneItem plain;

  if (!painter->is_plain || item->lit == LIT_NONE)
    return style_as_lit (painter, item);
  plain = *item;
  plain.lit = LIT_NONE;
  return style_as_lit (painter, &plain);
}

/* Items of one sort share a style, but for the hue of a cell: its strokes have
 * their own. */
static uint32_t
sort_of (const Painter *painter, const SceneItem *item)
{
  const Lit lit = painter->is_plain ? LIT_NONE : item->lit;
  uint32_t sort = (uint32_t)item->role;

  sort = (3 * sort + (uint32_t)item->emphasis) * 3 + (uint32_t)lit;
  sort = 3 * sort + (uint32_t)item->shape;
  sort = N_SCENE_DEPTHS * sort + (uint32_t)painter->depth;
  sort = 2 * sort + painter->is_behind;
  return 2 * sort + (item->object.kind == OBJECT_VERTEX);
}

bool
style_is_unseen (const Style *style, const SceneItem *item)
{
  switch (item->shape) {
  case SHAPE_POLYGON:
    return style->fill.alpha <= 0 && style->line.alpha <= 0
           && style->halo.alpha <= 0;
  case SHAPE_PATH:
    return style->line.alpha <= 0;
  case SHAPE_MARK:
    return style->mark == MARK_NONE || item->fade >= 1
           || (style->radius < LEAST_RADIUS && style->halo.alpha <= 0);
  }
  return false;
}

static PainterSort *
place_of (const Painter *painter, uint32_t sort)
{
  return &painter->sorts[sort * 0x9e3779b1U >> 16 & (N_PAINTER_SORTS - 1)];
}

static bool
is_of (const PainterSort *known, uint32_t sort, const SceneItem *item)
{
  return known->sort == sort && !(known->fade < item->fade)
         && !(known->fade > item->fade);
}

bool
painter_has_none (const Painter *painter, const SceneItem *item)
{
  const uint32_t sort = sort_of (painter, item) + 1;
  const PainterSort *known;

  if (painter->sorts == NULL)
    return false;
  known = place_of (painter, sort);
  return is_of (known, sort, item)
         && style_is_unseen (&painter->drawing->styles[known->style], item);
}

uint32_t
painter_number_style (Painter *painter, const SceneItem *item)
{
  const uint32_t sort = sort_of (painter, item) + 1;
  PainterSort new_one = { 0, 0, 0 };
  PainterSort *known
      = painter->sorts == NULL ? &new_one : place_of (painter, sort);

  if (!is_of (known, sort, item)) {
    SceneItem any = *item;
    Style style;

    any.hue = 0;
    style = painter_style (painter, &any);
    known->sort = sort;
    known->style = drawing_add_style (painter->drawing, &style);
    known->fade = item->fade;
  }
  return known->style;
}
