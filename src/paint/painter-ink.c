/* What names keep off: the ink of a drawing, as far as it lies near them. */
#include "painter-label.h"

#include <math.h>

#define BODY_INK 0.45  /* of the paraboloid's lines */
#define NEAR_SQUARE 24 /* side, px: ink is looked for in such squares */

/* A line of so much ink across is heavy where lines have their own widths, in a
 * theme that does not widen them, px. */
#define HEAVY_PX 2.2

/* Between names and the frame of the plane, or the border of a view, px. */
#define BORDER 1.0

/* The frame of the plane, which its view shows, or the border of space. */
static PixelBox
frame_of (const Painter *painter)
{
  const Projection *projection = painter->projection;
  const SceneLook *look = &painter->scene->look;
  const double border = BORDER + painter->theme->styles[ROLE_GROUND].width / 2;
  PixelBox frame
      = { 0, 0, (float)projection->width, (float)projection->height };
  Pixel low, high;

  if (!painter->scene->is_space && look->low.x < look->high.x
      && clip_point (projection, look->low, &low)
      && clip_point (projection, look->high, &high)) {
    frame.left = MAX (frame.left, (float)MIN (low.x, high.x));
    frame.top = MAX (frame.top, (float)MIN (low.y, high.y));
    frame.right = MIN (frame.right, (float)MAX (low.x, high.x));
    frame.bottom = MIN (frame.bottom, (float)MAX (low.y, high.y));
  }
  return (PixelBox){ frame.left + (float)border, frame.top + (float)border,
                     frame.right - (float)border,
                     frame.bottom - (float)border };
}

LabelSheet *
painter_sheet_new (const Painter *painter)
{
  const PixelBox frame = frame_of (painter);

  return label_sheet_new (&frame);
}

static double
heavy_px (const Painter *painter)
{
  return HEAVY_PX * painter->theme->line_factor * painter->drawing->size;
}

double
painter_mark_radius (const Style *style)
{
  return style->halo.alpha > 0 ? brush_mark_reach (style) : style->radius;
}

/* Dashes round a mark are a mark as large. */
static void
add_ring (const Stroke *stroke, const SceneItem *item, LabelSheet *sheet)
{
  const PixelBox *box = &stroke->box;
  const Pixel middle
      = { (box->left + box->right) / 2, (box->top + box->bottom) / 2 };

  label_sheet_mark (sheet, middle, (box->right - box->left) / 2,
                    (box->right - box->left) / 2,
                    item->object.kind == OBJECT_SITE);
}

static LabelLine
kind_of (const Painter *painter, const SceneItem *item, double ink)
{
  if (item == NULL || ink < heavy_px (painter))
    return LABEL_LINE_LIGHT;
  return item->role == ROLE_GAP ? LABEL_LINE_CLEAR : LABEL_LINE_HEAVY;
}

/* Marks, lines and outlines are what names avoid. What shines through is as
 * easily covered as what is thin, and so is what tells nothing but the form of
 * the paraboloid. */
static void
add_ink (const Painter *painter,
         LabelSheet *sheet,
         const Drawing *from,
         const Stroke *stroke)
{
  const SceneItem *item = stroke->place.item == INDEX_NONE
                              ? NULL
                              : &painter->scene->items[stroke->place.item];
  const Pixel *pixels = &from->pixels[stroke->first];
  const Style *style = &from->styles[stroke->style];
  const double ink = style->width * style->line.alpha;
  const bool is_outline = stroke->kind == STROKE_POLYGON;

  if (stroke->kind == STROKE_MARK && item != NULL)
    label_sheet_mark (sheet, pixels[0], painter_mark_radius (style),
                      brush_mark_reach (style),
                      item->object.kind == OBJECT_SITE);
  if (!(ink > 0) || (stroke->kind != STROKE_LINE && !is_outline))
    return;
  if (painter_is_leader (stroke)) {
    if (item->lit == LIT_NONE)
      label_sheet_line (sheet, pixels, ink, LABEL_LINE_LEADER);
    return;
  }
  if (item != NULL && item->shape == SHAPE_MARK) {
    add_ring (stroke, item, sheet);
    return;
  }
  for (uint32_t i = 0; i + 1 < stroke->n + is_outline; i++)
    label_sheet_line (
        sheet, (const Pixel[]){ pixels[i], pixels[(i + 1) % stroke->n] },
        item == NULL ? ink * BODY_INK : ink, kind_of (painter, item, ink));
}

/* All that can be of concern to a name. */
static PixelBox
box_near (const Label *label, const InkSource *source)
{
  const double near = source->is_crowd ? LABEL_NEAR_IN_CROWD_PX : LABEL_NEAR_PX;
  const double reach = label->reach + MAX (label->width, label->height) + near;

  return (PixelBox){ (float)(label->at.x - reach), (float)(label->at.y - reach),
                     (float)(label->at.x + reach),
                     (float)(label->at.y + reach) };
}

static void
add_ink_of (const Painter *painter,
            LabelSheet *sheet,
            const InkSource *source,
            const Stroke *stroke)
{
  const uint32_t item = stroke->place.item;

  if (!source->is_crowd
      || (item != INDEX_NONE
          && (stroke->kind == STROKE_MARK
              || painter->scene->items[item].emphasis == EMPHASIS_LOUD)))
    add_ink (painter, sheet, source->drawing, stroke);
}

static void
mark_squares_near (Squares *squares,
                   const InkSource *source,
                   const GArray *labels)
{
  const SquareGrid grid = square_grid_of (
      source->drawing->width, source->drawing->height, 1, NEAR_SQUARE);

  squares_init (squares, &grid);
  for (guint i = 0; i < labels->len; i++) {
    const PixelBox near = box_near (&g_array_index (labels, Label, i), source);

    squares_mark (squares, &near);
  }
}

static void
add_disc (const Squares *squares,
          LabelSheet *sheet,
          const BareVertex *disc,
          double scale)
{
  const Pixel at = { disc->at[0] / scale, disc->at[1] / scale };
  const double radius = disc->radii[0] / scale;
  const double reach = MAX (radius, disc->radii[1] / scale);
  const PixelBox box = { (float)at.x, (float)at.y, (float)at.x, (float)at.y };

  if (squares_meet (squares, &box))
    label_sheet_mark (sheet, at, radius, reach, true);
}

/* The marks of a sketch are no strokes. Names stand in it as in the drawing
 * that follows when all is still. */
static void
add_bare_marks (LabelSheet *sheet,
                const InkSource *source,
                const GArray *labels)
{
  const Drawing *drawing = source->drawing;
  const Bare *bare = &drawing->bare;
  Squares squares;

  if (bare->n_runs == 0)
    return;
  mark_squares_near (&squares, source, labels);
  for (uint32_t i = 0; i < bare->n_runs; i++) {
    const BareRun *run = &bare->runs[i];

    for (uint32_t k = 0; run->kind == BARE_DISCS && k < run->n; k++)
      add_disc (&squares, sheet, &bare->vertices[run->first + k],
                drawing->scale);
  }
  squares_clear (&squares);
}

static void
add_ink_in_squares (const Painter *painter,
                    LabelSheet *sheet,
                    const InkSource *source,
                    const GArray *labels)
{
  const Drawing *drawing = source->drawing;
  Squares squares;
  PixelBox all;

  mark_squares_near (&squares, source, labels);
  all = squares_extents (&squares);
  for (uint32_t i = 0; i < drawing->n_strokes; i++)
    if (boxes_meet (&drawing->strokes[i].box, &all)
        && squares_meet (&squares, &drawing->strokes[i].box))
      add_ink_of (painter, sheet, source, &drawing->strokes[i]);
  squares_clear (&squares);
}

void
painter_add_ink_near (const Painter *painter,
                      LabelSheet *sheet,
                      const InkSource *source,
                      const GArray *labels)
{
  BoxIndex *strokes = source->strokes;

  add_bare_marks (sheet, source, labels);
  if (strokes == NULL) {
    add_ink_in_squares (painter, sheet, source, labels);
    return;
  }
  for (guint i = 0; i < labels->len; i++) {
    const PixelBox near = box_near (&g_array_index (labels, Label, i), source);

    box_index_find (strokes, &near);
  }
  for (uint32_t i = box_index_next (strokes, 0); i != INDEX_NONE;
       i = box_index_next (strokes, i + 1))
    add_ink_of (painter, sheet, source, &source->drawing->strokes[i]);
  box_index_forget (strokes);
}

void
painter_add_all_ink (const Painter *painter,
                     LabelSheet *sheet,
                     const Drawing *from)
{
  for (uint32_t i = 0; i < from->n_strokes; i++)
    add_ink (painter, sheet, from, &from->strokes[i]);
}
