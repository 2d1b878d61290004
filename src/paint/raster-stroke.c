/* One stroke on the raster: what brush.c is to cairo. */
#include "brush.h"
#include "memory.h"
#include "raster-private.h"
#include "thin-line.h"

#include <math.h>
#include <stdlib.h>

static uint32_t
channel (double value, double alpha)
{
  return (uint32_t)(255 * value * alpha + 0.5);
}

uint32_t
hand_pixel (Colour colour)
{
  const double alpha = fmin (fmax (colour.alpha, 0), 1);

  return channel (alpha, 1) << 24 | channel (colour.red, alpha) << 16
         | channel (colour.green, alpha) << 8 | channel (colour.blue, alpha);
}

static void
fill (Hand *hand, Colour colour)
{
  coverage_fill (&hand->coverage, hand->pixels, hand->stride,
                 hand_pixel (colour));
}

static Colour
faded (Colour colour, double alpha)
{
  colour.alpha *= alpha;
  return colour;
}

/* The line that a style draws, so wide, in device pixels. */
static Widening
widening_of (const Hand *hand, const Style *style, double width)
{
  return (Widening){ .width = width * hand->scale,
                     .dash = style->dash * hand->scale,
                     .gap = style->gap * hand->scale,
                     .has_round_ends = brush_has_round_ends (style) };
}

/* Paths */

/* Nobody sees that a path runs by less than this beside its pixels, device
 * pixels. */
#define UNSEEN 0.05

/* So many pixels of a path may be left out between two. */
#define MOST_LEFT_OUT 8

/* Whether a pixel lies between two others, as good as on their line. */
static bool
is_between (Pixel pixel, Pixel from, Pixel to)
{
  const Pixel along = { to.x - from.x, to.y - from.y };
  const Pixel way = { pixel.x - from.x, pixel.y - from.y };
  const double squared = along.x * along.x + along.y * along.y;
  const double dot = along.x * way.x + along.y * way.y;
  const double cross = along.x * way.y - along.y * way.x;

  return dot >= 0 && dot <= squared
         && cross * cross <= UNSEEN * UNSEEN * squared;
}

static bool
are_between (const Pixel *pixels, uint32_t n, Pixel from, Pixel to)
{
  uint32_t i;

  for (i = 0; i < n; i++)
    if (!is_between (pixels[i], from, to))
      return false;
  return true;
}

/* Circles have as many pixels as they need when they are large. Leaves out
 * what small ones do not need.
 *
 * Returns: the number of pixels that are left. */
static uint32_t
simplify (Pixel *pixels, uint32_t n)
{
  uint32_t i, first = 1, kept = 0;

  if (n < 3)
    return n;
  for (i = 1; i + 1 < n; i++) {
    const uint32_t n_out = i + 1 - first;

    if (n_out <= MOST_LEFT_OUT
        && are_between (&pixels[first], n_out, pixels[kept], pixels[i + 1]))
      continue;
    pixels[++kept] = pixels[i];
    first = i + 1;
  }
  pixels[++kept] = pixels[n - 1];
  return kept + 1;
}

static void
paint_line (Hand *hand,
            const Style *style,
            const Pixel *pixels,
            uint32_t n,
            bool is_closed)
{
  Widening widening = widening_of (hand, style, style->width);
  const PixelGrid grid = { hand->pixels, hand->stride, hand->coverage.clip };

  widening.is_closed = is_closed;
  if (style->halo.alpha > 0) {
    Widening halo
        = widening_of (hand, style, style->width + 2 * style->halo_width);

    halo.dash = 0;
    halo.is_closed = is_closed;
    coverage_line (&hand->coverage, pixels, n, &halo);
    fill (hand, faded (style->halo, BRUSH_HALO_ALPHA));
  }
  if (n == 2 && widening.width <= THIN_LINE_WIDEST && !widening.has_round_ends)
    thin_line (&grid, pixels, &widening, hand_pixel (style->line));
  else {
    coverage_line (&hand->coverage, pixels, n, &widening);
    fill (hand, style->line);
  }
}

/* A ring as a line repeats its first pixel: there is room for it. */
static void
paint_ring (Hand *hand, const Style *style, Pixel *pixels, uint32_t n)
{
  pixels[n] = pixels[0];
  paint_line (hand, style, pixels, n + 1, true);
}

/* Hatches */

typedef struct HatchPen {
  Hand *hand;
  Widening widening;
} HatchPen;

static void
add_hatch (const Pixel ends[2], void *user)
{
  HatchPen *pen = user;
  const double scale = pen->hand->scale;
  const Pixel scaled[2] = { { ends[0].x * scale, ends[0].y * scale },
                            { ends[1].x * scale, ends[1].y * scale } };

  coverage_line (&pen->hand->coverage, scaled, 2, &pen->widening);
}

static void
paint_hatch (Hand *hand, const Style *style, const Pixel *corners, uint32_t n)
{
  HatchPen pen = { hand, { .width = style->hatch_width * hand->scale } };

  if (style->hatch == HATCH_NONE || style->line.alpha <= 0)
    return;
  brush_hatch (style, hand->theme, corners, n, add_hatch, &pen);
  fill (hand, style->line);
}

static void
paint_halo (Hand *hand, const Style *style, Pixel *pixels, uint32_t n)
{
  const Widening widening
      = { .width = BRUSH_HALO_OUTLINE * style->halo_width * hand->scale,
          .is_closed = true };

  coverage_polygon (&hand->coverage, pixels, n);
  fill (hand, faded (style->halo, BRUSH_HALO_FILL_ALPHA));
  pixels[n] = pixels[0];
  coverage_line (&hand->coverage, pixels, n + 1, &widening);
  fill (hand, style->halo);
}

/* @corners are px for the hatch, @pixels the same in device pixels. */
static void
paint_polygon (Hand *hand,
               const Style *style,
               const Pixel *corners,
               Pixel *pixels,
               uint32_t n)
{
  if (style->fill.alpha > 0) {
    coverage_polygon (&hand->coverage, pixels, n);
    fill (hand, style->fill);
  }
  paint_hatch (hand, style, corners, n);
  if (style->halo.alpha > 0)
    paint_halo (hand, style, pixels, n);
  if (style->width > 0 && style->line.alpha > 0)
    paint_ring (hand, style, pixels, n);
}

/* The inner ring turns against the outer one. */
static void
fill_region (Hand *hand, const Stroke *stroke, const Pixel *pixels)
{
  uint32_t i;

  coverage_polygon (&hand->coverage, pixels, stroke->n_outer);
  for (i = stroke->n_outer; i < stroke->n; i++)
    coverage_edge (&hand->coverage,
                   pixels[i + 1 < stroke->n ? i + 1 : stroke->n_outer],
                   pixels[i]);
  fill (hand, stroke->fill);
}

/* Marks */

/* Lays a colour over what lies between two circles round @at; the inner one
 * may be less than nothing. */
static void
paint_disc (Hand *hand, Pixel at, const double radii[2], Colour colour)
{
  const PixelClip *clip = &hand->coverage.clip;
  const double inner = radii[0] * hand->scale;
  const double outer = radii[1] * hand->scale;
  const double x = at.x * hand->scale, y = at.y * hand->scale;
  const int left = (int)fmax (floor (x - outer - 0.5), clip->left);
  const int right = (int)fmin (ceil (x + outer + 0.5), clip->right);
  const int bottom = (int)fmin (ceil (y + outer + 0.5), clip->bottom);
  const uint32_t pixel = hand_pixel (colour);
  int row = (int)fmax (floor (y - outer - 0.5), clip->top), column;

  for (; row < bottom; row++) {
    uint32_t *pixels = &hand->pixels[(size_t)row * (size_t)hand->stride];
    const float dy = (float)(row + 0.5 - y);

    for (column = left; column < right; column++) {
      const float dx = (float)(column + 0.5 - x);
      const float distance = sqrtf (dx * dx + dy * dy);
      const float in = (float)outer + 0.5F - distance;
      const float out = (float)inner + 0.5F - distance;
      const float part = (in < 1 ? in : 1) - (out > 0 ? out : 0);

      if (part > 0.002F)
        pixels[column] = pixel_over (
            pixels[column], pixel_scale (pixel, (uint32_t)(part * 256 + 0.5F)));
    }
  }
}

static void
fill_disc (Hand *hand, Pixel at, double radius, Colour colour)
{
  paint_disc (hand, at, (double[2]){ -1, radius }, colour);
}

static void
stroke_disc (Hand *hand, Pixel at, double radius, const Style *style)
{
  const double half = style->width / 2;

  paint_disc (hand, at, (double[2]){ radius - half, radius + half },
              style->line);
}

/* A site may lie under it: its casing is no more than an outline. */
static void
paint_diamond (Hand *hand, const Style *style, Pixel at)
{
  const double r = style->radius * hand->scale;
  const double x = at.x * hand->scale, y = at.y * hand->scale;
  Pixel pixels[5] = { { x, y - r }, { x + r, y }, { x, y + r }, { x - r, y } };
  const double width = style->width * hand->scale;
  Widening widening
      = { .width = width + 2 * style->casing * hand->scale, .is_closed = true };

  pixels[4] = pixels[0];
  if (style->casing > 0) {
    coverage_line (&hand->coverage, pixels, 5, &widening);
    fill (hand, hand->theme->background);
  }
  coverage_polygon (&hand->coverage, pixels, 4);
  fill (hand, style->fill);
  widening.width = width;
  coverage_line (&hand->coverage, pixels, 5, &widening);
  fill (hand, style->line);
}

static void
paint_cross (Hand *hand, const Style *style, Pixel at)
{
  const double r = style->radius * hand->scale;
  const double x = at.x * hand->scale, y = at.y * hand->scale;
  const Pixel falling[2] = { { x - r, y - r }, { x + r, y + r } };
  const Pixel rising[2] = { { x - r, y + r }, { x + r, y - r } };
  Widening widening = { .has_round_ends = true };
  int i;

  for (i = 0; i < 2; i++) {
    widening.width = (style->width + (i == 0 ? 2 : 0)) * hand->scale;
    coverage_line (&hand->coverage, falling, 2, &widening);
    coverage_line (&hand->coverage, rising, 2, &widening);
    fill (hand, i == 0 ? style->fill : style->line);
  }
}

static void
paint_mark (Hand *hand, const Style *style, Pixel at)
{
  const double edge = brush_mark_reach (style);
  const bool has_halo = style->halo.alpha > 0;

  if (has_halo)
    fill_disc (hand, at, edge, style->halo);
  if (style->casing > 0 && style->mark != MARK_DIAMOND)
    fill_disc (hand, at, edge - (has_halo ? style->halo_width : 0),
               hand->theme->background);
  switch (style->mark) {
  case MARK_NONE:
    break;
  case MARK_DOT:
    fill_disc (hand, at, style->radius, style->line);
    break;
  case MARK_RINGED:
    stroke_disc (hand, at, style->radius + style->ring_gap, style);
    fill_disc (hand, at, style->radius, style->fill);
    stroke_disc (hand, at, style->radius - 0.6, style);
    break;
  case MARK_HOLLOW:
    fill_disc (hand, at, style->radius, style->fill);
    stroke_disc (hand, at, style->radius, style);
    break;
  case MARK_DIAMOND:
    paint_diamond (hand, style, at);
    break;
  case MARK_CROSSED:
    paint_cross (hand, style, at);
    break;
  }
}

/* Returns: the pixels of a stroke on the device, with room for one more. */
static Pixel *
scale_pixels (Hand *hand, const Pixel *pixels, uint32_t n)
{
  uint32_t i;

  if (hand->scaled_room < n + 1)
    hand->scaled = memory_grow (hand->scaled, &hand->scaled_room, n + 1,
                                sizeof *hand->scaled);
  for (i = 0; i < n; i++)
    hand->scaled[i]
        = (Pixel){ pixels[i].x * hand->scale, pixels[i].y * hand->scale };
  return hand->scaled;
}

void
hand_paint_stroke (Hand *hand, const Drawing *drawing, const Stroke *stroke)
{
  const Pixel *corners = &drawing->pixels[stroke->first];
  Style style = drawing->styles[stroke->style];
  Pixel *pixels = scale_pixels (hand, corners, stroke->n);
  const double box[4]
      = { stroke->box.left * hand->scale, stroke->box.top * hand->scale,
          stroke->box.right * hand->scale, stroke->box.bottom * hand->scale };

  coverage_begin (&hand->coverage, box);
  switch (stroke->kind) {
  case STROKE_POLYGON:
    style.fill = stroke->fill;
    paint_polygon (hand, &style, corners, pixels, stroke->n);
    break;
  case STROKE_REGION:
    fill_region (hand, stroke, pixels);
    break;
  case STROKE_CASING: {
    const Widening widening
        = { .width = style.casing * hand->scale, .has_round_ends = true };

    coverage_line (&hand->coverage, pixels, simplify (pixels, stroke->n),
                   &widening);
    fill (hand, hand->theme->background);
    break;
  }
  case STROKE_LINE:
    paint_line (hand, &style, pixels, simplify (pixels, stroke->n), false);
    break;
  case STROKE_RING:
    paint_ring (hand, &style, pixels, stroke->n);
    break;
  case STROKE_MARK:
    paint_mark (hand, &style, corners[0]);
    break;
  }
}
