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

typedef struct GlBatch {
  GlVertex *vertices;
  uint32_t n_vertices, vertices_room;
  uint32_t *indices; /* three for each triangle */
  uint32_t n_indices, indices_room;
  Bare bare;    /* of a sketch, each before the index that is next */
  double scale; /* device pixels per px */
  const Theme *theme;
  uint32_t n_hard; /* indices up to the last area: only areas have edges that
                      the shader does not soften */
  bool is_sketch;  /* of the drawing: areas are bare */
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

/* Joins the last @n vertices as a convex polygon. */
void gl_batch_join (GlBatch *batch, uint32_t n);

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
