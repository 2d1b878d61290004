/* What differs between two drawings: the squares outside which both have the
 * same strokes in the same order, so the same pixels. */
#include "memory.h"
#include "squares.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Strokes and names of a drawing as marks: equal ones have equal marks. */
typedef struct Marks {
  uint64_t *marks;
  bool *is_kept;
  uint32_t n;
} Marks;

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
  const double lengths[]
      = { style->width,  style->dash,     style->gap,       style->casing,
          style->radius, style->ring_gap, style->halo_width };
  uint64_t mark = mix_number (1, (uint64_t)style->hatch << 8 | style->mark);

  mark = mix (mark, &style->fill, sizeof style->fill);
  mark = mix (mark, &style->line, sizeof style->line);
  mark = mix (mark, &style->halo, sizeof style->halo);
  return mix (mark, lengths, sizeof lengths);
}

static void
marks_init (Marks *marks, const Drawing *drawing)
{
  uint64_t *styles = memory_new (drawing->n_styles, sizeof *styles);
  uint32_t i, n = 0;

  marks->n = drawing->n_strokes + drawing->n_placed;
  marks->marks = memory_new (marks->n, sizeof *marks->marks);
  marks->is_kept = memory_new (marks->n, sizeof *marks->is_kept);
  for (i = 0; i < drawing->n_styles; i++)
    styles[i] = mark_of_style (&drawing->styles[i]);
  for (i = 0; i < drawing->n_strokes; i++, n++) {
    const Stroke *stroke = &drawing->strokes[i];
    uint64_t mark = mix_number (styles[stroke->style], stroke->kind);

    mark = mix (mark, &stroke->fill, sizeof stroke->fill);
    mark = mix_number (mark, stroke->n_outer);
    marks->marks[n] = mix (mark, &drawing->pixels[stroke->first],
                           stroke->n * sizeof (Pixel));
  }
  for (i = 0; i < drawing->n_placed; i++, n++) {
    const PlacedName *placed = &drawing->placed[i];
    uint64_t mark = mix_number (2, placed->name);

    mark = mix (mark, &placed->colour, sizeof placed->colour);
    marks->marks[n] = mix (mark, &placed->at, sizeof placed->at);
  }
  free (styles);
}

static void
marks_clear (Marks *marks)
{
  free (marks->marks);
  free (marks->is_kept);
}

/* Keeps what is equal at both ends; returns in @from and @ends what lies
 * between. */
static void
keep_ends (Marks *before, Marks *after, uint32_t *from, uint32_t ends[2])
{
  uint32_t n = 0;

  while (n < before->n && n < after->n && before->marks[n] == after->marks[n]) {
    before->is_kept[n] = after->is_kept[n] = true;
    n++;
  }
  *from = n;
  ends[0] = before->n;
  ends[1] = after->n;
  while (ends[0] > n && ends[1] > n
         && before->marks[ends[0] - 1] == after->marks[ends[1] - 1]) {
    ends[0] -= 1;
    ends[1] -= 1;
    before->is_kept[ends[0]] = after->is_kept[ends[1]] = true;
  }
}

/* Marks by value: the places of one value in a chain, first to last. */
typedef struct Index {
  uint32_t *heads, *next; /* place + 1, 0: none */
  uint32_t mask;
} Index;

static void
index_init (Index *index, const Marks *marks, uint32_t from, uint32_t end)
{
  uint32_t size = 16, i;

  while (size < 2 * (end - from))
    size *= 2;
  index->mask = size - 1;
  index->heads = memory_new (size, sizeof *index->heads);
  index->next = memory_new (marks->n, sizeof *index->next);
  for (i = end; i-- > from;) {
    uint32_t *head = &index->heads[marks->marks[i] & index->mask];

    index->next[i] = *head;
    *head = i + 1;
  }
}

/* Returns: the first place of @mark, which is not found again; or
 *          INDEX_NONE. */
static uint32_t
index_take (Index *index, const Marks *marks, uint64_t mark)
{
  uint32_t *link = &index->heads[mark & index->mask];

  while (*link != 0 && marks->marks[*link - 1] != mark)
    link = &index->next[*link - 1];
  if (*link != 0) {
    const uint32_t place = *link - 1;

    *link = index->next[place];
    return place;
  }
  return INDEX_NONE;
}

/* Keeps a longest part of @after whose places in @before ascend.
 *
 * Source: Fredman 1975, longest increasing subsequence. */
static void
keep_ascending (Marks *before,
                Marks *after,
                const uint32_t *place,
                uint32_t from,
                uint32_t end)
{
  uint32_t *tails = memory_new (end - from, sizeof *tails);
  uint32_t *previous = memory_new (end - from, sizeof *previous);
  uint32_t i, n = 0;

  for (i = from; i < end; i++) {
    uint32_t low = 0, high = n;

    if (place[i - from] == INDEX_NONE)
      continue;
    /* Most drawings keep their order: what ascends needs no search. */
    if (n > 0 && place[tails[n - 1] - from] < place[i - from])
      low = n;
    while (low < high) {
      const uint32_t middle = (low + high) / 2;

      if (place[tails[middle] - from] < place[i - from])
        low = middle + 1;
      else
        high = middle;
    }
    tails[low] = i;
    previous[i - from] = low > 0 ? tails[low - 1] : INDEX_NONE;
    n = low == n ? n + 1 : n;
  }
  for (i = n > 0 ? tails[n - 1] : INDEX_NONE; i != INDEX_NONE;
       i = previous[i - from])
    after->is_kept[i] = before->is_kept[place[i - from]] = true;
  free (tails);
  free (previous);
}

static void
keep_middle (Marks *before, Marks *after, uint32_t from, const uint32_t ends[2])
{
  uint32_t *place = memory_new (ends[1] - from, sizeof *place);
  Index index;
  uint32_t i;

  index_init (&index, before, from, ends[0]);
  for (i = from; i < ends[1]; i++)
    place[i - from] = index_take (&index, before, after->marks[i]);
  keep_ascending (before, after, place, from, ends[1]);
  free (index.heads);
  free (index.next);
  free (place);
}

static void
mark_changes (Squares *squares, const Drawing *drawing, const Marks *marks)
{
  uint32_t i;

  for (i = 0; i < marks->n; i++) {
    if (marks->is_kept[i])
      continue;
    if (i < drawing->n_strokes)
      squares_mark_stroke (squares, drawing, &drawing->strokes[i]);
    else
      squares_mark (squares, &drawing->placed[i - drawing->n_strokes].box);
  }
}

void
drawing_compare (const Drawing *before, const Drawing *after, Squares *squares)
{
  const Drawing *const drawings[2] = { before, after };
  Marks marks[2];
  uint32_t from, ends[2];
  int i;

  for (i = 0; i < 2; i++)
    marks_init (&marks[i], drawings[i]);
  keep_ends (&marks[0], &marks[1], &from, ends);
  keep_middle (&marks[0], &marks[1], from, ends);
  for (i = 0; i < 2; i++) {
    mark_changes (squares, drawings[i], &marks[i]);
    marks_clear (&marks[i]);
  }
}
