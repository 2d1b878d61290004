/* What themes promise, computed: contrast of every mark on all that it is
 * drawn over, and of all text. */
#include "sight.h"

#include <math.h>

#define MARK_CONTRAST 3.0 /* Source: WCAG 2.1, 1.4.11 */
#define TEXT_CONTRAST 4.5 /* Source: WCAG 2.1, 1.4.3 */
#define N_HUES 24
#define SHADE_DARKEST 0.22 /* of black, on a facet that is seen edge-on */

/* Grounds: all that a mark may lie on */

typedef struct Ground {
  Colour colour;
  char name[64];
} Ground;

static void
add (GArray *grounds, Colour colour, const char *name, int number)
{
  Ground ground = { .colour = colour };

  g_snprintf (ground.name, sizeof ground.name, "%s %d", name, number);
  g_array_append_val (grounds, ground);
}

/* The plane: background, cells calm and loud. */
static GArray *
plane_grounds (const Theme *theme)
{
  GArray *grounds = g_array_new (FALSE, FALSE, sizeof (Ground));
  guint32 hue;

  add (grounds, theme->background, "background", 0);
  for (hue = 0; hue < N_HUES; hue++) {
    SceneItem cell = { .role = ROLE_CELL, .hue = hue };

    cell.emphasis = EMPHASIS_NORMAL;
    add (grounds, theme_style (theme, &cell).fill, "cell", (int)hue);
    cell.emphasis = EMPHASIS_LOUD;
    add (grounds, theme_style (theme, &cell).fill, "loud cell", (int)hue);
  }
  return grounds;
}

static void
add_area (GArray *grounds,
          const Theme *theme,
          Role role,
          const char *name,
          Colour beneath)
{
  const Style style = sight_style (theme, role);

  add (grounds, sight_over (style.fill, beneath), name, 1);
}

/* Facets in space are darker where they are seen edge-on. */
static void
add_facet (GArray *grounds,
           const Theme *theme,
           Role role,
           const char *name,
           Colour beneath)
{
  const Style style = sight_style (theme, role);
  Colour shaded = style.fill;

  add_area (grounds, theme, role, name, beneath);
  if (!style.is_shaded)
    return;
  shaded.red *= 1 - SHADE_DARKEST;
  shaded.green *= 1 - SHADE_DARKEST;
  shaded.blue *= 1 - SHADE_DARKEST;
  add (grounds, sight_over (shaded, beneath), name, 2);
}

/* The plane with triangles of the current round upon it. A cell is loud once
 * the visible ones are gone. */
static GArray *
triangle_grounds (const Theme *theme)
{
  GArray *grounds = plane_grounds (theme);
  const guint n = grounds->len;
  guint i;

  for (i = 0; i < n; i++) {
    const Colour beneath = g_array_index (grounds, Ground, i).colour;

    if (!g_str_has_prefix (g_array_index (grounds, Ground, i).name, "loud"))
      add_area (grounds, theme, ROLE_VISIBLE, "visible triangle", beneath);
    add_area (grounds, theme, ROLE_CONE, "cone triangle", beneath);
  }
  return grounds;
}

/* Facets in space, before the background and before the sheet. */
static GArray *
facet_grounds (const Theme *theme)
{
  static const struct {
    Role role;
    const char *name;
  } facets[] = {
    { ROLE_LOWER, "lower" },
    { ROLE_UPPER, "upper" },
    { ROLE_VERTICAL, "vertical" },
    { ROLE_VISIBLE, "visible" },
    { ROLE_CONE, "cone" },
    { ROLE_VISIBLE_UPPER, "visible upper" },
    { ROLE_CONE_UPPER, "cone upper" },
  };
  GArray *grounds = g_array_new (FALSE, FALSE, sizeof (Ground));
  const Colour sheet = sight_style (theme, ROLE_SHEET).fill;
  const Colour background = theme->background;
  const Colour beneath[]
      = { background, sight_over (sheet, background),
          sight_over (sheet, sight_over (sheet, background)) };
  guint i, k;

  for (i = 0; i < G_N_ELEMENTS (beneath); i++) {
    add (grounds, beneath[i], "sheet", (int)i);
    for (k = 0; k < G_N_ELEMENTS (facets); k++)
      add_facet (grounds, theme, facets[k].role, facets[k].name, beneath[i]);
  }
  return grounds;
}

/* A casing parts a mark from whatever it lies on. */
static Colour
neighbour (const Theme *theme, const Style *style, Colour ground)
{
  return style->casing > 0 ? theme->background : ground;
}

static void
check_on (const Theme *theme, const Role *roles, guint n, GArray *grounds)
{
  guint i, k;

  for (k = 0; k < n; k++) {
    const Style style = sight_style (theme, roles[k]);

    for (i = 0; i < grounds->len; i++) {
      const Ground *ground = &g_array_index (grounds, Ground, i);
      const Colour beside = neighbour (theme, &style, ground->colour);
      const double value
          = sight_contrast (sight_over (style.line, beside), beside);

      if (value < MARK_CONTRAST)
        sight_fault (theme, "contrast", (int)roles[k], ground->name, value);
    }
  }
}

static void
check_plane (const Theme *theme)
{
  static const Role roles[]
      = { ROLE_GROUND,          ROLE_CIRCLE,           ROLE_CIRCLE_UPPER,
          ROLE_CIRCLE_SELECTED, ROLE_VORONOI_EDGE,     ROLE_DELAUNAY_EDGE,
          ROLE_FREE_EDGE,       ROLE_VORONOI_VERTEX,   ROLE_FOOT,
          ROLE_FURTHEST_EDGE,   ROLE_FURTHEST_VORONOI, ROLE_FURTHEST_VERTEX,
          ROLE_PREVIEW_EDGE,    ROLE_PREVIEW_CELL,     ROLE_PREVIEW_SITE,
          ROLE_CONTOUR,         ROLE_TANGENT_EDGE };
  static const Role upon[]
      = { ROLE_CIRCLE_VISIBLE,       ROLE_RETIRED,       ROLE_SELECTED_FACET,
          ROLE_VISIBLE_EDGE,         ROLE_CONE_EDGE,     ROLE_HORIZON,
          ROLE_HORIZON_UPPER,        ROLE_LIT,           ROLE_FOOT_APEX,
          ROLE_VORONOI_VERTEX_DYING, ROLE_SITE,          ROLE_SITE_WAITING,
          ROLE_SITE_OUTSIDE,         ROLE_SITE_APEX,     ROLE_SITE_DUPLICATE,
          ROLE_VORONOI_EDGE,         ROLE_DELAUNAY_EDGE, ROLE_VORONOI_VERTEX };
  g_autoptr (GArray) plane = plane_grounds (theme);
  g_autoptr (GArray) triangles = triangle_grounds (theme);

  check_on (theme, roles, G_N_ELEMENTS (roles), plane);
  check_on (theme, upon, G_N_ELEMENTS (upon), triangles);
}

static void
test_plane (void)
{
  sight_for_each_theme (check_plane);
}

static void
check_space (const Theme *theme)
{
  static const Role roles[]
      = { ROLE_RETIRED,      ROLE_SELECTED_FACET, ROLE_FREE_EDGE,
          ROLE_RIDGE,        ROLE_VISIBLE_EDGE,   ROLE_CONE_EDGE,
          ROLE_HORIZON,      ROLE_HORIZON_UPPER,  ROLE_LIFT,
          ROLE_LIFT_APEX,    ROLE_LIFT_OUTSIDE,   ROLE_DROP,
          ROLE_LIT,          ROLE_SITE,           ROLE_SITE_WAITING,
          ROLE_SITE_OUTSIDE, ROLE_SITE_APEX,      ROLE_ELLIPSE,
          ROLE_GAP,          ROLE_PREVIEW_SITE };
  static const Role sheet[] = { ROLE_RIM };
  g_autoptr (GArray) facets = facet_grounds (theme);
  g_autoptr (GArray) plane = plane_grounds (theme);

  check_on (theme, roles, G_N_ELEMENTS (roles), facets);
  check_on (theme, sheet, G_N_ELEMENTS (sheet), plane);
}

static void
test_space (void)
{
  sight_for_each_theme (check_space);
}

/* On a dark ground the strokes of a lattice are as bright as the dots on it,
 * and pure hues are as strong; on a light one a ring would lift what is hidden
 * onto the facet. */
static void
check_ring_behind (const Theme *theme, const Style *hidden)
{
  if (sight_lightness (theme->background) > 50 && !theme->has_mat)
    g_assert_cmpfloat (hidden->casing, ==, 0);
  else
    g_assert_cmpfloat (hidden->casing, >=, 1);
}

/* What the hull hides is seen through its facets. */
static void
check_behind (const Theme *theme)
{
  g_autoptr (GArray) facets = facet_grounds (theme);
  Style style = sight_style (theme, ROLE_SITE);
  const double radius = style.radius;
  guint i;

  theme_put_behind (theme, &style);
  g_assert_cmpfloat (style.radius, <, 0.8 * radius);
  check_ring_behind (theme, &style);
  for (i = 0; i < facets->len; i++) {
    const Ground *ground = &g_array_index (facets, Ground, i);
    const double value = sight_contrast (
        sight_over (style.line, ground->colour), ground->colour);

    if (value < MARK_CONTRAST)
      sight_fault (theme, "behind", ROLE_SITE, ground->name, value);
  }
}

static void
test_behind (void)
{
  sight_for_each_theme (check_behind);
}

/* Where three sites are in line is what a sign map is about. */
static void
check_signs (const Theme *theme)
{
  const Style zero = sight_style (theme, ROLE_SIGN_ZERO);
  const Style left = sight_style (theme, ROLE_SIGN_LEFT);
  const Style right = sight_style (theme, ROLE_SIGN_RIGHT);
  guint i;

  if (sight_contrast (zero.fill, left.fill) < MARK_CONTRAST)
    sight_fault (theme, "sign", ROLE_SIGN_ZERO, "left", 0);
  if (sight_contrast (zero.fill, right.fill) < MARK_CONTRAST)
    sight_fault (theme, "sign", ROLE_SIGN_ZERO, "right", 0);
  for (i = 0; i < N_VISIONS; i++)
    if (left.hatch == right.hatch
        && sight_distance (left.fill, right.fill, sight_visions[i]) < 0.1)
      sight_fault (theme, "sign", ROLE_SIGN_LEFT, sight_vision_names[i], 0);
}

static void
test_signs (void)
{
  sight_for_each_theme (check_signs);
}

/* A hatch is a mark upon its own area. */
static void
check_hatches (const Theme *theme)
{
  static const Role roles[]
      = { ROLE_UPPER,         ROLE_VERTICAL, ROLE_VISIBLE,
          ROLE_VISIBLE_UPPER, ROLE_CONE,     ROLE_CONE_UPPER };
  g_autoptr (GArray) plane = plane_grounds (theme);
  guint i, k;

  for (k = 0; k < G_N_ELEMENTS (roles); k++) {
    const Style style = sight_style (theme, roles[k]);

    for (i = 0; i < plane->len && style.hatch != HATCH_NONE; i++) {
      const Ground *ground = &g_array_index (plane, Ground, i);
      const Colour fill = sight_over (style.fill, ground->colour);
      const double value = sight_contrast (sight_over (style.line, fill), fill);

      if (value < MARK_CONTRAST && !g_str_has_prefix (ground->name, "loud"))
        sight_fault (theme, "hatch", (int)roles[k], ground->name, value);
    }
  }
}

static void
test_hatches (void)
{
  sight_for_each_theme (check_hatches);
}

/* What is pale is still seen. */
static void
check_pale (const Theme *theme)
{
  g_autoptr (GArray) plane = plane_grounds (theme);
  int role;
  guint i;

  for (role = 0; role < N_ROLES; role++) {
    const SceneItem item = { .role = (Role)role, .emphasis = EMPHASIS_PALE };
    const Style style = theme_style (theme, &item);

    if (style.line.alpha <= 0 || role == ROLE_SHEET)
      continue;
    for (i = 0; i < plane->len; i++) {
      const Ground *ground = &g_array_index (plane, Ground, i);
      const double value = sight_contrast (
          sight_over (style.line, ground->colour), ground->colour);

      if (value < MARK_CONTRAST && !g_str_has_prefix (ground->name, "loud"))
        sight_fault (theme, "pale", role, ground->name, value);
    }
  }
}

static void
test_pale (void)
{
  sight_for_each_theme (check_pale);
}

/* Names have a casing in the background's colour. */
static void
check_text (const Theme *theme)
{
  const Colour background = theme->background;

  g_assert_cmpfloat (sight_contrast (theme->text, background), >=,
                     TEXT_CONTRAST);
  g_assert_cmpfloat (sight_contrast (theme->apex_text, background), >=,
                     TEXT_CONTRAST);
  g_assert_cmpfloat (sight_contrast (theme->selection, background), >=,
                     MARK_CONTRAST);
  g_assert_cmpfloat (sight_contrast (theme->hover, background), >=,
                     MARK_CONTRAST);
}

static void
test_text (void)
{
  sight_for_each_theme (check_text);
}

static void
test_scales (void)
{
  const Appearance wanted = { THEME_DARK, 2, 0.5, 3 };
  const Theme *plain = theme_get (THEME_DARK);
  int role;
  Theme theme;

  theme_init (&theme, &wanted);
  g_assert_cmpfloat (theme.text_px, ==, 3 * plain->text_px);
  for (role = 0; role < N_ROLES; role++) {
    const Style a = sight_style (plain, (Role)role);
    const Style b = sight_style (&theme, (Role)role);
    const double factor = a.mark == MARK_NONE ? 2 : 0.5;

    g_assert_cmpfloat (fabs (b.width - factor * a.width), <, 1e-9);
    g_assert_cmpfloat (fabs (b.dash - factor * a.dash), <, 1e-9);
    g_assert_cmpfloat (fabs (b.gap - factor * a.gap), <, 1e-9);
    g_assert_cmpfloat (fabs (b.casing - factor * a.casing), <, 1e-9);
    g_assert_cmpfloat (fabs (b.radius - 0.5 * a.radius), <, 1e-9);
  }
}

/* The program's own formula. */
static void
test_contrast_of_known_values (void)
{
  const Colour black = { 0, 0, 0, 1 }, white = { 1, 1, 1, 1 };
  const Colour grey = { 0x77 / 255.0, 0x77 / 255.0, 0x77 / 255.0, 1 };

  g_assert_cmpfloat (fabs (colour_contrast (black, white) - 21), <, 1e-9);
  g_assert_cmpfloat (fabs (colour_contrast (grey, white) - 4.48), <, 0.01);
  g_assert_cmpfloat (
      fabs (colour_contrast (grey, black) - sight_contrast (grey, black)), <,
      1e-9);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/theme/marks-in-the-plane-stand-out-from-cells-and-"
                   "triangles",
                   test_plane);
  g_test_add_func ("/theme/marks-in-space-stand-out-from-facets", test_space);
  g_test_add_func ("/theme/hatches-stand-out-from-their-areas", test_hatches);
  g_test_add_func ("/theme/what-is-pale-is-still-seen", test_pale);
  g_test_add_func ("/theme/sites-behind-the-hull-stand-out-from-facets",
                   test_behind);
  g_test_add_func ("/theme/sign-maps-can-be-read", test_signs);
  g_test_add_func ("/theme/names-can-be-read", test_text);
  g_test_add_func ("/theme/scales-multiply-lines-marks-and-names-apart",
                   test_scales);
  g_test_add_func ("/theme/contrast-of-known-values",
                   test_contrast_of_known_values);
  return g_test_run ();
}
