/* The programs of the GL painter, from ui/shaders. */
#ifndef GL_PROGRAM_H
#define GL_PROGRAM_H

#include <glib.h>

/* Places of the vertices' numbers. */
typedef enum GlAttribute {
  GL_ATTRIBUTE_AT,
  GL_ATTRIBUTE_COLOUR,
  GL_ATTRIBUTE_LOCAL,
  GL_ATTRIBUTE_SHAPE,
  GL_ATTRIBUTE_SIDE,
} GlAttribute;

/* What a program paints. */
typedef enum GlProgramKind {
  GL_PROGRAM_STROKES, /* GlVertex */
  GL_PROGRAM_BARE,    /* GlBareVertex */
} GlProgramKind;

#define N_GL_PROGRAMS (GL_PROGRAM_BARE + 1)

/* Returns: the program, or 0 with @error set. */
unsigned gl_program_new (GlProgramKind kind, GError **error);

#endif
