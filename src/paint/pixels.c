/* The inner loop of the raster: a colour laid over a row of pixels. Four at a
 * time where the processor can, with the same result. */
#include "coverage.h"

#ifdef __SSE2__
#include <emmintrin.h>

static int
blend_fours (uint32_t *pixels, int n, uint32_t over)
{
  const int alpha = (int)(over >> 24);
  const __m128i rest = _mm_set1_epi16 ((short)(256 - alpha - (alpha >> 7)));
  const __m128i half = _mm_set1_epi16 (0x80), zero = _mm_setzero_si128 ();
  const __m128i colour = _mm_set1_epi32 ((int)over);
  int i;

  for (i = 0; i + 4 <= n; i += 4) {
    __m128i *at = (__m128i *)(void *)(pixels + i);
    const __m128i four = _mm_loadu_si128 (at);
    __m128i low = _mm_unpacklo_epi8 (four, zero);
    __m128i high = _mm_unpackhi_epi8 (four, zero);

    low = _mm_add_epi16 (_mm_mullo_epi16 (low, rest), half);
    high = _mm_add_epi16 (_mm_mullo_epi16 (high, rest), half);
    low = _mm_packus_epi16 (_mm_srli_epi16 (low, 8), _mm_srli_epi16 (high, 8));
    _mm_storeu_si128 (at, _mm_add_epi8 (low, colour));
  }
  return i;
}
#else
static int
blend_fours (uint32_t *pixels, int n, uint32_t over)
{
  (void)pixels;
  (void)n;
  (void)over;
  return 0;
}
#endif

void
pixels_blend (uint32_t *pixels, int n, uint32_t over)
{
  int i = n < 8 ? 0 : blend_fours (pixels, n, over);

  for (; i < n; i++)
    pixels[i] = pixel_over (pixels[i], over);
}
