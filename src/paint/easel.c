#include "easel.h"

#include "lit-drawing.h"
#include "memory.h"
#include "raster.h"
#include "underlay.h"

#include <stdlib.h>

/* What is painted anew is made of squares of so many device pixels: small ones
 * where only the light has changed. */
#define SQUARE 16
#define SQUARE_LIT 8

/* Of a stock and of a light over it: what the picture shows, and room for the
 * next one. */
struct Easel {
  Names *names;
  Drawing *stocks[2];
  Squares changed;       /* in which the two differ … */
  bool is_changed_known; /* … when this is so; else in any */
  LitDrawing *lights[2];
  Drawing *merged;    /* what of both is painted */
  uint64_t edition;   /* of the scene's stock that is drawn as stocks[0] */
  BoxIndex *boxes;    /* of the strokes of stocks[0] … */
  bool are_boxes_set; /* … when this is so */
  Raster *raster;     /* NULL before the first picture */
  Underlay *underlay;
  Theme theme;
  Projection projection;
  double scale;
};

Easel *
easel_new (void)
{
  Easel *easel = memory_new (1, sizeof *easel);
  int i;

  easel->names = names_new_apart ();
  easel->boxes = box_index_new ();
  easel->underlay = underlay_new ();
  easel->merged = drawing_new (easel->names);
  for (i = 0; i < 2; i++) {
    easel->stocks[i] = drawing_new (easel->names);
    easel->lights[i] = lit_drawing_new (easel->names);
  }
  return easel;
}

void
easel_free (Easel *easel)
{
  int i;

  if (easel == NULL)
    return;
  for (i = 0; i < 2; i++) {
    drawing_free (easel->stocks[i]);
    lit_drawing_free (easel->lights[i]);
  }
  squares_clear (&easel->changed);
  drawing_free (easel->merged);
  box_index_free (easel->boxes);
  underlay_free (easel->underlay);
  names_free (easel->names);
  raster_free (easel->raster);
  free (easel);
}

cairo_surface_t *
easel_get_surface (Easel *easel)
{
  return easel->raster == NULL ? NULL : raster_get_surface (easel->raster);
}

/* Whether the picture is seen from the same place, and its ground is as it
 * will be; else all of it has changed. */
static bool
is_same_sheet (const Easel *easel,
               const Projection *projection,
               const Theme *theme,
               double scale)
{
  return easel->raster != NULL && easel->scale == scale
         && projection_equal (&easel->projection, projection)
         && theme_equal (&easel->theme, theme);
}

static void
init_squares (const Easel *easel, int side, Squares *squares)
{
  const SquareGrid grid = square_grid_of (
      easel->projection.width, easel->projection.height, easel->scale, side);

  squares_init (squares, &grid);
}

/* What stays as it is is not drawn anew. */
static void
draw_stock (Easel *easel, const Scene *scene, bool is_same_sheet)
{
  Drawing *stock = easel->stocks[1];

  easel->stocks[1] = easel->stocks[0];
  easel->stocks[0] = stock;
  squares_clear (&easel->changed);
  init_squares (easel, SQUARE, &easel->changed);
  easel->is_changed_known = drawing_set_stock_again (
      stock, is_same_sheet ? easel->stocks[1] : NULL, scene, &easel->projection,
      &easel->theme, &easel->changed);
  easel->edition = scene->stock.edition;
  easel->are_boxes_set = false;
}

static void
list_strokes (Easel *easel)
{
  const Drawing *stock = easel->stocks[0];
  const PixelBox view = { 0, 0, (float)stock->width, (float)stock->height };

  if (easel->are_boxes_set)
    return;
  box_index_set (easel->boxes, &view, &stock->strokes[0].box,
                 sizeof stock->strokes[0], stock->n_strokes);
  easel->are_boxes_set = true;
}

/* The strokes are listed when something is lit over a stock that stays: on the
 * next occasions they will be there. */
static void
draw_light (Easel *easel, const Scene *scene, bool stays)
{
  const Drawing *stock = easel->stocks[0];
  LitDrawing *light = easel->lights[1];

  easel->lights[1] = easel->lights[0];
  easel->lights[0] = light;
  if (stays)
    list_strokes (easel);
  lit_drawing_set (light, stock, scene, &easel->projection,
                   easel->are_boxes_set ? easel->boxes : NULL);
}

static bool
is_same_size (const Easel *easel, double scale)
{
  return easel->raster != NULL && easel->scale == scale
         && easel->stocks[0]->width == easel->stocks[1]->width
         && easel->stocks[0]->height == easel->stocks[1]->height;
}

/* Returns: the numbers of the stock's strokes that may meet a square, when
 *          they are listed; free with free(). */
static uint32_t *
find_strokes (Easel *easel, const Squares *squares, uint32_t *n)
{
  const SquareGrid *grid = &squares->grid;
  const float side = (float)(1 / grid->per_px);
  uint32_t *strokes = memory_new (easel->stocks[0]->n_strokes, sizeof *strokes);
  uint32_t i;
  int row, column;

  for (row = 0; row < grid->rows; row++)
    for (column = 0; column < grid->columns; column++) {
      const float left = (float)column * side, top = (float)row * side;
      const PixelBox box = { left, top, left + side, top + side };

      if (squares->is_marked[row * grid->columns + column])
        box_index_find (easel->boxes, &box);
    }
  *n = 0;
  for (i = box_index_next (easel->boxes, 0); i != INDEX_NONE;
       i = box_index_next (easel->boxes, i + 1))
    if (squares_meet (squares, &easel->stocks[0]->strokes[i].box))
      strokes[(*n)++] = i;
  box_index_forget (easel->boxes);
  return strokes;
}

/* Where strokes are not listed, because the stock has changed, all are looked
 * through, once. */
static void
paint_squares (Easel *easel, const Scene *scene, const Squares *squares)
{
  const Drawing *stock = easel->stocks[0];
  uint32_t *strokes = NULL, n = stock->n_strokes;

  if (!scene_has_light (scene) && !easel->are_boxes_set) {
    raster_paint (easel->raster, stock, squares);
    return;
  }
  if (easel->are_boxes_set)
    strokes = find_strokes (easel, squares, &n);
  lit_drawing_merge (easel->lights[0], stock, scene, strokes, n, easel->merged);
  raster_paint (easel->raster, easel->merged, squares);
  free (strokes);
}

/* Another stock is shown; what of it is lit is not kept. */
static void
begin_underlay (Easel *easel)
{
  Squares lit;

  init_squares (easel, SQUARE_LIT, &lit);
  lit_drawing_mark (easel->lights[0], &lit);
  underlay_begin (easel->underlay, raster_get_surface (easel->raster), &lit);
  squares_clear (&lit);
}

static cairo_region_t *
paint_all (Easel *easel, const Scene *scene, double scale)
{
  const Drawing *stock = easel->stocks[0];
  cairo_rectangle_int_t whole = { 0 };
  cairo_surface_t *surface;

  if (!is_same_size (easel, scale)) {
    raster_free (easel->raster);
    easel->raster = raster_new (stock->width, stock->height, scale);
    easel->scale = scale;
  }
  if (scene_has_light (scene)) {
    lit_drawing_merge (easel->lights[0], stock, scene, NULL, stock->n_strokes,
                       easel->merged);
    stock = easel->merged;
  }
  raster_paint (easel->raster, stock, NULL);
  begin_underlay (easel);
  surface = raster_get_surface (easel->raster);
  whole.width = cairo_image_surface_get_width (surface);
  whole.height = cairo_image_surface_get_height (surface);
  return cairo_region_create_rectangle (&whole);
}

static cairo_region_t *
paint_stock_changes (Easel *easel, const Scene *scene)
{
  Squares *squares = &easel->changed;

  if (!easel->is_changed_known)
    drawing_compare (easel->stocks[1], easel->stocks[0], squares);
  lit_drawing_compare (easel->lights[1], easel->lights[0], squares);
  squares_close (squares);
  paint_squares (easel, scene, squares);
  begin_underlay (easel);
  return squares_region (squares);
}

static cairo_region_t *
paint_light_changes (Easel *easel, const Scene *scene)
{
  cairo_region_t *region;
  Squares squares, lit;

  init_squares (easel, SQUARE_LIT, &squares);
  init_squares (easel, SQUARE_LIT, &lit);
  lit_drawing_compare (easel->lights[1], easel->lights[0], &squares);
  lit_drawing_mark (easel->lights[0], &lit);
  region = squares_region (&squares);
  underlay_move (easel->underlay, raster_get_surface (easel->raster), &lit,
                 &squares);
  paint_squares (easel, scene, &squares);
  squares_clear (&squares);
  squares_clear (&lit);
  return region;
}

bool
easel_has_stock (const Easel *easel,
                 const Scene *scene,
                 const Projection *projection,
                 const Theme *theme,
                 double scale)
{
  return is_same_sheet (easel, projection, theme, scale)
         && easel->edition == scene->stock.edition;
}

void
easel_prepare_light (Easel *easel)
{
  list_strokes (easel);
}

cairo_region_t *
easel_paint (Easel *easel,
             const Scene *scene,
             const Projection *projection,
             const Theme *theme,
             double scale)
{
  const bool is_same = is_same_sheet (easel, projection, theme, scale);
  const bool has_other_stock
      = !easel_has_stock (easel, scene, projection, theme, scale);

  easel->theme = *theme;
  easel->projection = *projection;
  if (has_other_stock)
    draw_stock (easel, scene, is_same);
  draw_light (easel, scene, !has_other_stock);
  if (!is_same
      || (has_other_stock
          && easel->stocks[0]->edition != easel->stocks[1]->edition))
    return paint_all (easel, scene, scale);
  return has_other_stock ? paint_stock_changes (easel, scene)
                         : paint_light_changes (easel, scene);
}
