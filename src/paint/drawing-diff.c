/* What differs between two drawings: squares in which not the same strokes and
 * names lie in the same order. Each square has the sum of what lies in it. */
#include "memory.h"
#include "squares.h"

#include <stdlib.h>
#include <string.h>

static uint64_t
mix (uint64_t mark, const void *bytes, size_t n_bytes)
{
  const unsigned char *at = bytes;
  uint64_t word;

  for (; n_bytes >= sizeof word; n_bytes -= sizeof word, at += sizeof word) {
    memcpy (&word, at, sizeof word);
    mark = (mark ^ word) * 0x9fb21c651e98df25U;
    mark ^= mark >> 32;
  }
  return mark;
}

static uint64_t
mix_number (uint64_t mark, uint64_t number)
{
  return mix (mark, &number, sizeof number);
}

static uint64_t
mark_of_style (const Style *style)
{
  const double lengths[] = { style->width,      style->dash,
                             style->gap,        style->casing,
                             style->radius,     style->ring_gap,
                             style->halo_width, style->hatch_width };
  uint64_t mark = mix_number (1, (uint64_t)style->hatch << 8 | style->mark);

  mark = mix (mark, &style->fill, sizeof style->fill);
  mark = mix (mark, &style->line, sizeof style->line);
  mark = mix (mark, &style->halo, sizeof style->halo);
  return mix (mark, lengths, sizeof lengths);
}

/* Strokes that are painted alike have the same mark. */
static uint64_t
mark_of_stroke (const Drawing *drawing, const Stroke *stroke, uint64_t style)
{
  uint64_t mark = mix_number (style, stroke->kind);

  mark = mix (mark, &stroke->fill, sizeof stroke->fill);
  mark = mix_number (mark, stroke->n_outer);
  return mix (mark, &drawing->pixels[stroke->first],
              stroke->n * sizeof (Pixel));
}

static uint64_t
mark_of_name (const PlacedName *placed)
{
  const uint64_t mark = mix (mix_number (2, placed->name), &placed->colour,
                             sizeof placed->colour);

  return mix (mark, &placed->at, sizeof placed->at);
}

static void
add_strokes (SquareSums *sums, const Drawing *drawing, const uint64_t *styles)
{
  uint32_t i;

  for (i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];

    square_sums_add_stroke (
        sums, drawing, stroke,
        mark_of_stroke (drawing, stroke, styles[stroke->style]));
  }
}

static void
begin_sums (SquareSums *sums, const SquareGrid *grid)
{
  const uint32_t n = (uint32_t)(grid->columns * grid->rows);

  sums->grid = *grid;
  if (n > sums->sums_room)
    sums->sums
        = memory_grow (sums->sums, &sums->sums_room, n, sizeof *sums->sums);
  memset (sums->sums, 0, n * sizeof *sums->sums);
}

void
square_sums_set (SquareSums *sums,
                 const SquareGrid *grid,
                 const Drawing *drawing)
{
  uint64_t *styles = memory_new (drawing->n_styles, sizeof *styles);
  uint32_t i;

  begin_sums (sums, grid);
  for (i = 0; i < drawing->n_styles; i++)
    styles[i] = mark_of_style (&drawing->styles[i]);
  add_strokes (sums, drawing, styles);
  for (i = 0; i < drawing->n_placed; i++)
    square_sums_add (sums, &drawing->placed[i].box,
                     mark_of_name (&drawing->placed[i]));
  free (styles);
}

void
square_sums_clear (SquareSums *sums)
{
  free (sums->sums);
}

void
square_sums_compare (const SquareSums *before,
                     const SquareSums *after,
                     Squares *squares)
{
  const int n = squares->grid.columns * squares->grid.rows;
  int i;

  for (i = 0; i < n; i++)
    if (before->sums[i] != after->sums[i])
      squares->is_marked[i] = true;
}

static bool
is_empty (const Drawing *drawing)
{
  return drawing->n_strokes == 0 && drawing->n_placed == 0;
}

void
drawing_compare (const Drawing *before, const Drawing *after, Squares *squares)
{
  SquareSums sums[2] = { { .sums = NULL }, { .sums = NULL } };

  if (is_empty (before) && is_empty (after))
    return;
  square_sums_set (&sums[0], &squares->grid, before);
  square_sums_set (&sums[1], &squares->grid, after);
  square_sums_compare (&sums[0], &sums[1], squares);
  square_sums_clear (&sums[0]);
  square_sums_clear (&sums[1]);
}
