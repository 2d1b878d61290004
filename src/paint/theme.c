#include "theme-private.h"

#include <math.h>

#include <glib.h>

#define GOLDEN_ANGLE 0.38196601125010515 /* turns */

/* How much the look changes for what is lit, and for a new cell. */
#define HALO_WIDTH 4.0
#define LIT_CASING 1.4
#define LOUD_LIGHTNESS 0.97

#define N_HUES 24

#define QUIET_WIDTH 0.6
#define PALE_CONE 0.8
#define PALE_AREA 0.32

#define BEHIND_RADIUS 0.7
#define RING_GAP 3.2

/* Cells */

static Colour
cell_colour (const Theme *theme, uint32_t hue, bool is_loud)
{
  const double chroma
      = theme->cell_chroma * (is_loud ? theme->cell_loudness : 1);
  /* Without hues a darker cell would be of a kind of its own. */
  const double lightness
      = theme->cell_lightness * (is_loud && chroma > 0 ? LOUD_LIGHTNESS : 1);

  return colour_oklch (lightness, chroma, GOLDEN_ANGLE * hue);
}

bool
theme_has_hue (Role role)
{
  return role == ROLE_CELL || role == ROLE_FURTHEST_CELL
         || role == ROLE_TANGENT;
}

static void
take_hue (const Theme *theme, const SceneItem *item, Style *style)
{
  const double alpha = style->fill.alpha;

  style->fill = cell_colour (theme, item->hue, item->emphasis == EMPHASIS_LOUD);
  style->fill.alpha = alpha;
}

static void
make_fade (double fade, Style *style)
{
  style->fill.alpha *= 1 - fade;
  style->line.alpha *= 1 - fade;
  style->halo.alpha *= 1 - fade;
  if (fade >= 1)
    style->casing = 0;
}

/* Pale */

/* The least contrast of @colour against background and cells. */
static double
least_contrast (const Theme *theme, Colour colour)
{
  double least = colour_contrast (colour, theme->background);
  uint32_t hue;

  for (hue = 0; hue < N_HUES; hue++)
    least = fmin (least,
                  colour_contrast (colour, cell_colour (theme, hue, false)));
  return least;
}

/* Lets @line sink into the background as far as the theme wants, but not so
 * far that it is lost. */
static Colour
fade (const Theme *theme, Colour line)
{
  double part = 1 - theme->pale_line;
  Colour pale = colour_mix (line, theme->background, part);

  while (part > 0.02 && least_contrast (theme, pale) < theme->pale_contrast) {
    part -= 0.02;
    pale = colour_mix (line, theme->background, part);
  }
  return pale;
}

static bool
is_horizon (Role role)
{
  return role == ROLE_HORIZON || role == ROLE_HORIZON_UPPER;
}

/* A pale black would be a grey line, of which no legend tells: the horizon is
 * told by its ink, and is thinner instead. A pale diamond would sink into the
 * cone that it lies on. */
static bool
is_told_by_ink (Role role)
{
  return is_horizon (role) || role == ROLE_VORONOI_VERTEX_DYING;
}

/* Where no ink ever pales, widths tell what a line is: all of them become
 * thinner alike. */
static double
quiet_width (const Theme *theme, Role role)
{
  return is_horizon (role) && theme->pale_line < 1
             ? fmin (QUIET_WIDTH, theme->pale_width)
             : theme->pale_width;
}

/* For when a theme is as it should be: what is pale follows. */
static void
fade_lines (Theme *theme)
{
  int role;

  for (role = 0; role < N_ROLES; role++)
    theme->pale_lines[role] = is_told_by_ink ((Role)role)
                                  ? theme->styles[role].line
                                  : fade (theme, theme->styles[role].line);
}

/* What is pale of the cone is still told from what stands, and what is inside
 * a hull in the plane from what is outside. */
static double
pale_fill (const Theme *theme, Role role)
{
  if (role == ROLE_HULL_AREA)
    return fmax (PALE_AREA, theme->pale_fill);
  if (role == ROLE_CONE || role == ROLE_CONE_UPPER)
    return fmax (PALE_CONE, theme->pale_fill);
  return theme_has_hue (role) ? theme->pale_cell : theme->pale_fill;
}

static void
make_pale (const Theme *theme, Role role, Style *style)
{
  const double width = quiet_width (theme, role);

  style->line = theme->pale_lines[role];
  /* What is inside a mark or a hull in the plane keeps off what lies under
   * it. */
  if (role == ROLE_HULL_AREA)
    style->fill
        = colour_mix (theme->background, style->fill, pale_fill (theme, role));
  else if (style->mark == MARK_NONE)
    style->fill.alpha *= pale_fill (theme, role);
  style->width *= width;
  style->casing *= width;
  style->hatch_width *= theme->pale_hatch;
}

/* Making */

static void (*const makers[N_THEMES]) (Theme *theme) = {
  [THEME_LIGHT] = theme_light,         [THEME_PAPER] = theme_paper,
  [THEME_PROJECTOR] = theme_projector, [THEME_DARK] = theme_dark,
  [THEME_PRINT] = theme_print,         [THEME_CONTRAST] = theme_contrast,
};

/* A hull in the plane hides what the next one shares with it. */
static void
make_hull_opaque (Theme *theme)
{
  Colour *fill = &theme->styles[ROLE_HULL_AREA].fill;

  *fill = colour_mix (theme->background, *fill, fill->alpha);
}

static void
make (Theme *theme, ThemeKind kind)
{
  makers[kind](theme);
  make_hull_opaque (theme);
  theme->name = theme_kind_name (kind);
  fade_lines (theme);
}

const Theme *
theme_get (ThemeKind kind)
{
  static Theme themes[N_THEMES];
  static gsize is_made;

  if (g_once_init_enter (&is_made)) {
    for (int i = 0; i < N_THEMES; i++)
      make (&themes[i], (ThemeKind)i);
    g_once_init_leave (&is_made, 1);
  }
  return &themes[kind];
}

void
theme_init (Theme *theme, const Appearance *appearance)
{
  *theme = *theme_get (appearance->theme);
  theme->line_factor *= appearance->line_scale;
  theme->mark_factor *= appearance->mark_scale;
  theme->text_px *= appearance->text_scale;
  theme->hatch_px *= sqrt (appearance->line_scale);
}

/* Lit */

static bool
is_of_facet (const SceneItem *item)
{
  return item->role == ROLE_LIT || item->role == ROLE_CIRCLE_SELECTED
         || (item->shape == SHAPE_POLYGON && item->role != ROLE_CELL);
}

/* Outlines and circles of what is lit change their colour; all other shapes
 * keep their look and get a halo. */
static void
make_lit (const Theme *theme, const SceneItem *item, Style *style)
{
  const bool is_selected = item->lit == LIT_SELECTED;
  const Colour selection
      = is_of_facet (item) ? theme->selected_facet : theme->selection;
  const Colour colour = is_selected ? selection : theme->hover;
  const bool is_thin
      = item->role >= ROLE_LIFT && item->role <= ROLE_LIFT_OUTSIDE;

  if (item->role == ROLE_LIT || item->role == ROLE_CIRCLE_SELECTED) {
    style->line = colour;
    return;
  }
  if (is_selected && item->role == ROLE_TRIANGLE
      && theme->selected_area.alpha > 0)
    style->fill = theme->selected_area;
  /* A ring stands off, or it would be a large dot. */
  if (item->shape == SHAPE_MARK && style->mark != MARK_NONE
      && style->casing < LIT_CASING)
    style->casing = LIT_CASING;
  style->halo = colour;
  style->halo_width = is_selected ? HALO_WIDTH : 0.7 * HALO_WIDTH;
  if (is_thin || item->role == ROLE_CIRCLE_VISIBLE)
    style->halo_width /= 2;
}

void
theme_put_behind (const Theme *theme, Style *style)
{
  style->radius *= BEHIND_RADIUS;
  style->width *= theme->far_width;
  /* Pure hues would shine through pale ink. */
  if (!theme->has_mat)
    style->line.alpha *= sqrt (theme->far_line);
  style->casing *= theme->far_casing;
}

static void
scale (Style *style, double factor)
{
  style->width *= factor;
  style->casing *= factor;
  style->hatch_width *= factor;
  style->dash *= factor;
  style->gap *= factor;
  style->radius *= factor;
  style->ring_gap *= factor;
  style->halo_width *= factor;
}

Style
theme_style (const Theme *theme, const SceneItem *item)
{
  Style style = theme->styles[item->role];

  style.ring_gap = RING_GAP;
  if (theme_has_hue (item->role))
    take_hue (theme, item, &style);
  if (item->emphasis == EMPHASIS_PALE && item->lit == LIT_NONE)
    make_pale (theme, item->role, &style);
  if (item->lit != LIT_NONE)
    make_lit (theme, item, &style);
  make_fade (item->fade, &style);
  scale (&style,
         style.mark == MARK_NONE ? theme->line_factor : theme->mark_factor);
  if (style.mark == MARK_NONE && style.width > 0)
    style.width = fmax (style.width, HAIRLINE);
  return style;
}
