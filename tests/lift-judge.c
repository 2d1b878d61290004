#include "lift-judge.h"

#include <gmp.h>

typedef mpq_t Lift[3];

static void
lift_init (Lift lift, const Site *site)
{
  mpq_t square;

  mpq_init (square);
  for (int i = 0; i < 3; i += 1)
    mpq_init (lift[i]);
  mpq_set_d (lift[0], site->x);
  mpq_set_d (lift[1], site->y);
  mpq_mul (lift[2], lift[0], lift[0]);
  mpq_mul (square, lift[1], lift[1]);
  mpq_add (lift[2], lift[2], square);
  mpq_clear (square);
}

static void
lift_clear (Lift lift)
{
  for (int i = 0; i < 3; i += 1)
    mpq_clear (lift[i]);
}

static void
lift_subtract (Lift lift, Lift other)
{
  for (int i = 0; i < 3; i += 1)
    mpq_sub (lift[i], lift[i], other[i]);
}

/* minor = u[i] v[j] - u[j] v[i] */
static void
minor (mpq_t result, Lift u, Lift v, int i, int j)
{
  mpq_t right;

  mpq_init (right);
  mpq_mul (result, u[i], v[j]);
  mpq_mul (right, u[j], v[i]);
  mpq_sub (result, result, right);
  mpq_clear (right);
}

int
lift_judge_orient (const Site *a, const Site *b, const Site *c)
{
  Lift u, v, origin;
  mpq_t area;
  int sign;

  lift_init (origin, a);
  lift_init (u, b);
  lift_init (v, c);
  mpq_init (area);
  lift_subtract (u, origin);
  lift_subtract (v, origin);
  minor (area, u, v, 0, 1);
  sign = mpq_sgn (area);
  lift_clear (origin);
  lift_clear (u);
  lift_clear (v);
  mpq_clear (area);
  return sign;
}

/* gap = normal of the plane through @plane, times the way to @d. */
static void
judge_gap (mpq_t gap, const Site plane[3], const Site *d)
{
  Lift u, v, way, origin;
  mpq_t normal;

  lift_init (origin, &plane[0]);
  lift_init (u, &plane[1]);
  lift_init (v, &plane[2]);
  lift_init (way, d);
  lift_subtract (u, origin);
  lift_subtract (v, origin);
  lift_subtract (way, origin);
  mpq_init (normal);
  mpq_set_ui (gap, 0, 1);
  for (int i = 0; i < 3; i += 1) {
    minor (normal, u, v, (i + 1) % 3, (i + 2) % 3);
    mpq_mul (normal, normal, way[i]);
    mpq_add (gap, gap, normal);
  }
  mpq_clear (normal);
  lift_clear (origin);
  lift_clear (u);
  lift_clear (v);
  lift_clear (way);
}

int
lift_judge_side (const Site plane[3], const Site *d)
{
  mpq_t gap;
  int sign;

  mpq_init (gap);
  judge_gap (gap, plane, d);
  sign = mpq_sgn (gap);
  mpq_clear (gap);
  return sign;
}

int
lift_judge_further (const Site plane[3], const Site *p, const Site *q)
{
  mpq_t p_gap, q_gap;
  int order;

  mpq_init (p_gap);
  mpq_init (q_gap);
  judge_gap (p_gap, plane, p);
  judge_gap (q_gap, plane, q);
  order = mpq_cmp (p_gap, q_gap);
  mpq_clear (p_gap);
  mpq_clear (q_gap);
  return (order > 0) - (order < 0);
}
