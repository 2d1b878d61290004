/* OpenGL without a screen, for the tests and the bench of the GL painter. */
#ifndef EGL_CONTEXT_H
#define EGL_CONTEXT_H

#include <cairo.h>
#include <glib.h>

/* Makes a context current: OpenGL 3.2 core, or OpenGL ES 3.
 *
 * Returns: FALSE with the reason in *@why. */
gboolean egl_context_make (gboolean is_es, const char **why);
void egl_context_drop (void);

/* A framebuffer of so many pixels; 0 when GL refuses. */
unsigned egl_framebuffer_new (int width, int height);
void egl_framebuffer_free (unsigned framebuffer);

/* Returns: (transfer full): what is in the framebuffer. */
cairo_surface_t *egl_read (unsigned framebuffer, int width, int height);

#endif
