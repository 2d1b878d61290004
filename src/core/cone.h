/* The cone as it looks from its apex, eight facets side by side, so that one
 * instruction asks several of them at once. Private to hand-over. */
#ifndef CONE_H
#define CONE_H

#include "site.h"

#include <math.h>

#ifdef __AVX2__
#include <immintrin.h>
#endif

#define CONE_LANES 8

/* A site as seen from the apex. */
typedef struct Offset {
  double x, y, square;
} Offset;

static inline Offset
offset_of (const Site *site, const Site *apex)
{
  const double x = site->x - apex->x, y = site->y - apex->y;

  return (Offset){ x, y, x * x + y * y };
}

/* The plane of one facet: the determinant of a site at d from the apex is
 * area · |d|² - normal · d. */
typedef struct ConePlane {
  double area, normal_x, normal_y;
} ConePlane;

/* The planes of eight. A lane without a facet has an area of -∞: no site is in
 * front of it. */
typedef struct ConeBlock {
  double area[CONE_LANES], normal_x[CONE_LANES], normal_y[CONE_LANES];
} ConeBlock;

/* A determinant, and how far rounding may have moved it. */
typedef struct Rounded {
  double value, doubt;
} Rounded;

/* What waits at one of them. An end of a list, also of an empty one, is the
 * number of sites, for which there is room: nobody need ask for it. */
typedef struct ConeSet {
  Rounded furthest;      /* the greatest determinant; -∞ when none waits */
  uint32_t head, others; /* the furthest site, and the first of the others */
} ConeSet;

/* The plane of the facet on a ridge. */
static inline ConePlane
cone_plane (const Offset *tail, const Offset *head)
{
  return (ConePlane){ tail->x * head->y - tail->y * head->x,
                      tail->square * head->y - head->square * tail->y,
                      head->square * tail->x - tail->square * head->x };
}

static inline double
cone_front (const ConePlane *plane, const Offset *at)
{
  return plane->area * at->square - plane->normal_x * at->x
         - plane->normal_y * at->y;
}

static inline ConePlane
cone_block_plane (const ConeBlock *block, uint32_t lane)
{
  return (ConePlane){ block->area[lane], block->normal_x[lane],
                      block->normal_y[lane] };
}

/* Writes the determinants of a site.
 *
 * Returns: a bit for each lane that is not below @least: with what rounding may
 *          have taken, a facet that the site sees; with less than nothing, one
 *          that it may see. */
static inline uint32_t
cone_fronts (const ConeBlock *block,
             const Offset *at,
             double least,
             double front[CONE_LANES])
{
  uint32_t seen = 0;
  uint32_t lane;

#ifdef __AVX2__
  const __m256d x = _mm256_set1_pd (at->x), y = _mm256_set1_pd (at->y);
  const __m256d square = _mm256_set1_pd (at->square);
  const __m256d bound = _mm256_set1_pd (least);

  for (lane = 0; lane < CONE_LANES; lane += 4) {
    const __m256d lift
        = _mm256_mul_pd (_mm256_loadu_pd (&block->area[lane]), square);
    const __m256d along_x
        = _mm256_mul_pd (_mm256_loadu_pd (&block->normal_x[lane]), x);
    const __m256d along_y
        = _mm256_mul_pd (_mm256_loadu_pd (&block->normal_y[lane]), y);
    const __m256d four = _mm256_sub_pd (_mm256_sub_pd (lift, along_x), along_y);

    _mm256_storeu_pd (&front[lane], four);
    seen |= (uint32_t)_mm256_movemask_pd (
                _mm256_cmp_pd (four, bound, _CMP_GE_OQ))
            << lane;
  }
#else
  for (lane = 0; lane < CONE_LANES; lane++)
    front[lane] = block->area[lane] * at->square - block->normal_x[lane] * at->x
                  - block->normal_y[lane] * at->y;
  for (lane = 0; lane < CONE_LANES; lane++)
    seen |= (uint32_t)(front[lane] >= least) << lane;
#endif
  return seen;
}

#endif
