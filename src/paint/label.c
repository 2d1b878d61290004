#include "label.h"

#include "label-field.h"
#include "label-trial.h"

#include <float.h>
#include <math.h>

/* Ink of lines, a px of their length: how bad it is to cover. */
#define INK_PALE 0.5 /* lines that are hardly seen, below PALE_PX */
#define INK_LINE 1.5
#define INK_HEAVY 10.0
#define INK_CLEAR 100.0 /* of what has to be seen, also leaders */
#define PALE_PX 0.6
#define WIDE_PX 4.0 /* from here on each px of width counts */

/* So much more a place may cost than when it was chosen, before a name leaves
 * it. */
#define SLACK 100.0

/* Other leaders pass the middle of a facet at this distance, px. */
#define MIDDLE_PX 8.0

/* A line that passes a mark at more than this part of its radius is beside it.
 */
#define PASSES 0.7

/* What a label does for a place. */
typedef struct Manner {
  int n_gaps;   /* it looks for one in so many of them */
  double limit; /* all together costs less than this */
  LabelPatience patience;
} Manner;

static const Manner manners[] = {
  [LABEL_SHY] = { 2, 34, BEARS_NOTHING },
  [LABEL_PLAIN] = { 4, 130, BEARS_NOTHING },     /* or plain_manner */
  [LABEL_MAY_BE_LED] = { 4, 80, BEARS_NOTHING }, /* then led_manner */
  [LABEL_SHOULD] = { 4, 80, BEARS_NOTHING },     /* then led_far_manner */
  [LABEL_MUST] = { N_GAPS, DBL_MAX, BEARS_ALL },
  [LABEL_MUST_NEAR] = { 6, DBL_MAX, BEARS_ALL },
};
/* Further away one would not see in a crowd which of all marks is meant. */
static const Manner plain_manner = { 2, 130, BEARS_NOTHING };
static const Manner led_manner = { 6, 300, BEARS_DOUBT };
static const Manner led_far_manner = { N_GAPS, 2000, BEARS_DOUBT };

struct LabelSheet {
  PixelBox frame;
  LabelField *field;
  LabelNear near; /* the current label */
};

LabelSheet *
label_sheet_new (const PixelBox *frame)
{
  LabelSheet *sheet = g_new0 (LabelSheet, 1);

  sheet->frame = *frame;
  sheet->field = label_field_new (frame);
  label_near_init (&sheet->near);
  return sheet;
}

void
label_sheet_free (LabelSheet *sheet)
{
  label_field_free (sheet->field);
  label_near_clear (&sheet->near);
  g_free (sheet);
}

void
label_sheet_line (LabelSheet *sheet,
                  const Pixel ends[2],
                  double width_px,
                  LabelLine kind)
{
  const double wide = MAX (width_px / WIDE_PX, 1);
  double ink = width_px >= PALE_PX ? INK_LINE : INK_PALE;
  FieldLine line = { .ends = { ends[0], ends[1] }, .reach = width_px / 2 };

  if (kind != LABEL_LINE_LIGHT)
    ink = kind == LABEL_LINE_HEAVY ? INK_HEAVY : INK_CLEAR;
  line.ink = wide * ink;
  line.is_heavy = kind == LABEL_LINE_HEAVY || kind == LABEL_LINE_CLEAR;
  line.is_leader = kind == LABEL_LINE_LEADER;
  label_field_add_line (sheet->field, &line);
}

void
label_sheet_mark (
    LabelSheet *sheet, Pixel at, double radius, double reach, bool is_named)
{
  label_field_add_mark (sheet->field,
                        &(FieldMark){ at, radius, reach, is_named });
}

void
label_sheet_name (LabelSheet *sheet, const PixelBox *box, bool is_fixed)
{
  label_field_add_name (sheet->field, &(FieldName){ *box, is_fixed, false });
}

/* How large the label's own mark is painted: behind the hull it is smaller. */
static double
own_radius (const LabelNear *near, const Label *label)
{
  double radius = label->is_centred ? 0 : label->radius;

  for (guint i = 0; i < near->marks->len; i++) {
    const FieldMark *mark = &g_array_index (near->marks, FieldMark, i);

    if (label_is_own (label, mark->at))
      radius = MIN (radius, mark->radius);
  }
  return radius;
}

/* Lines that run into the label's own mark, or through the midst of it, lie
 * between it and nothing. */
static void
lighten_own (LabelNear *near, const Label *label)
{
  const double radius = own_radius (near, label);

  for (guint i = 0; i < near->lines->len; i++) {
    FieldLine *line = &g_array_index (near->lines, FieldLine, i);
    const double dx = line->ends[1].x - line->ends[0].x;
    const double dy = line->ends[1].y - line->ends[0].y;
    const double length = dx * dx + dy * dy;
    const double along = (label->at.x - line->ends[0].x) * dx
                         + (label->at.y - line->ends[0].y) * dy;
    const double part = length > 0 ? CLAMP (along / length, 0, 1) : 0;

    const double off = hypot (line->ends[0].x + part * dx - label->at.x,
                              line->ends[0].y + part * dy - label->at.y);
    const double most = part > 0 && part < 1 ? PASSES * radius : radius;

    if (line->is_heavy && off <= most + (label->is_centred ? line->reach : 0))
      line->is_heavy = false;
  }
}

static void
find_near (LabelSheet *sheet, const Label *label, const Manner *manner)
{
  const double reach = label_reach (label, label_gap (manner->n_gaps - 1));
  const PixelBox box = { (float)(label->at.x - reach - label->width),
                         (float)(label->at.y - reach - label->height),
                         (float)(label->at.x + reach + label->width),
                         (float)(label->at.y + reach + label->height) };

  label_field_find (sheet->field, &box, &sheet->near);
  lighten_own (&sheet->near, label);
}

static void
take (Label *label, int slot, const LabelTrial *trial)
{
  label->place.slot = slot;
  label->place.cost = trial->cost;
  label->low = (Pixel){ trial->box.left, trial->box.top };
  label->place.is_led = label_trial_is_led (trial, label);
}

/* Nearer places and earlier directions win ties. Where one would not see whose
 * name it is, one would not see it further away in the same direction.
 *
 * Returns: whether there is one. */
static bool
find_place (const LabelSheet *sheet, Label *label, const Manner *manner)
{
  double least = manner->limit;
  int slot = label->is_centred ? SLOT_ON_MARK : SLOT_ROUND;
  bool is_hopeless[N_DIRECTIONS] = { false };

  label->place.slot = LABEL_NOWHERE;
  for (; slot < SLOT_ROUND + manner->n_gaps * N_DIRECTIONS; slot++) {
    const int direction = (slot + N_DIRECTIONS - SLOT_ROUND) % N_DIRECTIONS;
    LabelTrial trial = label_trial (label, slot);

    /* All places to come cost more. */
    if (trial.cost >= least && direction == 0)
      break;
    if (trial.cost >= least || is_hopeless[direction])
      continue;
    trial.most = least;
    label_trial_judge (&trial, label, &sheet->near, &sheet->frame,
                       manner->patience);
    is_hopeless[direction]
        = manner->patience == BEARS_NOTHING && trial.doubt > 0;
    if (trial.cost < least) {
      take (label, slot, &trial);
      least = trial.cost;
    }
  }
  return label->place.slot != LABEL_NOWHERE;
}

/* Returns: whether the label can stay in the place that it had. */
static bool
stay (const LabelSheet *sheet, Label *label, const Manner *manner)
{
  const LabelPlace before = label->place;
  LabelTrial trial;

  if (before.slot == LABEL_NOWHERE
      || (before.slot == SLOT_ON_MARK && !label->is_centred)
      || before.slot >= SLOT_ROUND + manner->n_gaps * N_DIRECTIONS)
    return false;
  trial = label_trial (label, before.slot);
  trial.is_held = true;
  trial.most = before.cost + SLACK;
  label_trial_judge (&trial, label, &sheet->near, &sheet->frame,
                     manner->patience);
  if (trial.cost >= trial.most)
    return false;
  take (label, before.slot, &trial);
  label->place.cost = before.cost;
  label->place.is_led = label->place.is_led || before.is_led;
  return true;
}

/* Others keep off the name and its leader from now on. */
static void
settle (LabelSheet *sheet, const Label *label)
{
  const FieldName name = { { (float)label->low.x, (float)label->low.y,
                             (float)(label->low.x + label->width),
                             (float)(label->low.y + label->height) },
                           true,
                           label->is_centred };
  FieldLine leader = { .ink = INK_CLEAR, .is_leader = true };

  label_field_add_name (sheet->field, &name);
  if (!label->place.is_led)
    return;
  if (label_leader (label, &name.box, leader.ends))
    label_field_add_line (sheet->field, &leader);
}

typedef enum Attempt {
  ATTEMPT_TO_STAY,
  ATTEMPT_TO_FIND,
  ATTEMPT_TO_FIND_BEHIND,
  ATTEMPT_TO_BE_LED,
} Attempt;

#define N_RANKS 4

static const Manner *
manner_of (const Label *label, Attempt attempt)
{
  const bool may_be_led
      = attempt == ATTEMPT_TO_STAY || attempt == ATTEMPT_TO_BE_LED;

  if (may_be_led && label->need == LABEL_MAY_BE_LED)
    return &led_manner;
  if (may_be_led && label->need == LABEL_SHOULD)
    return &led_far_manner;
  return label->need == LABEL_PLAIN && !label->is_centred
             ? &plain_manner
             : &manners[label->need];
}

static void
try_to_place (LabelSheet *sheet, Label *label, Attempt attempt)
{
  const Manner *manner = manner_of (label, attempt);

  if (attempt == ATTEMPT_TO_STAY && label->place.slot == LABEL_NOWHERE)
    return;
  find_near (sheet, label, manner);
  if (attempt == ATTEMPT_TO_STAY)
    label->is_settled = stay (sheet, label, manner);
  else
    label->is_settled = find_place (sheet, label, manner);
  if (label->is_settled)
    settle (sheet, label);
}

/* Those that have to have a place come first; a facet has more room for its
 * name than a mark has. */
static int
rank_of (const Label *label)
{
  if (label->need >= LABEL_MUST)
    return label->is_centred ? 1 : 0;
  return label->need == LABEL_SHOULD ? 2 : 3;
}

static bool
is_tried (const Label *label, Attempt attempt)
{
  if (attempt == ATTEMPT_TO_BE_LED)
    return label->need == LABEL_MAY_BE_LED || label->need == LABEL_SHOULD;
  return label->is_behind == (attempt == ATTEMPT_TO_FIND_BEHIND);
}

static void
stay_all (LabelSheet *sheet, Label *labels, uint32_t n_labels)
{
  for (int rank = 0; rank < N_RANKS; rank++)
    for (uint32_t i = 0; i < n_labels; i++)
      if (!labels[i].is_settled && rank_of (&labels[i]) == rank)
        try_to_place (sheet, &labels[i], ATTEMPT_TO_STAY);
}

/* Of one rank those that the hull hides come after those that it does not, and
 * a name has a leader where none of the others needs the place. */
static void
find_all (LabelSheet *sheet, Label *labels, uint32_t n_labels)
{
  for (int rank = 0; rank < N_RANKS; rank++)
    for (Attempt attempt = ATTEMPT_TO_FIND; attempt <= ATTEMPT_TO_BE_LED;
         attempt++)
      for (uint32_t i = 0; i < n_labels; i++)
        if (!labels[i].is_settled && rank_of (&labels[i]) == rank
            && is_tried (&labels[i], attempt))
          try_to_place (sheet, &labels[i], attempt);
}

void
label_sheet_place (LabelSheet *sheet, Label *labels, uint32_t n_labels)
{
  for (uint32_t i = 0; i < n_labels; i++) {
    Label *label = &labels[i];

    label->is_settled = false;
    /* The middle of a facet is no mark, nor is that of a gap. But a leader may
     * begin there. */
    if (label->is_centred && label->need >= LABEL_MUST)
      label_sheet_mark (sheet, label->at, MIDDLE_PX, 0, false);
    else if (!label->is_centred && !label->is_number)
      label_sheet_mark (sheet, label->at, label->radius, label->reach, true);
  }
  stay_all (sheet, labels, n_labels);
  find_all (sheet, labels, n_labels);
}
