/* The program of the GL painter, from ui/shaders. */
#ifndef GL_PROGRAM_H
#define GL_PROGRAM_H

#include <glib.h>

/* Places of the vertices' numbers. */
typedef enum GlAttribute {
  GL_ATTRIBUTE_AT,
  GL_ATTRIBUTE_COLOUR,
  GL_ATTRIBUTE_LOCAL,
  GL_ATTRIBUTE_SHAPE,
} GlAttribute;

/* Returns: the program, or 0 with @error set. */
unsigned gl_program_new (GError **error);

#endif
