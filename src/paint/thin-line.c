#include "thin-line.h"

#include <math.h>
#include <stddef.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/* Places across are counted in such parts of a pixel. */
#define PART_BITS 12
#define PARTS (1 << PART_BITS)

/* … and for the way from column to column in smaller ones, so that it does not
 * matter with which column a clip begins. */
#define STEP_BITS 32

/* A line whose columns are painted; of a steep one they are rows. */
typedef struct ThinLine {
  const PixelGrid *grid;
  int along, across;         /* from a pixel to the next one, in pixels */
  int first, end, low, high; /* the clip along and across */
  float start, stop;         /* along, start < stop */
  float at_start, slope;     /* across */
  float half;                /* width, across */
  int width;                 /* all of it, in parts */
  int64_t middle, step;      /* across, in the middle of column 0; per column */
  float dash, period, pace;  /* length of the line per column */
  float phase;               /* of the dashes at start; they may run back */
  uint32_t colour;
} ThinLine;

/* floor(), without asking the library; the places of a line lie near the
 * picture. */
static int
floor_of (float value)
{
  const int whole = (int)value;

  return whole - ((float)whole > value);
}

/* How much of the column from @from to @to is dash, 0 … 1. */
static float
dash_part (const ThinLine *line, float from, float to)
{
  const float a = line->phase + (from - line->start) * line->pace;
  const float b = line->phase + (to - line->start) * line->pace;
  const float low = a < b ? a : b, high = a < b ? b : a;
  const float turn = (float)floor_of (low / line->period) * line->period;
  float sum = 0, at;

  for (at = turn; at < high; at += line->period) {
    const float first = at > low ? at : low;
    const float last = at + line->dash < high ? at + line->dash : high;

    sum += last > first ? last - first : 0;
  }
  return high > low ? sum / (high - low) : 0;
}

/* Returns: parts of a pixel in 256ths. */
static inline int
in_256 (int parts)
{
  return (parts + PARTS / 512) >> (PART_BITS - 8);
}

/* Paints a column from @low on, in parts; @part of 256 of it is line. */
static void
paint_column (const ThinLine *line, int column, int low, int part)
{
  const int high = low + line->width;
  const int first = low >> PART_BITS;
  const int last = (high + PARTS - 1) >> PART_BITS;
  const int end = last < line->high ? last : line->high;
  int row = first > line->low ? first : line->low;
  uint32_t *pixel = line->grid->pixels + (ptrdiff_t)column * line->along
                    + (ptrdiff_t)row * line->across;

  for (; row < end; row++, pixel += line->across) {
    const int above = row * PARTS, below = above + PARTS;
    const int top = above > low ? above : low;
    const int bottom = below < high ? below : high;
    const int k = (in_256 (bottom - top) * part + 128) >> 8;

    *pixel = pixel_over (*pixel, pixel_scale (line->colour, (uint32_t)k));
  }
}

/* Paints a column that is dashed, or in which the line begins or ends. */
static void
paint_piece (const ThinLine *line, int column)
{
  const float from = (float)column > line->start ? (float)column : line->start;
  const float to
      = (float)(column + 1) < line->stop ? (float)(column + 1) : line->stop;
  const float middle
      = line->at_start + ((from + to) / 2 - line->start) * line->slope;
  const float part = line->period > 0 ? dash_part (line, from, to) : 1;

  if (part > 0)
    paint_column (line, column, floor_of ((middle - line->half) * PARTS),
                  (int)(part * (to - from) * 256 + 0.5F));
}

#ifdef __SSE2__
/* Lays @first of 256 of a colour over one pixel and @second of it over another:
 * pixel_over() of both at once. @colour has a channel in each 16 bits, twice.
 */
static inline void
paint_two (uint32_t *pixels[2], __m128i colour, int first, int second)
{
  const __m128i zero = _mm_setzero_si128 (), half = _mm_set1_epi16 (0x80);
  const __m128i both = _mm_unpacklo_epi32 (_mm_cvtsi32_si128 ((int)*pixels[0]),
                                           _mm_cvtsi32_si128 ((int)*pixels[1]));
  const __m128i parts = _mm_unpacklo_epi64 (
      _mm_shufflelo_epi16 (_mm_cvtsi32_si128 (first), 0),
      _mm_shufflelo_epi16 (_mm_cvtsi32_si128 (second), 0));
  const __m128i over = _mm_srli_epi16 (
      _mm_add_epi16 (_mm_mullo_epi16 (colour, parts), half), 8);
  const __m128i alpha
      = _mm_shufflehi_epi16 (_mm_shufflelo_epi16 (over, 0xff), 0xff);
  const __m128i rest = _mm_sub_epi16 (
      _mm_sub_epi16 (_mm_set1_epi16 (256), alpha), _mm_srli_epi16 (alpha, 7));
  const __m128i under = _mm_mullo_epi16 (_mm_unpacklo_epi8 (both, zero), rest);
  const __m128i sum
      = _mm_add_epi16 (_mm_srli_epi16 (_mm_add_epi16 (under, half), 8), over);
  const __m128i two = _mm_packus_epi16 (sum, zero);

  *pixels[0] = (uint32_t)_mm_cvtsi128_si32 (two);
  *pixels[1] = (uint32_t)_mm_cvtsi128_si32 (_mm_srli_si128 (two, 4));
}

/* Paints columns that are all line, of a line no wider than a pixel: it lies
 * in two rows, or in one of them. Which is hard to guess, so both are painted.
 */
static void
paint_hairline (const ThinLine *line, int from, int end)
{
  const __m128i channels = _mm_unpacklo_epi8 (
      _mm_set1_epi32 ((int)line->colour), _mm_setzero_si128 ());
  const int half = line->width / 2;
  int64_t middle = line->middle + from * line->step;
  int i;

  for (i = from; i < end; i++, middle += line->step) {
    const int low = (int)(middle >> (STEP_BITS - PART_BITS)) - half;
    const int row = low >> PART_BITS;
    const int below = PARTS - (low & (PARTS - 1));
    const int first = below < line->width ? below : line->width;
    uint32_t *const pixel = line->grid->pixels + (ptrdiff_t)i * line->along
                            + (ptrdiff_t)row * line->across;

    if (row < line->low || row + 1 >= line->high)
      paint_column (line, i, low, 256);
    else
      paint_two ((uint32_t *[2]){ pixel, pixel + line->across }, channels,
                 in_256 (first), in_256 (line->width - first));
  }
}
#endif

/* Paints columns that are all line. */
static void
paint_whole (const ThinLine *line, int from, int end)
{
  const int half = line->width / 2;
  int64_t middle = line->middle + from * line->step;
  int i;

#ifdef __SSE2__
  if (line->width <= PARTS) {
    paint_hairline (line, from, end);
    return;
  }
#endif
  for (i = from; i < end; i++, middle += line->step)
    paint_column (line, i, (int)(middle >> (STEP_BITS - PART_BITS)) - half,
                  256);
}

/* Leaves out columns in which the line lies beside the clip, but for some of
 * them: rounding must not matter. */
static void
narrow (const ThinLine *line, int *first, int *end)
{
  const float room = line->half + 1;
  const float low = ((float)line->low - room - line->at_start) / line->slope;
  const float high = ((float)line->high + room - line->at_start) / line->slope;
  const float from = line->start - 2 + (low < high ? low : high);
  const float to = line->start + 3 + (low < high ? high : low);

  /* A flat line has no such columns, or all are. */
  if (!(from > -1e9F && to < 1e9F))
    return;
  if (from > (float)*first)
    *first = from < (float)*end ? (int)from : *end;
  if (to < (float)*end)
    *end = to > (float)*first ? (int)to : *first;
}

static void
paint (const ThinLine *line)
{
  const int from = floor_of (line->start), to = floor_of (line->stop);
  int column = from > line->first ? from : line->first;
  int end = (float)to < line->stop ? to + 1 : to;
  int whole, whole_end, i;

  end = end < line->end ? end : line->end;
  narrow (line, &column, &end);
  whole = (float)column < line->start || line->period > 0 ? column + 1 : column;
  whole_end = end < to ? end : to;
  if (line->period > 0 || whole > whole_end)
    whole = whole_end = end;
  for (i = column; i < whole && i < end; i++)
    paint_piece (line, i);
  paint_whole (line, whole, whole_end);
  for (i = whole_end; i < end; i++)
    paint_piece (line, i);
}

static int64_t
in_steps (double px)
{
  return (int64_t)(px * ((int64_t)1 << STEP_BITS));
}

void
thin_line (const PixelGrid *grid,
           const Pixel ends[2],
           const Widening *widening,
           uint32_t colour)
{
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y;
  const double length = sqrt (dx * dx + dy * dy);
  const bool is_steep = fabs (dy) > fabs (dx);
  const double run = is_steep ? dy : dx, rise = is_steep ? dx : dy;
  const Pixel *a = run > 0 ? &ends[0] : &ends[1];
  const Pixel *b = run > 0 ? &ends[1] : &ends[0];
  const PixelClip *clip = &grid->clip;
  ThinLine line = { .grid = grid, .colour = colour };

  if (!(length > 0))
    return;
  line.along = is_steep ? grid->stride : 1;
  line.across = is_steep ? 1 : grid->stride;
  line.first = is_steep ? clip->top : clip->left;
  line.end = is_steep ? clip->bottom : clip->right;
  line.low = is_steep ? clip->left : clip->top;
  line.high = is_steep ? clip->right : clip->bottom;
  line.start = (float)(is_steep ? a->y : a->x);
  line.stop = (float)(is_steep ? b->y : b->x);
  line.at_start = (float)(is_steep ? a->x : a->y);
  line.slope = (float)(rise / run);
  line.half = (float)(widening->width / 2 * length / fabs (run));
  line.width = (int)(widening->width * length / fabs (run) * PARTS + 0.5);
  line.step = in_steps (rise / run);
  line.middle = in_steps ((is_steep ? a->x : a->y)
                          + (0.5 - (is_steep ? a->y : a->x)) * (rise / run));
  line.dash = (float)widening->dash;
  if (widening->dash > 0)
    line.period = (float)(widening->dash + widening->gap);
  line.pace = (float)(length / run);
  line.phase = run > 0 ? 0 : (float)length;
  paint (&line);
}
