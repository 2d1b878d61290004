#include "hilbert.h"

#include "memory.h"
#include "order.h"

#include <math.h>
#include <stdlib.h>

/* The curve is followed four bits of each axis at a time. */
#define STEP_BITS 4
#define N_STEPS 5
#define AXIS_CELLS (1U << (STEP_BITS * N_STEPS))

/* For each of the curve's four turns and eight bits xxxxyyyy: the eight bits
 * of the key and the turn to go on with. */
typedef struct CurveStep {
  uint8_t key, turn;
} CurveStep;

typedef CurveStep Curve[4][256];

/* One bit of each axis: turns 0 … 3 are the curve, its transpose, and both
 * turned about. */
static CurveStep
single_step (unsigned turn, unsigned x, unsigned y)
{
  static const uint8_t keys[4][4] = { /* by 2x + y */
                                      { 0, 1, 3, 2 },
                                      { 0, 3, 1, 2 },
                                      { 2, 3, 1, 0 },
                                      { 2, 1, 3, 0 }
  };
  static const uint8_t turns[4][4]
      = { { 1, 0, 3, 0 }, { 0, 2, 1, 1 }, { 2, 1, 2, 3 }, { 3, 3, 0, 2 } };

  return (CurveStep){ keys[turn][2 * x + y], turns[turn][2 * x + y] };
}

static void
fill_curve (Curve curve)
{
  unsigned turn, cell;
  int bit;

  for (turn = 0; turn < 4; turn++)
    for (cell = 0; cell < 256; cell++) {
      CurveStep all = { 0, (uint8_t)turn };

      for (bit = STEP_BITS - 1; bit >= 0; bit--) {
        const CurveStep one
            = single_step (all.turn, cell >> (bit + 4) & 1, cell >> bit & 1);

        all.key = (uint8_t)(all.key << 2 | one.key);
        all.turn = one.turn;
      }
      curve[turn][cell] = all;
    }
}

static uint64_t
key_of (Curve curve, uint32_t x, uint32_t y)
{
  uint64_t key = 0;
  unsigned turn = 0;
  int shift;

  for (shift = STEP_BITS * (N_STEPS - 1); shift >= 0; shift -= STEP_BITS) {
    const CurveStep *step
        = &curve[turn][(x >> shift & 15) << 4 | (y >> shift & 15)];

    key = key << 8 | step->key;
    turn = step->turn;
  }
  return key;
}

/* Keys in the upper bits, indices in the lower ones; @index_bits is enough
 * for n, and takes bits from the key only beyond 2^24 sites. */
static void
fill_keys (const Site *sites, uint32_t n, unsigned index_bits, uint64_t *keys)
{
  Curve curve;
  double low_x = INFINITY, low_y = INFINITY;
  double high_x = -INFINITY, high_y = -INFINITY;
  double scale;
  uint32_t i;

  fill_curve (curve);
  for (i = 0; i < n; i++) {
    low_x = sites[i].x < low_x ? sites[i].x : low_x;
    high_x = sites[i].x > high_x ? sites[i].x : high_x;
    low_y = sites[i].y < low_y ? sites[i].y : low_y;
    high_y = sites[i].y > high_y ? sites[i].y : high_y;
  }
  scale = fmax (high_x - low_x, high_y - low_y);
  scale = scale > 0 ? (AXIS_CELLS - 1) / scale : 0;
  for (i = 0; i < n; i++) {
    const uint32_t x = (uint32_t)((sites[i].x - low_x) * scale);
    const uint32_t y = (uint32_t)((sites[i].y - low_y) * scale);

    keys[i] = key_of (curve, x, y) >> (index_bits - 24) << index_bits | i;
  }
}

#define DIGIT_BITS 10
#define N_DIGITS                                                               \
  4 /* an even number brings the keys back to where they were                  \
     */

/* Turns counts of digits into the places where the first of each goes. */
static void
add_up (uint32_t counts[1 << DIGIT_BITS])
{
  uint32_t sum = 0, i;

  for (i = 0; i < 1 << DIGIT_BITS; i++) {
    const uint32_t count = counts[i];

    counts[i] = sum;
    sum += count;
  }
}

/* Sorts by the bits from @from on, at most 40: a counting sort for each digit,
 * to and fro between the two lists. */
static void
radix_sort (uint64_t *keys, uint64_t *spare, uint32_t n, unsigned from)
{
  uint32_t next[N_DIGITS][1 << DIGIT_BITS] = { { 0 } };
  const uint64_t mask = (1 << DIGIT_BITS) - 1;
  unsigned digit;
  uint32_t i;

  for (i = 0; i < n; i++)
    for (digit = 0; digit < N_DIGITS; digit++)
      next[digit][keys[i] >> from >> (digit * DIGIT_BITS) & mask] += 1;
  for (digit = 0; digit < N_DIGITS; digit++) {
    uint64_t *const source = digit % 2 == 0 ? keys : spare;
    uint64_t *const target = digit % 2 == 0 ? spare : keys;
    const unsigned shift = digit * DIGIT_BITS;

    add_up (next[digit]);
    for (i = 0; i < n; i++)
      target[next[digit][source[i] >> from >> shift & mask]++] = source[i];
  }
}

void
hilbert_sort (const Site *sites, uint32_t n, uint32_t *list)
{
  uint64_t *keys = memory_new (2 * (size_t)n, sizeof *keys);
  unsigned index_bits = 24;
  uint32_t i;

  while (n >> index_bits != 0)
    index_bits++;
  fill_keys (sites, n, index_bits, keys);
  radix_sort (keys, keys + n, n, index_bits);
  for (i = 0; i < n; i++)
    list[i] = (uint32_t)(keys[i] & ((UINT64_C (1) << index_bits) - 1));
  free (keys);
}

/* Round 0 is the last and holds seven sites of eight; round k one of eight of
 * what is left. */
static unsigned
round_of (uint64_t *random)
{
  uint64_t bits = order_random (random);
  unsigned round = 0;

  while (round < 15 && (bits & 7) == 0) {
    bits >>= 3;
    round++;
  }
  return round;
}

void
hilbert_brio (const Site *sites, uint32_t n, uint32_t *list)
{
  uint32_t *curve = memory_new (n, sizeof *curve);
  uint8_t *rounds = memory_new (n, sizeof *rounds);
  uint32_t next[17] = { 0 };
  uint64_t random = 1;
  uint32_t i;

  hilbert_sort (sites, n, curve);
  for (i = 0; i < n; i++) {
    rounds[i] = (uint8_t)(15 - round_of (&random));
    next[rounds[i] + 1] += 1;
  }
  for (i = 1; i < 17; i++)
    next[i] += next[i - 1];
  for (i = 0; i < n; i++)
    list[next[rounds[i]]++] = curve[i];
  free (curve);
  free (rounds);
}
