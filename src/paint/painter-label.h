/* What the parts of the painter that place names share. */
#ifndef PAINTER_LABEL_H
#define PAINTER_LABEL_H

#include "label.h"
#include "painter-private.h"

#include <glib.h>

/* Names to be placed. */
typedef struct Wanted {
  GArray *labels; /* Label */
  GArray *names;  /* the number of each */
} Wanted;

void wanted_init (Wanted *wanted);
void wanted_clear (Wanted *wanted);

/* Wants the name of an item, if it has one and is in the view. */
void painter_want (Painter *painter, Wanted *wanted, uint32_t item);

/* What is important must have its name, and corners should; @need is that of
 * the others. */
void painter_set_needs (const Painter *painter,
                        const Wanted *wanted,
                        bool is_crowd,
                        LabelNeed need);

/* Returns: the item that a label names. */
const SceneItem *painter_item_of (const Painter *painter, const Label *label);

/* Adds those that have found a place, with their leaders. */
void painter_add_wanted (Painter *painter, const Wanted *wanted);

/* Where sites are drawn smaller than this there is ink everywhere: a name is
 * best next to its mark, but for what is loud. */
#define CROWDED_SIZE 0.75

static inline bool
painter_is_crowd (const Drawing *drawing)
{
  return drawing->size < CROWDED_SIZE;
}

/* Returns: a sheet for the names of a drawing in the view of @painter. */
LabelSheet *painter_sheet_new (const Painter *painter);

/* Where names find ink that they keep off. */
typedef struct InkSource {
  const Drawing *drawing;
  BoxIndex *strokes; /* lists its strokes; NULL: all are looked through */
  bool is_crowd;     /* marks, and what is loud, are all that names keep off */
} InkSource;

/* Adds the ink that lies near one of the labels; that of some other strokes
 * does no harm. */
void painter_add_ink_near (const Painter *painter,
                           LabelSheet *sheet,
                           const InkSource *source,
                           const GArray *labels);

/* Adds the ink of all strokes. */
void painter_add_all_ink (const Painter *painter,
                          LabelSheet *sheet,
                          const Drawing *from);

/* Returns: how far the ink of a mark of this style reaches, its halo too, but
 *          not the ring of background round it. */
double painter_mark_radius (const Style *style);

/* Adds the line from the mark of a label to its name. */
void painter_add_leader (Painter *painter, const Label *label);

#endif
