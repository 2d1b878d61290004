/* A drawing: what a scene looks like through a projection, as strokes of
 * pixels with their styles, back to front, and names in their places. One
 * front half makes it for all painters: cairo (drawing-cairo.c), the raster of
 * the screen (raster.h) and GL (gl-painter.h).
 *
 *   Names *names = names_new ();
 *   Drawing *drawing = drawing_new (names);
 *
 *   drawing_set (drawing, &scene, &projection, theme);
 *   drawing_to_cairo (drawing, cr);
 *   drawing_free (drawing);
 */
#ifndef DRAWING_H
#define DRAWING_H

#include "clip.h"
#include "names.h"
#include "theme.h"

#include <cairo.h>

typedef enum StrokeKind {
  STROKE_POLYGON, /* convex: filled, hatched, outlined, by its style */
  STROKE_REGION,  /* filled between two convex rings, or within one */
  STROKE_CASING,  /* what lies under a line with a casing */
  STROKE_LINE,    /* open */
  STROKE_RING,    /* a line whose last pixel is joined to its first */
  STROKE_MARK,
} StrokeKind;

/* A rectangle of pixels. */
typedef struct PixelBox {
  float left, top, right, bottom;
} PixelBox;

typedef struct Stroke {
  StrokeKind kind;
  uint32_t style;    /* of Drawing.styles */
  uint32_t first, n; /* Drawing.pixels[first] … */
  uint32_t n_outer;  /* STROKE_REGION: pixels of the outer ring */
  PixelBox box;      /* nothing is painted outside it */
  Colour fill;       /* of polygons and regions, instead of the style's */
} Stroke;

/* A name in its place. */
typedef struct PlacedName {
  uint32_t name; /* of Drawing.names */
  Pixel at;      /* the upper left corner of its ink, whole pixels */
  Colour colour;
  PixelBox box;
} PlacedName;

typedef struct Drawing {
  Stroke *strokes;
  uint32_t n_strokes, strokes_room;
  Pixel *pixels;
  uint32_t n_pixels, pixels_room;
  Style *styles;
  uint32_t n_styles, styles_room;
  PlacedName *placed;
  uint32_t n_placed, placed_room;
  Names *names;         /* borrowed; kept from one scene to the next */
  uint32_t edition;     /* of the names; numbers of another one are void */
  const Theme *theme;   /* borrowed */
  double width, height; /* px */
} Drawing;

Drawing *drawing_new (Names *names);
void drawing_free (Drawing *drawing);

/* Draws @scene anew; the room of the last one is used again.
 *
 * Cost: O(items + names · their places); 1000 sites in about 3 ms. */
void drawing_set (Drawing *drawing,
                  const Scene *scene,
                  const Projection *projection,
                  const Theme *theme);

/* Returns: (transfer full): where two drawings of one size and theme differ,
 *          in device pixels, @scale to a px; elsewhere they have the same
 *          pixels. Their names must be of the same Names. */
cairo_region_t *
drawing_compare (const Drawing *before, const Drawing *after, double scale);

/* Paints strokes and names, without a background. */
void drawing_to_cairo (const Drawing *drawing, cairo_t *cr);

/* For painter*.c: begins a stroke; pixels that are added after it are its
 * own, until stroke_end() finds its box. A stroke without pixels is dropped.
 */
Stroke *stroke_begin (Drawing *drawing, StrokeKind kind, uint32_t style);
void stroke_add (Drawing *drawing, Pixel pixel);
void stroke_end (Drawing *drawing);

/* Returns: the number of a style. */
uint32_t drawing_add_style (Drawing *drawing, const Style *style);
void drawing_add_name (Drawing *drawing, const PlacedName *placed);

static inline bool
boxes_meet (const PixelBox *a, const PixelBox *b)
{
  return a->left < b->right && b->left < a->right && a->top < b->bottom
         && b->top < a->bottom;
}

#endif
