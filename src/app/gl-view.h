/* A view painted by OpenGL: a context of the widget's own window and a texture
 * that is put where cairo would paint. GtkGLArea does the same in a widget of
 * its own; here the canvas stays the one widget that has the pointer, the
 * keyboard and the accessible children. */
#ifndef GL_VIEW_H
#define GL_VIEW_H

#include "drawing.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

typedef struct GlView GlView;

/* For a widget that is realized, until it is unrealized.
 *
 * Returns: NULL with @error set when OpenGL is not to be had. */
GlView *gl_view_new (GtkWidget *widget, GError **error);
void gl_view_free (GlView *view);

/* Whether OpenGL is made by the processor alone where @widget is: then the
 * raster is faster. */
gboolean gl_view_is_software (GtkWidget *widget);

/* The same of a view that is there. */
gboolean gl_view_is_slow (const GlView *view);

/* Paints the drawing anew; roughly while something moves.
 *
 * Returns: FALSE with @error set; then the view is of no use any more. */
gboolean gl_view_paint (GlView *view,
                        const Drawing *drawing,
                        gboolean is_rough,
                        GError **error);

/* Puts the picture on the window, or on any other surface. */
void gl_view_draw (GlView *view, cairo_t *cr);

G_END_DECLS

#endif
