#include "gl-painter.h"

#include "gl-atlas.h"
#include "gl-program.h"

#include <epoxy/gl.h>
#include <math.h>
#include <stddef.h>

#define N_SAMPLES 4

G_DEFINE_QUARK (gl - painter - error - quark, gl_painter_error)

struct GlPainter {
  unsigned program, vertex_array, buffers[2]; /* vertices, indices */
  unsigned framebuffer, renderbuffer;         /* with several samples */
  int width, height;                          /* of the renderbuffer */
  int n_samples;
  int size_place, ground_place, names_place; /* of the uniforms */
  GlAtlas *atlas;
  GlBatch batch;
};

static gboolean
is_new_enough (void)
{
  return epoxy_gl_version () >= (epoxy_is_desktop_gl () ? 32 : 30);
}

/* Says where in a vertex its numbers are. */
static void
describe_vertices (void)
{
  static const struct {
    GlAttribute attribute;
    int n;
    unsigned type;
    gboolean is_normalized;
    size_t offset;
  } parts[] = {
    { GL_ATTRIBUTE_AT, 2, GL_FLOAT, FALSE, offsetof (GlVertex, at) },
    { GL_ATTRIBUTE_LOCAL, 3, GL_FLOAT, FALSE, offsetof (GlVertex, local) },
    { GL_ATTRIBUTE_SHAPE, 4, GL_FLOAT, FALSE, offsetof (GlVertex, shape) },
    { GL_ATTRIBUTE_COLOUR, 4, GL_UNSIGNED_BYTE, TRUE,
      offsetof (GlVertex, colour) },
  };
  size_t i;

  for (i = 0; i < G_N_ELEMENTS (parts); i++) {
    glEnableVertexAttribArray (parts[i].attribute);
    glVertexAttribPointer (parts[i].attribute, parts[i].n, parts[i].type,
                           (GLboolean)parts[i].is_normalized, sizeof (GlVertex),
                           (const void *)(uintptr_t)parts[i].offset);
  }
}

static void
make_buffers (GlPainter *painter)
{
  glGenVertexArrays (1, &painter->vertex_array);
  glGenBuffers (2, painter->buffers);
  glBindVertexArray (painter->vertex_array);
  glBindBuffer (GL_ARRAY_BUFFER, painter->buffers[0]);
  glBindBuffer (GL_ELEMENT_ARRAY_BUFFER, painter->buffers[1]);
  describe_vertices ();
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

GlPainter *
gl_painter_new (GError **error)
{
  GlPainter *painter;
  unsigned program;

  if (!is_new_enough ()) {
    g_set_error (error, GL_PAINTER_ERROR, GL_PAINTER_ERROR_VERSION,
                 "OpenGL %d.%d is too old", epoxy_gl_version () / 10,
                 epoxy_gl_version () % 10);
    return NULL;
  }
  forget_errors ();
  program = gl_program_new (error);
  if (program == 0)
    return NULL;
  painter = g_new0 (GlPainter, 1);
  painter->program = program;
  painter->size_place = glGetUniformLocation (program, "size");
  painter->ground_place = glGetUniformLocation (program, "ground");
  painter->names_place = glGetUniformLocation (program, "names");
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
  glDeleteProgram (painter->program);
  glDeleteBuffers (2, painter->buffers);
  glDeleteVertexArrays (1, &painter->vertex_array);
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
  glUseProgram (painter->program);
  glUniform2f (painter->size_place, (float)size[0], (float)size[1]);
  glUniform4f (painter->ground_place, (float)ground.red, (float)ground.green,
               (float)ground.blue, 1);
  glUniform1i (painter->names_place, 0);
  glActiveTexture (GL_TEXTURE0);
  glBindTexture (GL_TEXTURE_2D, gl_atlas_get_texture (painter->atlas));
}

static void
draw (const GlPainter *painter)
{
  const GlBatch *batch = &painter->batch;

  glBindVertexArray (painter->vertex_array);
  glBindBuffer (GL_ARRAY_BUFFER, painter->buffers[0]);
  glBufferData (GL_ARRAY_BUFFER,
                (GLsizeiptr)(batch->n_vertices * sizeof *batch->vertices),
                batch->vertices, GL_STREAM_DRAW);
  glBufferData (GL_ELEMENT_ARRAY_BUFFER,
                (GLsizeiptr)(batch->n_indices * sizeof *batch->indices),
                batch->indices, GL_STREAM_DRAW);
  glDrawElements (GL_TRIANGLES, (int)batch->n_indices, GL_UNSIGNED_INT, NULL);
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
  const bool has_samples = !target->is_rough && painter->n_samples > 1;

  gl_batch_set (&painter->batch, drawing, target->scale);
  gl_atlas_add_names (painter->atlas, &painter->batch, drawing);
  if (has_samples)
    bind_samples (painter, size[0], size[1]);
  else
    glBindFramebuffer (GL_FRAMEBUFFER, target->framebuffer);
  set_state (painter, drawing->theme, size);
  draw (painter);
  if (has_samples)
    resolve (painter, target->framebuffer);
  glBindFramebuffer (GL_FRAMEBUFFER, target->framebuffer);
  return check_frame (error);
}
