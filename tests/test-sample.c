/* The legend's samples show what their marks are known by. */
#include "sight.h"

#include <math.h>

#define WIDTH 30
#define HEIGHT 18

static cairo_surface_t *
paint_item (const Theme *theme, const SceneItem *item)
{
  return sight_paint_sample (theme, item, WIDTH, HEIGHT);
}

static cairo_surface_t *
paint_sample (const Theme *theme, Role role, SceneShape shape)
{
  const SceneItem item
      = { .role = role, .shape = shape, .emphasis = EMPHASIS_NORMAL };

  return paint_item (theme, &item);
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

/* Lines as heavy and as dashed as in the pictures */

#define LINE_PART 0.62 /* of the height is room for a line */
#define INSET 2

/* Returns: which part of a pixel is inked, 0 … 1. */
static double
ink_at (cairo_surface_t *surface, const Theme *theme, Colour line, int x, int y)
{
  const unsigned char *at = cairo_image_surface_get_data (surface)
                            + y * cairo_image_surface_get_stride (surface)
                            + 4 * x;
  const Colour ground = theme->background;
  const double red = line.red - ground.red, green = line.green - ground.green;
  const double blue = line.blue - ground.blue;

  return (red * (at[2] / 255.0 - ground.red)
          + green * (at[1] / 255.0 - ground.green)
          + blue * (at[0] / 255.0 - ground.blue))
         / (red * red + green * green + blue * blue);
}

static double
column_ink (cairo_surface_t *surface, const Theme *theme, Colour line, int x)
{
  double sum = 0;

  for (int y = 0; y < HEIGHT; y++)
    sum += ink_at (surface, theme, line, x, y);
  return sum;
}

/* Returns: px of ink across the line, where there is most. */
static double
width_of (cairo_surface_t *surface, const Theme *theme, Colour line)
{
  double most = 0;

  for (int x = INSET; x < WIDTH - INSET; x++)
    most = MAX (most, column_ink (surface, theme, line, x));
  return most;
}

/* Returns: px of the first dash, or of the first gap after it. */
static double
length_of (cairo_surface_t *surface,
           const Theme *theme,
           const Style *style,
           gboolean is_gap)
{
  const double half = style->width / 2;
  double dash = 0, gap = 0;

  for (int x = 0; x < WIDTH; x++) {
    const double ink = column_ink (surface, theme, style->line, x);

    if (gap >= 1 && ink > half)
      break;
    if (ink > half)
      dash += 1;
    else if (dash > 0)
      gap += 1;
  }
  return is_gap ? gap : dash;
}

/* A dash and the best part of the next one are shown as long as they are. */
static void
check_length (cairo_surface_t *surface, const Theme *theme, const Style *style)
{
  const double dash = length_of (surface, theme, style, FALSE);
  const double gap = length_of (surface, theme, style, TRUE);

  if (fabs (dash - style->dash) > 1 || fabs (gap - style->gap) > 1)
    sight_fault (theme, "dash", (int)style->dash, "sample", dash);
}

static void
check_line (const Theme *theme, const SceneItem *item)
{
  const Style style = theme_style (theme, item);
  const double period = style.dash + style.gap;
  const double wanted = MIN (style.width, LINE_PART * HEIGHT);
  const gboolean is_short = period > (WIDTH - 2 * INSET) / 1.7;
  cairo_surface_t *surface = paint_item (theme, item);
  double width;

  if (style.dash <= 0 || !is_short) {
    width = width_of (surface, theme, style.line);
    if (fabs (width - wanted) > 0.3)
      sight_fault (theme, "width", (int)item->role, "sample", width);
  }
  if (style.dash > 1.5 * style.width && !is_short)
    check_length (surface, theme, &style);
  cairo_surface_destroy (surface);
}

/* But for those that lie between areas, or have ticks. */
static void
check_lines (const Theme *theme)
{
  for (int role = ROLE_VORONOI_EDGE; role < ROLE_LIT; role++)
    for (int emphasis = EMPHASIS_PALE; emphasis <= EMPHASIS_NORMAL;
         emphasis++) {
      const SceneItem item = { .role = (Role)role,
                               .shape = SHAPE_PATH,
                               .emphasis = (Emphasis)emphasis };

      if (role != ROLE_TANGENT_EDGE && role != ROLE_RIDGE
          && role != ROLE_SIGN_NODE && role != ROLE_DROP)
        check_line (theme, &item);
    }
}

static void
test_lines (void)
{
  sight_for_each_theme (check_lines);
}

/* Areas, dark ones on black too, have a border that is seen. */
static void
check_areas (const Theme *theme)
{
  for (int role = ROLE_SHEET; role <= ROLE_PLANE; role++)
    for (int emphasis = EMPHASIS_PALE; emphasis <= EMPHASIS_NORMAL;
         emphasis++) {
      const SceneItem item = { .role = (Role)role,
                               .shape = SHAPE_POLYGON,
                               .emphasis = (Emphasis)emphasis };
      cairo_surface_t *surface;
      double most = 0;

      if (role == ROLE_RETIRED || role == ROLE_SELECTED_FACET
          || role == ROLE_RIM)
        continue;
      surface = paint_item (theme, &item);
      for (int y = 0; y < 4; y++)
        most = MAX (most, contrast_at (surface, theme, WIDTH / 2, y));
      if (most < 2.9)
        sight_fault (theme, "border", role, "sample", most);
      cairo_surface_destroy (surface);
    }
}

static void
test_areas (void)
{
  sight_for_each_theme (check_areas);
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

/* Returns: how many pixels from x = @from to @to stand out. */
static guint
count_ink (cairo_surface_t *surface, const Theme *theme, int from, int to)
{
  guint n = 0;

  for (int y = 0; y < HEIGHT; y++)
    for (int x = from; x < to; x++)
      n += contrast_at (surface, theme, x, y) > 1.6;
  return n;
}

/* A site behind the hull is on it, and smaller. */
static void
check_behind (const Theme *theme)
{
  const SceneItem item = {
    .role = ROLE_SITE, .shape = SHAPE_MARK, .emphasis = EMPHASIS_NORMAL, .n = 2
  };
  cairo_surface_t *surface = paint_item (theme, &item);
  const guint front = count_ink (surface, theme, 0, WIDTH / 2);
  const guint behind = count_ink (surface, theme, WIDTH / 2, WIDTH);

  if (behind < 9 || front <= behind)
    sight_fault (theme, "a site behind the hull", ROLE_SITE, "sample", behind);
  cairo_surface_destroy (surface);
}

static void
test_behind (void)
{
  sight_for_each_theme (check_behind);
}

/* Returns: along the middle, from the left end to the middle, how often ink
 *          begins. */
static guint
count_inks (cairo_surface_t *surface, const Theme *theme)
{
  gboolean is_inked = FALSE;
  guint n = 0;

  for (int x = 0; x <= WIDTH / 2; x++) {
    const double contrast = contrast_at (surface, theme, x, HEIGHT / 2);

    n += !is_inked && contrast > 2.5;
    is_inked = contrast > (is_inked ? 1.6 : 2.5);
  }
  return n;
}

/* Of a hull in the plane. */
static void
check_corner (const Theme *theme)
{
  cairo_surface_t *surface
      = paint_sample (theme, ROLE_HORIZON_CORNER, SHAPE_MARK);
  const guint n = count_inks (surface, theme);

  if (n != 2)
    sight_fault (theme, "corner", ROLE_HORIZON_CORNER, "sample", n);
  cairo_surface_destroy (surface);
}

static void
test_corner (void)
{
  sight_for_each_theme (check_corner);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/sample/dashes-and-dots-have-gaps-between-them",
                   test_dashes);
  g_test_add_func ("/sample/lines-are-as-wide-and-as-dashed-as-in-pictures",
                   test_lines);
  g_test_add_func ("/sample/areas-stand-out-from-the-ground", test_areas);
  g_test_add_func ("/sample/the-paraboloid-has-a-rim-and-wires", test_sheet);
  g_test_add_func ("/sample/sites-on-the-hull-are-before-and-behind-it",
                   test_behind);
  g_test_add_func ("/sample/a-corner-of-the-horizon-is-a-ring-round-a-dot",
                   test_corner);
  return g_test_run ();
}
