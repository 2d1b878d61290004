/* A place for a label that is looked at: where it is, and what speaks against
 * it. */
#ifndef LABEL_TRIAL_H
#define LABEL_TRIAL_H

#include "label-field.h"
#include "label.h"

typedef struct LabelTrial {
  PixelBox box;
  bool is_held; /* the label has the place already */
  double most;  /* all together has to cost less than this */
  double gap;   /* from mark to box, px */
  double cost;  /* of distance and direction, and of ink */
  double doubt; /* above 0: one would not see whose name it is */
  double fault; /* above 0: it lies on something, or outside the frame */
} LabelTrial;

/* Slots: right on the mark; then all directions with the smallest gap, all with
 * the next one … */
#define SLOT_ON_MARK 0
#define SLOT_ROUND 1
#define N_DIRECTIONS 16
#define N_GAPS 8

/* Returns: the gap in px of the slots from SLOT_ROUND + @i · N_DIRECTIONS. */
double label_gap (int i);

/* Returns: a trial in a slot, of which place and cost of distance are known. */
LabelTrial label_trial (const Label *label, int slot);

/* What a label bears where it needs a place. */
typedef enum LabelPatience {
  BEARS_NOTHING,
  BEARS_DOUBT,
  BEARS_ALL,
} LabelPatience;

/* Finds what else speaks against a trial. What cannot be borne, or costs too
 * much, costs DBL_MAX: then nothing else is looked for. */
void label_trial_judge (LabelTrial *trial,
                        const Label *label,
                        const LabelNear *near,
                        const PixelBox *frame,
                        LabelPatience patience);

/* Whether a leader has to tell whose name it would be. */
bool label_trial_is_led (const LabelTrial *trial, const Label *label);

/* Whether a mark is its own: marks in the same place share their name. */
bool label_is_own (const Label *label, Pixel at);

/* The way of the leader, from next to the mark, or the middle of a facet, to
 * its name in @box.
 *
 * Returns: false when it is too short to be seen. */
bool label_leader (const Label *label, const PixelBox *box, Pixel ends[2]);

/* Returns: what is wrong with the leader that a trial needs, above 0; what is a
 *          pity is added to cost and doubt of the trial. */
double label_leader_fault (const LabelNear *near,
                           const Label *label,
                           LabelTrial *trial);

/* Returns: how far from its mark a label with gaps up to @gap has to look. */
double label_reach (const Label *label, double gap);

#endif
