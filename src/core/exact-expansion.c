#include "exact-expansion.h"

#include <assert.h>
#include <math.h>

static void
append (Expansion *e, double term)
{
  if (term == 0)
    return;
  assert (e->n_terms < e->room);
  e->terms[e->n_terms] = term;
  e->n_terms += 1;
}

/* Source: Shewchuk 1997, FAST-EXPANSION-SUM with zero elimination. */
void
expansion_add (const Expansion *e,
               double sign,
               const Expansion *f,
               Expansion *sum)
{
  int i = 0, j = 0;
  DoubleWord total = { 0, 0 };

  assert (e->n_terms + f->n_terms <= sum->room);
  sum->n_terms = 0;
  while (i < e->n_terms || j < f->n_terms) {
    const bool is_from_e
        = j == f->n_terms
          || (i < e->n_terms && fabs (e->terms[i]) <= fabs (f->terms[j]));
    const double term = is_from_e ? e->terms[i] : sign * f->terms[j];

    i += is_from_e ? 1 : 0;
    j += is_from_e ? 0 : 1;
    total = two_sum (total.high, term);
    append (sum, total.low);
  }
  append (sum, total.high);
}

/* Source: Shewchuk 1997, SCALE-EXPANSION with zero elimination. */
void
expansion_scale (const Expansion *e, double factor, Expansion *product)
{
  DoubleWord total = { 0, 0 };

  assert (2 * e->n_terms <= product->room);
  product->n_terms = 0;
  for (int i = 0; i < e->n_terms; i += 1) {
    const DoubleWord term = two_product (e->terms[i], factor);

    total = two_sum (total.high, term.low);
    append (product, total.low);
    total = two_sum (term.high, total.high);
    append (product, total.low);
  }
  append (product, total.high);
}

void
expansion_copy (const Expansion *e, Expansion *copy)
{
  copy->n_terms = 0;
  for (int i = 0; i < e->n_terms; i += 1)
    append (copy, e->terms[i]);
}

void
expansion_multiply (const Expansion *e, const Expansion *f, Expansion *product)
{
  EXPANSION (scaled, 2 * EXPANSION_MINOR);
  EXPANSION (sum, EXPANSION_ELEMENT);

  assert (2 * e->n_terms * f->n_terms <= product->room);
  product->n_terms = 0;
  for (int i = 0; i < f->n_terms; i += 1) {
    expansion_scale (e, f->terms[i], &scaled);
    expansion_add (product, 1, &scaled, &sum);
    expansion_copy (&sum, product);
  }
}

/* The last term is larger than all others together. */
int
expansion_sign (const Expansion *e)
{
  if (e->n_terms == 0)
    return 0;
  return e->terms[e->n_terms - 1] > 0 ? 1 : -1;
}

double
expansion_estimate (const Expansion *e)
{
  double sum = 0;

  for (int i = 0; i < e->n_terms; i += 1)
    sum += e->terms[i];
  return sum;
}

void
expansion_set (Expansion *e, DoubleWord value)
{
  e->n_terms = 0;
  append (e, value.low);
  append (e, value.high);
}

/* product = a b */
static void
multiply (DoubleWord a, DoubleWord b, Expansion *product)
{
  EXPANSION (left, EXPANSION_DIFFERENCE);
  EXPANSION (right, EXPANSION_DIFFERENCE);

  expansion_set (&left, a);
  expansion_set (&right, b);
  expansion_multiply (&left, &right, product);
}

void
vector_cross (const Vector *v, const Vector *w, Expansion *cross)
{
  EXPANSION (left, EXPANSION_PRODUCT);
  EXPANSION (right, EXPANSION_PRODUCT);

  multiply (v->x, w->y, &left);
  multiply (v->y, w->x, &right);
  expansion_add (&left, -1, &right, cross);
}

void
vector_square (const Vector *v, Expansion *square)
{
  EXPANSION (left, EXPANSION_PRODUCT);
  EXPANSION (right, EXPANSION_PRODUCT);

  multiply (v->x, v->x, &left);
  multiply (v->y, v->y, &right);
  expansion_add (&left, 1, &right, square);
}
