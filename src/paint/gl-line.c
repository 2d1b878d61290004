/* Lines as quads on the screen: one for each segment, mitred where the line
 * bends a little, with a disc in the corner where it turns. */
#include "gl-batch.h"

#include <math.h>

/* Cosine of the angle from which on a bend is a corner. */
#define CORNER 0.9

/* A line while it is cut into quads. */
typedef struct Strip {
  GlBatch *batch;
  const GlLine *line;
  const Pixel *pixels;
  uint32_t n;
  GlInk ink;
  double reach;  /* of the quads, on each side */
  double length; /* of the whole line */
} Strip;

static Pixel
pixel_at (const Strip *strip, uint32_t i)
{
  const Pixel pixel = strip->pixels[i % strip->n];

  return (Pixel){ pixel.x * strip->batch->scale,
                  pixel.y * strip->batch->scale };
}

/* Returns: the length of a segment; its direction in *@direction. */
static double
segment (const Strip *strip, uint32_t i, Pixel *direction)
{
  const Pixel a = pixel_at (strip, i), b = pixel_at (strip, i + 1);
  const double x = b.x - a.x, y = b.y - a.y;
  const double length = sqrt (x * x + y * y);

  if (length > 0)
    *direction = (Pixel){ x / length, y / length };
  return length;
}

static uint32_t
n_segments (const Strip *strip)
{
  return strip->line->is_closed ? strip->n : strip->n - 1;
}

/* The segment before or after @i, or -1 at an open end. */
static int64_t
neighbour (const Strip *strip, uint32_t i, int step)
{
  const int64_t n = n_segments (strip);
  const int64_t next = (int64_t)i + step;

  if (next >= 0 && next < n)
    return next;
  return strip->line->is_closed ? (next + n) % n : -1;
}

/* How far the corners of a quad lie beyond its end, per px across: 0 for a
 * square end, as far as the mitre wants where the next segment bends. */
static double
slant (const Strip *strip, uint32_t i, int step, Pixel direction)
{
  const int64_t next = neighbour (strip, i, step);
  Pixel other = { 0, 0 };
  double cosine;

  if (next < 0 || !(segment (strip, (uint32_t)next, &other) > 0))
    return 0;
  cosine = direction.x * other.x + direction.y * other.y;
  if (cosine < CORNER)
    return 0;
  return (direction.x * other.y - direction.y * other.x) / (1 + cosine);
}

static bool
is_corner (const Strip *strip, uint32_t i, Pixel direction)
{
  const int64_t next = neighbour (strip, i, 1);
  Pixel other = { 0, 0 };

  return next >= 0 && segment (strip, (uint32_t)next, &other) > 0
         && direction.x * other.x + direction.y * other.y < CORNER;
}

/* One corner of a quad: so far along the whole line, and across. */
static void
add_corner (const Strip *strip,
            Pixel at,
            Pixel direction,
            const double beyond[3])
{
  const double along = beyond[0], across = beyond[1], place = beyond[2];
  const float local[3]
      = { (float)(place + along), (float)across, (float)strip->length };

  gl_batch_add (strip->batch, &strip->ink,
                (Pixel){ at.x + along * direction.x - across * direction.y,
                         at.y + along * direction.y + across * direction.x },
                local);
}

/* Open ends reach a pixel further, round ones by half the width too. */
static double
extra (const Strip *strip, uint32_t i, int step)
{
  if (neighbour (strip, i, step) >= 0)
    return 0;
  return strip->line->has_round_ends ? strip->reach : 1;
}

static void
add_segment (const Strip *strip, uint32_t i, double place)
{
  const double reach = strip->reach;
  Pixel direction;
  const double length = segment (strip, i, &direction);
  double start, end;

  if (!(length > 0))
    return;
  start = -slant (strip, i, -1, direction);
  end = slant (strip, i, 1, direction);
  add_corner (
      strip, pixel_at (strip, i), direction,
      (double[3]){ -extra (strip, i, -1) - start * reach, -reach, place });
  add_corner (
      strip, pixel_at (strip, i), direction,
      (double[3]){ -extra (strip, i, -1) + start * reach, reach, place });
  add_corner (
      strip, pixel_at (strip, i + 1), direction,
      (double[3]){ extra (strip, i, 1) - end * reach, reach, place + length });
  add_corner (
      strip, pixel_at (strip, i + 1), direction,
      (double[3]){ extra (strip, i, 1) + end * reach, -reach, place + length });
  gl_batch_join (strip->batch, 4);
  if (strip->line->dash <= 0 && is_corner (strip, i, direction)) {
    const double radii[2]
        = { -1, strip->line->width / 2 / strip->batch->scale };

    gl_batch_disc (strip->batch, strip->pixels[(i + 1) % strip->n], radii,
                   strip->line->colour);
  }
}

void
gl_batch_line (GlBatch *batch,
               const GlLine *line,
               const Pixel *pixels,
               uint32_t n)
{
  Strip strip = {
    .batch = batch,
    .line = line,
    .pixels = pixels,
    .n = n,
    .ink = { .colour = line->colour,
             .shape = { (float)(line->width / 2), (float)line->dash,
                        (float)line->gap },
             .kind = line->has_round_ends ? GL_KIND_ROUND : GL_KIND_SQUARE },
    .reach = line->width / 2 + 1,
  };
  Pixel direction;
  double place = 0;
  uint32_t i;

  for (i = 0; i < n_segments (&strip); i++)
    strip.length += segment (&strip, i, &direction);
  /* A ring has no ends. */
  if (line->is_closed && line->dash <= 0)
    place = strip.length * 2;
  strip.length += 2 * place;
  for (i = 0; i < n_segments (&strip); i++) {
    add_segment (&strip, i, place);
    place += segment (&strip, i, &direction);
  }
}
