/* Expansions: sums of doubles that do not overlap, smallest first, without
 * zeros; the empty one is zero. Slow, and never in doubt. Private to exact.c
 * and exact-centre.c.
 *
 *   EXPANSION (area, EXPANSION_MINOR);
 *
 *   vector_cross (&v, &w, &area);
 *   turn = expansion_sign (&area);
 *
 * Source: Shewchuk 1997.
 */
#ifndef EXACT_EXPANSION_H
#define EXACT_EXPANSION_H

#include "exact-vector.h"

/* Room for the terms of the results, by the sizes of the operands: a sum has
 * at most n + m terms, a product at most 2 n m. expansion_add() and
 * expansion_multiply() assert it. */
enum {
  EXPANSION_DIFFERENCE = 2, /* of two coordinates */
  EXPANSION_PRODUCT = 2 * EXPANSION_DIFFERENCE * EXPANSION_DIFFERENCE,
  EXPANSION_MINOR = 2 * EXPANSION_PRODUCT, /* a b - c d, or a² + b² */
  EXPANSION_ELEMENT = 2 * EXPANSION_MINOR * EXPANSION_MINOR,
};

typedef struct Expansion {
  double *terms;
  int n_terms, room;
} Expansion;

#define EXPANSION(name, size)                                                  \
  double name##_terms[size];                                                   \
  Expansion name = { name##_terms, 0, size }

/* sum = e + sign f, where @sign is 1 or -1; @sum is neither of them. */
void expansion_add (const Expansion *e,
                    double sign,
                    const Expansion *f,
                    Expansion *sum);

void expansion_scale (const Expansion *e, double factor, Expansion *product);

/* The factors have at most EXPANSION_MINOR terms each. */
void
expansion_multiply (const Expansion *e, const Expansion *f, Expansion *product);

void expansion_copy (const Expansion *e, Expansion *copy);
int expansion_sign (const Expansion *e);

/* Returns: the sum, right but for a few units in the last place. */
double expansion_estimate (const Expansion *e);

void expansion_set (Expansion *e, DoubleWord value);

/* cross = v.x w.y - v.y w.x, square = v.x² + v.y² */
void vector_cross (const Vector *v, const Vector *w, Expansion *cross);
void vector_square (const Vector *v, Expansion *square);

#endif
