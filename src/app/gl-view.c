#include "gl-view.h"

#include "gl-painter.h"

#include <epoxy/gl.h>
#include <string.h>

struct GlView {
  GtkWidget *widget; /* borrowed */
  GdkGLContext *context;
  GlPainter *painter;
  unsigned framebuffer, texture;
  int width, height; /* of the texture, device pixels */
};

static void
make_target (GlView *view)
{
  glGenTextures (1, &view->texture);
  glGenFramebuffers (1, &view->framebuffer);
}

/* Makes the texture as large as the widget. */
static void
fit_target (GlView *view)
{
  const int scale = gtk_widget_get_scale_factor (view->widget);
  const int width = scale * gtk_widget_get_allocated_width (view->widget);
  const int height = scale * gtk_widget_get_allocated_height (view->widget);

  if (view->width == width && view->height == height)
    return;
  view->width = width;
  view->height = height;
  glBindTexture (GL_TEXTURE_2D, view->texture);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D (GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA,
                GL_UNSIGNED_BYTE, NULL);
  glBindFramebuffer (GL_FRAMEBUFFER, view->framebuffer);
  glFramebufferTexture2D (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                          view->texture, 0);
}

GlView *
gl_view_new (GtkWidget *widget, GError **error)
{
  g_autoptr (GdkGLContext) context
      = gdk_window_create_gl_context (gtk_widget_get_window (widget), error);
  GlPainter *painter;
  GlView *view;

  if (context == NULL)
    return NULL;
  gdk_gl_context_set_required_version (context, 3, 2);
  if (!gdk_gl_context_realize (context, error))
    return NULL;
  gdk_gl_context_make_current (context);
  painter = gl_painter_new (error);
  if (painter == NULL)
    return NULL;
  view = g_new0 (GlView, 1);
  view->widget = widget;
  view->context = g_steal_pointer (&context);
  view->painter = painter;
  make_target (view);
  return view;
}

void
gl_view_free (GlView *view)
{
  if (view == NULL)
    return;
  gdk_gl_context_make_current (view->context);
  gl_painter_free (view->painter);
  glDeleteFramebuffers (1, &view->framebuffer);
  glDeleteTextures (1, &view->texture);
  gdk_gl_context_clear_current ();
  g_object_unref (view->context);
  g_free (view);
}

static gboolean
is_software (const char *renderer)
{
  static const char *const names[]
      = { "llvmpipe", "softpipe", "swrast", "SwiftShader", "Software" };

  for (guint i = 0; renderer != NULL && i < G_N_ELEMENTS (names); i++)
    if (strstr (renderer, names[i]) != NULL)
      return TRUE;
  return FALSE;
}

/* Asked on a window that nobody sees: GDK puts all of a window that has ever
 * had a context on the screen by OpenGL, for each picture. */
gboolean
gl_view_is_software (GtkWidget *widget)
{
  GdkWindowAttr attributes = { .wclass = GDK_INPUT_OUTPUT,
                               .window_type = GDK_WINDOW_TOPLEVEL,
                               .width = 1,
                               .height = 1 };
  GdkScreen *screen = gtk_widget_get_screen (widget);
  GdkWindow *window
      = gdk_window_new (gdk_screen_get_root_window (screen), &attributes, 0);
  GdkGLContext *context = gdk_window_create_gl_context (window, NULL);
  gboolean is_soft = FALSE;

  if (context != NULL && gdk_gl_context_realize (context, NULL)) {
    gdk_gl_context_make_current (context);
    is_soft = is_software ((const char *)glGetString (GL_RENDERER));
    gdk_gl_context_clear_current ();
  }
  g_clear_object (&context);
  gdk_window_destroy (window);
  return is_soft;
}

gboolean
gl_view_paint (GlView *view,
               const Drawing *drawing,
               gboolean is_rough,
               GError **error)
{
  const GlTarget target = { .framebuffer = view->framebuffer,
                            .scale = gtk_widget_get_scale_factor (view->widget),
                            .is_rough = is_rough };
  gboolean is_painted;

  gdk_gl_context_make_current (view->context);
  fit_target (view);
  is_painted = gl_painter_paint (view->painter, drawing, &target, error);
  glFlush ();
  return is_painted;
}

void
gl_view_draw (GlView *view, cairo_t *cr)
{
  gdk_cairo_draw_from_gl (cr, gtk_widget_get_window (view->widget),
                          (int)view->texture, GL_TEXTURE,
                          gtk_widget_get_scale_factor (view->widget), 0, 0,
                          view->width, view->height);
}
