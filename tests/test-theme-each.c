/* What single themes promise, and all of them of quiet marks. */
#include "sight.h"

#define MARK_CONTRAST_HIGH 7.0 /* Source: WCAG 2.1, 1.4.6, that of text */
#define PALE_CONTRAST_HIGH 4.5 /* Source: WCAG 2.1, 1.4.3, that of text */

static void
test_high_contrast_is_higher (void)
{
  const Theme *theme = theme_get (THEME_CONTRAST);
  int role;

  g_assert_cmpfloat (sight_contrast (theme->text, theme->background), >=, 15);
  for (role = ROLE_SELECTED_FACET; role < ROLE_FACET_NAME; role++) {
    const Colour line = theme->styles[role].line;
    const double value = sight_contrast (line, theme->background);

    if (line.alpha > 0 && value < MARK_CONTRAST_HIGH)
      g_error ("role %d: %g", role, value);
    if (line.alpha > 0
        && sight_contrast (theme->pale_lines[role], theme->background)
               < PALE_CONTRAST_HIGH)
      g_error ("pale role %d", role);
  }
}

static gboolean
is_grey (Colour c)
{
  return c.alpha <= 0 || (c.red == c.green && c.green == c.blue);
}

static void
test_print_is_grey (void)
{
  const Theme *theme = theme_get (THEME_PRINT);
  int role;

  g_assert_true (is_grey (theme->background) && is_grey (theme->text)
                 && is_grey (theme->selection) && is_grey (theme->hover)
                 && is_grey (theme->apex_text));
  for (role = 0; role < N_ROLES; role++) {
    const Style style = sight_style (theme, (Role)role);

    if (role != ROLE_CELL)
      g_assert_true (is_grey (style.fill) && is_grey (style.line));
  }
}

static gboolean
is_black_or_white (Colour c)
{
  return c.alpha <= 0
         || (c.alpha >= 1 && is_grey (c) && (c.red == 0 || c.red == 1));
}

/* A copier knows no grey: but for facet f and what is pointed at, ink is
 * black, also when pale and behind the hull. */
static void
test_print_is_black_on_white (void)
{
  const Theme *theme = theme_get (THEME_PRINT);
  int role;

  g_assert_cmpfloat (theme->far_line, ==, 1);
  for (role = 0; role < N_ROLES; role++) {
    const Style style = sight_style (theme, (Role)role);
    const gboolean is_light = colour_equal (style.line, theme->hover);

    if (role == ROLE_SELECTED_FACET || is_light)
      continue;
    if (!is_black_or_white (style.line)
        || !is_black_or_white (theme->pale_lines[role]) || style.is_shaded)
      g_error ("role %d", role);
  }
}

/* Yellow laid over cyan would be the green of upper facets; test-painter sees
 * to it that none is. */
static void
test_papers_colours (void)
{
  const Theme *theme = theme_get (THEME_PAPER);
  const Colour yellow = sight_style (theme, ROLE_SHEET).fill;
  const Colour lower = sight_style (theme, ROLE_LOWER).fill;
  const Colour upper = sight_style (theme, ROLE_UPPER).fill;

  g_assert_true (yellow.red > 0.9 && yellow.green > 0.9 && yellow.blue < 0.1);
  g_assert_true (lower.red < 0.1 && lower.green > 0.9 && lower.blue > 0.9);
  g_assert_true (upper.green > 1.8 * upper.red && upper.green > upper.blue);
  g_assert_cmpfloat (sight_contrast (lower, upper), >, 1.5);
  g_assert_true (theme->has_mat);
}

/* Heavy lines and large names. */
static void
test_projector_is_heavy (void)
{
  const Theme *theme = theme_get (THEME_PROJECTOR);
  const Theme *light = theme_get (THEME_LIGHT);
  int role;

  g_assert_cmpfloat (theme->text_px, >=, 1.5 * light->text_px);
  for (role = 0; role < N_ROLES; role++) {
    const Style heavy = sight_style (theme, (Role)role);
    const Style calm = sight_style (light, (Role)role);

    if (heavy.mark == MARK_NONE && calm.width > 0)
      g_assert_cmpfloat (heavy.width, >=, 1.95 * calm.width);
    if (heavy.mark != MARK_NONE)
      g_assert_cmpfloat (heavy.radius, >=, 1.3 * calm.radius);
  }
}

/* A hull in the plane hides the part of the next one that it has. */
static void
check_hull (const Theme *theme)
{
  const SceneItem quiet = { .role = ROLE_HULL_AREA, .emphasis = EMPHASIS_PALE };

  if (sight_style (theme, ROLE_HULL_AREA).fill.alpha < 1
      || theme_style (theme, &quiet).fill.alpha < 1)
    sight_fault (theme, "hull", ROLE_HULL_AREA, "cone", 0);
}

static void
test_hull (void)
{
  sight_for_each_theme (check_hull);
}

/* Quiet marks */

/* A quiet horizon is thinner, and of the colour that the legend shows. */
static void
check_quiet (const Theme *theme)
{
  static const Role roles[] = { ROLE_HORIZON, ROLE_HORIZON_UPPER };

  for (guint i = 0; i < G_N_ELEMENTS (roles); i++) {
    const SceneItem item = { .role = roles[i], .emphasis = EMPHASIS_PALE };
    const Style quiet = theme_style (theme, &item);
    const Style full = sight_style (theme, roles[i]);

    g_assert_true (colour_equal (quiet.line, full.line));
    g_assert_cmpfloat (quiet.width, <, 0.85 * full.width);
    g_assert_cmpfloat (quiet.width, >, 1.5 * theme->line_factor);
  }
}

/* Without colours lines are known by how wide they are: a quiet one is still
 * closer to the sample of its own kind than to that of a thinner kind. */
static void
test_widths (void)
{
  static const Role kinds[]
      = { ROLE_VORONOI_EDGE, ROLE_RIDGE, ROLE_DELAUNAY_EDGE, ROLE_CONE_EDGE,
          ROLE_HORIZON };
  const Theme *theme = theme_get (THEME_PRINT);

  for (guint i = 1; i < G_N_ELEMENTS (kinds); i++) {
    const SceneItem item = { .role = kinds[i], .emphasis = EMPHASIS_PALE };
    const double thinner = sight_style (theme, kinds[i - 1]).width;
    const double own = sight_style (theme, kinds[i]).width;
    const double quiet = theme_style (theme, &item).width;

    g_assert_cmpfloat (own, >, 1.2 * thinner);
    g_assert_cmpfloat (quiet / thinner, >, own / quiet);
  }
}

/* The cone is what a quiet horizon lies beside. */
static void
test_new_edges (void)
{
  const Theme *theme = theme_get (THEME_PRINT);
  const SceneItem quiet = { .role = ROLE_HORIZON, .emphasis = EMPHASIS_PALE };

  g_assert_cmpfloat (theme_style (theme, &quiet).width, >,
                     1.45 * sight_style (theme, ROLE_CONE_EDGE).width);
}

/* No hatch shows through the inside of a quiet mark. */
static void
check_inside (const Theme *theme)
{
  const SceneItem item = { .role = ROLE_VORONOI_VERTEX_DYING,
                           .shape = SHAPE_MARK,
                           .emphasis = EMPHASIS_PALE };
  const Style quiet = theme_style (theme, &item);

  g_assert_cmpfloat (quiet.fill.alpha, >, 0.5);
}

/* A quiet diamond is as bright as its sample, and stands out from the cone, or
 * from the ring that parts the two. */
static void
check_quiet_diamond (const Theme *theme)
{
  const SceneItem item = { .role = ROLE_VORONOI_VERTEX_DYING,
                           .shape = SHAPE_MARK,
                           .emphasis = EMPHASIS_PALE };
  const SceneItem cell = { .role = ROLE_CELL };
  const Style quiet = theme_style (theme, &item);
  const Colour cone = sight_over (sight_style (theme, ROLE_CONE).fill,
                                  theme_style (theme, &cell).fill);
  const double value = sight_contrast (quiet.line, cone);
  const double ring = sight_contrast (quiet.line, theme->background);

  g_assert_true (colour_equal (
      quiet.line, sight_style (theme, ROLE_VORONOI_VERTEX_DYING).line));
  if (value < 3 && (quiet.casing < 0.8 || ring < 3))
    sight_fault (theme, "quiet diamond", ROLE_CONE, "cone", value);
}

/* Black on black would be no area. */
#define AREA_CONTRAST 1.5

static void
test_quiet_areas (void)
{
  static const Role roles[] = { ROLE_LOWER, ROLE_UPPER, ROLE_HULL_AREA };
  const Theme *theme = theme_get (THEME_CONTRAST);

  for (guint i = 0; i < G_N_ELEMENTS (roles); i++) {
    const SceneItem item = { .role = roles[i], .emphasis = EMPHASIS_PALE };
    const Colour fill
        = sight_over (theme_style (theme, &item).fill, theme->background);

    g_assert_cmpfloat (sight_contrast (fill, theme->background), >=,
                       AREA_CONTRAST);
    g_assert_cmpfloat (sight_contrast (fill, theme->text), >=, 4.5);
  }
}

static void
test_quiet_diamond (void)
{
  sight_for_each_theme (check_quiet_diamond);
}

static void
test_inside (void)
{
  sight_for_each_theme (check_inside);
}

static void
test_quiet (void)
{
  sight_for_each_theme (check_quiet);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/theme-each/high-contrast-is-higher",
                   test_high_contrast_is_higher);
  g_test_add_func ("/theme-each/print-is-grey", test_print_is_grey);
  g_test_add_func ("/theme-each/print-is-black-on-white",
                   test_print_is_black_on_white);
  g_test_add_func ("/theme-each/the-papers-colours-are-those-it-names",
                   test_papers_colours);
  g_test_add_func ("/theme-each/the-projectors-lines-are-heavy",
                   test_projector_is_heavy);
  g_test_add_func ("/theme-each/a-hull-in-the-plane-is-opaque", test_hull);
  g_test_add_func ("/theme-each/a-quiet-horizon-is-the-same-mark", test_quiet);
  g_test_add_func ("/theme-each/a-quiet-mark-keeps-its-inside", test_inside);
  g_test_add_func (
      "/theme-each/in-print-quiet-lines-keep-their-place-in-widths",
      test_widths);
  g_test_add_func (
      "/theme-each/in-print-a-quiet-horizon-is-wider-than-new-edges",
      test_new_edges);
  g_test_add_func ("/theme-each/in-high-contrast-quiet-areas-are-seen",
                   test_quiet_areas);
  g_test_add_func ("/theme-each/a-quiet-diamond-stands-out-from-the-cone",
                   test_quiet_diamond);
  return g_test_run ();
}
