#include "gl-view.h"

#include "gl-painter.h"

#include <epoxy/gl.h>
#include <string.h>

struct GlView {
  GtkWidget *widget; /* borrowed */
  GdkWindow *hidden; /* that the context is of; NULL: of the widget's */
  GdkGLContext *context;
  GlPainter *painter;
  unsigned framebuffer, texture;
  int width, height;        /* of the texture, device pixels */
  cairo_surface_t *surface; /* where OpenGL is software: what it has painted */
};

/* One that nobody sees. GDK puts all of a window that has ever had a context
 * on the screen by OpenGL, for each picture: by the processor alone that takes
 * longer than the picture itself. */
static GdkWindow *
hidden_window_new (GtkWidget *widget)
{
  GdkWindowAttr attributes = { .wclass = GDK_INPUT_OUTPUT,
                               .window_type = GDK_WINDOW_TOPLEVEL,
                               .width = 1,
                               .height = 1 };
  GdkScreen *screen = gtk_widget_get_screen (widget);

  return gdk_window_new (gdk_screen_get_root_window (screen), &attributes, 0);
}

/* Returns: the context of a window, current, or NULL with @error set. */
static GdkGLContext *
make_context (GdkWindow *window, GError **error)
{
  GdkGLContext *context = gdk_window_create_gl_context (window, error);

  if (context == NULL)
    return NULL;
  gdk_gl_context_set_required_version (context, 3, 2);
  if (!gdk_gl_context_realize (context, error)) {
    g_object_unref (context);
    return NULL;
  }
  gdk_gl_context_make_current (context);
  return context;
}

static gboolean
is_software (void)
{
  static const char *const names[]
      = { "llvmpipe", "softpipe", "swrast", "SwiftShader", "Software" };
  const char *renderer = (const char *)glGetString (GL_RENDERER);

  for (guint i = 0; renderer != NULL && i < G_N_ELEMENTS (names); i++)
    if (strstr (renderer, names[i]) != NULL)
      return TRUE;
  return FALSE;
}

/* Lets go of a context, and of its window if it is a hidden one. */
static void
drop_context (GdkGLContext *context, GdkWindow *hidden)
{
  gdk_gl_context_clear_current ();
  g_object_unref (context);
  if (hidden != NULL)
    gdk_window_destroy (hidden);
}

gboolean
gl_view_is_software (GtkWidget *widget)
{
  GdkWindow *window = hidden_window_new (widget);
  GdkGLContext *context = make_context (window, NULL);
  gboolean is_soft = FALSE;

  if (context == NULL) {
    gdk_window_destroy (window);
    return FALSE;
  }
  is_soft = is_software ();
  drop_context (context, window);
  return is_soft;
}

gboolean
gl_view_is_slow (const GlView *view)
{
  return view->hidden != NULL;
}

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
  g_clear_pointer (&view->surface, cairo_surface_destroy);
  glBindTexture (GL_TEXTURE_2D, view->texture);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D (GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA,
                GL_UNSIGNED_BYTE, NULL);
  glBindFramebuffer (GL_FRAMEBUFFER, view->framebuffer);
  glFramebufferTexture2D (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                          view->texture, 0);
}

/* Where a graphics processor does the work, pictures stay with it. */
static GdkGLContext *
choose_context (GtkWidget *widget, GdkWindow **hidden, GError **error)
{
  GdkGLContext *context;

  *hidden = hidden_window_new (widget);
  context = make_context (*hidden, error);
  if (context != NULL && is_software ())
    return context;
  if (context != NULL)
    drop_context (context, NULL);
  gdk_window_destroy (*hidden);
  *hidden = NULL;
  return context == NULL ? NULL
                         : make_context (gtk_widget_get_window (widget), error);
}

GlView *
gl_view_new (GtkWidget *widget, GError **error)
{
  GdkWindow *hidden;
  GdkGLContext *context = choose_context (widget, &hidden, error);
  GlPainter *painter;
  GlView *view;

  if (context == NULL)
    return NULL;
  painter = gl_painter_new (error);
  if (painter == NULL) {
    drop_context (context, hidden);
    return NULL;
  }
  view = g_new0 (GlView, 1);
  view->widget = widget;
  view->hidden = hidden;
  view->context = context;
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
  drop_context (view->context, view->hidden);
  g_clear_pointer (&view->surface, cairo_surface_destroy);
  g_free (view);
}

static void
swap_rows (unsigned char *a, unsigned char *b, unsigned char *room, gsize n)
{
  memcpy (room, a, n);
  memcpy (a, b, n);
  memcpy (b, room, n);
}

/* Takes the picture out of OpenGL, whose rows go up. */
static void
read_back (GlView *view)
{
  const int scale = gtk_widget_get_scale_factor (view->widget);
  g_autofree unsigned char *room = NULL;
  unsigned char *data;
  gsize stride;

  if (view->surface == NULL)
    view->surface = cairo_image_surface_create (CAIRO_FORMAT_RGB24, view->width,
                                                view->height);
  cairo_surface_set_device_scale (view->surface, scale, scale);
  cairo_surface_flush (view->surface);
  data = cairo_image_surface_get_data (view->surface);
  stride = (gsize)cairo_image_surface_get_stride (view->surface);
  /* Rows of RGB24 have no room between them. */
  glReadPixels (0, 0, view->width, view->height, GL_BGRA,
                epoxy_is_desktop_gl () ? GL_UNSIGNED_INT_8_8_8_8_REV
                                       : GL_UNSIGNED_BYTE,
                data);
  room = g_malloc (stride);
  for (gsize i = 0, k = (gsize)view->height - 1; i < k; i++, k--)
    swap_rows (data + i * stride, data + k * stride, room, stride);
  cairo_surface_mark_dirty (view->surface);
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
  if (is_painted && view->hidden != NULL)
    read_back (view);
  else
    glFlush ();
  return is_painted;
}

void
gl_view_draw (GlView *view, cairo_t *cr)
{
  if (view->hidden != NULL) {
    cairo_set_source_surface (cr, view->surface, 0, 0);
    cairo_paint (cr);
    return;
  }
  gdk_cairo_draw_from_gl (cr, gtk_widget_get_window (view->widget),
                          (int)view->texture, GL_TEXTURE,
                          gtk_widget_get_scale_factor (view->widget), 0, 0,
                          view->width, view->height);
}
