/* Sets that are no plain figures. All is made of sums, products, quotients and
 * square roots, which round the same everywhere, and put on a grid last. */
#include "generator-private.h"

#include <math.h>

/* Makes one more site; it may fall on one that is there. */
typedef struct Scatter {
  guint64 state;
  int bits; /* the grid is that of 2^-bits */
  guint n_centres;
  Site centres[12];
} Scatter;

typedef Site (*MakeSite) (Scatter *scatter);

/* Returns: a number -1 … 1. */
static double
random_between (Scatter *scatter)
{
  return (double)generator_below (&scatter->state, 1u << 30) / (1u << 29) - 1;
}

/* Returns: a point of the circle of radius 1, all as likely. */
static Site
random_direction (Scatter *scatter)
{
  for (;;) {
    const double x = random_between (scatter), y = random_between (scatter);
    const double square = x * x + y * y;

    if (square > 0.0625 && square <= 1)
      return (Site){ x / sqrt (square), y / sqrt (square) };
  }
}

static gboolean
is_inside (Site site)
{
  return fabs (site.x) <= 1 && fabs (site.y) <= 1;
}

static double
to_grid (double coordinate, int bits)
{
  return ldexp (nearbyint (ldexp (coordinate, bits)), -bits) + 0.0;
}

/* Coordinates of the grid fit into 32 bits each. */
static guint64
key_of (Site site, int bits)
{
  const guint64 x = (guint64)(ldexp (site.x, bits) + 0x1p30);
  const guint64 y = (guint64)(ldexp (site.y, bits) + 0x1p30);

  return x << 32 | y;
}

/* Sites on the grid of 2^-bits in the square, each once. */
static Site *
scatter_sites (Scatter *scatter, MakeSite make, guint n)
{
  g_autoptr (GHashTable) taken
      = g_hash_table_new_full (g_int64_hash, g_int64_equal, g_free, NULL);
  Site *sites = g_new (Site, n);

  for (guint i = 0; i < n;) {
    Site site = make (scatter);
    guint64 key;

    if (!is_inside (site))
      continue;
    site.x = to_grid (site.x, scatter->bits);
    site.y = to_grid (site.y, scatter->bits);
    key = key_of (site, scatter->bits);
    if (!g_hash_table_add (taken, g_memdup2 (&key, sizeof key)))
      continue;
    sites[i] = site;
    i += 1;
  }
  return sites;
}

/* Clusters */

#define CLUSTER_WIDTH 0.22

/* Sums of random numbers crowd round their mean. */
static double
random_crowded (Scatter *scatter)
{
  double sum = 0;

  for (int i = 0; i < 4; i++)
    sum += random_between (scatter);
  return sum / 4;
}

static Site
make_in_cluster (Scatter *scatter)
{
  const guint32 last = scatter->n_centres - 1;
  const Site centre = scatter->centres[generator_below (&scatter->state, last)];

  const double x = CLUSTER_WIDTH * random_crowded (scatter);
  const double y = CLUSTER_WIDTH * random_crowded (scatter);

  return (Site){ centre.x + x, centre.y + y };
}

/* A few for a few sites, more for many. */
static guint
count_centres (guint n)
{
  guint n_centres = 3;

  while (n_centres < 12 && n_centres * n_centres * 4 < n)
    n_centres += 1;
  return n_centres;
}

Site *
generator_clusters (guint n, guint64 seed, GError **error)
{
  Scatter scatter = { .state = seed, .bits = generator_bits (n) + 3 };

  if (!generator_check_count (n, GENERATOR_MAX, error))
    return NULL;
  scatter.n_centres = count_centres (n);
  for (guint i = 0; i < scatter.n_centres; i++) {
    scatter.centres[i].x = 0.8 * random_between (&scatter);
    scatter.centres[i].y = 0.8 * random_between (&scatter);
  }
  return scatter_sites (&scatter, make_in_cluster, n);
}

/* Near-circle */

Site *
generator_near_circle (guint n, guint64 seed, GError **error)
{
  /* The circle meets ever fewer squares of a grid than the square does. */
  Scatter scatter = { .state = seed, .bits = MAX (10, 2 * generator_bits (n)) };

  if (!generator_check_count (n, GENERATOR_MAX, error))
    return NULL;
  return scatter_sites (&scatter, random_direction, n);
}

/* Kuzmin */

/* Nobody sees further out than this many times the middle's radius. */
#define KUZMIN_REACH 32.0

static Site
make_star (Scatter *scatter)
{
  const Site direction = random_direction (scatter);
  const double share = (random_between (scatter) + 1) / 2;
  /* share = 1/√(1 + r²) */
  const double radius = sqrt (1 / (share * share) - 1) / KUZMIN_REACH;

  return (Site){ radius * direction.x, radius * direction.y };
}

Site *
generator_kuzmin (guint n, guint64 seed, GError **error)
{
  Scatter scatter = { .state = seed, .bits = generator_bits (n) + 6 };

  if (!generator_check_count (n, GENERATOR_MAX, error))
    return NULL;
  return scatter_sites (&scatter, make_star, n);
}

/* Spiral */

/* A turn by the angle whose half has this tangent. */
static Site
turn_by_half_tangent (Site direction, double tangent)
{
  const double square = tangent * tangent;
  const double cosine = (1 - square) / (1 + square);
  const double sine = 2 * tangent / (1 + square);

  return (Site){ direction.x * cosine - direction.y * sine,
                 direction.x * sine + direction.y * cosine };
}

Site *
generator_spiral (guint n, GError **error)
{
  const int bits = generator_bits (n) + 2;
  /* As many turns as put neighbours on the line at half the distance of
   * neighbouring turns. */
  const double turns = sqrt (n / 6.25);
  Site direction = { 1, 0 };
  double before = 0;
  Site *sites;

  if (!generator_check_count (n, GENERATOR_MAX, error))
    return NULL;
  sites = g_new (Site, n);
  for (guint i = 0; i < n; i++) {
    /* Equal steps along the line are equal steps of r². */
    const double radius = sqrt ((i + 0.5) / n);

    direction
        = turn_by_half_tangent (direction, 3.125 * turns * (radius - before));
    sites[i] = (Site){ to_grid (radius * direction.x, bits),
                       to_grid (radius * direction.y, bits) };
    before = radius;
  }
  return sites;
}
