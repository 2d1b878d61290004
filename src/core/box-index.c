#include "box-index.h"

#include "memory.h"
#include "site.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SQUARE_PX 16
#define WORD 64u

struct BoxIndex {
  PixelBox view;
  uint32_t columns, rows;
  uint32_t *starts; /* per square, and the end: where its numbers begin */
  uint32_t starts_room;
  uint32_t *numbers;
  uint32_t numbers_room;
  uint64_t *found; /* a bit for each box */
  uint32_t n_words, found_room;
};

/* Squares that a box meets; right and bottom are in it. */
typedef struct Squares {
  uint32_t left, right, top, bottom;
} Squares;

BoxIndex *
box_index_new (void)
{
  return memory_new (1, sizeof (BoxIndex));
}

void
box_index_free (BoxIndex *index)
{
  if (index == NULL)
    return;
  free (index->starts);
  free (index->numbers);
  free (index->found);
  free (index);
}

static uint32_t
square_at (float px, float start, uint32_t n)
{
  const float square = (px - start) / SQUARE_PX;

  return !(square > 0)              ? 0
         : square >= (float)(n - 1) ? n - 1
                                    : (uint32_t)square;
}

static Squares
squares_of (const BoxIndex *index, const PixelBox *box)
{
  return (Squares){ square_at (box->left, index->view.left, index->columns),
                    square_at (box->right, index->view.left, index->columns),
                    square_at (box->top, index->view.top, index->rows),
                    square_at (box->bottom, index->view.top, index->rows) };
}

static uint32_t
count_squares (float length)
{
  const double n = ceil ((double)length / SQUARE_PX);

  return n >= 1 ? (uint32_t)n : 1;
}

static const PixelBox *
box_at (const PixelBox *boxes, size_t stride, uint32_t i)
{
  return (const PixelBox *)(const void *)((const char *)(const void *)boxes
                                          + stride * i);
}

static void
set_view (BoxIndex *index, const PixelBox *view)
{
  uint32_t n;

  index->view = *view;
  index->columns = count_squares (view->right - view->left);
  index->rows = count_squares (view->bottom - view->top);
  n = index->columns * index->rows + 1;
  if (n > index->starts_room)
    index->starts = memory_grow (index->starts, &index->starts_room, n,
                                 sizeof *index->starts);
  memset (index->starts, 0, n * sizeof *index->starts);
}

/* After this starts[square] is where the numbers of the square end: they are
 * filled in from behind. */
static void
sum_up (BoxIndex *index)
{
  const uint32_t n = index->columns * index->rows;
  uint32_t i;

  for (i = 1; i <= n; i++)
    index->starts[i] += index->starts[i - 1];
  if (index->starts[n] > index->numbers_room)
    index->numbers = memory_grow (index->numbers, &index->numbers_room,
                                  index->starts[n], sizeof *index->numbers);
}

/* Counts the squares of one box, or puts its number into them. */
static void
enter (BoxIndex *index, const PixelBox *box, bool is_counted, uint32_t number)
{
  Squares at;
  uint32_t row, column;

  if (!boxes_meet (box, &index->view))
    return;
  at = squares_of (index, box);
  for (row = at.top; row <= at.bottom; row++)
    for (column = at.left; column <= at.right; column++) {
      uint32_t *start = &index->starts[row * index->columns + column];

      if (is_counted)
        index->numbers[--*start] = number;
      else
        *start += 1;
    }
}

void
box_index_set (BoxIndex *index,
               const PixelBox *view,
               const PixelBox *boxes,
               size_t stride,
               uint32_t n)
{
  uint32_t i;

  set_view (index, view);
  for (i = 0; i < n; i++)
    enter (index, box_at (boxes, stride, i), false, i);
  sum_up (index);
  for (i = n; i-- > 0;)
    enter (index, box_at (boxes, stride, i), true, i);
  index->n_words = n / WORD + 1;
  if (index->n_words > index->found_room)
    index->found = memory_grow (index->found, &index->found_room,
                                index->n_words, sizeof *index->found);
  box_index_forget (index);
}

void
box_index_find (BoxIndex *index, const PixelBox *place)
{
  const Squares at = squares_of (index, place);
  uint32_t row, i;

  if (!boxes_meet (place, &index->view))
    return;
  /* The numbers of a row of squares stand one after the other. */
  for (row = at.top; row <= at.bottom; row++) {
    const uint32_t *starts = &index->starts[row * index->columns];

    for (i = starts[at.left]; i < starts[at.right + 1]; i++)
      index->found[index->numbers[i] / WORD] |= (uint64_t)1
                                                << (index->numbers[i] % WORD);
  }
}

uint32_t
box_index_next (const BoxIndex *index, uint32_t from)
{
  uint32_t word = from / WORD;
  uint64_t bits;

  if (word >= index->n_words)
    return INDEX_NONE;
  bits = index->found[word] >> (from % WORD) << (from % WORD);
  while (bits == 0 && ++word < index->n_words)
    bits = index->found[word];
  if (word == index->n_words)
    return INDEX_NONE;
  for (from = word * WORD; (bits & 1) == 0; bits >>= 1)
    from++;
  return from;
}

void
box_index_forget (BoxIndex *index)
{
  memset (index->found, 0, index->n_words * sizeof *index->found);
}
