/* Marks in a picture. */
#include "painter.h"
#include "sight.h"
#include "stage.h"

#include <math.h>

#define SIDE 500 /* px, of a picture */
#define NEAR 30  /* px */

static Colour
colour_at (cairo_surface_t *surface, Pixel place)
{
  const unsigned char *at
      = cairo_image_surface_get_data (surface)
        + (int)place.y * cairo_image_surface_get_stride (surface)
        + 4 * (int)place.x;

  return (Colour){ at[2] / 255.0, at[1] / 255.0, at[0] / 255.0, 1 };
}

static cairo_surface_t *
paint (const Stage *stage, const Theme *theme)
{
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, SIDE, SIDE);
  cairo_t *cr = cairo_create (surface);

  painter_paint (cr, &stage->plane, &stage->on_plane, theme, 0);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

/* Whether a site is so near a vertex that it may be seen through it. */
static gboolean
has_site (const Stage *stage, Pixel at)
{
  for (guint i = 0; i < stage->plane.n_items; i++) {
    const SceneItem *item = &stage->plane.items[i];
    const Pixel site
        = stage_pixel (&stage->on_plane, stage->plane.points[item->first]);

    if (item->role >= ROLE_SITE && item->role <= ROLE_SITE_IGNORED
        && hypot (site.x - at.x, site.y - at.y) < NEAR)
      return TRUE;
  }
  return FALSE;
}

/* Returns: how many vertices that die are seen with no site below; each has
 *          its own ground inside. */
static guint
check_grounds (const Stage *stage, const Theme *theme)
{
  cairo_surface_t *surface = paint (stage, theme);
  guint n = 0;

  for (guint i = 0; i < stage->plane.n_items; i++) {
    const SceneItem *item = &stage->plane.items[i];
    const Pixel at
        = stage_pixel (&stage->on_plane, stage->plane.points[item->first]);
    const Colour ground = theme_style (theme, item).fill;

    if (item->role != ROLE_VORONOI_VERTEX_DYING || at.x < 1 || at.y < 1
        || at.x > SIDE - 1 || at.y > SIDE - 1 || has_site (stage, at))
      continue;
    g_assert_cmpfloat (
        sight_distance (colour_at (surface, at), ground, sight_visions[0]), <,
        0.01);
    n++;
  }
  cairo_surface_destroy (surface);
  return n;
}

static void
test_grounds (void)
{
  guint n = 0;

  for (guint round = 2; round <= 4; round++) {
    g_autoptr (Stage) stage = stage_new ("lecture8", round, PHASE_CONE);

    for (int kind = 0; kind < N_THEMES; kind++)
      n += check_grounds (stage, theme_get ((ThemeKind)kind));
  }
  g_assert_cmpuint (n, >=, N_THEMES);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/painter-mark/no-line-is-seen-inside-a-vertex",
                   test_grounds);
  return g_test_run ();
}
