/* What themes promise, computed: contrast of every mark on all that it is
 * drawn over, of all text, and that roles stay apart for eyes that see fewer
 * colours, or none. The formulas here are the test's own. */
#include "theme.h"

#include <glib.h>
#include <math.h>

#define MARK_CONTRAST 3.0 /* Source: WCAG 2.1, 1.4.11 */
#define TEXT_CONTRAST 4.5 /* Source: WCAG 2.1, 1.4.3 */
#define N_HUES 24
#define SHADE_DARKEST 0.22 /* of black, on a facet that is seen edge-on */

/* Colours */

static double
linear (double value)
{
  return value <= 0.04045 ? value / 12.92 : pow ((value + 0.055) / 1.055, 2.4);
}

static double
luminance (Colour c)
{
  return 0.2126 * linear (c.red) + 0.7152 * linear (c.green)
         + 0.0722 * linear (c.blue);
}

static double
contrast (Colour a, Colour b)
{
  const double p = luminance (a), q = luminance (b);

  return (MAX (p, q) + 0.05) / (MIN (p, q) + 0.05);
}

/* CIE 1976 lightness, 0 … 100. */
static double
lightness (Colour c)
{
  const double y = luminance (c);

  return y > 216.0 / 24389 ? 116 * cbrt (y) - 16 : y * 24389 / 27;
}

static Colour
over (Colour top, Colour ground)
{
  const double a = top.alpha;

  return (Colour){ a * top.red + (1 - a) * ground.red,
                   a * top.green + (1 - a) * ground.green,
                   a * top.blue + (1 - a) * ground.blue, 1 };
}

/* Linear light as an eye without one kind of cones takes it.
 * Source: Machado, Oliveira, Fernandes 2009, severity 1. */
static const double visions[3][9] = {
  { 1, 0, 0, 0, 1, 0, 0, 0, 1 },
  { 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882,
    -0.048116, 1.051998 },
  { 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820,
    0.042940, 0.968881 },
};

static const char *const vision_names[]
    = { "all cones", "no L cones", "no M cones" };

/* OKLab as seen with one of the visions. */
static void
see (Colour c, const double *vision, double lab[3])
{
  const double in[3] = { linear (c.red), linear (c.green), linear (c.blue) };
  double rgb[3], l, m, s;
  int i;

  for (i = 0; i < 3; i++)
    rgb[i] = CLAMP (vision[3 * i] * in[0] + vision[3 * i + 1] * in[1]
                        + vision[3 * i + 2] * in[2],
                    0, 1);
  l = cbrt (0.4122214708 * rgb[0] + 0.5363325363 * rgb[1]
            + 0.0514459929 * rgb[2]);
  m = cbrt (0.2119034982 * rgb[0] + 0.6806995451 * rgb[1]
            + 0.1073969566 * rgb[2]);
  s = cbrt (0.0883024619 * rgb[0] + 0.2817188376 * rgb[1]
            + 0.6299787005 * rgb[2]);
  lab[0] = 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
  lab[1] = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
  lab[2] = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
}

static double
distance (Colour a, Colour b, const double *vision)
{
  double p[3], q[3];

  see (a, vision, p);
  see (b, vision, q);
  return sqrt ((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
               + (p[2] - q[2]) * (p[2] - q[2]));
}

/* Grounds: all that a mark may lie on */

typedef struct Ground {
  Colour colour;
  char name[64];
} Ground;

static Style
style_of (const Theme *theme, Role role)
{
  const SceneItem item = { .role = role, .emphasis = EMPHASIS_NORMAL };

  return theme_style (theme, &item);
}

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
  const Style style = style_of (theme, role);

  add (grounds, over (style.fill, beneath), name, 1);
}

/* Facets in space are darker where they are seen edge-on. */
static void
add_facet (GArray *grounds,
           const Theme *theme,
           Role role,
           const char *name,
           Colour beneath)
{
  const Style style = style_of (theme, role);
  Colour shaded = style.fill;

  add_area (grounds, theme, role, name, beneath);
  if (!style.is_shaded)
    return;
  shaded.red *= 1 - SHADE_DARKEST;
  shaded.green *= 1 - SHADE_DARKEST;
  shaded.blue *= 1 - SHADE_DARKEST;
  add (grounds, over (shaded, beneath), name, 2);
}

/* The plane with triangles of the round in hand upon it. A cell is loud once
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
  const Colour sheet = style_of (theme, ROLE_SHEET).fill;
  const Colour background = theme->background;
  const Colour beneath[] = { background, over (sheet, background),
                             over (sheet, over (sheet, background)) };
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

static guint n_faults;

static void
fault (const Theme *theme,
       const char *what,
       int role,
       const char *ground,
       double value)
{
  g_test_message ("%s: %s, role %d on %s: %.2f", theme->name, what, role,
                  ground, value);
  n_faults++;
}

static void
check_on (const Theme *theme, const Role *roles, guint n, GArray *grounds)
{
  guint i, k;

  for (k = 0; k < n; k++) {
    const Style style = style_of (theme, roles[k]);

    for (i = 0; i < grounds->len; i++) {
      const Ground *ground = &g_array_index (grounds, Ground, i);
      const Colour beside = neighbour (theme, &style, ground->colour);
      const double value = contrast (over (style.line, beside), beside);

      if (value < MARK_CONTRAST)
        fault (theme, "contrast", (int)roles[k], ground->name, value);
    }
  }
}

static void
for_each_theme (void (*check) (const Theme *theme))
{
  int kind;

  n_faults = 0;
  for (kind = 0; kind < N_THEMES; kind++)
    check (theme_get ((ThemeKind)kind));
  g_assert_cmpuint (n_faults, ==, 0);
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
  for_each_theme (check_plane);
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
  for_each_theme (check_space);
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
    const Style style = style_of (theme, roles[k]);

    for (i = 0; i < plane->len && style.hatch != HATCH_NONE; i++) {
      const Ground *ground = &g_array_index (plane, Ground, i);
      const Colour fill = over (style.fill, ground->colour);
      const double value = contrast (over (style.line, fill), fill);

      if (value < MARK_CONTRAST && !g_str_has_prefix (ground->name, "loud"))
        fault (theme, "hatch", (int)roles[k], ground->name, value);
    }
  }
}

static void
test_hatches (void)
{
  for_each_theme (check_hatches);
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
      const double value
          = contrast (over (style.line, ground->colour), ground->colour);

      if (value < MARK_CONTRAST && !g_str_has_prefix (ground->name, "loud"))
        fault (theme, "pale", role, ground->name, value);
    }
  }
}

static void
test_pale (void)
{
  for_each_theme (check_pale);
}

/* Names have a casing in the background's colour. */
static void
check_text (const Theme *theme)
{
  const Colour background = theme->background;

  g_assert_cmpfloat (contrast (theme->text, background), >=, TEXT_CONTRAST);
  g_assert_cmpfloat (contrast (theme->apex_text, background), >=,
                     TEXT_CONTRAST);
  g_assert_cmpfloat (contrast (theme->selection, background), >=,
                     MARK_CONTRAST);
  g_assert_cmpfloat (contrast (theme->hover, background), >=, MARK_CONTRAST);
}

static void
test_text (void)
{
  for_each_theme (check_text);
}

static void
test_high_contrast_is_higher (void)
{
  const Theme *theme = theme_get (THEME_CONTRAST);
  int role;

  g_assert_cmpfloat (contrast (theme->text, theme->background), >=, 15);
  for (role = ROLE_SELECTED_FACET; role < ROLE_FACET_NAME; role++) {
    const Colour line = theme->styles[role].line;
    const double value = contrast (line, theme->background);

    if (line.alpha > 0 && value < 7)
      g_error ("role %d: %g", role, value);
  }
}

/* Roles that must be told apart */

typedef struct Pair {
  Role a, b;
} Pair;

static const Pair area_pairs[] = {
  { ROLE_LOWER, ROLE_UPPER },     { ROLE_LOWER, ROLE_VERTICAL },
  { ROLE_UPPER, ROLE_VERTICAL },  { ROLE_LOWER, ROLE_VISIBLE },
  { ROLE_UPPER, ROLE_VISIBLE },   { ROLE_VISIBLE, ROLE_VISIBLE_UPPER },
  { ROLE_LOWER, ROLE_CONE },      { ROLE_UPPER, ROLE_CONE },
  { ROLE_CONE, ROLE_CONE_UPPER }, { ROLE_VISIBLE, ROLE_CONE },
};

static const Pair line_pairs[] = {
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
  const Style a = style_of (theme, pair.a), b = style_of (theme, pair.b);
  const Colour p = over (is_area ? a.fill : a.line, theme->background);
  const Colour q = over (is_area ? b.fill : b.line, theme->background);
  const double apart = fabs (lightness (p) - lightness (q));
  g_autofree char *other = g_strdup_printf ("role %d", pair.b);

  if (!has_other_shape (&a, &b) && apart < LIGHTNESS_APART)
    fault (theme, "grey", (int)pair.a, other, apart);
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
  for_each_theme (check_without_colour);
}

/* What colour alone says must be said to all eyes: in OKLab, where a
 * difference of 0.02 can just be seen. */
#define COLOUR_APART 0.07

static void
check_visions (const Theme *theme, Pair pair, gboolean is_area)
{
  const Style a = style_of (theme, pair.a), b = style_of (theme, pair.b);
  const Colour p = over (is_area ? a.fill : a.line, theme->background);
  const Colour q = over (is_area ? b.fill : b.line, theme->background);
  guint i;

  for (i = 0; i < G_N_ELEMENTS (visions); i++) {
    const double apart = distance (p, q, visions[i]);
    g_autofree char *other
        = g_strdup_printf ("role %d, %s", pair.b, vision_names[i]);

    if (apart < COLOUR_APART && !has_other_shape (&a, &b))
      fault (theme, "colours", (int)pair.a, other, apart);
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
test_fewer_colours (void)
{
  int kind;
  guint i;

  n_faults = 0;
  for (kind = 0; kind < N_THEMES; kind++) {
    const Theme *theme = theme_get ((ThemeKind)kind);

    for (i = 0; i < G_N_ELEMENTS (coloured_areas) && kind != THEME_PRINT; i++)
      check_visions (theme, coloured_areas[i], TRUE);
    for (i = 0; i < G_N_ELEMENTS (coloured_lines) && kind != THEME_PRINT; i++)
      check_visions (theme, coloured_lines[i], FALSE);
  }
  g_assert_cmpuint (n_faults, ==, 0);
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
    const Style style = style_of (theme, (Role)role);

    if (role != ROLE_CELL)
      g_assert_true (is_grey (style.fill) && is_grey (style.line));
  }
}

/* Yellow laid over cyan would be the green of upper facets; test-painter sees
 * to it that none is. */
static void
test_papers_colours (void)
{
  const Theme *theme = theme_get (THEME_PAPER);
  const Colour yellow = style_of (theme, ROLE_SHEET).fill;
  const Colour lower = style_of (theme, ROLE_LOWER).fill;
  const Colour upper = style_of (theme, ROLE_UPPER).fill;

  g_assert_true (yellow.red > 0.9 && yellow.green > 0.9 && yellow.blue < 0.1);
  g_assert_true (lower.red < 0.1 && lower.green > 0.9 && lower.blue > 0.9);
  g_assert_true (upper.green > 1.8 * upper.red && upper.green > upper.blue);
  g_assert_cmpfloat (contrast (lower, upper), >, 1.5);
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
    const Style heavy = style_of (theme, (Role)role);
    const Style calm = style_of (light, (Role)role);

    if (heavy.mark == MARK_NONE && calm.width > 0)
      g_assert_cmpfloat (heavy.width, >=, 1.95 * calm.width);
    if (heavy.mark != MARK_NONE)
      g_assert_cmpfloat (heavy.radius, >=, 1.3 * calm.radius);
  }
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
    const Style a = style_of (plain, (Role)role);
    const Style b = style_of (&theme, (Role)role);
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
      fabs (colour_contrast (grey, black) - contrast (grey, black)), <, 1e-9);
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

      g_assert_cmpfloat (distance (p, q, visions[0]), >, 0.02);
    }
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
  g_test_add_func ("/theme/names-can-be-read", test_text);
  g_test_add_func ("/theme/high-contrast-is-higher",
                   test_high_contrast_is_higher);
  g_test_add_func ("/theme/roles-differ-without-colour", test_without_colour);
  g_test_add_func ("/theme/roles-differ-for-eyes-with-fewer-cones",
                   test_fewer_colours);
  g_test_add_func ("/theme/print-is-grey", test_print_is_grey);
  g_test_add_func ("/theme/the-papers-colours-are-those-it-names",
                   test_papers_colours);
  g_test_add_func ("/theme/the-projectors-lines-are-heavy",
                   test_projector_is_heavy);
  g_test_add_func ("/theme/scales-multiply-lines-marks-and-names-apart",
                   test_scales);
  g_test_add_func ("/theme/contrast-of-known-values",
                   test_contrast_of_known_values);
  g_test_add_func ("/theme/the-next-site-has-another-hue", test_hues);
  return g_test_run ();
}
