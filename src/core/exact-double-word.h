/* The signs in double-word arithmetic: 106 bits, and a bound on what rounding
 * took. Private to exact.c and exact-centre.c.
 *
 * Each function returns false when rounding may have turned the sign, and has
 * then decided nothing.
 */
#ifndef EXACT_DOUBLE_WORD_H
#define EXACT_DOUBLE_WORD_H

#include "exact-vector.h"

/* As the functions of exact-integer.h. */
bool double_word_cross (const Vector v[2], int *sign);
bool double_word_incircle (const Vector v[3], int *sign);
bool double_word_incircle_compare (const Vector v[6], int *sign);

/* Centre of the circle through @a and the sites at v[0], v[1] from it.
 *
 * Returns: false when a few units in the last place may be wrong.
 */
bool double_word_circumcentre (const Site *a, const Vector v[2], Site *centre);

#endif
