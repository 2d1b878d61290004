/* bench-sites KIND N: writes N sites of a kind, the same every time. */
#include "order.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

typedef struct Source {
  uint64_t random;
  uint32_t n, i, side; /* side² >= n */
} Source;

static double
uniform (Source *source)
{
  return (double)(order_random (&source->random) >> 11) * 0x1p-53;
}

static Site
on_circle (double radius, double angle)
{
  const double x = radius * cos (angle);
  const double y = radius * sin (angle);

  return (Site){ x, y };
}

static Site
make_uniform (Source *source)
{
  const double x = uniform (source);

  return (Site){ x, uniform (source) };
}

/* A hundred knots, each a thousandth across. */
static Site
make_clusters (Source *source)
{
  uint64_t knot = order_random (&source->random) % 100;
  const double x = (double)(order_random (&knot) >> 11) * 0x1p-53;
  const double y = (double)(order_random (&knot) >> 11) * 0x1p-53;
  const Site offset = on_circle (1e-3 * sqrt (-2 * log (1 - uniform (source))),
                                 2 * PI * uniform (source));

  return (Site){ x + offset.x, y + offset.y };
}

static Site
make_grid (Source *source)
{
  const uint32_t column = source->i % source->side;
  const uint32_t row = source->i / source->side;

  return (Site){ column, row };
}

static Site
make_circle (Source *source)
{
  return on_circle (1, 2 * PI * uniform (source));
}

static Site
make_line (Source *source)
{
  const double x = uniform (source);

  return (Site){ x, x + 1e-9 * uniform (source) };
}

/* Dense in the middle, without a border. Source: Kuzmin 1956, as used by
 * Shewchuk 1996. */
static Site
make_kuzmin (Source *source)
{
  const double left = 1 - uniform (source);

  return on_circle (sqrt (1 / (left * left) - 1), 2 * PI * uniform (source));
}

static Site
make_spiral (Source *source)
{
  const double t = (source->i + uniform (source)) / source->n;

  return on_circle (t, 40 * PI * t);
}

/* Each place taken about four times. */
static Site
make_duplicates (Source *source)
{
  const uint32_t side = source->side / 2;
  const double x = floor (side * uniform (source));

  return (Site){ x, floor (side * uniform (source)) };
}

static const struct {
  const char *name;
  Site (*make) (Source *source);
} kinds[] = {
  { "uniform", make_uniform }, { "clusters", make_clusters },
  { "grid", make_grid },       { "circle", make_circle },
  { "line", make_line },       { "kuzmin", make_kuzmin },
  { "spiral", make_spiral },   { "duplicates", make_duplicates },
};

int
main (int argc, char **argv)
{
  Source source = { .random = 1, .side = 1 };
  size_t kind = 0;

  if (argc == 3)
    source.n = (uint32_t)strtoul (argv[2], NULL, 10);
  while (argc == 3 && kind < sizeof kinds / sizeof *kinds
         && strcmp (argv[1], kinds[kind].name) != 0)
    kind++;
  if (source.n == 0 || kind == sizeof kinds / sizeof *kinds) {
    fprintf (stderr, "usage: bench-sites KIND N\n");
    return 64;
  }
  while (source.side * source.side < source.n)
    source.side++;
  for (source.i = 0; source.i < source.n; source.i++) {
    const Site site = kinds[kind].make (&source);

    printf ("%.17g %.17g\n", site.x, site.y);
  }
  return 0;
}
