#include "picture.h"

#include <glib.h>

#define SIDE 480.0
#define FRAME_INSET 6.0 /* from the border of the picture to the plane's */

void
picture_init (Picture *picture, PictureView view, const Frame *frame)
{
  *picture = (Picture){ .view = view,
                        .width = view == PICTURE_BOTH ? 2 * SIDE : SIDE,
                        .height = SIDE,
                        .scale = 1,
                        .theme = theme_get (THEME_LIGHT) };
  scene_look_init (&picture->look, frame);
  camera_init (&picture->camera, CAMERA_HOME);
  plane_camera_init (&picture->plane_camera);
}

bool
picture_has_good_size (const Picture *picture)
{
  const double width = picture->width * picture->scale;
  const double height = picture->height * picture->scale;

  return width >= 1 && height >= 1 && width <= PICTURE_MOST
         && height <= PICTURE_MOST;
}

static Projection
project (const Picture *picture, bool is_space, double width)
{
  const Camera camera = camera_raised (&picture->camera, picture->look.raise);

  return is_space ? camera_projection (&camera, width, picture->height)
                  : plane_camera_projection (&picture->plane_camera, width,
                                             picture->height);
}

static void
fill (const Picture *picture,
      const Frame *frame,
      int pane,
      const SceneLook *look,
      Scene *scene)
{
  if (picture->fill != NULL)
    picture->fill (scene, pane, look, picture->fill_user);
  else if (pane == 0)
    scene_plane (scene, frame, look);
  else
    scene_space (scene, frame, look);
}

static void
paint_pane (const Picture *picture,
            const Frame *frame,
            int pane,
            cairo_t *cr,
            double width)
{
  const bool is_space
      = picture->fill != NULL ? picture->is_space[pane] : pane == 1;
  const Projection projection = project (picture, is_space, width);
  SceneLook look = picture->look;
  Scene scene = { 0 };

  if (!is_space)
    scene_look_fit (&look, &projection, FRAME_INSET);
  fill (picture, frame, pane, &look, &scene);
  painter_paint (cr, &scene, &projection, picture->theme, PAINTER_CLEAR);
  scene_clear (&scene);
}

static void
paint_background (const Picture *picture, cairo_t *cr)
{
  const Colour colour = picture->theme->background;

  cairo_set_source_rgb (cr, colour.red, colour.green, colour.blue);
  cairo_rectangle (cr, 0, 0, picture->width, picture->height);
  cairo_fill (cr);
}

/* Each half is clipped: without, far marks of one view would stand in the
 * other. */
static void
paint_both (const Picture *picture, const Frame *frame, cairo_t *cr)
{
  const double half = picture->width / 2;
  int i;

  for (i = 0; i < 2; i++) {
    cairo_save (cr);
    cairo_rectangle (cr, i * half, 0, half, picture->height);
    cairo_clip (cr);
    cairo_translate (cr, i * half, 0);
    paint_pane (picture, frame, i, cr, half);
    cairo_restore (cr);
  }
}

void
picture_paint (const Picture *picture, const Frame *frame, cairo_t *cr)
{
  if (!picture->is_transparent)
    paint_background (picture, cr);
  switch (picture->view) {
  case PICTURE_PLANE:
    paint_pane (picture, frame, 0, cr, picture->width);
    break;
  case PICTURE_SPACE:
    paint_pane (picture, frame, 1, cr, picture->width);
    break;
  case PICTURE_BOTH:
    paint_both (picture, frame, cr);
    break;
  }
}

bool
picture_format_of (const char *path, PictureFormat *format)
{
  static const char *const endings[] = { ".svg", ".pdf", ".png" };
  g_autofree char *lower = g_ascii_strdown (path, -1);
  int i;

  for (i = 0; i <= PICTURE_PNG; i++) {
    if (!g_str_has_suffix (lower, endings[i]))
      continue;
    *format = (PictureFormat)i;
    return true;
  }
  return false;
}
