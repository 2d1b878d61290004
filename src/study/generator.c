#include "generator-private.h"

#include "order.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

G_DEFINE_QUARK (generator - error - quark, generator_error)

gboolean
generator_check_count (guint64 n, guint most, GError **error)
{
  g_autofree char *wanted = g_strdup_printf ("%" G_GUINT64_FORMAT, n);

  if (n >= 1 && n <= most)
    return TRUE;
  g_set_error (error, GENERATOR_ERROR, GENERATOR_ERROR_COUNT,
               _ ("there is no such set of %s sites; the nearest has %u"),
               wanted, n < 1 ? 1 : most);
  return FALSE;
}

int
generator_bits (guint n)
{
  int bits = 6;

  while ((G_GUINT64_CONSTANT (1) << (2 * bits + 2)) < 64 * (guint64)n)
    bits += 1;
  return bits;
}

guint32
generator_below (guint64 *state, guint32 most)
{
  return (guint32)(((order_random (state) >> 32) * (most + 1)) >> 32);
}

Site *
generator_random (guint n, guint64 seed, GError **error)
{
  g_autoptr (GHashTable) taken = g_hash_table_new (NULL, NULL);
  const int bits = generator_bits (n);
  const guint32 most = (guint32)2 << bits;
  guint64 state = seed;
  Site *sites;

  if (!generator_check_count (n, GENERATOR_MAX, error))
    return NULL;
  sites = g_new (Site, n);
  for (guint i = 0; i < n;) {
    const guint32 x = generator_below (&state, most);
    const guint32 y = generator_below (&state, most);

    if (!g_hash_table_add (taken, GUINT_TO_POINTER (x * (most + 1) + y)))
      continue;
    sites[i].x = ldexp (x, -bits) - 1;
    sites[i].y = ldexp (y, -bits) - 1;
    i += 1;
  }
  return sites;
}

/* Returns: the exponent of the power of two that brings -@size … @size into
 *          -1 … 1. */
static int
fit_exponent (double size)
{
  int exponent;

  /* size = fraction · 2^exponent with fraction in 1/2 … 1. */
  if (size == 0)
    return 0;
  return frexp (size, &exponent) == 0.5 ? 1 - exponent : -exponent;
}

Site *
generator_grid (guint width, guint height, GError **error)
{
  const guint64 n = (guint64)width * height;
  /* Twice the coordinates are whole: columns -(width - 1), … by twos. */
  const int exponent = fit_exponent (MAX (width, height) - 1.0);
  Site *sites;

  if (!generator_check_count (n, GENERATOR_MAX, error))
    return NULL;
  sites = g_new (Site, n);
  for (guint i = 0; i < n; i++) {
    const guint column = i % width, row = i / width;

    sites[i].x = ldexp (2.0 * column - (width - 1.0), exponent);
    sites[i].y = ldexp (2.0 * row - (height - 1.0), exponent);
  }
  return sites;
}

Site *
generator_line (guint n, GError **error)
{
  static const guint gaps[] = { 2, 1, 3 };
  Site *sites;
  double length = 0, at = 0;

  if (!generator_check_count (n, GENERATOR_MAX, error))
    return NULL;
  for (guint i = 0; i + 1 < n; i++)
    length += gaps[i % G_N_ELEMENTS (gaps)];

  sites = g_new (Site, n);
  for (guint i = 0; i < n; i++) {
    sites[i].x = ldexp (2 * (2 * at - length), fit_exponent (2 * length));
    sites[i].y = ldexp (2 * at - length, fit_exponent (2 * length));
    at += gaps[i % G_N_ELEMENTS (gaps)];
  }
  return sites;
}

/* A Gaussian integer: x + iy, and an integer point of the plane. */
typedef struct Gaussian {
  gint64 x, y;
} Gaussian;

static Gaussian
gaussian_times (Gaussian a, Gaussian b)
{
  return (Gaussian){ a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x };
}

/* The primes 5, 13, 17, … = 4k + 1, each as x² + y². */
static const Gaussian primes[] = {
  { 2, 1 }, { 3, 2 }, { 4, 1 }, { 5, 2 }, { 6, 1 }, { 5, 4 },
  { 7, 2 }, { 6, 5 }, { 8, 3 }, { 8, 5 }, { 9, 4 },
};

G_STATIC_ASSERT (GENERATOR_CIRCLE_MAX == 4 << G_N_ELEMENTS (primes));

/* Returns: by how many primes a circle has four times as many integer points
 *          as sites are wanted, so that these can be well spread; all primes
 *          when none has. */
static guint
circle_primes (guint n)
{
  guint n_primes = 2;

  while (n_primes < G_N_ELEMENTS (primes) && (4u << n_primes) < 4 * n)
    n_primes += 1;
  return n_primes;
}

/* All integer points on the circle whose radius² is the product of the first
 * @n_primes primes: each prime doubles them, since (2 + i) and (2 - i) turn a
 * point to two others.
 *
 * Shape: 4·2^n_primes points. */
static Gaussian *
circle_points (guint n_primes)
{
  static const Gaussian units[] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  Gaussian *points = g_new (Gaussian, 4u << n_primes);

  memcpy (points, units, sizeof units);
  for (guint i = 0; i < n_primes; i++) {
    const Gaussian conjugate = { primes[i].x, -primes[i].y };
    const guint n = 4u << i;

    for (guint j = 0; j < n; j++) {
      points[n + j] = gaussian_times (points[j], conjugate);
      points[j] = gaussian_times (points[j], primes[i]);
    }
  }
  return points;
}

static gboolean
is_below (const Gaussian *point)
{
  return point->y < 0 || (point->y == 0 && point->x < 0);
}

/* By angle from 0, exactly. */
static int
compare_angles (const void *left, const void *right)
{
  const Gaussian *a = left, *b = right;
  const gint64 turn = a->x * b->y - a->y * b->x;

  if (is_below (a) != is_below (b))
    return is_below (a) ? 1 : -1;
  return turn > 0 ? -1 : turn < 0;
}

Site *
generator_circle (guint n, GError **error)
{
  g_autofree Gaussian *points = NULL;
  guint64 n_points;
  double radius;
  Site *sites;

  if (!generator_check_count (n, GENERATOR_CIRCLE_MAX, error))
    return NULL;
  points = circle_points (circle_primes (n));
  n_points = 4u << circle_primes (n);
  radius = hypot ((double)points[0].x, (double)points[0].y);
  qsort (points, n_points, sizeof *points, compare_angles);

  sites = g_new (Site, n);
  for (guint i = 0; i < n; i++) {
    const Gaussian point = points[i * n_points / n];

    sites[i].x = ldexp ((double)point.x, fit_exponent (radius));
    sites[i].y = ldexp ((double)point.y, fit_exponent (radius));
  }
  return sites;
}
