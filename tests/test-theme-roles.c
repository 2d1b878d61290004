/* Roles that must be told apart are, by eyes that see fewer colours, or
 * none. */
#include "sight.h"

#include <math.h>

typedef struct Pair {
  Role a, b;
} Pair;

static const Pair area_pairs[] = {
  { ROLE_LOWER, ROLE_UPPER },      { ROLE_LOWER, ROLE_VERTICAL },
  { ROLE_UPPER, ROLE_VERTICAL },   { ROLE_LOWER, ROLE_VISIBLE },
  { ROLE_UPPER, ROLE_VISIBLE },    { ROLE_VISIBLE, ROLE_VISIBLE_UPPER },
  { ROLE_LOWER, ROLE_CONE },       { ROLE_UPPER, ROLE_CONE },
  { ROLE_CONE, ROLE_CONE_UPPER },  { ROLE_VISIBLE, ROLE_CONE },
  { ROLE_UPPER, ROLE_CONE_UPPER },
};

static const Pair line_pairs[] = {
  { ROLE_CIRCLE, ROLE_VORONOI_EDGE },
  { ROLE_VISIBLE_EDGE, ROLE_CIRCLE_VISIBLE },
  { ROLE_DELAUNAY_EDGE, ROLE_VORONOI_EDGE },
  { ROLE_DELAUNAY_EDGE, ROLE_FREE_EDGE },
  { ROLE_DELAUNAY_EDGE, ROLE_CONE_EDGE },
  { ROLE_DELAUNAY_EDGE, ROLE_HORIZON },
  { ROLE_VISIBLE_EDGE, ROLE_HORIZON },
  { ROLE_VISIBLE_EDGE, ROLE_CONE_EDGE },
  { ROLE_VISIBLE_EDGE, ROLE_RETIRED },
  { ROLE_CONE_EDGE, ROLE_HORIZON },
  { ROLE_HORIZON, ROLE_HORIZON_UPPER },
  { ROLE_HORIZON, ROLE_SELECTED_FACET },
  { ROLE_CIRCLE, ROLE_CIRCLE_VISIBLE },
  { ROLE_CIRCLE, ROLE_CIRCLE_SELECTED },
  { ROLE_CIRCLE_VISIBLE, ROLE_CIRCLE_UPPER },
  { ROLE_CIRCLE_VISIBLE, ROLE_CIRCLE_SELECTED },
  { ROLE_LIFT, ROLE_LIFT_APEX },
  { ROLE_LIFT, ROLE_LIFT_OUTSIDE },
  { ROLE_LIFT_OUTSIDE, ROLE_LIFT_APEX },
  { ROLE_LIFT_OUTSIDE, ROLE_DROP },
  { ROLE_VORONOI_VERTEX, ROLE_VORONOI_VERTEX_DYING },
  { ROLE_SITE, ROLE_SITE_APEX },
  { ROLE_SITE, ROLE_SITE_WAITING },
  { ROLE_SITE_WAITING, ROLE_SITE_OUTSIDE },
  { ROLE_SITE, ROLE_SITE_DUPLICATE },
  { ROLE_SITE, ROLE_SITE_IGNORED },
  { ROLE_FOOT, ROLE_FOOT_APEX },
};

#define LIGHTNESS_APART 12.0
#define RATIO_APART 1.3

static gboolean
is_other_length (double a, double b)
{
  return MAX (a, b) >= RATIO_APART * MIN (a, b);
}

/* Whether hatch, dash, width, mark or size differ. */
static gboolean
has_other_shape (const Style *a, const Style *b)
{
  return a->hatch != b->hatch || a->mark != b->mark
         || (a->dash > 0) != (b->dash > 0)
         || (a->dash > 0 && is_other_length (a->dash, b->dash))
         || (a->mark == MARK_NONE && is_other_length (a->width, b->width))
         || (a->mark != MARK_NONE && is_other_length (a->radius, b->radius));
}

static void
check_grey (const Theme *theme, Pair pair, gboolean is_area)
{
  const Style a = sight_style (theme, pair.a), b = sight_style (theme, pair.b);
  const Colour p = sight_over (is_area ? a.fill : a.line, theme->background);
  const Colour q = sight_over (is_area ? b.fill : b.line, theme->background);
  const double apart = fabs (sight_lightness (p) - sight_lightness (q));
  g_autofree char *other = g_strdup_printf ("role %d", pair.b);

  if (!has_other_shape (&a, &b) && apart < LIGHTNESS_APART)
    sight_fault (theme, "grey", (int)pair.a, other, apart);
}

static void
check_without_colour (const Theme *theme)
{
  guint i;

  for (i = 0; i < G_N_ELEMENTS (area_pairs); i++)
    check_grey (theme, area_pairs[i], TRUE);
  for (i = 0; i < G_N_ELEMENTS (line_pairs); i++)
    check_grey (theme, line_pairs[i], FALSE);
}

static void
test_without_colour (void)
{
  sight_for_each_theme (check_without_colour);
}

/* What colour alone says must be said to all eyes: in OKLab, where a
 * difference of 0.02 can just be seen. */
#define COLOUR_APART 0.07

static void
check_visions (const Theme *theme, Pair pair, gboolean is_area)
{
  const Style a = sight_style (theme, pair.a), b = sight_style (theme, pair.b);
  const Colour p = sight_over (is_area ? a.fill : a.line, theme->background);
  const Colour q = sight_over (is_area ? b.fill : b.line, theme->background);
  guint i;

  for (i = 0; i < G_N_ELEMENTS (sight_visions); i++) {
    const double apart = sight_distance (p, q, sight_visions[i]);
    g_autofree char *other
        = g_strdup_printf ("role %d, %s", pair.b, sight_vision_names[i]);

    if (apart < COLOUR_APART && !has_other_shape (&a, &b))
      sight_fault (theme, "colours", (int)pair.a, other, apart);
  }
}

static const Pair coloured_areas[] = {
  { ROLE_LOWER, ROLE_UPPER },   { ROLE_LOWER, ROLE_VISIBLE },
  { ROLE_UPPER, ROLE_VISIBLE }, { ROLE_LOWER, ROLE_CONE },
  { ROLE_UPPER, ROLE_CONE },    { ROLE_VISIBLE, ROLE_CONE },
};

static const Pair coloured_lines[] = {
  { ROLE_DELAUNAY_EDGE, ROLE_VISIBLE_EDGE },
  { ROLE_DELAUNAY_EDGE, ROLE_CONE_EDGE },
  { ROLE_VISIBLE_EDGE, ROLE_CONE_EDGE },
  { ROLE_VISIBLE_EDGE, ROLE_HORIZON },
  { ROLE_DELAUNAY_EDGE, ROLE_HORIZON },
  { ROLE_SITE, ROLE_SITE_APEX },
  { ROLE_CIRCLE, ROLE_CIRCLE_VISIBLE },
  { ROLE_CIRCLE_VISIBLE, ROLE_CIRCLE_SELECTED },
};

static void
check_fewer_colours (const Theme *theme)
{
  guint i;

  if (theme == theme_get (THEME_PRINT))
    return;
  for (i = 0; i < G_N_ELEMENTS (coloured_areas); i++)
    check_visions (theme, coloured_areas[i], TRUE);
  for (i = 0; i < G_N_ELEMENTS (coloured_lines); i++)
    check_visions (theme, coloured_lines[i], FALSE);
}

static void
test_fewer_colours (void)
{
  sight_for_each_theme (check_fewer_colours);
}

/* What a person has selected, the facet that QuickHull has and the edges of
 * the diagram lie side by side; so do the cone and the horizon, all of them
 * lines without dashes. */
static void
check_solid_lines (const Theme *theme)
{
  const Colour edge = sight_style (theme, ROLE_DELAUNAY_EDGE).line;
  const Colour selected = sight_style (theme, ROLE_SELECTED_FACET).line;
  const Colour horizon = sight_style (theme, ROLE_HORIZON).line;
  const Colour cone = sight_style (theme, ROLE_CONE_EDGE).line;
  const SceneItem behind_it
      = { .role = ROLE_HORIZON, .emphasis = EMPHASIS_PALE };
  const Colour pale
      = sight_over (theme_style (theme, &behind_it).line, theme->background);
  guint i;

  if (theme == theme_get (THEME_PRINT))
    return;
  for (i = 0; i < G_N_ELEMENTS (sight_visions); i++) {
    const double *vision = sight_visions[i];
    const char *name = sight_vision_names[i];

    if (sight_distance (theme->selected_facet, edge, vision) < COLOUR_APART)
      sight_fault (theme, "selected", ROLE_DELAUNAY_EDGE, name, 0);
    /* One of these is wider, too. */
    if (sight_distance (theme->selected_facet, selected, vision)
        < 0.5 * COLOUR_APART)
      sight_fault (theme, "selected", ROLE_SELECTED_FACET, name,
                   sight_distance (theme->selected_facet, selected, vision));
    if (sight_distance (cone, horizon, vision) < 2 * COLOUR_APART)
      sight_fault (theme, "cone", ROLE_HORIZON, name,
                   sight_distance (cone, horizon, vision));
    if (sight_distance (cone, pale, vision) < COLOUR_APART)
      sight_fault (theme, "cone, pale", ROLE_HORIZON, name,
                   sight_distance (cone, pale, vision));
  }
}

static void
test_solid_lines (void)
{
  sight_for_each_theme (check_solid_lines);
}

/* The hue of a cell differs from that of the next sites. */
static void
test_hues (void)
{
  static const ThemeKind kinds[] = { THEME_LIGHT, THEME_PAPER, THEME_PROJECTOR,
                                     THEME_DARK, THEME_CONTRAST };
  guint i, k;

  for (k = 0; k < G_N_ELEMENTS (kinds); k++)
    for (i = 0; i < 40; i++) {
      const SceneItem a = { .role = ROLE_CELL, .hue = i };
      const SceneItem b = { .role = ROLE_CELL, .hue = i + 1 };
      const Colour p = theme_style (theme_get (kinds[k]), &a).fill;
      const Colour q = theme_style (theme_get (kinds[k]), &b).fill;

      g_assert_cmpfloat (sight_distance (p, q, sight_visions[0]), >, 0.02);
    }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/theme-roles/roles-differ-without-colour",
                   test_without_colour);
  g_test_add_func ("/theme-roles/roles-differ-for-eyes-with-fewer-cones",
                   test_fewer_colours);
  g_test_add_func ("/theme-roles/the-next-site-has-another-hue", test_hues);
  g_test_add_func ("/theme-roles/solid-lines-side-by-side-differ-to-all-eyes",
                   test_solid_lines);
  return g_test_run ();
}
