/* The strokes of a drawing as triangles for GL, in the order of paint. Their
 * pixels are those that the other painters have; what a stroke looks like
 * across its width is left to the shader (ui/shaders/stroke-fragment.glsl).
 */
#ifndef GL_BATCH_H
#define GL_BATCH_H

#include "drawing.h"

/* What the shader makes of local and shape. */
typedef enum GlKind {
  GL_KIND_FLAT,   /* neither */
  GL_KIND_SQUARE, /* line with square ends: local is the place along, across,
                     and the length; shape half the width, dash, gap */
  GL_KIND_ROUND,  /* the same with round ends */
  GL_KIND_DISC,   /* local is the place from the middle, shape the inner and
                     the outer radius */
  GL_KIND_HATCH,  /* local is the place and the step, shape the normal and
                     half the width */
  GL_KIND_NAME,   /* local is the place in the atlas */
} GlKind;

typedef struct GlVertex {
  float at[2]; /* device pixels, y down */
  float local[3];
  float shape[4];          /* the last one is the GlKind */
  unsigned char colour[4]; /* premultiplied */
} GlVertex;

/* A vertex of something that is all of one colour. */
typedef struct GlBareVertex {
  float at[2];
  float side; /* of the square that a point is */
  unsigned char colour[4];
} GlBareVertex;

/* What is drawn in one go. */
typedef enum GlRunKind {
  GL_RUN_STROKES,   /* indices; the other ones are bare vertices: */
  GL_RUN_TRIANGLES, /* three for each, */
  GL_RUN_LINES,     /* two for each, a pixel wide, */
  GL_RUN_POINTS,    /* one for each */
} GlRunKind;

typedef struct GlRun {
  GlRunKind kind;
  uint32_t first, n; /* of indices or bare vertices */
} GlRun;

typedef struct GlBatch {
  GlVertex *vertices;
  uint32_t n_vertices, vertices_room;
  uint32_t *indices; /* three for each triangle */
  uint32_t n_indices, indices_room;
  GlBareVertex *bare;
  uint32_t n_bare, bare_room;
  GlRun *runs; /* in the order of paint */
  uint32_t n_runs, runs_room;
  double scale; /* device pixels per px */
  const Theme *theme;
  bool is_sketch; /* of the drawing: bare where that hardly shows */
} GlBatch;

void gl_batch_clear (GlBatch *batch);

/* Fills @batch anew with the strokes of @drawing. */
void gl_batch_set (GlBatch *batch, const Drawing *drawing, double scale);

/* What all vertices of a shape have in common. */
typedef struct GlInk {
  Colour colour;
  float shape[3];
  GlKind kind;
} GlInk;

/* Adds a vertex; @at in device pixels. */
void
gl_batch_add (GlBatch *batch, const GlInk *ink, Pixel at, const float local[3]);

/* The way through a convex polygon that is cut into triangles: every other
 * corner is cut off, and again, until none is left. Triangles that all met in
 * one corner would be splinters, which take long to fill. */
typedef struct GlCut {
  uint32_t first, step;
} GlCut;

#define GL_CUT_INIT ((GlCut){ 0, 1 })

/* Returns: false: the polygon of @n corners is cut up. */
bool gl_cut_next (GlCut *cut, uint32_t n, uint32_t triangle[3]);

/* Joins the last @n vertices as a convex polygon. */
void gl_batch_join (GlBatch *batch, uint32_t n);

/* What is added next is drawn so. */
void gl_batch_begin_run (GlBatch *batch, GlRunKind kind);

/* Sketches (gl-sketch.c). Adds a stroke as bare triangles, lines or a point.
 *
 * Returns: false when it needs more than that. */
bool gl_sketch_add (GlBatch *batch,
                    const Stroke *stroke,
                    const Style *style,
                    const Pixel *pixels);

/* The same of a convex polygon. */
void gl_sketch_polygon (GlBatch *batch,
                        const Pixel *corners,
                        uint32_t n,
                        Colour colour);

/* Premultiplies. */
void gl_batch_bytes (Colour colour, unsigned char bytes[4]);

/* Fills a convex polygon; corners in px. */
void
gl_batch_fill (GlBatch *batch, const Pixel *corners, uint32_t n, Colour colour);

/* Fills a STROKE_REGION. */
void
gl_batch_region (GlBatch *batch, const Stroke *stroke, const Pixel *pixels);

/* How a line is drawn, device pixels. */
typedef struct GlLine {
  Colour colour;
  double width, dash, gap;
  bool has_round_ends, is_closed;
} GlLine;

/* Adds a line of @n pixels, px; its joins are round. */
void gl_batch_line (GlBatch *batch,
                    const GlLine *line,
                    const Pixel *pixels,
                    uint32_t n);

/* Adds what lies between two circles round @at, px. */
void
gl_batch_disc (GlBatch *batch, Pixel at, const double radii[2], Colour colour);

#endif
