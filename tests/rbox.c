#include "rbox.h"

#include "fixture.h"

#include <float.h>
#include <math.h>

typedef struct Maker {
  GRand *random;
  GArray *sites;
  guint n; /* how many to make */
} Maker;

static void
add (Maker *maker, double x, double y)
{
  const Site site = { x, y };

  g_array_append_val (maker->sites, site);
}

/* Between -1 and 1. */
static double
unit (Maker *maker)
{
  return 2 * g_rand_double (maker->random) - 1;
}

static int
whole (Maker *maker, int least, int most)
{
  return g_rand_int_range (maker->random, least, most + 1);
}

/* A point of the unit circle, by a rational parameter. */
static Site
direction (Maker *maker)
{
  const double t = unit (maker);
  const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);

  return whole (maker, 0, 1) == 0 ? (Site){ x, y } : (Site){ -x, y };
}

static void
make_cube (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const double x = unit (maker);

    add (maker, x, unit (maker));
  }
}

static void
make_diamond (Maker *maker)
{
  for (guint i = 0; i < maker->n / 4; i++) {
    const double side = i % 2 == 0 ? i : fabs (unit (maker));

    add (maker, side, 0);
    add (maker, -side, 0);
    add (maker, 0, side);
    add (maker, 0, -side);
  }
}

static void
make_ball (Maker *maker)
{
  while (maker->sites->len < maker->n) {
    const double x = unit (maker), y = unit (maker);

    if (x * x + y * y <= 1)
      add (maker, x, y);
  }
}

static void
make_sphere (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const Site at = direction (maker);

    add (maker, at.x, at.y);
  }
}

static void
make_shell (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const Site at = direction (maker);
    const double radius = 1 - 0x1p-30 * g_rand_double (maker->random);

    add (maker, radius * at.x, radius * at.y);
  }
}

/* Turns @n times by the angle of @turn, moving outwards by @growth. */
static void
make_turns (Maker *maker, Site turn, double growth)
{
  Site at = { 1, 0 };

  for (guint i = 0; i < maker->n; i++) {
    const double x = at.x * turn.x - at.y * turn.y;

    add (maker, at.x, at.y);
    at.y = growth * (at.x * turn.y + at.y * turn.x);
    at.x = growth * x;
  }
}

/* The angle is bisected until the polygon has enough corners. */
static void
make_regular (Maker *maker)
{
  Site turn = { 0, 1 };
  guint n_corners = 4;

  while (n_corners < maker->n) {
    turn.y /= sqrt (2 * (1 + turn.x));
    turn.x = sqrt ((1 + turn.x) / 2);
    n_corners *= 2;
  }
  maker->n = n_corners;
  make_turns (maker, turn, 1);
}

static void
make_spiral (Maker *maker)
{
  const double t = 0x1p-5 + 0.5 * g_rand_double (maker->random);

  make_turns (maker, (Site){ (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t) },
              1 + 0x1p-6 * g_rand_double (maker->random));
}

static void
make_lens (Maker *maker)
{
  const double far = ldexp (1, whole (maker, 0, 20));

  for (guint i = 0; i < maker->n; i++) {
    const double x = unit (maker);
    const double bow = sqrt ((far * far + 1) - x * x) - far;

    add (maker, x, i % 2 == 0 ? bow : -bow);
  }
}

static guint
width_of_mesh (Maker *maker)
{
  return (guint)whole (maker, 2, MAX (2, (int)maker->n / 2));
}

static void
make_mesh (Maker *maker)
{
  const guint width = width_of_mesh (maker);

  for (guint i = 0; i < maker->n; i++) {
    const guint row = i / width;

    add (maker, i % width, row);
  }
}

static void
make_rotated (Maker *maker)
{
  const guint width = width_of_mesh (maker);

  for (guint i = 0; i < maker->n; i++) {
    const double column = i % width;
    const double row = floor ((double)i / width);

    add (maker, 0.6 * column - 0.8 * row, 0.8 * column + 0.6 * row);
  }
}

/* 65² is the sum of two squares in 36 ways. */
static void
make_cosphere (Maker *maker)
{
  const double scale = ldexp (1, whole (maker, -60, 60));

  for (int x = -65; x <= 65; x++) {
    const double y = sqrt (65 * 65 - x * x);

    if (y != floor (y))
      continue;
    for (guint i = 0; i < MAX (1, maker->n / 36); i++) {
      add (maker, (i + 1) * scale * x, (i + 1) * scale * y);
      add (maker, (i + 1) * scale * x, (i + 1) * scale * -y);
    }
  }
}

static void
make_integers (Maker *maker)
{
  const int most = whole (maker, 1, 12);

  for (guint i = 0; i < maker->n; i++) {
    const int x = whole (maker, -most, most);

    add (maker, x, whole (maker, -most, most));
  }
}

static void
make_mirrored (Maker *maker)
{
  for (guint i = 0; i < maker->n / 4; i++) {
    const double x = unit (maker), y = unit (maker);

    add (maker, x, y);
    add (maker, -x, y);
    add (maker, x, -y);
    add (maker, -x, -y);
  }
}

static void
make_line (Maker *maker)
{
  const int slope = whole (maker, -3, 3);
  const guint n_beside = (guint)whole (maker, 0, 3);

  for (guint i = 0; i < maker->n; i++) {
    const int x = whole (maker, -1000, 1000);

    add (maker, x, slope * x + (i < n_beside ? whole (maker, -9, 9) : 0));
  }
}

static void
make_near_line (Maker *maker)
{
  const double slope = unit (maker), height = unit (maker);

  for (guint i = 0; i < maker->n; i++) {
    const double x = unit (maker);

    add (maker, x, slope * x + height);
  }
}

static void
make_parabola (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const double x = whole (maker, 0, 1) == 0 ? unit (maker) : i;

    add (maker, x, x * x);
  }
}

static void
make_clusters (Maker *maker)
{
  Site knot = { 0, 0 };

  for (guint i = 0; i < maker->n; i++) {
    int aside;

    if (i % 7 == 0)
      knot.x = unit (maker);
    if (i % 7 == 0)
      knot.y = whole (maker, -3, 3);
    aside = whole (maker, -9, 9);
    add (maker, knot.x + ldexp (aside, -40),
         knot.y + ldexp (whole (maker, -9, 9), -40));
  }
}

static void
make_kuzmin (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const double left = 1 - g_rand_double (maker->random);
    const double radius = sqrt (1 / (left * left) - 1);
    const Site at = direction (maker);

    add (maker, radius * at.x, radius * at.y);
  }
}

static void
make_twins (Maker *maker)
{
  for (guint i = 0; i < maker->n / 3; i++) {
    const double x = unit (maker);
    const double y = i % 2 == 0 ? x : unit (maker);

    add (maker, x, y);
    add (maker, nextafter (x, 2), y);
    add (maker, x, nextafter (y, whole (maker, 0, 1) == 0 ? 2 : -2));
  }
}

static double
power (Maker *maker)
{
  const double value = ldexp (1, whole (maker, -SITE_RANGE, SITE_RANGE));
  const int sign = whole (maker, -3, 3);

  return sign == 0 ? 0 : copysign (value, sign);
}

static void
make_powers (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const double x = power (maker);

    add (maker, x, power (maker));
  }
}

static void
make_offset (Maker *maker)
{
  const int exponent = whole (maker, 1, 60);
  const double far = ldexp (1 + g_rand_double (maker->random), exponent);

  for (guint i = 0; i < maker->n; i++) {
    const double x = far + unit (maker);

    add (maker, x, 3 * far + unit (maker));
  }
}

static void
make_box (Maker *maker)
{
  const double side = ldexp (1, whole (maker, 1, 100));

  make_cube (maker);
  for (int i = 0; i < 4; i++)
    add (maker, i % 2 == 0 ? side : -side, i < 2 ? side : -side);
}

static void
make_width (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const double along = unit (maker);
    const double across = 1 - 0x1p-20 * g_rand_double (maker->random);
    const double signed_across = whole (maker, 0, 1) == 0 ? across : -across;

    if (whole (maker, 0, 1) == 0)
      add (maker, along, signed_across);
    else
      add (maker, signed_across, along);
  }
}

static void
make_subnormal (Maker *maker)
{
  const int most = whole (maker, 2, 1000);

  for (guint i = 0; i < maker->n; i++) {
    const double x = whole (maker, -most, most) * DBL_TRUE_MIN;

    add (maker, x, whole (maker, -most, most) * DBL_TRUE_MIN);
  }
}

static void
make_huge (Maker *maker)
{
  for (guint i = 0; i < maker->n; i++) {
    const double x = DBL_MAX * unit (maker);

    add (maker, x, DBL_MAX * (i % 3 == 0 ? unit (maker) : 0x1p-40));
  }
}

static const struct {
  const char *name;
  void (*make) (Maker *maker);
} kinds[N_RBOXES] = {
  [RBOX_CUBE] = { "cube", make_cube },
  [RBOX_DIAMOND] = { "diamond", make_diamond },
  [RBOX_BALL] = { "ball", make_ball },
  [RBOX_SPHERE] = { "sphere", make_sphere },
  [RBOX_SHELL] = { "shell", make_shell },
  [RBOX_REGULAR] = { "regular", make_regular },
  [RBOX_SPIRAL] = { "spiral", make_spiral },
  [RBOX_LENS] = { "lens", make_lens },
  [RBOX_MESH] = { "mesh", make_mesh },
  [RBOX_ROTATED] = { "rotated", make_rotated },
  [RBOX_COSPHERE] = { "cosphere", make_cosphere },
  [RBOX_INTEGERS] = { "integers", make_integers },
  [RBOX_MIRRORED] = { "mirrored", make_mirrored },
  [RBOX_LINE] = { "line", make_line },
  [RBOX_NEAR_LINE] = { "near-line", make_near_line },
  [RBOX_PARABOLA] = { "parabola", make_parabola },
  [RBOX_CLUSTERS] = { "clusters", make_clusters },
  [RBOX_KUZMIN] = { "kuzmin", make_kuzmin },
  [RBOX_TWINS] = { "twins", make_twins },
  [RBOX_POWERS] = { "powers", make_powers },
  [RBOX_OFFSET] = { "offset", make_offset },
  [RBOX_BOX] = { "box", make_box },
  [RBOX_WIDTH] = { "width", make_width },
  [RBOX_SUBNORMAL] = { "subnormal", make_subnormal },
  [RBOX_HUGE] = { "huge", make_huge },
};

static void
shuffle (Maker *maker)
{
  Site *sites = (Site *)(void *)maker->sites->data;

  for (guint i = maker->sites->len; i > 1; i--) {
    const guint j = (guint)g_rand_int_range (maker->random, 0, (gint32)i);
    const Site last = sites[i - 1];

    sites[i - 1] = sites[j];
    sites[j] = last;
  }
}

SiteSet *
rbox_new (Rbox kind, guint32 seed, guint n)
{
  g_autoptr (GArray) sites = g_array_new (FALSE, FALSE, sizeof (Site));
  Maker maker = { g_rand_new_with_seed (seed), sites, n };
  SiteSet *set;

  kinds[kind].make (&maker);
  shuffle (&maker);
  g_rand_free (maker.random);
  set = site_set_new ((const Site *)(void *)sites->data, sites->len);
  if (set == NULL)
    g_error ("%s %u leaves the range", kinds[kind].name, seed);
  return set;
}

const char *
rbox_name (Rbox kind)
{
  return kinds[kind].name;
}

void
rbox_for_each (guint n,
               guint most,
               void (*check) (const SiteSet *set, const char *name))
{
  const guint n_sets = fixture_n_seeds (n) * N_RBOXES;

  for (guint i = 0; i < n_sets; i++) {
    const guint32 seed = i / N_RBOXES;
    /* Small sets have the rare cases, large ones the long loops. */
    const guint n_sites = seed % 2 == 0 ? most : 4 + seed * 7 % most;
    g_autofree char *name = g_strdup_printf (
        "%s %u of %u sites", kinds[i % N_RBOXES].name, seed, n_sites);
    SiteSet *set = rbox_new (i % N_RBOXES, seed, n_sites);

    check (set, name);
    site_set_free (set);
  }
}
