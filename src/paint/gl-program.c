#include "gl-program.h"

#include "gl-painter.h"

#include <epoxy/gl.h>

/* Ends each line of the shaders, which are strings by now. */
#define NEWLINE "\n"

#include "bare-fragment.h"
#include "bare-vertex.h"
#include "disc-fragment.h"
#include "disc-vertex.h"
#include "stroke-fragment.h"
#include "stroke-vertex.h"

/* The same shaders for both kinds of GL. */
static const char *
get_prologue (void)
{
  return epoxy_is_desktop_gl () ? "#version 150\n"
                                : "#version 300 es\n"
                                  "precision highp float;\n"
                                  "precision highp int;\n";
}

/* Returns: the shader, or 0 with @error set. */
static unsigned
compile (unsigned kind, const char *source, GError **error)
{
  const char *sources[] = { get_prologue (), source };
  const unsigned shader = glCreateShader (kind);
  int is_compiled = 0;
  char log[512] = "";

  glShaderSource (shader, 2, sources, NULL);
  glCompileShader (shader);
  glGetShaderiv (shader, GL_COMPILE_STATUS, &is_compiled);
  if (is_compiled)
    return shader;
  glGetShaderInfoLog (shader, sizeof log, NULL, log);
  g_set_error (error, GL_PAINTER_ERROR, GL_PAINTER_ERROR_SHADER,
               "a shader does not compile: %s", g_strchomp (log));
  glDeleteShader (shader);
  return 0;
}

static gboolean
link_program (unsigned program, const unsigned shaders[2], GError **error)
{
  int is_linked = 0;
  char log[512] = "";

  glAttachShader (program, shaders[0]);
  glAttachShader (program, shaders[1]);
  glBindAttribLocation (program, GL_ATTRIBUTE_AT, "at");
  glBindAttribLocation (program, GL_ATTRIBUTE_COLOUR, "colour");
  glBindAttribLocation (program, GL_ATTRIBUTE_LOCAL, "local");
  glBindAttribLocation (program, GL_ATTRIBUTE_SHAPE, "shape");
  glBindAttribLocation (program, GL_ATTRIBUTE_RADII, "radii");
  glLinkProgram (program);
  glGetProgramiv (program, GL_LINK_STATUS, &is_linked);
  if (is_linked)
    return TRUE;
  glGetProgramInfoLog (program, sizeof log, NULL, log);
  g_set_error (error, GL_PAINTER_ERROR, GL_PAINTER_ERROR_SHADER,
               "the shaders do not link: %s", g_strchomp (log));
  return FALSE;
}

unsigned
gl_program_new (GlProgramKind kind, GError **error)
{
  static const char *const sources[N_GL_PROGRAMS][2] = {
    [GL_PROGRAM_STROKES] = { stroke_vertex, stroke_fragment },
    [GL_PROGRAM_BARE] = { bare_vertex, bare_fragment },
    [GL_PROGRAM_DISCS] = { disc_vertex, disc_fragment },
  };
  unsigned shaders[2] = { 0, 0 };
  unsigned program = 0;

  shaders[0] = compile (GL_VERTEX_SHADER, sources[kind][0], error);
  if (shaders[0] != 0)
    shaders[1] = compile (GL_FRAGMENT_SHADER, sources[kind][1], error);
  if (shaders[1] != 0) {
    program = glCreateProgram ();
    if (!link_program (program, shaders, error)) {
      glDeleteProgram (program);
      program = 0;
    }
  }
  /* The program keeps what it needs of them. */
  glDeleteShader (shaders[0]);
  glDeleteShader (shaders[1]);
  return program;
}
