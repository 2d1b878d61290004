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
  GL_ATTRIBUTE_RADII,
} GlAttribute;

/* What a program paints. */
typedef enum GlProgramKind {
  GL_PROGRAM_STROKES, /* GlVertex */
  GL_PROGRAM_BARE,    /* BareVertex: triangles and lines, */
  GL_PROGRAM_DISCS,   /* discs */
} GlProgramKind;

#define N_GL_PROGRAMS (GL_PROGRAM_DISCS + 1)

/* Returns: the program, or 0 with @error set. */
unsigned gl_program_new (GlProgramKind kind, GError **error);

#endif
