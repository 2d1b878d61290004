/* An expansion is a sum of doubles that do not overlap, smallest first,
 * without zeros; the empty one is zero. Sums and products of expansions are
 * exact as long as nothing overflows or underflows, and nothing does: in
 * SITE_RANGE every coordinate is a multiple of 2^-197 and less than 2^146,
 * and no predicate multiplies more than four of their differences, so that
 * every term stays a multiple of 2^-788 and less than 2^600. */
#include "exact.h"

#include <assert.h>
#include <float.h>
#include <math.h>

/* Error-free sums need every operation rounded once, to double. */
_Static_assert(FLT_EVAL_METHOD == 0, "doubles are not computed as doubles");

/* Room for the terms of the results, by the sizes of the operands: a sum has
 * at most n + m terms, a product at most 2 n m. expansion_add() and
 * expansion_multiply() assert it. */
enum {
  DIFFERENCE = 2, /* of two coordinates */
  PRODUCT = 2 * DIFFERENCE * DIFFERENCE,
  MINOR = 2 * PRODUCT,         /* a b - c d, or a² + b² */
  ELEMENT = 2 * MINOR * MINOR, /* of the expanded determinant */
  DETERMINANT = 3 * ELEMENT,
  COMPARISON = 2 * DETERMINANT,
  CENTRE_PRODUCT = 2 * DIFFERENCE * MINOR,
  CENTRE_OFFSET = 2 * CENTRE_PRODUCT,
  CENTRE = CENTRE_OFFSET + 2 * MINOR, /* offset + coordinate * minor */
};

typedef struct Expansion {
  double *terms;
  int n_terms, room;
} Expansion;

#define EXPANSION(name, size)                                                  \
  double name##_terms[size];                                                   \
  Expansion name = { name##_terms, 0, size }

static void
append (Expansion *e, double term)
{
  if (term == 0)
    return;
  assert (e->n_terms < e->room);
  e->terms[e->n_terms] = term;
  e->n_terms += 1;
}

/* Returns: a + b rounded; *@error is what rounding took away.
 * Source:  Knuth; Shewchuk 1997, theorem 7. */
static double
two_sum (double a, double b, double *error)
{
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;

  *error = (a - a_virtual) + (b - b_virtual);
  return sum;
}

/* Splits @a into two halves of at most 26 bits.
 * Source:  Dekker; Shewchuk 1997, theorem 17. */
static double
split (double a, double *low)
{
  const double big = 134217729 * a; /* 2^27 + 1 */
  const double high = big - (big - a);

  *low = a - high;
  return high;
}

/* Returns: a b rounded; *@error is what rounding took away.
 * Source:  Dekker, Veltkamp; Shewchuk 1997, theorem 18. */
static double
two_product (double a, double b, double *error)
{
  const double product = a * b;
  double a_low, b_low;
  const double a_high = split (a, &a_low);
  const double b_high = split (b, &b_low);

  *error = a_low * b_low
           - (product - a_high * b_high - a_low * b_high - a_high * b_low);
  return product;
}

/* sum = e + sign f, where @sign is 1 or -1.
 * Source: Shewchuk 1997, FAST-EXPANSION-SUM with zero elimination. */
static void
expansion_add (const Expansion *e,
               double sign,
               const Expansion *f,
               Expansion *sum)
{
  int i = 0, j = 0;
  double total = 0, error;

  assert (e->n_terms + f->n_terms <= sum->room);
  sum->n_terms = 0;
  while (i < e->n_terms || j < f->n_terms) {
    const bool is_from_e
        = j == f->n_terms
          || (i < e->n_terms && fabs (e->terms[i]) <= fabs (f->terms[j]));
    const double term = is_from_e ? e->terms[i] : sign * f->terms[j];

    i += is_from_e ? 1 : 0;
    j += is_from_e ? 0 : 1;
    total = two_sum (total, term, &error);
    append (sum, error);
  }
  append (sum, total);
}

/* Source: Shewchuk 1997, SCALE-EXPANSION with zero elimination. */
static void
expansion_scale (const Expansion *e, double factor, Expansion *product)
{
  double total = 0;

  assert (2 * e->n_terms <= product->room);
  product->n_terms = 0;
  for (int i = 0; i < e->n_terms; i += 1) {
    double low, error;
    const double high = two_product (e->terms[i], factor, &low);

    total = two_sum (total, low, &error);
    append (product, error);
    total = two_sum (high, total, &error);
    append (product, error);
  }
  append (product, total);
}

static void
expansion_copy (const Expansion *e, Expansion *copy)
{
  copy->n_terms = 0;
  for (int i = 0; i < e->n_terms; i += 1)
    append (copy, e->terms[i]);
}

static void
expansion_double (Expansion *e)
{
  for (int i = 0; i < e->n_terms; i += 1)
    e->terms[i] *= 2;
}

static void
expansion_multiply (const Expansion *e, const Expansion *f, Expansion *product)
{
  EXPANSION (scaled, 2 * MINOR);
  EXPANSION (sum, ELEMENT);

  assert (2 * e->n_terms * f->n_terms <= product->room);
  product->n_terms = 0;
  for (int i = 0; i < f->n_terms; i += 1) {
    expansion_scale (e, f->terms[i], &scaled);
    expansion_add (product, 1, &scaled, &sum);
    expansion_copy (&sum, product);
  }
}

/* The last term is larger than all others together. */
static int
expansion_sign (const Expansion *e)
{
  if (e->n_terms == 0)
    return 0;
  return e->terms[e->n_terms - 1] > 0 ? 1 : -1;
}

static double
expansion_estimate (const Expansion *e)
{
  double sum = 0;

  for (int i = 0; i < e->n_terms; i += 1)
    sum += e->terms[i];
  return sum;
}

/* A vector of the plane between two sites, exactly. */
typedef struct Vector {
  double x_terms[DIFFERENCE], y_terms[DIFFERENCE];
  Expansion x, y;
} Vector;

/* difference = a - b */
static void
subtract (double a, double b, Expansion *difference)
{
  double error;
  const double rounded = two_sum (a, -b, &error);

  append (difference, error);
  append (difference, rounded);
}

static void
vector_init (Vector *v, const Site *to, const Site *from)
{
  v->x = (Expansion){ v->x_terms, 0, DIFFERENCE };
  v->y = (Expansion){ v->y_terms, 0, DIFFERENCE };
  subtract (to->x, from->x, &v->x);
  subtract (to->y, from->y, &v->y);
}

/* cross = v.x w.y - v.y w.x */
static void
vector_cross (const Vector *v, const Vector *w, Expansion *cross)
{
  EXPANSION (left, PRODUCT);
  EXPANSION (right, PRODUCT);

  expansion_multiply (&v->x, &w->y, &left);
  expansion_multiply (&v->y, &w->x, &right);
  expansion_add (&left, -1, &right, cross);
}

/* square = v.x² + v.y² */
static void
vector_square (const Vector *v, Expansion *square)
{
  EXPANSION (left, PRODUCT);
  EXPANSION (right, PRODUCT);

  expansion_multiply (&v->x, &v->x, &left);
  expansion_multiply (&v->y, &v->y, &right);
  expansion_add (&left, 1, &right, square);
}

int
exact_orient (const Site *a, const Site *b, const Site *c)
{
  Vector from_c_to_a, from_c_to_b;
  EXPANSION (area, MINOR);

  vector_init (&from_c_to_a, a, c);
  vector_init (&from_c_to_b, b, c);
  vector_cross (&from_c_to_a, &from_c_to_b, &area);
  return expansion_sign (&area);
}

/* element = u² (v × w) */
static void
add_element (const Vector *u,
             const Vector *v,
             const Vector *w,
             Expansion *determinant)
{
  EXPANSION (square, MINOR);
  EXPANSION (cross, MINOR);
  EXPANSION (element, ELEMENT);
  EXPANSION (sum, DETERMINANT);

  vector_square (u, &square);
  vector_cross (v, w, &cross);
  expansion_multiply (&square, &cross, &element);
  expansion_add (determinant, 1, &element, &sum);
  expansion_copy (&sum, determinant);
}

/* The determinant of Shewchuk's INCIRCLE: positive when d lies inside the
 * circle of the counter-clockwise triangle abc. */
static void
incircle (const Site *a,
          const Site *b,
          const Site *c,
          const Site *d,
          Expansion *determinant)
{
  Vector to_a, to_b, to_c;

  vector_init (&to_a, a, d);
  vector_init (&to_b, b, d);
  vector_init (&to_c, c, d);
  determinant->n_terms = 0;
  add_element (&to_a, &to_b, &to_c, determinant);
  add_element (&to_b, &to_c, &to_a, determinant);
  add_element (&to_c, &to_a, &to_b, determinant);
}

int
exact_lift_orient (const Site *a, const Site *b, const Site *c, const Site *d)
{
  EXPANSION (determinant, DETERMINANT);

  incircle (a, b, c, d, &determinant);
  return -expansion_sign (&determinant);
}

int
exact_lift_further (const Site plane[3], const Site *p, const Site *q)
{
  EXPANSION (behind_p, DETERMINANT);
  EXPANSION (behind_q, DETERMINANT);
  EXPANSION (comparison, COMPARISON);

  incircle (&plane[0], &plane[1], &plane[2], p, &behind_p);
  incircle (&plane[0], &plane[1], &plane[2], q, &behind_q);
  expansion_add (&behind_q, -1, &behind_p, &comparison);
  return expansion_sign (&comparison);
}

/* centre = (offset + coordinate * divisor) / divisor, where offset may be
 * far larger than the sum: nothing is rounded before the division. */
static double
centre_coordinate (const Expansion *offset,
                   double coordinate,
                   const Expansion *divisor)
{
  EXPANSION (scaled, 2 * MINOR);
  EXPANSION (numerator, CENTRE);

  expansion_scale (divisor, coordinate, &scaled);
  expansion_add (offset, 1, &scaled, &numerator);
  return expansion_estimate (&numerator) / expansion_estimate (divisor);
}

/* offset = left left_square - right right_square */
static void
centre_offset (const Expansion *left,
               const Expansion *left_square,
               const Expansion *right,
               const Expansion *right_square,
               Expansion *offset)
{
  EXPANSION (left_product, CENTRE_PRODUCT);
  EXPANSION (right_product, CENTRE_PRODUCT);

  expansion_multiply (left, left_square, &left_product);
  expansion_multiply (right, right_square, &right_product);
  expansion_add (&left_product, -1, &right_product, offset);
}

Site
exact_circumcentre (const Site *a, const Site *b, const Site *c)
{
  Vector to_b, to_c;
  EXPANSION (b_square, MINOR);
  EXPANSION (c_square, MINOR);
  EXPANSION (divisor, MINOR);
  EXPANSION (x, CENTRE_OFFSET);
  EXPANSION (y, CENTRE_OFFSET);

  vector_init (&to_b, b, a);
  vector_init (&to_c, c, a);
  vector_square (&to_b, &b_square);
  vector_square (&to_c, &c_square);
  vector_cross (&to_b, &to_c, &divisor);
  expansion_double (&divisor); /* four times the area of abc */
  centre_offset (&to_c.y, &b_square, &to_b.y, &c_square, &x);
  centre_offset (&to_b.x, &c_square, &to_c.x, &b_square, &y);
  return (Site){ centre_coordinate (&x, a->x, &divisor),
                 centre_coordinate (&y, a->y, &divisor) };
}
