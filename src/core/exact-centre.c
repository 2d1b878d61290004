#include "exact.h"

#include "exact-double-word.h"
#include "exact-expansion.h"
#include "exact-integer.h"

enum {
  CENTRE_PRODUCT = 2 * EXPANSION_DIFFERENCE * EXPANSION_MINOR,
  CENTRE_OFFSET = 2 * CENTRE_PRODUCT,
  CENTRE = CENTRE_OFFSET + 2 * EXPANSION_MINOR, /* + coordinate * minor */
};

/* centre = (offset + coordinate * divisor) / divisor, where offset may be
 * far larger than the sum: nothing is rounded before the division. */
static double
centre_coordinate (const Expansion *offset,
                   double coordinate,
                   const Expansion *divisor)
{
  EXPANSION (scaled, 2 * EXPANSION_MINOR);
  EXPANSION (numerator, CENTRE);

  expansion_scale (divisor, coordinate, &scaled);
  expansion_add (offset, 1, &scaled, &numerator);
  return expansion_estimate (&numerator) / expansion_estimate (divisor);
}

/* offset = left left_square - right right_square */
static void
centre_offset (DoubleWord left,
               const Expansion *left_square,
               DoubleWord right,
               const Expansion *right_square,
               Expansion *offset)
{
  EXPANSION (left_factor, EXPANSION_DIFFERENCE);
  EXPANSION (right_factor, EXPANSION_DIFFERENCE);
  EXPANSION (left_product, CENTRE_PRODUCT);
  EXPANSION (right_product, CENTRE_PRODUCT);

  expansion_set (&left_factor, left);
  expansion_set (&right_factor, right);
  expansion_multiply (&left_factor, left_square, &left_product);
  expansion_multiply (&right_factor, right_square, &right_product);
  expansion_add (&left_product, -1, &right_product, offset);
}

/* The same without any doubt, from the vectors to b and c. */
static Site
expansion_circumcentre (const Site *a, const Vector v[2])
{
  EXPANSION (b_square, EXPANSION_MINOR);
  EXPANSION (c_square, EXPANSION_MINOR);
  EXPANSION (area, EXPANSION_MINOR);
  EXPANSION (divisor, 2 * EXPANSION_MINOR);
  EXPANSION (x, CENTRE_OFFSET);
  EXPANSION (y, CENTRE_OFFSET);

  vector_square (&v[0], &b_square);
  vector_square (&v[1], &c_square);
  vector_cross (&v[0], &v[1], &area);
  expansion_scale (&area, 2, &divisor);
  centre_offset (v[1].y, &b_square, v[0].y, &c_square, &x);
  centre_offset (v[0].x, &c_square, v[1].x, &b_square, &y);
  return (Site){ centre_coordinate (&x, a->x, &divisor),
                 centre_coordinate (&y, a->y, &divisor) };
}

Site
exact_circumcentre (const Site *a, const Site *b, const Site *c)
{
  const Vector v[3] = { vector_between (&(Site){ 0, 0 }, a),
                        vector_between (a, b), vector_between (a, c) };
  Site centre;

  if (double_word_circumcentre (a, v + 1, &centre)
      || integer_circumcentre (v, &centre))
    return centre;
  return expansion_circumcentre (a, v + 1);
}
