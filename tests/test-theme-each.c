/* What single themes promise. */
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
  return g_test_run ();
}
