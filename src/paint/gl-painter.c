#include "gl-painter.h"

#include "gl-atlas.h"
#include "gl-program.h"

#include <epoxy/gl.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#define N_SAMPLES 4

#define LONG_RUN 4000 /* vertices that are worth being sent at once */

G_DEFINE_QUARK (gl - painter - error - quark, gl_painter_error)

/* A program and the places of its uniforms; -1: it has no such one. */
typedef struct Program {
  unsigned number;
  int size_place, ground_place, names_place;
} Program;

struct GlPainter {
  Program programs[N_GL_PROGRAMS];
  unsigned vertex_arrays[2], buffers[2]; /* of GlVertex and BareVertex */
  unsigned index_buffer;                 /* for the first one */
  unsigned framebuffer, renderbuffer;    /* with several samples */
  int width, height;                     /* of the renderbuffer */
  int n_samples;
  GlAtlas *atlas;
  GlBatch batch;
};

static gboolean
is_new_enough (void)
{
  return epoxy_gl_version () >= (epoxy_is_desktop_gl () ? 32 : 30);
}

/* Where in a vertex some of its numbers are. */
typedef struct VertexPart {
  GlAttribute attribute;
  int n;
  unsigned type;
  gboolean is_normalized;
  size_t offset;
} VertexPart;

static void
make_array (GlPainter *painter, int i, const VertexPart *parts, size_t stride)
{
  glBindVertexArray (painter->vertex_arrays[i]);
  glBindBuffer (GL_ARRAY_BUFFER, painter->buffers[i]);
  for (; parts->n > 0; parts++) {
    glEnableVertexAttribArray (parts->attribute);
    glVertexAttribPointer (parts->attribute, parts->n, parts->type,
                           (GLboolean)parts->is_normalized, (int)stride,
                           (const void *)(uintptr_t)parts->offset);
  }
}

static void
make_buffers (GlPainter *painter)
{
  static const VertexPart parts[] = {
    { GL_ATTRIBUTE_AT, 2, GL_FLOAT, FALSE, offsetof (GlVertex, at) },
    { GL_ATTRIBUTE_LOCAL, 3, GL_FLOAT, FALSE, offsetof (GlVertex, local) },
    { GL_ATTRIBUTE_SHAPE, 4, GL_FLOAT, FALSE, offsetof (GlVertex, shape) },
    { GL_ATTRIBUTE_COLOUR, 4, GL_UNSIGNED_BYTE, TRUE,
      offsetof (GlVertex, colour) },
    { 0 },
  };
  static const VertexPart bare_parts[] = {
    { GL_ATTRIBUTE_AT, 2, GL_FLOAT, FALSE, offsetof (BareVertex, at) },
    { GL_ATTRIBUTE_RADII, 2, GL_FLOAT, FALSE, offsetof (BareVertex, radii) },
    { GL_ATTRIBUTE_COLOUR, 4, GL_UNSIGNED_BYTE, TRUE,
      offsetof (BareVertex, colour) },
    { 0 },
  };

  glGenVertexArrays (2, painter->vertex_arrays);
  glGenBuffers (2, painter->buffers);
  glGenBuffers (1, &painter->index_buffer);
  make_array (painter, 0, parts, sizeof (GlVertex));
  glBindBuffer (GL_ELEMENT_ARRAY_BUFFER, painter->index_buffer);
  make_array (painter, 1, bare_parts, sizeof (BareVertex));
  glBindVertexArray (0);
  glGenFramebuffers (1, &painter->framebuffer);
  glGenRenderbuffers (1, &painter->renderbuffer);
  glGetIntegerv (GL_MAX_SAMPLES, &painter->n_samples);
  painter->n_samples = MIN (painter->n_samples, N_SAMPLES);
}

static void
forget_errors (void)
{
  int i;

  /* A lost context may have no end of them. */
  for (i = 0; i < 16 && glGetError () != GL_NO_ERROR; i++)
    continue;
}

static gboolean
make_programs (Program *programs, GError **error)
{
  for (int i = 0; i < N_GL_PROGRAMS; i++) {
    const unsigned number = gl_program_new ((GlProgramKind)i, error);

    if (number == 0)
      return FALSE;
    programs[i] = (Program){ number, glGetUniformLocation (number, "size"),
                             glGetUniformLocation (number, "ground"),
                             glGetUniformLocation (number, "names") };
  }
  return TRUE;
}

static void
delete_programs (const Program *programs)
{
  for (int i = 0; i < N_GL_PROGRAMS; i++)
    glDeleteProgram (programs[i].number);
}

GlPainter *
gl_painter_new (GError **error)
{
  Program programs[N_GL_PROGRAMS] = { 0 };
  GlPainter *painter;

  if (!is_new_enough ()) {
    g_set_error (error, GL_PAINTER_ERROR, GL_PAINTER_ERROR_VERSION,
                 "OpenGL %d.%d is too old", epoxy_gl_version () / 10,
                 epoxy_gl_version () % 10);
    return NULL;
  }
  forget_errors ();
  if (!make_programs (programs, error)) {
    delete_programs (programs);
    return NULL;
  }
  painter = g_new0 (GlPainter, 1);
  memcpy (painter->programs, programs, sizeof programs);
  make_buffers (painter);
  painter->atlas = gl_atlas_new ();
  return painter;
}

void
gl_painter_free (GlPainter *painter)
{
  if (painter == NULL)
    return;
  gl_atlas_free (painter->atlas);
  delete_programs (painter->programs);
  glDeleteBuffers (2, painter->buffers);
  glDeleteBuffers (1, &painter->index_buffer);
  glDeleteVertexArrays (2, painter->vertex_arrays);
  glDeleteFramebuffers (1, &painter->framebuffer);
  glDeleteRenderbuffers (1, &painter->renderbuffer);
  gl_batch_clear (&painter->batch);
  g_free (painter);
}

/* The framebuffer with several samples per pixel, of the wanted size. */
static void
bind_samples (GlPainter *painter, int width, int height)
{
  glBindFramebuffer (GL_FRAMEBUFFER, painter->framebuffer);
  if (painter->width == width && painter->height == height)
    return;
  painter->width = width;
  painter->height = height;
  glBindRenderbuffer (GL_RENDERBUFFER, painter->renderbuffer);
  glRenderbufferStorageMultisample (GL_RENDERBUFFER, painter->n_samples,
                                    GL_RGBA8, width, height);
  glFramebufferRenderbuffer (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                             GL_RENDERBUFFER, painter->renderbuffer);
}

static void
resolve (const GlPainter *painter, unsigned framebuffer)
{
  const int width = painter->width, height = painter->height;

  glBindFramebuffer (GL_READ_FRAMEBUFFER, painter->framebuffer);
  glBindFramebuffer (GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer (0, 0, width, height, 0, 0, width, height,
                     GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

static void
set_state (const GlPainter *painter, const Theme *theme, const int size[2])
{
  const Colour ground = theme->background;

  glViewport (0, 0, size[0], size[1]);
  glDisable (GL_SCISSOR_TEST);
  glDisable (GL_DEPTH_TEST);
  glDisable (GL_CULL_FACE);
  glDepthMask (GL_FALSE);
  glEnable (GL_BLEND);
  glBlendFunc (GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glClearColor ((float)ground.red, (float)ground.green, (float)ground.blue, 1);
  glClear (GL_COLOR_BUFFER_BIT);
  for (int i = 0; i < N_GL_PROGRAMS; i++) {
    const Program *program = &painter->programs[i];

    /* What a program does not have, at -1, is passed over. */
    glUseProgram (program->number);
    glUniform2f (program->size_place, (float)size[0], (float)size[1]);
    glUniform4f (program->ground_place, (float)ground.red, (float)ground.green,
                 (float)ground.blue, 1);
    glUniform1i (program->names_place, 0);
  }
  /* OpenGL ES has it always so. */
  if (epoxy_is_desktop_gl ())
    glEnable (GL_PROGRAM_POINT_SIZE);
  glActiveTexture (GL_TEXTURE0);
  glBindTexture (GL_TEXTURE_2D, gl_atlas_get_texture (painter->atlas));
}

static void
use (const GlPainter *painter, GlProgramKind kind)
{
  glUseProgram (painter->programs[kind].number);
  glBindVertexArray (painter->vertex_arrays[kind != GL_PROGRAM_STROKES]);
}

static void
draw_run (const GlPainter *painter, const BareRun *run)
{
  static const unsigned modes[] = { [BARE_TRIANGLES] = GL_TRIANGLES,
                                    [BARE_LINES] = GL_LINES,
                                    [BARE_DISCS] = GL_POINTS };

  use (painter, run->kind == BARE_DISCS ? GL_PROGRAM_DISCS : GL_PROGRAM_BARE);
  glDrawArrays (modes[run->kind], (int)run->first, (int)run->n);
}

/* Draws the strokes whose indices are @from … @to - 1. */
static void
draw_strokes (const GlPainter *painter, uint32_t from, uint32_t to)
{
  const uintptr_t offset = from * sizeof *painter->batch.indices;

  if (from == to)
    return;
  use (painter, GL_PROGRAM_STROKES);
  glDrawElements (GL_TRIANGLES, (int)(to - from), GL_UNSIGNED_INT,
                  (const void *)offset);
}

static void
fill_buffer (unsigned target, unsigned buffer, const void *from, size_t n_bytes)
{
  glBindBuffer (target, buffer);
  glBufferData (target, (GLsizeiptr)n_bytes, from, GL_STREAM_DRAW);
}

static void
fill_buffers (const GlPainter *painter)
{
  const GlBatch *batch = &painter->batch;
  const Bare *bare = &batch->bare;

  glBindVertexArray (painter->vertex_arrays[0]);
  fill_buffer (GL_ARRAY_BUFFER, painter->buffers[0], batch->vertices,
               batch->n_vertices * sizeof *batch->vertices);
  fill_buffer (GL_ELEMENT_ARRAY_BUFFER, painter->index_buffer, batch->indices,
               batch->n_indices * sizeof *batch->indices);
  fill_buffer (GL_ARRAY_BUFFER, painter->buffers[1], bare->vertices,
               bare->n_vertices * sizeof *bare->vertices);
}

static void
draw_sketch (const GlPainter *painter)
{
  const Bare *bare = &painter->batch.bare;
  uint32_t i, drawn = 0;

  for (i = 0; i < bare->n_runs; i++) {
    draw_strokes (painter, drawn, bare->runs[i].place.before);
    drawn = bare->runs[i].place.before;
    draw_run (painter, &bare->runs[i]);
    /* Let it be painted while the next one is told. */
    if (bare->runs[i].n >= LONG_RUN)
      glFlush ();
  }
  draw_strokes (painter, drawn, painter->batch.n_indices);
}

/* Several samples a pixel are there for the edges of areas. What comes after
 * the last of them takes half of the time without. */
static void
draw_finely (const GlPainter *painter, unsigned framebuffer)
{
  const GlBatch *batch = &painter->batch;

  draw_strokes (painter, 0, batch->n_hard);
  resolve (painter, framebuffer);
  glBindFramebuffer (GL_FRAMEBUFFER, framebuffer);
  draw_strokes (painter, batch->n_hard, batch->n_indices);
}

static void
clear_state (void)
{
  glBindVertexArray (0);
  glBindBuffer (GL_ARRAY_BUFFER, 0);
  glUseProgram (0);
}

static bool
is_context_lost (void)
{
  const gboolean can_tell = epoxy_is_desktop_gl () ? epoxy_gl_version () >= 45
                                                   : epoxy_gl_version () >= 32;

  return can_tell && glGetGraphicsResetStatus () != GL_NO_ERROR;
}

static bool
check_frame (GError **error)
{
  const unsigned code = glGetError ();

  if (is_context_lost ()) {
    g_set_error (error, GL_PAINTER_ERROR, GL_PAINTER_ERROR_LOST,
                 "the graphics context was lost");
    return false;
  }
  if (code == GL_NO_ERROR)
    return true;
  g_set_error (error, GL_PAINTER_ERROR, GL_PAINTER_ERROR_FRAME,
               "OpenGL error 0x%04x", code);
  forget_errors ();
  return false;
}

bool
gl_painter_paint (GlPainter *painter,
                  const Drawing *drawing,
                  const GlTarget *target,
                  GError **error)
{
  const int size[2] = { (int)ceil (drawing->width * target->scale),
                        (int)ceil (drawing->height * target->scale) };
  const bool has_samples
      = !target->is_rough && !drawing->is_sketch && painter->n_samples > 1;

  gl_batch_set (&painter->batch, drawing, target->scale);
  gl_atlas_add_names (painter->atlas, &painter->batch, drawing);
  if (has_samples)
    bind_samples (painter, size[0], size[1]);
  else
    glBindFramebuffer (GL_FRAMEBUFFER, target->framebuffer);
  set_state (painter, drawing->theme, size);
  fill_buffers (painter);
  if (has_samples)
    draw_finely (painter, target->framebuffer);
  else
    draw_sketch (painter);
  clear_state ();
  glBindFramebuffer (GL_FRAMEBUFFER, target->framebuffer);
  return check_frame (error);
}
