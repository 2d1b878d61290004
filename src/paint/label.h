/* Labels: where the names of marks go.
 *
 * A name stands well when it lies within the frame, apart from all other names,
 * on no mark, when it is much nearer to the mark that it names than to any
 * other that has a name, and no heavy line lies between the two. Of several
 * such places a name takes the one that covers least of other lines. Where no
 * place near its mark is such, a name is left out, or a leader tells from a
 * little further away whose it is. A leader runs along no line, crosses no
 * other, and passes clear of all marks but its own; nor does the name that it
 * leads to stand beside another. The name of a facet stands in it, or has a
 * leader, and keeps away from marks and their names.
 *
 * A name that had a place in the picture before stays there while it stands
 * well and covers hardly more than when the place was chosen. */
#ifndef LABEL_H
#define LABEL_H

#include "box-index.h"
#include "clip.h"

typedef struct LabelSheet LabelSheet;

/* A place round a mark, by direction and distance: whatever the size of name
 * and mark, it is the same. */
typedef struct LabelPlace {
  int slot;    /* LABEL_NOWHERE: none */
  double cost; /* when it was chosen */
  bool is_led; /* a leader tells whose name it is */
} LabelPlace;

#define LABEL_NOWHERE (-1)

/* What becomes of a name without a place where it stands well. */
typedef enum LabelNeed {
  LABEL_SHY,        /* it is left out, and also if it would cover anything */
  LABEL_PLAIN,      /* it is left out */
  LABEL_MAY_BE_LED, /* it has a leader, if that and it lie on nothing */
  LABEL_SHOULD,     /* the same, placed before those and from further away */
  LABEL_MUST,       /* it is never left out, and placed before the others */
  LABEL_MUST_NEAR,  /* the same, near its mark: in a crowd there is no better
                       place far away */
} LabelNeed;

/* A name to place. */
typedef struct Label {
  Pixel at;      /* its mark */
  double radius; /* of the mark, px, */
  double reach;  /* and of the ring round it */
  double width, height;
  LabelNeed need;
  bool is_centred;  /* best right on its mark */
  bool is_behind;   /* its mark is hidden, and hardly seen beside others */
  bool is_of_facet; /* centred in a facet, of which it stays within: */
  Pixel corners[3]; /* its corners */
  bool is_number;   /* of a line, not the name of a mark: none takes it for
                       that of another */
  uint32_t item;    /* for the caller */
  LabelPlace place; /* that it had before; then the result: */
  bool is_settled;  /* it has one */
  Pixel low;        /* its upper left corner */
} Label;

/* Of a view whose names have to stay in @frame. */
LabelSheet *label_sheet_new (const PixelBox *frame);
void label_sheet_free (LabelSheet *sheet);

/* Of lines with more ink across, more is covered. */
typedef enum LabelLine {
  LABEL_LINE_LIGHT,
  LABEL_LINE_HEAVY,  /* must not lie between a name and its mark */
  LABEL_LINE_CLEAR,  /* nor under a name */
  LABEL_LINE_LEADER, /* of another name */
} LabelLine;

/* What labels should keep off. A mark @is_named when a name beside it would
 * seem to be its own. */
void label_sheet_line (LabelSheet *sheet,
                       const Pixel ends[2],
                       double width_px,
                       LabelLine kind);
void label_sheet_mark (
    LabelSheet *sheet, Pixel at, double radius, double reach, bool is_named);

/* A name that has its place; one that is not fixed may be covered, though it is
 * a pity. */
void label_sheet_name (LabelSheet *sheet, const PixelBox *box, bool is_fixed);

/* Places all labels that find room. Their marks are named, whether they have
 * been added or not. */
void label_sheet_place (LabelSheet *sheet, Label *labels, uint32_t n_labels);

/* Nothing further from its mark than this, beyond reach and size of a label, is
 * of concern to it, px. */
#define LABEL_NEAR_PX 74.0
#define LABEL_NEAR_IN_CROWD_PX 56.0 /* where none goes far away */

#endif
