/* Where sites wait that have been orphaned: four of them at a time are asked
 * for the first facet of the cone that they may see. Private to hand-over. */
#ifndef CONE_FOUR_H
#define CONE_FOUR_H

#include "cone.h"

#include <float.h>
#include <stdint.h>

typedef double Four __attribute__ ((vector_size (32)));
typedef int64_t FourBits __attribute__ ((vector_size (32)));

/* So many are asked together. */
#define CONE_ORPHANS 32

/* A determinant at d is off by less than square · |d|² + offset · (|d.x| +
 * |d.y|). */
typedef struct ConeDoubt {
  double square, offset;
} ConeDoubt;

typedef struct ConeOrphans {
  uint32_t n;
  uint32_t site[CONE_ORPHANS];
  Four x[CONE_ORPHANS / 4], y[CONE_ORPHANS / 4]; /* from the apex */
  /* The first facet whose determinant is not below -doubt, or -1. */
  FourBits facet[CONE_ORPHANS / 4];
  Four front[CONE_ORPHANS / 4], doubt[CONE_ORPHANS / 4];
} ConeOrphans;

/* Macros, for where there is no AVX no function can return so many. */
#define FOUR_OF(value)                                                         \
  (Four) { (value), (value), (value), (value) }
#define FOUR_BITS_OF(value)                                                    \
  (FourBits) { (value), (value), (value), (value) }
#define FOUR_CHOOSE(which, yes, no) (((yes) & (which)) | ((no) & ~(which)))

/* Asks the facets of one block, the last one first, so that the first one has
 * the last word. */
static inline void
cone_ask_block (const ConeBlock *block,
                uint32_t n,
                const Four at[3],
                const Four *least,
                FourBits *facet,
                Four *front)
{
  while (n-- > 0) {
    const Four value = FOUR_OF (block->area[n]) * at[2]
                       - FOUR_OF (block->normal_x[n]) * at[0]
                       - FOUR_OF (block->normal_y[n]) * at[1];
    const FourBits sees = (FourBits)(value >= *least);

    *front = (Four)FOUR_CHOOSE (sees, (FourBits)value, (FourBits)*front);
    *facet = FOUR_CHOOSE (sees, FOUR_BITS_OF (n), *facet);
  }
}

/* Asks the blocks in turn for four sites until each has found its facet. */
static inline void
cone_ask (const ConeBlock *cone,
          uint32_t n_facets,
          const ConeDoubt *doubt,
          ConeOrphans *orphans,
          uint32_t k)
{
  const FourBits no_sign = FOUR_BITS_OF (INT64_MAX);
  const FourBits none = FOUR_BITS_OF (-1);
  const Four x = orphans->x[k], y = orphans->y[k];
  const Four at[3] = { x, y, x * x + y * y };
  const Four reach
      = (Four)((FourBits)x & no_sign) + (Four)((FourBits)y & no_sign);
  FourBits facet = none;
  Four least;
  Four front = { 0 };
  uint32_t first;

  orphans->doubt[k] = FOUR_OF (doubt->square) * at[2]
                      + FOUR_OF (doubt->offset) * reach + FOUR_OF (DBL_MIN);
  least = -orphans->doubt[k];
  for (first = 0; first < n_facets; first += CONE_LANES) {
    const uint32_t n
        = n_facets - first < CONE_LANES ? n_facets - first : CONE_LANES;
    const int64_t base = first;
    FourBits found = none;
    Four value = front;

    cone_ask_block (&cone[first / CONE_LANES], n, at, &least, &found, &value);
    found = FOUR_CHOOSE ((FourBits)(found < 0), none,
                         found + FOUR_BITS_OF (base));
    front = (Four)FOUR_CHOOSE ((FourBits)(facet < 0), (FourBits)value,
                               (FourBits)front);
    facet = FOUR_CHOOSE ((FourBits)(facet < 0), found, facet);
    if ((facet[0] | facet[1] | facet[2] | facet[3]) >= 0)
      break;
  }
  orphans->facet[k] = facet;
  orphans->front[k] = front;
}

#endif
