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

#include "bare.h"
#include "box-index.h"
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

/* What a stroke is of, and where it stands in the order of paint: by layer,
 * then by anchor. */
typedef struct StrokePlace {
  uint32_t item;   /* of the scene; INDEX_NONE: of none that can be lit */
  uint32_t anchor; /* an item: of lines and all else itself, of a casing that
                      before whose line it lies; 0 for what no item is */
  uint32_t layer;
} StrokePlace;

typedef struct Stroke {
  StrokeKind kind;
  uint32_t style;    /* of Drawing.styles */
  uint32_t first, n; /* Drawing.pixels[first] … */
  uint32_t n_outer;  /* STROKE_REGION: pixels of the outer ring */
  PixelBox box;      /* nothing is painted outside it */
  StrokePlace place;
  Colour fill;  /* of polygons and regions, instead of the style's */
  uint64_t key; /* of all that it follows from but projection, theme and size;
                   0: not known */
} Stroke;

/* A name in its place. */
typedef struct PlacedName {
  uint32_t name; /* of Drawing.names */
  uint32_t item; /* of the scene */
  Pixel mark;    /* what it names */
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
  Bare bare;            /* of a sketch, each before the stroke that is next */
  Names *names;         /* borrowed; kept from one scene to the next */
  uint32_t edition;     /* of the names; numbers of another one are void */
  const Theme *theme;   /* borrowed */
  double width, height; /* px */
  double size;          /* of marks and lines; below 1 in a crowd */
  StrokePlace next;     /* of the strokes that are begun next, */
  uint64_t key;         /* and their key */
  bool is_sketch;       /* drawing_set_sketch() */
  double scale;         /* of a sketch, device pixels per px */
  struct HiddenCorners *hidden; /* painter-hidden.c: corners of the scene */
  struct PainterSort *sorts;    /* painter-style.c: which style is whose */
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

/* The same for a picture that is looked at for a moment, because something
 * moves: where there is much to draw, what is hardly seen is left out, and what
 * is simple is bare. Such a drawing is a sketch, none of its strokes has a key,
 * and OpenGL alone can paint it, at this scale. */
void drawing_set_sketch (Drawing *drawing,
                         const Scene *scene,
                         const Projection *projection,
                         const Theme *theme,
                         double scale);

/* The same of its stock alone, as if nothing were lit. What is lit can be laid
 * over it: lit-drawing.h. */
void drawing_set_stock (Drawing *drawing,
                        const Scene *scene,
                        const Projection *projection,
                        const Theme *theme);

/* Paints strokes and names, without a background. */
void drawing_to_cairo (const Drawing *drawing, cairo_t *cr);

/* For painter*.c: forgets what @drawing held, and takes size and theme.
 * Names are those of @stock, or of an edition of their own when it is NULL. */
void drawing_begin (Drawing *drawing,
                    const Projection *projection,
                    const Theme *theme,
                    const Drawing *stock);

typedef struct HiddenCorners HiddenCorners;
void hidden_corners_free (HiddenCorners *hidden);

/* For painter*.c: begins a stroke; pixels that are added after it are its
 * own, until stroke_end() finds its box. A stroke without pixels is dropped.
 */
Stroke *stroke_begin (Drawing *drawing, StrokeKind kind, uint32_t style);
void stroke_add (Drawing *drawing, Pixel pixel);
void stroke_end (Drawing *drawing);

/* Adds a copy of a stroke of another drawing, with its place, key and style.
 *
 * Returns: the copy, until the next one is added. */
Stroke *
drawing_add_copy (Drawing *drawing, const Drawing *from, const Stroke *stroke);

/* Returns: how far a stroke is painted beyond its pixels at most, px. */
double stroke_reach (const Drawing *drawing, const Stroke *stroke);

/* Returns: whether anything of a stroke may be painted in @box. */
bool stroke_meets (const Drawing *drawing,
                   const Stroke *stroke,
                   const PixelBox *box);

/* Returns: the number of a style. */
uint32_t drawing_add_style (Drawing *drawing, const Style *style);
void drawing_add_name (Drawing *drawing, const PlacedName *placed);

#endif
