#include "judge.h"

#include <math.h>
#include <stdlib.h>

/* Returns: the lowest power of two that divides all coordinates. */
static int
lowest_exponent (const SiteSet *set)
{
  int lowest = 0;

  for (uint32_t i = 0; i < 2 * set->n_sites; i++) {
    const Site *site = &set->sites[i / 2];
    int exponent;

    if (frexp (i % 2 == 0 ? site->x : site->y, &exponent) != 0
        && exponent - 53 < lowest)
      lowest = exponent - 53;
  }
  return lowest;
}

/* Sets @integer to value · 2^-exponent, which is one. */
static void
set_integer (mpz_t integer, double value, int exponent)
{
  int own;
  const double mantissa = frexp (value, &own);

  mpz_set_d (integer, ldexp (mantissa, 53));
  if (mantissa != 0)
    mpz_mul_2exp (integer, integer, (mp_bitcnt_t)(own - 53 - exponent));
}

Judge *
judge_new (const SiteSet *set)
{
  Judge *judge = malloc (sizeof *judge);
  const int exponent = lowest_exponent (set);

  judge->n_sites = set->n_sites;
  judge->x = malloc ((set->n_sites + 1) * sizeof *judge->x);
  judge->y = malloc ((set->n_sites + 1) * sizeof *judge->y);
  for (uint32_t i = 0; i < set->n_sites; i++) {
    mpz_inits (judge->x[i], judge->y[i], NULL);
    set_integer (judge->x[i], set->sites[i].x, exponent);
    set_integer (judge->y[i], set->sites[i].y, exponent);
  }
  return judge;
}

void
judge_free (Judge *judge)
{
  for (uint32_t i = 0; i < judge->n_sites; i++)
    mpz_clears (judge->x[i], judge->y[i], NULL);
  free (judge->x);
  free (judge->y);
  free (judge);
}

/* Twice the area of abc. */
static void
set_area (const Judge *judge, mpz_t area, uint32_t a, uint32_t b, uint32_t c)
{
  mpz_t left, right;

  mpz_inits (left, right, NULL);
  mpz_sub (left, judge->x[b], judge->x[a]);
  mpz_sub (right, judge->y[c], judge->y[a]);
  mpz_mul (area, left, right);
  mpz_sub (left, judge->y[b], judge->y[a]);
  mpz_sub (right, judge->x[c], judge->x[a]);
  mpz_submul (area, left, right);
  mpz_clears (left, right, NULL);
}

int
judge_orient (const Judge *judge, uint32_t a, uint32_t b, uint32_t c)
{
  mpz_t area;
  int sign;

  mpz_init (area);
  set_area (judge, area, a, b, c);
  sign = mpz_sgn (area);
  mpz_clear (area);
  return sign;
}

int
judge_compare_areas (const Judge *judge,
                     const uint32_t line[2],
                     uint32_t p,
                     uint32_t q)
{
  mpz_t area, other;
  int sign;

  mpz_inits (area, other, NULL);
  set_area (judge, area, line[0], line[1], p);
  set_area (judge, other, line[0], line[1], q);
  sign = mpz_cmp (area, other);
  mpz_clears (area, other, NULL);
  return (sign > 0) - (sign < 0);
}

/* With a at the origin the circle's centre is (u, v) / (2 · area2), where
 *   u = y_c |b|² - y_b |c|²,  v = x_b |c|² - x_c |b|²,
 * and the power of d is |d|² - 2 d · centre.
 *
 * Source: any textbook on Cartesian circumcentres. */
typedef struct Circle {
  mpz_t bx, by, cx, cy, dx, dy, b2, c2, d2, area, u, v;
} Circle;

static void
circle_init (Circle *t)
{
  mpz_inits (t->bx, t->by, t->cx, t->cy, t->dx, t->dy, NULL);
  mpz_inits (t->b2, t->c2, t->d2, t->area, t->u, t->v, NULL);
}

static void
circle_clear (Circle *t)
{
  mpz_clears (t->bx, t->by, t->cx, t->cy, t->dx, t->dy, NULL);
  mpz_clears (t->b2, t->c2, t->d2, t->area, t->u, t->v, NULL);
}

static void
set_difference (const Judge *judge, mpz_t x, mpz_t y, uint32_t p, uint32_t a)
{
  mpz_sub (x, judge->x[p], judge->x[a]);
  mpz_sub (y, judge->y[p], judge->y[a]);
}

static void
set_square (mpz_t square, const mpz_t x, const mpz_t y)
{
  mpz_mul (square, x, x);
  mpz_addmul (square, y, y);
}

int
judge_power (const Judge *judge,
             const uint32_t circle[3],
             uint32_t site,
             mpz_t power)
{
  Circle t;

  circle_init (&t);
  set_difference (judge, t.bx, t.by, circle[1], circle[0]);
  set_difference (judge, t.cx, t.cy, circle[2], circle[0]);
  set_difference (judge, t.dx, t.dy, site, circle[0]);
  set_square (t.b2, t.bx, t.by);
  set_square (t.c2, t.cx, t.cy);
  set_square (t.d2, t.dx, t.dy);
  set_area (judge, t.area, circle[0], circle[1], circle[2]);

  mpz_mul (t.u, t.cy, t.b2);
  mpz_submul (t.u, t.by, t.c2);
  mpz_mul (t.v, t.bx, t.c2);
  mpz_submul (t.v, t.cx, t.b2);
  mpz_mul (power, t.d2, t.area);
  mpz_submul (power, t.dx, t.u);
  mpz_submul (power, t.dy, t.v);
  if (mpz_sgn (t.area) < 0)
    mpz_neg (power, power);
  circle_clear (&t);
  return mpz_sgn (power);
}

int
judge_circle (const Judge *judge, const uint32_t circle[3], uint32_t site)
{
  mpz_t power;
  int sign;

  mpz_init (power);
  sign = judge_power (judge, circle, site, power);
  mpz_clear (power);
  return sign;
}

static int
compare_sites (const Judge *judge, uint32_t a, uint32_t b)
{
  const int x = mpz_cmp (judge->x[a], judge->x[b]);

  return x != 0 ? x : mpz_cmp (judge->y[a], judge->y[b]);
}

/* Insertion sort from left to right: the sets are small. */
static uint32_t *
sorted (const Judge *judge, const uint32_t *active, uint32_t n_active)
{
  uint32_t *list = malloc ((n_active + 1) * sizeof *list);

  for (uint32_t i = 0; i < n_active; i++) {
    uint32_t j = i;

    for (; j > 0 && compare_sites (judge, active[i], list[j - 1]) < 0; j--)
      list[j] = list[j - 1];
    list[j] = active[i];
  }
  return list;
}

/* Source: Andrew 1979, the monotone chain. */
uint32_t
judge_hull (const Judge *judge,
            const uint32_t *active,
            uint32_t n_active,
            uint32_t *corners)
{
  uint32_t *list = sorted (judge, active, n_active);
  uint32_t n = 0, base = 0;

  for (uint32_t k = 0; n_active > 0 && k < 2 * n_active - 1; k++) {
    const uint32_t site = list[k < n_active ? k : 2 * n_active - 2 - k];

    if (k == n_active)
      base = n - 1;
    while (n >= base + 2
           && judge_orient (judge, corners[n - 2], corners[n - 1], site) <= 0)
      n -= 1;
    corners[n++] = site;
  }
  free (list);
  return n > 1 ? n - 1 : n; /* the first corner came again */
}

int
judge_inside (const Judge *judge,
              const uint32_t *corners,
              uint32_t n_corners,
              uint32_t site)
{
  int place = 1;

  for (uint32_t i = 0; i < n_corners; i++) {
    const uint32_t next = corners[(i + 1) % n_corners];
    const int turn = judge_orient (judge, corners[i], next, site);

    if (turn < place)
      place = turn;
  }
  return place;
}

bool
judge_cross (const Judge *judge, const uint32_t p[2], const uint32_t q[2])
{
  return judge_orient (judge, p[0], p[1], q[0])
                 * judge_orient (judge, p[0], p[1], q[1])
             < 0
         && judge_orient (judge, q[0], q[1], p[0])
                    * judge_orient (judge, q[0], q[1], p[1])
                < 0;
}

void
judge_add_area (const Judge *judge,
                const uint32_t *corners,
                uint32_t n_corners,
                mpz_t area)
{
  mpz_t part;

  mpz_init (part);
  for (uint32_t i = 2; i < n_corners; i++) {
    set_area (judge, part, corners[0], corners[i - 1], corners[i]);
    mpz_add (area, area, part);
  }
  mpz_clear (part);
}
