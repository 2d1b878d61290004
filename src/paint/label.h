/* Labels: where the names of marks go, so that they sit on no mark, on no
 * line and on no other label if there is any room at all, and are nearest to
 * the mark that they name.
 *
 * What is painted leaves ink in a coarse raster; a label takes the place
 * near its mark with the least ink, the important ones first. */
#ifndef LABEL_H
#define LABEL_H

#include "box-index.h"
#include "clip.h"

#include <cairo.h>

typedef struct LabelSheet LabelSheet;

/* A name to place. */
typedef struct Label {
  const char *text; /* borrowed */
  Pixel at;         /* its mark */
  double reach;     /* of the mark, px */
  double width, height;
  bool is_important; /* placed first, and never left out */
  bool is_centred;   /* best right on its mark */
  bool is_number;    /* of a line, not the name of a mark: none takes it for
                        that of another, and it may be further away */
  uint32_t item;     /* for the caller */
  bool is_placed;    /* the result: */
  Pixel low;         /* its upper left corner */
} Label;

/* Of a view of this size. Where only @area of it matters, and what labels come
 * into it, the sheet may be as small: nothing outside it is known. */
LabelSheet *label_sheet_new (double width, double height, const PixelBox *area);
void label_sheet_free (LabelSheet *sheet);

/* What labels should keep off. A heavier line is worse to cover. */
void label_sheet_line (LabelSheet *sheet, const Pixel ends[2], double width_px);
void label_sheet_mark (LabelSheet *sheet, Pixel at, double reach);

/* A mark whose name is not among those to be placed, or that has none: none of
 * these should seem to be it. */
void label_sheet_named (LabelSheet *sheet, Pixel at, double reach);

/* A name that may be covered, though it is a pity. */
void label_sheet_name (LabelSheet *sheet, const PixelBox *box);

/* Places all labels that find room. */
void label_sheet_place (LabelSheet *sheet, Label *labels, uint32_t n_labels);

/* Places all labels, each over what is the least pity. */
void
label_sheet_place_over (LabelSheet *sheet, Label *labels, uint32_t n_labels);

/* Nothing further from its mark than this, beyond reach and size of a label,
 * is a place for it. */
#define LABEL_NEAR_PX 30.0

#endif
