/* Four ways, each tried when the one before it cannot tell: the filter of
 * predicate.c, integers on a grid, double words, expansions. */
#include "exact.h"

#include "exact-double-word.h"
#include "exact-expansion.h"
#include "exact-integer.h"

enum {
  DETERMINANT = 3 * EXPANSION_ELEMENT,
  COMPARISON = 2 * DETERMINANT,
};

static int
cross_sign (const Vector v[2])
{
  EXPANSION (area, EXPANSION_MINOR);
  int sign;

  if (integer_cross (v, &sign) || double_word_cross (v, &sign))
    return sign;
  vector_cross (&v[0], &v[1], &area);
  return expansion_sign (&area);
}

int
exact_orient (const Site *a, const Site *b, const Site *c)
{
  const Vector v[2] = { vector_between (c, a), vector_between (c, b) };

  return cross_sign (v);
}

int
exact_further_right (const Site *a, const Site *b, const Site *p, const Site *q)
{
  const Vector v[2] = { vector_between (a, b), vector_between (p, q) };

  return cross_sign (v);
}

/* element = u² (v × w) */
static void
add_element (const Vector *u,
             const Vector *v,
             const Vector *w,
             Expansion *determinant)
{
  EXPANSION (square, EXPANSION_MINOR);
  EXPANSION (cross, EXPANSION_MINOR);
  EXPANSION (element, EXPANSION_ELEMENT);
  EXPANSION (sum, DETERMINANT);

  vector_square (u, &square);
  vector_cross (v, w, &cross);
  expansion_multiply (&square, &cross, &element);
  expansion_add (determinant, 1, &element, &sum);
  expansion_copy (&sum, determinant);
}

/* The determinant of Shewchuk's INCIRCLE: positive when the origin lies
 * inside the circle of the counter-clockwise triangle v[0] v[1] v[2]. */
static void
incircle (const Vector v[3], Expansion *determinant)
{
  determinant->n_terms = 0;
  add_element (&v[0], &v[1], &v[2], determinant);
  add_element (&v[1], &v[2], &v[0], determinant);
  add_element (&v[2], &v[0], &v[1], determinant);
}

static int
expansion_incircle (const Vector v[3])
{
  EXPANSION (determinant, DETERMINANT);

  incircle (v, &determinant);
  return expansion_sign (&determinant);
}

static int
expansion_incircle_compare (const Vector v[6])
{
  EXPANSION (left, DETERMINANT);
  EXPANSION (right, DETERMINANT);
  EXPANSION (comparison, COMPARISON);

  incircle (v, &left);
  incircle (v + 3, &right);
  expansion_add (&left, -1, &right, &comparison);
  return expansion_sign (&comparison);
}

int
exact_lift_orient (const Site *a, const Site *b, const Site *c, const Site *d)
{
  const Vector v[3]
      = { vector_between (d, a), vector_between (d, b), vector_between (d, c) };
  int sign;

  if (integer_incircle (v, &sign) || double_word_incircle (v, &sign))
    return -sign;
  return -expansion_incircle (v);
}

int
exact_lift_further (const Site plane[3], const Site *p, const Site *q)
{
  Vector v[6];
  int sign;

  for (int i = 0; i < 3; i += 1) {
    v[i] = vector_between (q, &plane[i]);
    v[3 + i] = vector_between (p, &plane[i]);
  }
  if (integer_incircle_compare (v, &sign)
      || double_word_incircle_compare (v, &sign))
    return sign;
  return expansion_incircle_compare (v);
}
