#include "canvas-picture.h"

#include "easel.h"
#include "gl-view.h"

/* A picture by OpenGL that takes longer than this is painted roughly while
 * something moves. */
#define SLOW_US 12000

struct CanvasPicture {
  GtkWidget *widget; /* borrowed */
  gboolean may_use_gl;
  gboolean is_valid;
  Easel *easel;
  cairo_surface_t *surface; /* of the easel's picture, where the window is */
  GlView *gl;               /* NULL: the easel paints */
  Names *names;             /* for OpenGL */
  Drawing *drawing;
  Theme theme;
  gboolean is_rough;
  gint64 cost_us; /* of the last picture by OpenGL at full quality */
};

static const char *
wanted_renderer (void)
{
  return g_getenv ("HULL2VD_RENDERER");
}

CanvasPicture *
canvas_picture_new (GtkWidget *widget, gboolean may_use_gl)
{
  CanvasPicture *picture = g_new0 (CanvasPicture, 1);

  picture->widget = widget;
  picture->may_use_gl
      = may_use_gl && g_strcmp0 (wanted_renderer (), "cairo") != 0;
  picture->easel = easel_new ();
  picture->names = names_new ();
  picture->drawing = drawing_new (picture->names);
  return picture;
}

void
canvas_picture_free (CanvasPicture *picture)
{
  if (picture == NULL)
    return;
  canvas_picture_release (picture);
  easel_free (picture->easel);
  drawing_free (picture->drawing);
  names_free (picture->names);
  g_free (picture);
}

void
canvas_picture_invalidate (CanvasPicture *picture)
{
  picture->is_valid = FALSE;
}

gboolean
canvas_picture_is_valid (const CanvasPicture *picture)
{
  return picture->is_valid;
}

gboolean
canvas_picture_is_rough (const CanvasPicture *picture)
{
  return picture->is_rough;
}

void
canvas_picture_release (CanvasPicture *picture)
{
  picture->is_valid = FALSE;
  g_clear_pointer (&picture->surface, cairo_surface_destroy);
  g_clear_pointer (&picture->gl, gl_view_free);
}

/* The picture is kept where it is shown from: to send it there each time the
 * pointer moves would cost more than to paint what has changed. */
static void
send (CanvasPicture *picture, const cairo_region_t *region, int scale)
{
  cairo_surface_t *from = easel_get_surface (picture->easel);
  const int width = cairo_image_surface_get_width (from) / scale;
  const int height = cairo_image_surface_get_height (from) / scale;
  cairo_t *cr;

  if (picture->surface == NULL)
    picture->surface = gdk_window_create_similar_surface (
        gtk_widget_get_window (picture->widget), CAIRO_CONTENT_COLOR, width,
        height);
  cr = cairo_create (picture->surface);
  cairo_scale (cr, 1.0 / scale, 1.0 / scale);
  gdk_cairo_region (cr, region);
  cairo_clip (cr);
  cairo_scale (cr, scale, scale);
  cairo_set_source_surface (cr, from, 0, 0);
  cairo_paint (cr);
  cairo_destroy (cr);
}

static gboolean
is_whole (cairo_surface_t *surface, const cairo_region_t *region)
{
  cairo_rectangle_int_t box;

  cairo_region_get_extents (region, &box);
  return box.width == cairo_image_surface_get_width (surface)
         && box.height == cairo_image_surface_get_height (surface)
         && cairo_region_num_rectangles (region) == 1;
}

static void
update_easel (CanvasPicture *picture,
              const Scene *scene,
              const Projection *projection,
              const Theme *theme)
{
  const int scale = gtk_widget_get_scale_factor (picture->widget);
  cairo_region_t *region
      = easel_paint (picture->easel, scene, projection, theme, scale);
  cairo_rectangle_int_t all = { 0 };

  /* Another size, or another window: nothing of it is there yet. */
  if (picture->surface == NULL
      || is_whole (easel_get_surface (picture->easel), region)) {
    cairo_surface_t *surface = easel_get_surface (picture->easel);

    g_clear_pointer (&picture->surface, cairo_surface_destroy);
    all.width = cairo_image_surface_get_width (surface);
    all.height = cairo_image_surface_get_height (surface);
    cairo_region_union_rectangle (region, &all);
  }
  if (!cairo_region_is_empty (region))
    send (picture, region, scale);
  cairo_region_destroy (region);
  picture->is_rough = FALSE;
}

/* Returns: FALSE with @error set when OpenGL is not to be had. Software is
 *          taken only when it is asked for. */
static gboolean
choose (CanvasPicture *picture, GError **error)
{
  if (!picture->may_use_gl || picture->gl != NULL)
    return TRUE;
  picture->gl = gl_view_new (picture->widget, error);
  if (picture->gl == NULL) {
    picture->may_use_gl = FALSE;
    return FALSE;
  }
  if (g_strcmp0 (wanted_renderer (), "gl") != 0
      && gl_view_is_software (picture->gl)) {
    g_clear_pointer (&picture->gl, gl_view_free);
    picture->may_use_gl = FALSE;
  }
  return TRUE;
}

static gboolean
update_gl (CanvasPicture *picture, gboolean is_moving, GError **error)
{
  const gint64 start = g_get_monotonic_time ();

  picture->is_rough = is_moving && picture->cost_us > SLOW_US;
  if (!gl_view_paint (picture->gl, picture->drawing, picture->is_rough,
                      error)) {
    g_clear_pointer (&picture->gl, gl_view_free);
    picture->may_use_gl = FALSE;
    return FALSE;
  }
  if (!picture->is_rough)
    picture->cost_us = g_get_monotonic_time () - start;
  return TRUE;
}

gboolean
canvas_picture_update (CanvasPicture *picture,
                       const Scene *scene,
                       const Projection *projection,
                       const Theme *theme,
                       gboolean is_moving,
                       GError **error)
{
  gboolean is_as_wished = TRUE;

  if (picture->is_valid)
    return TRUE;
  is_as_wished = choose (picture, error);
  if (picture->gl != NULL) {
    picture->theme = *theme;
    drawing_set (picture->drawing, scene, projection, &picture->theme);
    is_as_wished = update_gl (picture, is_moving, error);
  }
  if (picture->gl == NULL)
    update_easel (picture, scene, projection, theme);
  picture->is_valid = TRUE;
  return is_as_wished;
}

void
canvas_picture_draw (CanvasPicture *picture, cairo_t *cr)
{
  if (picture->gl != NULL) {
    gl_view_draw (picture->gl, cr);
    return;
  }
  cairo_set_source_surface (cr, picture->surface, 0, 0);
  cairo_paint (cr);
}
