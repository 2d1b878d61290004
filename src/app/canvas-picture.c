#include "canvas-picture.h"

#include "easel.h"
#include "gl-view.h"

/* A picture by OpenGL that takes longer than this is painted roughly while
 * something moves. */
#define SLOW_US 12000

/* So many items, 1 500 sites with all layers, take OpenGL too long at rest
 * where the processor alone does its work; with six times as many a sketch
 * takes as long as the raster's whole picture. */
#define MANY_ITEMS 30000

/* What a picture is made with, and for what. */
struct PictureWork {
  Easel *easel;
  Names *names; /* for OpenGL */
  Drawing *drawing;
  gboolean is_for_gl, is_rough;
  gboolean is_software; /* OpenGL is */
  Projection projection;
  Theme theme;
  int scale;
  cairo_region_t *region; /* that the easel has painted */
};

struct CanvasPicture {
  GtkWidget *widget; /* borrowed */
  gboolean may_use_gl;
  gboolean is_valid, is_painted;
  PictureWork *tools;       /* NULL: lent */
  cairo_surface_t *surface; /* of the easel's picture, where the window is */
  GlView *gl;               /* NULL: the easel paints */
  gboolean is_by_gl;        /* what is shown */
  gboolean is_rough;
  gint64 cost_us; /* of the last picture by OpenGL at full quality */
};

static PictureWork *
tools_new (void)
{
  PictureWork *tools = g_new0 (PictureWork, 1);

  tools->easel = easel_new ();
  tools->names = names_new_apart ();
  tools->drawing = drawing_new (tools->names);
  return tools;
}

void
picture_work_free (PictureWork *work)
{
  if (work == NULL)
    return;
  easel_free (work->easel);
  drawing_free (work->drawing);
  names_free (work->names);
  g_clear_pointer (&work->region, cairo_region_destroy);
  g_free (work);
}

/* Those that are there, or new ones. */
static PictureWork *
get_tools (CanvasPicture *picture)
{
  if (picture->tools == NULL)
    picture->tools = tools_new ();
  return picture->tools;
}

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
  return picture;
}

void
canvas_picture_free (CanvasPicture *picture)
{
  if (picture == NULL)
    return;
  canvas_picture_release (picture);
  picture_work_free (picture->tools);
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
  picture->is_valid = picture->is_painted = FALSE;
  g_clear_pointer (&picture->surface, cairo_surface_destroy);
  g_clear_pointer (&picture->gl, gl_view_free);
}

static gpointer
throw_away (gpointer work)
{
  picture_work_free (work);
  return NULL;
}

void
canvas_picture_forget (CanvasPicture *picture)
{
  if (picture->tools != NULL)
    g_thread_unref (g_thread_new ("throw-away", throw_away,
                                  g_steal_pointer (&picture->tools)));
}

/* The picture is kept where it is shown from: to send it there each time the
 * pointer moves would cost more than to paint what has changed. */
static void
send (CanvasPicture *picture, cairo_surface_t *from, const PictureWork *work)
{
  const int scale = work->scale;
  const int width = cairo_image_surface_get_width (from) / scale;
  const int height = cairo_image_surface_get_height (from) / scale;
  cairo_t *cr;

  if (picture->surface == NULL)
    picture->surface = gdk_window_create_similar_surface (
        gtk_widget_get_window (picture->widget), CAIRO_CONTENT_COLOR, width,
        height);
  cr = cairo_create (picture->surface);
  cairo_scale (cr, 1.0 / scale, 1.0 / scale);
  gdk_cairo_region (cr, work->region);
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

/* Shows what the easel has painted. */
static void
show_easel (CanvasPicture *picture, PictureWork *work)
{
  cairo_surface_t *from = easel_get_surface (work->easel);
  cairo_rectangle_int_t all = { 0 };

  /* Another size, or another window: nothing of it is there yet. */
  if (picture->surface == NULL || is_whole (from, work->region)) {
    g_clear_pointer (&picture->surface, cairo_surface_destroy);
    all.width = cairo_image_surface_get_width (from);
    all.height = cairo_image_surface_get_height (from);
    cairo_region_union_rectangle (work->region, &all);
  }
  if (!cairo_region_is_empty (work->region))
    send (picture, from, work);
  picture->is_rough = picture->is_by_gl = FALSE;
}

/* Returns: FALSE with @error set when OpenGL is not to be had. Software is
 *          taken only when it is asked for. */
static gboolean
choose (CanvasPicture *picture, GError **error)
{
  if (!picture->may_use_gl || picture->gl != NULL)
    return TRUE;
  if (g_strcmp0 (wanted_renderer (), "gl") != 0
      && gl_view_is_software (picture->widget)) {
    picture->may_use_gl = FALSE;
    return TRUE;
  }
  picture->gl = gl_view_new (picture->widget, error);
  picture->may_use_gl = picture->gl != NULL;
  return picture->may_use_gl;
}

static gboolean
show_gl (CanvasPicture *picture, const PictureWork *work, GError **error)
{
  const gint64 start = g_get_monotonic_time ();

  picture->is_rough = work->is_rough;
  picture->is_by_gl = TRUE;
  if (!gl_view_paint (picture->gl, work->drawing, work->is_rough, error)) {
    g_clear_pointer (&picture->gl, gl_view_free);
    picture->may_use_gl = FALSE;
    return FALSE;
  }
  if (!picture->is_rough)
    picture->cost_us = g_get_monotonic_time () - start;
  return TRUE;
}

PictureWork *
canvas_picture_lend (CanvasPicture *picture,
                     const Projection *projection,
                     const Theme *theme,
                     gboolean is_moving,
                     GError **error)
{
  PictureWork *work;

  choose (picture, error);
  get_tools (picture);
  work = g_steal_pointer (&picture->tools);
  work->is_for_gl = picture->gl != NULL;
  work->is_software = work->is_for_gl && gl_view_is_slow (picture->gl);
  work->is_rough = work->is_for_gl && is_moving
                   && (work->is_software || picture->cost_us > SLOW_US);
  work->projection = *projection;
  work->theme = *theme;
  work->scale = gtk_widget_get_scale_factor (picture->widget);
  return work;
}

void
picture_work_do (PictureWork *work, const Scene *scene)
{
  if (work->is_software && scene->stock.n_items >= MANY_ITEMS)
    work->is_for_gl = work->is_rough = FALSE;
  if (work->is_rough) {
    drawing_set_sketch (work->drawing, scene, &work->projection, &work->theme,
                        work->scale);
    return;
  }
  if (work->is_for_gl) {
    drawing_set (work->drawing, scene, &work->projection, &work->theme);
    return;
  }
  work->region = easel_paint (work->easel, scene, &work->projection,
                              &work->theme, work->scale);
}

void
picture_work_prepare (PictureWork *work)
{
  if (!work->is_for_gl)
    easel_prepare_light (work->easel);
}

gboolean
canvas_picture_take_back (CanvasPicture *picture,
                          PictureWork *work,
                          gboolean is_up_to_date,
                          GError **error)
{
  gboolean is_shown = TRUE;

  picture_work_free (picture->tools);
  picture->tools = work;
  /* Where the window has gone, or OpenGL, nothing can be shown: once more. */
  is_up_to_date = is_up_to_date && (!work->is_for_gl || picture->gl != NULL)
                  && gtk_widget_get_realized (picture->widget);
  if (gtk_widget_get_realized (picture->widget)) {
    if (!work->is_for_gl)
      show_easel (picture, work);
    else if (picture->gl != NULL)
      is_shown = show_gl (picture, work, error);
  }
  g_clear_pointer (&work->region, cairo_region_destroy);
  picture->is_valid = is_up_to_date && is_shown;
  picture->is_painted = picture->is_painted || picture->is_valid;
  return is_shown;
}

gboolean
canvas_picture_has_stock (const CanvasPicture *picture,
                          const Scene *scene,
                          const Projection *projection,
                          const Theme *theme)
{
  const int scale = gtk_widget_get_scale_factor (picture->widget);

  return !picture->is_by_gl && picture->tools != NULL
         && easel_has_stock (picture->tools->easel, scene, projection, theme,
                             scale);
}

/* What OpenGL cannot paint, the easel does. */
gboolean
canvas_picture_update (CanvasPicture *picture,
                       const Scene *scene,
                       const Projection *projection,
                       const Theme *theme,
                       gboolean is_moving,
                       GError **error)
{
  PictureWork *work;
  gboolean is_as_wished;

  if (picture->is_valid)
    return TRUE;
  work = canvas_picture_lend (picture, projection, theme, is_moving, error);
  is_as_wished = error == NULL || *error == NULL;
  picture_work_do (work, scene);
  if (!canvas_picture_take_back (picture, work, TRUE, error)) {
    is_as_wished = FALSE;
    work = canvas_picture_lend (picture, projection, theme, is_moving, NULL);
    picture_work_do (work, scene);
    canvas_picture_take_back (picture, work, TRUE, NULL);
  }
  return is_as_wished;
}

gboolean
canvas_picture_draw (CanvasPicture *picture, cairo_t *cr)
{
  if (picture->is_by_gl && picture->gl != NULL && picture->is_painted) {
    gl_view_draw (picture->gl, cr);
    return TRUE;
  }
  if (picture->surface == NULL)
    return FALSE;
  cairo_set_source_surface (cr, picture->surface, 0, 0);
  cairo_paint (cr);
  return TRUE;
}
