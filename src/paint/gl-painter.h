/* The GL painter: drawings through OpenGL 3.2 or OpenGL ES 3.0. It owns no
 * context: one is current whenever it is called, the same one always.
 *
 *   GlPainter *painter = gl_painter_new (&error);
 *
 *   if (!gl_painter_paint (painter, drawing, &target, &error))
 *     … paint with something else …
 */
#ifndef GL_PAINTER_H
#define GL_PAINTER_H

#include "drawing.h"

#include <glib.h>

typedef struct GlPainter GlPainter;

#define GL_PAINTER_ERROR (gl_painter_error_quark ())
GQuark gl_painter_error_quark (void);
typedef enum GlPainterError {
  GL_PAINTER_ERROR_VERSION, /* the context is too old */
  GL_PAINTER_ERROR_SHADER,  /* does not compile or link */
  GL_PAINTER_ERROR_FRAME,   /* GL failed while a picture was painted */
  GL_PAINTER_ERROR_LOST,    /* the context is no more */
} GlPainterError;

/* Returns: NULL with @error set when the context cannot be used. */
GlPainter *gl_painter_new (GError **error);
void gl_painter_free (GlPainter *painter);

/* What is painted on. */
typedef struct GlTarget {
  unsigned framebuffer; /* as large as the drawing times the scale */
  double scale;         /* device pixels per px */
  bool is_rough;        /* something moves: one sample per pixel. Drawings are
                           best sketches then: drawing_set_sketch() */
} GlTarget;

/* Paints the background, the strokes and the names. The layers of a scene are
 * nested convex surfaces in the order of paint: there is no depth buffer.
 *
 * Returns: false with @error set; then the painter is of no use any more. */
bool gl_painter_paint (GlPainter *painter,
                       const Drawing *drawing,
                       const GlTarget *target,
                       GError **error);

#endif
