/* Sketches: what moves and has thousands of strokes, as bare triangles, lines
 * and points. An edge is one line then instead of a quad, each of whose pixels
 * asks how far off the edge is: where the processor does the work of OpenGL,
 * that is three quarters of the time. */
#include "brush.h"
#include "gl-batch.h"
#include "memory.h"

/* Lines are bare up to this width, marks up to this radius; device pixels. */
#define WIDEST 1.5
#define LARGEST 4.0

/* As large as a disc with the radius 1. */
#define SIDE_OF_DISC 1.772453850905516

/* Returns: room for @n vertices more in a run of a kind, which is to be filled.
 */
static GlBareVertex *
grow (GlBatch *batch, GlRunKind kind, uint32_t n)
{
  gl_batch_begin_run (batch, kind);
  if (batch->n_bare + n > batch->bare_room)
    batch->bare = memory_grow (batch->bare, &batch->bare_room,
                               batch->n_bare + n, sizeof *batch->bare);
  batch->runs[batch->n_runs - 1].n += n;
  batch->n_bare += n;
  return &batch->bare[batch->n_bare - n];
}

static void
place (const GlBatch *batch, GlBareVertex *vertex, Pixel at)
{
  vertex->at[0] = (float)(at.x * batch->scale);
  vertex->at[1] = (float)(at.y * batch->scale);
}

void
gl_sketch_polygon (GlBatch *batch,
                   const Pixel *corners,
                   uint32_t n,
                   Colour colour)
{
  GlBareVertex any = { 0 };
  GlCut cut = GL_CUT_INIT;
  uint32_t triangle[3];
  int i;

  gl_batch_bytes (colour, any.colour);
  while (gl_cut_next (&cut, n, triangle)) {
    GlBareVertex *vertices = grow (batch, GL_RUN_TRIANGLES, 3);

    for (i = 0; i < 3; i++) {
      vertices[i] = any;
      place (batch, &vertices[i], corners[triangle[i]]);
    }
  }
}

static bool
add_area (GlBatch *batch,
          const Stroke *stroke,
          const Style *style,
          const Pixel *pixels)
{
  if (style->line.alpha > 0 || style->halo.alpha > 0)
    return false;
  if (stroke->fill.alpha > 0)
    gl_sketch_polygon (batch, pixels, stroke->n, stroke->fill);
  return true;
}

/* A thinner line than a pixel is as much paler. */
static bool
add_line (GlBatch *batch,
          const Stroke *stroke,
          const Style *style,
          const Pixel *pixels)
{
  const double width = style->width * batch->scale;
  GlBareVertex any = { 0 };
  Colour colour = style->line;
  uint32_t i;

  if (style->dash > 0 || style->halo.alpha > 0 || width > WIDEST)
    return false;
  colour.alpha *= width < 1 ? width : 1;
  gl_batch_bytes (colour, any.colour);
  for (i = 0; i + 1 < stroke->n; i++) {
    GlBareVertex *vertices = grow (batch, GL_RUN_LINES, 2);

    vertices[0] = vertices[1] = any;
    place (batch, &vertices[0], pixels[i]);
    place (batch, &vertices[1], pixels[i + 1]);
  }
  return true;
}

static void
add_point (GlBatch *batch, Pixel at, double radius, Colour colour)
{
  GlBareVertex *vertex = grow (batch, GL_RUN_POINTS, 1);

  *vertex = (GlBareVertex){ .side = (float)(SIDE_OF_DISC * radius) };
  gl_batch_bytes (colour, vertex->colour);
  place (batch, vertex, at);
}

static bool
add_mark (GlBatch *batch, const Style *style, Pixel at)
{
  const double reach = brush_mark_reach (style) * batch->scale;

  if (style->mark != MARK_DOT || style->halo.alpha > 0 || reach > LARGEST)
    return false;
  if (style->casing > 0)
    add_point (batch, at, reach, batch->theme->background);
  add_point (batch, at, style->radius * batch->scale, style->line);
  return true;
}

bool
gl_sketch_add (GlBatch *batch,
               const Stroke *stroke,
               const Style *style,
               const Pixel *pixels)
{
  switch (stroke->kind) {
  case STROKE_POLYGON:
    return add_area (batch, stroke, style, pixels);
  case STROKE_LINE:
    return add_line (batch, stroke, style, pixels);
  case STROKE_MARK:
    return add_mark (batch, style, pixels[0]);
  case STROKE_REGION:
  case STROKE_CASING:
  case STROKE_RING:
    return false;
  }
  return false;
}
