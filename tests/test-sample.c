/* The legend's samples show what their marks are known by. */
#include "brush.h"
#include "painter.h"
#include "sight.h"

#define WIDTH 30
#define HEIGHT 18

static cairo_surface_t *
paint_sample (const Theme *theme, Role role, SceneShape shape)
{
  const SceneItem item
      = { .role = role, .shape = shape, .emphasis = EMPHASIS_NORMAL };
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, WIDTH, HEIGHT);
  cairo_t *cr = cairo_create (surface);

  brush_colour (cr, theme->background);
  cairo_paint (cr);
  painter_swatch (cr, &item, theme, WIDTH, HEIGHT);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

/* Returns: how a pixel stands out from the background. */
static double
contrast_at (cairo_surface_t *surface, const Theme *theme, int x, int y)
{
  const unsigned char *at = cairo_image_surface_get_data (surface)
                            + y * cairo_image_surface_get_stride (surface)
                            + 4 * x;
  const Colour colour = { at[2] / 255.0, at[1] / 255.0, at[0] / 255.0, 1 };

  return sight_contrast (colour, theme->background);
}

/* Returns: how many dashes lie along the middle, each with ground after it. */
static guint
count_dashes (cairo_surface_t *surface, const Theme *theme)
{
  gboolean is_inked = FALSE;
  guint n = 0;

  for (int x = 0; x < WIDTH; x++) {
    const double contrast = contrast_at (surface, theme, x, HEIGHT / 2);

    if (is_inked && contrast < 1.6) {
      is_inked = FALSE;
      n++;
    } else if (contrast > 2.5)
      is_inked = TRUE;
  }
  return n;
}

/* Only lines: they lie along the middle. */
static void
check_dashes (const Theme *theme)
{
  for (int role = ROLE_FURTHEST_EDGE; role <= ROLE_DROP; role++) {
    const Style style = sight_style (theme, (Role)role);
    cairo_surface_t *surface;
    guint n;

    if (!(style.dash > 0))
      continue;
    surface = paint_sample (theme, (Role)role, SHAPE_PATH);
    n = count_dashes (surface, theme);
    if (n < 2)
      sight_fault (theme, "dashes", role, "sample", n);
    cairo_surface_destroy (surface);
  }
}

static void
test_dashes (void)
{
  sight_for_each_theme (check_dashes);
}

/* The sheet itself is hardly to be seen. */
static void
check_sheet (const Theme *theme)
{
  cairo_surface_t *surface = paint_sample (theme, ROLE_SHEET, SHAPE_PATH);
  guint n_rim = 0, n_wires = 0;

  for (int y = 0; y < HEIGHT; y++)
    for (int x = 0; x < WIDTH; x++) {
      const double contrast = contrast_at (surface, theme, x, y);
      const gboolean is_inside
          = x > 3 && x < WIDTH - 4 && y > 3 && y < HEIGHT - 4;

      n_rim += !is_inside && contrast >= 2;
      n_wires += is_inside && contrast >= 1.3;
    }
  if (n_rim < 60)
    sight_fault (theme, "rim", ROLE_SHEET, "sample", n_rim);
  if (n_wires < 12)
    sight_fault (theme, "wires", ROLE_SHEET, "sample", n_wires);
  cairo_surface_destroy (surface);
}

static void
test_sheet (void)
{
  sight_for_each_theme (check_sheet);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/sample/dashes-and-dots-have-gaps-between-them",
                   test_dashes);
  g_test_add_func ("/sample/the-paraboloid-has-a-rim-and-wires", test_sheet);
  return g_test_run ();
}
