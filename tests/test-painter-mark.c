/* Marks in a picture. */
#include "drawing.h"
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

/* Returns: how many marks of a drawing are no item's own, less those of
 *          vertices that die. */
static int
count_lone_grounds (const Stage *stage, Names *names)
{
  Drawing *drawing = drawing_new (names);
  int n = 0;

  drawing_set (drawing, &stage->space, &stage->on_space,
               theme_get (THEME_LIGHT));
  for (guint i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];

    if (stroke->kind != STROKE_MARK)
      continue;
    n += stroke->place.item == INDEX_NONE;
    n -= stroke->place.item != INDEX_NONE
         && stage->space.items[stroke->place.item].role
                == ROLE_VORONOI_VERTEX_DYING;
  }
  drawing_free (drawing);
  return n;
}

/* On the ground of space the vertices of a crowd are too small to be seen. */
static void
test_crowd (void)
{
  Names *names = names_new ();
  guint n_dying = 0;

  for (guint round = 4; round <= 64; round *= 2) {
    Fixture *fixture = fixture_new (FAMILY_RANDOM, 5, 1000, ORDER_FURTHEST);
    uint32_t step;
    Stage *stage;

    g_assert_true (timeline_find (fixture->trace, (Place){ round, PHASE_CONE },
                                  false, &step));
    stage = stage_take (fixture, step);
    n_dying += stage_count (&stage->space, ROLE_VORONOI_VERTEX_DYING);
    g_assert_cmpint (count_lone_grounds (stage, names), ==, 0);
    stage_free (stage);
  }
  g_assert_cmpuint (n_dying, >, 4);
  names_free (names);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/painter-mark/no-line-is-seen-inside-a-vertex",
                   test_grounds);
  g_test_add_func ("/painter-mark/no-vertex-has-a-ground-alone", test_crowd);
  return g_test_run ();
}
