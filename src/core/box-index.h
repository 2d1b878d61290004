/* Which of many boxes lie near a place: squares of pixels, each with the
 * numbers of the boxes that meet it.
 *
 *   BoxIndex *index = box_index_new ();
 *
 *   box_index_set (index, &view, &strokes[0].box, sizeof strokes[0], n);
 *   box_index_find (index, &place);
 *   for (i = box_index_next (index, 0); i != INDEX_NONE;
 *        i = box_index_next (index, i + 1))
 *     … strokes[i] may meet the place …
 *   box_index_forget (index);
 */
#ifndef BOX_INDEX_H
#define BOX_INDEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A rectangle of pixels. */
typedef struct PixelBox {
  float left, top, right, bottom;
} PixelBox;

static inline bool
boxes_meet (const PixelBox *a, const PixelBox *b)
{
  return a->left < b->right && b->left < a->right && a->top < b->bottom
         && b->top < a->bottom;
}

typedef struct BoxIndex BoxIndex;

BoxIndex *box_index_new (void);
void box_index_free (BoxIndex *index);

/* Lists @n boxes anew, which stand @stride bytes apart. Those that do not meet
 * @view are never found, whoever looks there.
 *
 * Cost: O(boxes + squares that they meet). */
void box_index_set (BoxIndex *index,
                    const PixelBox *view,
                    const PixelBox *boxes,
                    size_t stride,
                    uint32_t n);

/* Finds all that meet @place, and some others near it, beside those that have
 * been found before. */
void box_index_find (BoxIndex *index, const PixelBox *place);

/* Returns: the first number from @from that has been found, or INDEX_NONE. */
uint32_t box_index_next (const BoxIndex *index, uint32_t from);

/* Nothing has been found. */
void box_index_forget (BoxIndex *index);

#endif
