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

/* Rows of squares. */
typedef struct Rows {
  int first, end;
} Rows;

static void
take_in (Rows *rows, const SquareGrid *grid, const PixelBox *box)
{
  const float top = box->top * (float)grid->per_px - 1;
  const float bottom = box->bottom * (float)grid->per_px + 2;

  if (top < (float)rows->first)
    rows->first = top > 0 ? (int)top : 0;
  if (bottom > (float)rows->end)
    rows->end = bottom < (float)grid->rows ? (int)bottom : grid->rows;
}

/* Takes in the rows in which a drawing has something, and some near them. */
static void
take_in_drawing (Rows *rows, const SquareGrid *grid, const Drawing *drawing)
{
  uint32_t i;

  for (i = 0; i < drawing->n_strokes; i++)
    take_in (rows, grid, &drawing->strokes[i].box);
  for (i = 0; i < drawing->n_placed; i++)
    take_in (rows, grid, &drawing->placed[i].box);
}

/* Only the sums in @rows are used: what is lit lies in few of them. */
static void
begin_sums (SquareSums *sums, const SquareGrid *grid, Rows rows)
{
  const size_t columns = (size_t)grid->columns;
  const size_t first = (size_t)rows.first * columns;

  sums->grid = *grid;
  sums->sums = memory_room ((size_t)grid->rows * columns, sizeof *sums->sums);
  memset (&sums->sums[first], 0,
          ((size_t)rows.end * columns - first) * sizeof *sums->sums);
}

static void
sum_up (SquareSums *sums, const Drawing *drawing)
{
  uint64_t *styles = memory_new (drawing->n_styles, sizeof *styles);
  uint32_t i;

  for (i = 0; i < drawing->n_styles; i++)
    styles[i] = mark_of_style (&drawing->styles[i]);
  add_strokes (sums, drawing, styles);
  for (i = 0; i < drawing->n_placed; i++)
    square_sums_add (sums, &drawing->placed[i].box,
                     mark_of_name (&drawing->placed[i]));
  free (styles);
}

void
drawing_compare (const Drawing *before, const Drawing *after, Squares *squares)
{
  const SquareGrid *grid = &squares->grid;
  const Drawing *const drawings[2] = { before, after };
  Rows rows = { grid->rows, 0 };
  SquareSums sums[2];
  int i;

  for (i = 0; i < 2; i++)
    take_in_drawing (&rows, grid, drawings[i]);
  if (rows.first >= rows.end)
    return;
  for (i = 0; i < 2; i++) {
    begin_sums (&sums[i], grid, rows);
    sum_up (&sums[i], drawings[i]);
  }
  for (i = rows.first * grid->columns; i < rows.end * grid->columns; i++)
    if (sums[0].sums[i] != sums[1].sums[i])
      squares->is_marked[i] = true;
  for (i = 0; i < 2; i++)
    free (sums[i].sums);
}
