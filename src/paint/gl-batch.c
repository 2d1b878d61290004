#include "gl-batch.h"

#include "brush.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

void
gl_batch_clear (GlBatch *batch)
{
  free (batch->vertices);
  free (batch->indices);
  bare_clear (&batch->bare);
  memset (batch, 0, sizeof *batch);
}

void
gl_batch_add (GlBatch *batch, const GlInk *ink, Pixel at, const float local[3])
{
  GlVertex vertex = {
    .at = { (float)at.x, (float)at.y },
    .local = { local[0], local[1], local[2] },
    .shape = { ink->shape[0], ink->shape[1], ink->shape[2], (float)ink->kind },
  };

  bare_bytes (ink->colour, vertex.colour);
  if (batch->n_vertices == batch->vertices_room)
    batch->vertices
        = memory_grow (batch->vertices, &batch->vertices_room,
                       batch->n_vertices + 1, sizeof *batch->vertices);
  batch->vertices[batch->n_vertices++] = vertex;
}

static void
add_index (GlBatch *batch, uint32_t vertex)
{
  if (batch->n_indices == batch->indices_room)
    batch->indices = memory_grow (batch->indices, &batch->indices_room,
                                  batch->n_indices + 1, sizeof *batch->indices);
  batch->indices[batch->n_indices++] = vertex;
}

void
gl_batch_join (GlBatch *batch, uint32_t n)
{
  const uint32_t first = batch->n_vertices - n;
  BareCut cut = BARE_CUT_INIT;
  uint32_t triangle[3];
  int i;

  while (bare_cut_next (&cut, n, triangle))
    for (i = 0; i < 3; i++)
      add_index (batch, first + triangle[i]);
}

static void
add_polygon (GlBatch *batch,
             const GlInk *ink,
             const Pixel *corners,
             uint32_t n,
             float step)
{
  uint32_t i;

  for (i = 0; i < n; i++) {
    const float local[3] = { (float)corners[i].x, (float)corners[i].y, step };

    gl_batch_add (
        batch, ink,
        (Pixel){ corners[i].x * batch->scale, corners[i].y * batch->scale },
        local);
  }
  gl_batch_join (batch, n);
  batch->n_hard = batch->n_indices;
}

static BarePlace
here (const GlBatch *batch)
{
  return (BarePlace){ batch->n_indices, 0 };
}

void
gl_batch_fill (GlBatch *batch, const Pixel *corners, uint32_t n, Colour colour)
{
  const GlInk ink = { .colour = colour, .kind = GL_KIND_FLAT };

  if (!(colour.alpha > 0))
    return;
  if (batch->is_sketch)
    bare_polygon (&batch->bare, here (batch), corners, n, batch->scale, colour);
  else
    add_polygon (batch, &ink, corners, n, 0);
}

/* The shader draws the strokes, in px: their places are those of the other
 * painters, whole multiples of the step. */
static void
hatch_polygon (GlBatch *batch,
               const Style *style,
               const Pixel *corners,
               uint32_t n)
{
  HatchDirection directions[2];
  const int n_directions
      = brush_hatch_directions (style, batch->theme, directions);
  int i;

  for (i = 0; i < n_directions; i++) {
    const HatchDirection *direction = &directions[i];
    const GlInk ink
        = { .colour = style->line,
            .shape = { (float)direction->normal[0], (float)direction->normal[1],
                       (float)(style->hatch_width / 2) },
            .kind = GL_KIND_HATCH };

    add_polygon (batch, &ink, corners, n, (float)direction->step);
  }
}

static Colour
faded (Colour colour, double alpha)
{
  colour.alpha *= alpha;
  return colour;
}

static GlLine
line_of (const GlBatch *batch, const Style *style)
{
  return (GlLine){ .colour = style->line,
                   .width = style->width * batch->scale,
                   .dash = style->dash * batch->scale,
                   .gap = style->gap * batch->scale,
                   .has_round_ends = brush_has_round_ends (style) };
}

static void
add_line (GlBatch *batch,
          const Style *style,
          const Pixel *pixels,
          uint32_t n,
          bool is_closed)
{
  GlLine line = line_of (batch, style);
  Colour colour;

  if (batch->is_sketch && bare_line_colour (style, batch->scale, &colour)) {
    bare_path (&batch->bare, here (batch), pixels, n, is_closed, batch->scale,
               colour);
    return;
  }
  line.is_closed = is_closed;
  if (style->halo.alpha > 0) {
    GlLine halo = line;

    halo.colour = faded (style->halo, BRUSH_HALO_ALPHA);
    halo.width += 2 * style->halo_width * batch->scale;
    halo.dash = 0;
    gl_batch_line (batch, &halo, pixels, n);
  }
  gl_batch_line (batch, &line, pixels, n);
}

static void
add_casing (GlBatch *batch, const Style *style, const Pixel *pixels, uint32_t n)
{
  const GlLine casing = { .colour = batch->theme->background,
                          .width = style->casing * batch->scale,
                          .has_round_ends = true };

  gl_batch_line (batch, &casing, pixels, n);
}

static void
add_halo (GlBatch *batch, const Style *style, const Pixel *corners, uint32_t n)
{
  const GlLine outline
      = { .colour = style->halo,
          .width = BRUSH_HALO_OUTLINE * style->halo_width * batch->scale,
          .is_closed = true };

  gl_batch_fill (batch, corners, n, faded (style->halo, BRUSH_HALO_FILL_ALPHA));
  gl_batch_line (batch, &outline, corners, n);
}

static void
add_area (GlBatch *batch,
          const Style *style,
          const Stroke *stroke,
          const Pixel *corners)
{
  gl_batch_fill (batch, corners, stroke->n, stroke->fill);
  if (style->line.alpha > 0)
    hatch_polygon (batch, style, corners, stroke->n);
  if (style->halo.alpha > 0)
    add_halo (batch, style, corners, stroke->n);
  if (style->width > 0 && style->line.alpha > 0)
    add_line (batch, style, corners, stroke->n, true);
}

/* Marks */

void
gl_batch_disc (GlBatch *batch, Pixel at, const double radii[2], Colour colour)
{
  static const float corners[4][2]
      = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
  const double reach = radii[1] * batch->scale + 1;
  const GlInk ink = { .colour = colour,
                      .shape = { (float)(radii[0] * batch->scale),
                                 (float)(radii[1] * batch->scale), 0 },
                      .kind = GL_KIND_DISC };
  int i;

  for (i = 0; i < 4; i++) {
    const double x = corners[i][0] * reach, y = corners[i][1] * reach;
    const float local[3] = { (float)x, (float)y, 0 };

    gl_batch_add (batch, &ink,
                  (Pixel){ at.x * batch->scale + x, at.y * batch->scale + y },
                  local);
  }
  gl_batch_join (batch, 4);
}

static void
fill_disc (GlBatch *batch, Pixel at, double radius, Colour colour)
{
  gl_batch_disc (batch, at, (double[2]){ -1, radius }, colour);
}

static void
stroke_disc (GlBatch *batch, Pixel at, double radius, const Style *style)
{
  const double half = style->width / 2;

  gl_batch_disc (batch, at, (double[2]){ radius - half, radius + half },
                 style->line);
}

/* A site may lie under it: its casing is no more than an outline. */
static void
add_diamond (GlBatch *batch, const Style *style, Pixel at)
{
  const double r = style->radius;
  const Pixel corners[4] = { { at.x, at.y - r },
                             { at.x + r, at.y },
                             { at.x, at.y + r },
                             { at.x - r, at.y } };
  const GlLine outline = { .colour = style->line,
                           .width = style->width * batch->scale,
                           .is_closed = true };
  GlLine casing = outline;

  casing.colour = batch->theme->background;
  casing.width += 2 * style->casing * batch->scale;
  if (style->casing > 0)
    gl_batch_line (batch, &casing, corners, 4);
  gl_batch_fill (batch, corners, 4, style->fill);
  gl_batch_line (batch, &outline, corners, 4);
}

static void
add_cross (GlBatch *batch, const Style *style, Pixel at)
{
  const double r = style->radius;
  const Pixel falling[2] = { { at.x - r, at.y - r }, { at.x + r, at.y + r } };
  const Pixel rising[2] = { { at.x - r, at.y + r }, { at.x + r, at.y - r } };
  int i;

  for (i = 0; i < 2; i++) {
    const GlLine line
        = { .colour = i == 0 ? style->fill : style->line,
            .width = (style->width + (i == 0 ? 2 : 0)) * batch->scale,
            .has_round_ends = true };

    gl_batch_line (batch, &line, falling, 2);
    gl_batch_line (batch, &line, rising, 2);
  }
}

static void
add_mark (GlBatch *batch, const Style *style, Pixel at)
{
  const double edge = brush_mark_reach (style);
  const bool has_halo = style->halo.alpha > 0;

  if (has_halo)
    fill_disc (batch, at, edge, style->halo);
  if (style->casing > 0 && style->mark != MARK_DIAMOND)
    fill_disc (batch, at, edge - (has_halo ? style->halo_width : 0),
               batch->theme->background);
  switch (style->mark) {
  case MARK_NONE:
    break;
  case MARK_DOT:
    fill_disc (batch, at, style->radius, style->line);
    break;
  case MARK_RINGED:
    stroke_disc (batch, at, style->radius + style->ring_gap, style);
    fill_disc (batch, at, style->radius, style->fill);
    stroke_disc (batch, at, style->radius - 0.6, style);
    break;
  case MARK_HOLLOW:
    fill_disc (batch, at, style->radius, style->fill);
    stroke_disc (batch, at, style->radius, style);
    break;
  case MARK_DIAMOND:
    add_diamond (batch, style, at);
    break;
  case MARK_CROSSED:
    add_cross (batch, style, at);
    break;
  }
}

/* Adds what is bare before a stroke, from *@run on. */
static void
add_bare (GlBatch *batch, const Bare *bare, uint32_t stroke, uint32_t *run)
{
  for (; *run < bare->n_runs && bare->runs[*run].place.before <= stroke; ++*run)
    bare_copy (&batch->bare, here (batch), bare, &bare->runs[*run]);
}

void
gl_batch_set (GlBatch *batch, const Drawing *drawing, double scale)
{
  uint32_t i, run = 0;

  batch->n_vertices = batch->n_indices = batch->n_hard = 0;
  bare_begin (&batch->bare);
  batch->scale = scale;
  batch->is_sketch = drawing->is_sketch;
  batch->theme = drawing->theme;
  for (i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Pixel *pixels = &drawing->pixels[stroke->first];
    const Style *style = &drawing->styles[stroke->style];

    add_bare (batch, &drawing->bare, i, &run);
    switch (stroke->kind) {
    case STROKE_POLYGON:
      add_area (batch, style, stroke, pixels);
      break;
    case STROKE_REGION:
      gl_batch_region (batch, stroke, pixels);
      break;
    case STROKE_CASING:
      add_casing (batch, style, pixels, stroke->n);
      break;
    case STROKE_LINE:
      add_line (batch, style, pixels, stroke->n, false);
      break;
    case STROKE_RING:
      add_line (batch, style, pixels, stroke->n, true);
      break;
    case STROKE_MARK:
      add_mark (batch, style, pixels[0]);
      break;
    }
  }
  add_bare (batch, &drawing->bare, i, &run);
}
