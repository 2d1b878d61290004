#include "egl-context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#ifndef EGL_PLATFORM_SURFACELESS_MESA
#define EGL_PLATFORM_SURFACELESS_MESA 0x31DD
#endif

static EGLDisplay display = EGL_NO_DISPLAY;
static EGLContext context = EGL_NO_CONTEXT;
static unsigned texture;

/* The display stays open: what its driver keeps can be told by name only while
 * the driver is there. */
static gboolean
open_display (const char **why)
{
  if (display != EGL_NO_DISPLAY)
    return TRUE;
  if (!epoxy_has_egl_extension (EGL_NO_DISPLAY, "EGL_EXT_platform_base")
      || !epoxy_has_egl_extension (EGL_NO_DISPLAY,
                                   "EGL_MESA_platform_surfaceless")) {
    *why = "EGL has no surfaceless platform";
    return FALSE;
  }
  display = eglGetPlatformDisplayEXT (EGL_PLATFORM_SURFACELESS_MESA,
                                      EGL_DEFAULT_DISPLAY, NULL);
  if (display != EGL_NO_DISPLAY && eglInitialize (display, NULL, NULL))
    return TRUE;
  *why = "EGL cannot be initialized";
  return FALSE;
}

gboolean
egl_context_make (gboolean is_es, const char **why)
{
  const EGLint config_wanted[]
      = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
          is_es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE };
  const EGLint core[] = { EGL_CONTEXT_MAJOR_VERSION,
                          3,
                          EGL_CONTEXT_MINOR_VERSION,
                          2,
                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                          EGL_NONE };
  const EGLint es[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE };
  EGLConfig config;
  EGLint n_configs = 0;

  if (!open_display (why))
    return FALSE;
  eglBindAPI (is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
  if (!eglChooseConfig (display, config_wanted, &config, 1, &n_configs)
      || n_configs == 0) {
    *why = "EGL has no configuration for OpenGL";
    return FALSE;
  }
  context
      = eglCreateContext (display, config, EGL_NO_CONTEXT, is_es ? es : core);
  if (context != EGL_NO_CONTEXT
      && eglMakeCurrent (display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    return TRUE;
  *why = "EGL has no context for OpenGL";
  return FALSE;
}

void
egl_context_drop (void)
{
  eglMakeCurrent (display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext (display, context);
}

unsigned
egl_framebuffer_new (int width, int height)
{
  unsigned framebuffer;

  glGenTextures (1, &texture);
  glBindTexture (GL_TEXTURE_2D, texture);
  glTexImage2D (GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA,
                GL_UNSIGNED_BYTE, NULL);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glGenFramebuffers (1, &framebuffer);
  glBindFramebuffer (GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                          texture, 0);
  return framebuffer;
}

void
egl_framebuffer_free (unsigned framebuffer)
{
  glDeleteFramebuffers (1, &framebuffer);
  glDeleteTextures (1, &texture);
}

/* GL's rows run upwards and its first byte is red. */
cairo_surface_t *
egl_read (unsigned framebuffer, int width, int height)
{
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, width, height);
  const int stride = cairo_image_surface_get_stride (surface);
  g_autofree unsigned char *pixels = g_malloc (4 * (gsize)(width * height));

  glBindFramebuffer (GL_READ_FRAMEBUFFER, framebuffer);
  glReadPixels (0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  cairo_surface_flush (surface);
  for (int y = 0; y < height; y++)
    for (int x = 0; x < width; x++) {
      const unsigned char *from = pixels + 4 * ((height - 1 - y) * width + x);
      guint32 *to = (guint32 *)(void *)(cairo_image_surface_get_data (surface)
                                        + y * stride + 4 * x);

      *to = (guint32)from[0] << 16 | (guint32)from[1] << 8 | from[2];
    }
  cairo_surface_mark_dirty (surface);
  return surface;
}
