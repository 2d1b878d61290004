#include "sight.h"
#include "painter.h"

#include <math.h>

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

double
sight_contrast (Colour a, Colour b)
{
  const double p = luminance (a), q = luminance (b);

  return (MAX (p, q) + 0.05) / (MIN (p, q) + 0.05);
}

double
sight_lightness (Colour c)
{
  const double y = luminance (c);

  return y > 216.0 / 24389 ? 116 * cbrt (y) - 16 : y * 24389 / 27;
}

Colour
sight_over (Colour top, Colour ground)
{
  const double a = top.alpha;

  return (Colour){ a * top.red + (1 - a) * ground.red,
                   a * top.green + (1 - a) * ground.green,
                   a * top.blue + (1 - a) * ground.blue, 1 };
}

/* Linear light as an eye without one kind of cones takes it.
 * Source: Machado, Oliveira, Fernandes 2009, severity 1. */
const double sight_visions[N_VISIONS][9] = {
  { 1, 0, 0, 0, 1, 0, 0, 0, 1 },
  { 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882,
    -0.048116, 1.051998 },
  { 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820,
    0.042940, 0.968881 },
};

const char *const sight_vision_names[N_VISIONS]
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

double
sight_distance (Colour a, Colour b, const double *vision)
{
  double p[3], q[3];

  see (a, vision, p);
  see (b, vision, q);
  return sqrt ((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
               + (p[2] - q[2]) * (p[2] - q[2]));
}

Style
sight_style (const Theme *theme, Role role)
{
  const SceneItem item = { .role = role, .emphasis = EMPHASIS_NORMAL };

  return theme_style (theme, &item);
}

static guint n_faults;

cairo_surface_t *
sight_paint_sample (const Theme *theme,
                    const SceneItem *sample,
                    int width,
                    int height)
{
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, width, height);
  cairo_t *cr = cairo_create (surface);
  const Colour ground = theme->background;

  cairo_set_source_rgb (cr, ground.red, ground.green, ground.blue);
  cairo_paint (cr);
  painter_swatch (cr, sample, theme, width, height);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

void
sight_fault (const Theme *theme,
             const char *what,
             int role,
             const char *ground,
             double value)
{
  g_test_message ("%s: %s, role %d on %s: %.2f", theme->name, what, role,
                  ground, value);
  n_faults++;
}

void
sight_for_each_theme (void (*check) (const Theme *theme))
{
  int kind;

  n_faults = 0;
  for (kind = 0; kind < N_THEMES; kind++)
    check (theme_get ((ThemeKind)kind));
  g_assert_cmpuint (n_faults, ==, 0);
}
