#include "label-trial.h"

#include "label-geometry.h"

#include <float.h>
#include <math.h>

static const double gaps[N_GAPS] = { 1.5, 5, 8.5, 12, 18, 26, 36, 44 };

/* What is best right on its mark is moved by little from there. */
#define CENTRED_STEP 1.6

/* What a place costs besides ink. */
#define COST_GAP 2.5 /* each px */
#define COST_OFF 5.0 /* the same for what is best right on its mark */
#define COST_DIRECTION 0.1

/* What it costs not to stand well. */
#define COST_OUTSIDE 20000.0
#define COST_NAME 15000.0
#define COST_PITY 160.0
#define COST_MARK 7000.0
#define COST_STACKED 45.0
#define COST_STACKED_OTHER 110.0
#define COST_UNDER 150.0
#define COST_MISTAKEN 110.0
#define COST_BETWEEN 90.0
#define COST_OUT 60.0    /* the name of a facet is not within it, */
#define COST_UNLED 300.0 /* and has no leader, */
#define COST_STUB 1000.0 /* or one that does not leave the facet */

/* Another mark is this many times as far from a name as its own, and so many
 * px more; further away there is a leader anyway. */
#define NEARER 2.0
#define NEARER_PX 2.5
#define NEARER_MOST_PX 30.0

/* So many times further is a mark that a name is on a line with. */
#define LEVEL 2.0

/* So many times further the mark of another is from the name of one that lies
 * behind: it would seem to be its own. */
#define NEARER_BEHIND 1.6

/* So far the name of a facet may reach out of it; the same where it stays. */
#define OUT_PX 0.5
#define OUT_HELD_PX 4.0

/* Less than that, this part of it, will do for a name to stay where it is. */
#define HELD 0.7

/* Names are painted on whole pixels: this far from where they are placed, px.
 */
#define ROUNDING 0.5

/* Between two names side by side, parts of their height. */
#define APART 0.6

/* The same, parts of that, between names one above the other when one is a
 * facet's: it would seem to be the site's second one. */
#define ABOVE 0.5F

/* What is too near for good company: one name above the other, parts of their
 * height; the same when one is a facet's; that of a facet and a mark. */
#define STACKED 0.6
#define STACKED_OTHER 1.3
#define UNDER_MARK 0.6

/* A name that a leader has to tell covers so much more with a line. */
#define LED_INK 3.0

/* Beyond this gap one looks for the mark of a name, px. */
#define LEADER_GAP 13.0

double
label_gap (int i)
{
  return gaps[i];
}

/* How far other marks have to be from a label with this gap. */
static double
far_enough (const Label *label, double gap)
{
  const double own = label->reach - label->radius + gap;

  return MIN (NEARER * own + NEARER_PX, NEARER_MOST_PX);
}

double
label_reach (const Label *label, double gap)
{
  return label->reach + gap
         + far_enough (label, gap) * (label->is_behind ? NEARER_BEHIND : 1);
}

/* Directions fan out from the upper right to both sides.
 *
 * Returns: a sixteenth turn each, from the right over the top. */
static int
sixteenth_of (int direction)
{
  const int side = direction % 2 == 0 ? direction / 2 : -(direction + 1) / 2;

  return (side + 2 + N_DIRECTIONS) % N_DIRECTIONS;
}

/* On the right the box
 * slides along the mark, in a corner it turns round it: from everywhere the gap
 * is the same. */
static Pixel
middle_at (const Label *label, int direction, double radius)
{
  const int sixteenth = sixteenth_of (direction);
  const int quarter = ((sixteenth + 1) / 4) % 4;
  const double slide = 0.5 * ((sixteenth + 1) % 4 - 1);
  const double width = label->width / 2, height = label->height / 2;
  double x, y;

  /* Quarters: right, up, left, down; within one, a third of the side each, and
   * then the corner. */
  if ((sixteenth + 1) % 4 == 3) {
    const double along = radius * G_SQRT2 / 2;

    x = quarter == 0 || quarter == 3 ? along + width : -along - width;
    y = quarter < 2 ? -along - height : along + height;
  } else if (quarter % 2 == 0) {
    x = quarter == 0 ? radius + width : -radius - width;
    y = (quarter == 0 ? -slide : slide) * height;
  } else {
    x = (quarter == 1 ? -slide : slide) * width;
    y = quarter == 1 ? -radius - height : radius + height;
  }
  return (Pixel){ label->at.x + x, label->at.y + y };
}

/* From the middle of a facet the name goes a little to one side. */
static Pixel
middle_off (const Label *label, int direction, double gap)
{
  const double angle = sixteenth_of (direction) * 2 * G_PI / N_DIRECTIONS;

  return (Pixel){ label->at.x + CENTRED_STEP * gap * cos (angle),
                  label->at.y - CENTRED_STEP * gap * sin (angle) };
}

LabelTrial
label_trial (const Label *label, int slot)
{
  const int direction = (slot - SLOT_ROUND) % N_DIRECTIONS;
  LabelTrial trial = { .gap = 0 };
  Pixel middle = label->at;

  if (slot >= SLOT_ROUND) {
    trial.gap = gaps[(slot - SLOT_ROUND) / N_DIRECTIONS];
    middle = label->is_centred
                 ? middle_off (label, direction, trial.gap)
                 : middle_at (label, direction, label->reach + trial.gap);
    /* Earlier directions win ties. */
    trial.cost = COST_DIRECTION * direction
                 + trial.gap * (label->is_centred ? COST_OFF : COST_GAP);
  }
  trial.box = (PixelBox){ (float)(middle.x - label->width / 2),
                          (float)(middle.y - label->height / 2),
                          (float)(middle.x + label->width / 2),
                          (float)(middle.y + label->height / 2) };
  return trial;
}

/* Faults */

/* Whether it is not lost yet: after that nothing else is looked for. */
static bool
is_borne (const LabelTrial *trial, LabelPatience patience)
{
  if (trial->cost + trial->fault + trial->doubt >= trial->most)
    return false;
  return patience == BEARS_ALL
         || (!(trial->fault > 0)
             && (patience == BEARS_DOUBT || !(trial->doubt > 0)));
}

static double
fault_of_frame (const PixelBox *frame, const PixelBox *box)
{
  return box->left >= frame->left && box->right <= frame->right
                 && box->top >= frame->top && box->bottom <= frame->bottom
             ? 0
             : COST_OUTSIDE;
}

static double
fault_of_names (const LabelNear *near, const Label *label, LabelTrial *trial)
{
  const PixelBox *box = &trial->box;
  const float part = (float)(trial->is_held ? HELD * APART : APART);
  const float apart = part * (box->bottom - box->top);
  const PixelBox wide
      = { box->left - apart, box->top, box->right + apart, box->bottom };
  const PixelBox roomy = { wide.left, wide.top - ABOVE * apart, wide.right,
                           wide.bottom + ABOVE * apart };
  double fault = 0;

  for (guint i = 0; i < near->names->len; i++) {
    const FieldName *name = &g_array_index (near->names, FieldName, i);

    const bool is_other
        = name->is_centred != label->is_centred && !label->is_number;
    const PixelBox *room = is_other ? &roomy : &wide;

    if (!name->is_fixed)
      trial->cost += boxes_meet (&name->box, box) ? COST_PITY : 0;
    else if (boxes_meet (&name->box, room))
      fault += COST_NAME;
  }
  return fault;
}

bool
label_is_own (const Label *label, Pixel at)
{
  return fabs (at.x - label->at.x) + fabs (at.y - label->at.y) <= 1;
}

/* Whether a name is on a line with another mark, but not with its own: it is
 * read after that one. */
static bool
is_level (const LabelTrial *trial, const Label *label, Pixel at)
{
  const PixelBox *box = &trial->box;

  return !trial->is_held && at.y > box->top && at.y < box->bottom
         && (label->at.y < box->top || label->at.y > box->bottom);
}

static void
find_marks (const LabelNear *near,
            const Label *label,
            LabelPatience patience,
            LabelTrial *trial)
{
  const double nearest = far_enough (label, trial->gap)
                         * (trial->is_held     ? HELD
                            : label->is_behind ? NEARER_BEHIND
                                               : 1);
  const bool may_be_mistaken = !label->is_number && !label->is_centred;

  for (guint i = 0; i < near->marks->len && is_borne (trial, patience); i++) {
    const FieldMark *mark = &g_array_index (near->marks, FieldMark, i);
    const double square = label_square_to (&trial->box, mark->at);
    const double reach
        = trial->is_held ? MIN (mark->radius, mark->reach) : mark->reach;
    const double needed
        = mark->radius
          + nearest * (is_level (trial, label, mark->at) ? LEVEL : 1);
    const bool is_others = !label_is_own (label, mark->at);

    if (square < reach * reach && (is_others || !label->is_centred))
      trial->fault += COST_MARK;
    if (may_be_mistaken && mark->is_named && is_others
        && square < needed * needed)
      trial->doubt = COST_MISTAKEN;
  }
}

/* Whether a line is crossed on the way to the middle of a name, wherever within
 * @room px of it that comes to lie. */
static bool
is_between (const FieldLine *line, Pixel from, Pixel middle, double room)
{
  const Pixel *ends = line->ends;

  for (int i = 0; i < 4; i++) {
    const Pixel to = { middle.x + (i % 2 == 0 ? room : -room),
                       middle.y + (i < 2 ? room : -room) };

    if (label_segments_cross (from, to, ends[0], ends[1]))
      return true;
  }
  return false;
}

/* A line lies between when it is crossed on the way from the mark to the middle
 * of the name. */
static void
find_lines (const LabelNear *near, const Label *label, LabelTrial *trial)
{
  const double room = trial->is_held ? ROUNDING : 2 * ROUNDING;
  const Pixel middle = { (trial->box.left + trial->box.right) / 2,
                         (trial->box.top + trial->box.bottom) / 2 };

  if (label->is_number)
    return;
  for (guint i = 0; i < near->lines->len; i++) {
    const FieldLine *line = &g_array_index (near->lines, FieldLine, i);

    if (line->is_heavy && is_between (line, label->at, middle, room)) {
      trial->doubt += COST_BETWEEN;
      return;
    }
  }
}

/* Whether the name of a facet is on others too: a leader tells whose it is. */
static void
find_facet (const Label *label, LabelTrial *trial)
{
  const double room = trial->is_held ? OUT_HELD_PX : OUT_PX;

  if (label->is_of_facet && label_outside (&trial->box, label->corners) > room)
    trial->doubt += COST_OUT;
}

/* The length of a line in a box, px. */
static double
length_under (const FieldLine *line, const PixelBox *box)
{
  const Pixel low = { box->left - line->reach, box->top - line->reach };
  const Pixel high = { box->right + line->reach, box->bottom + line->reach };
  Pixel ends[2] = { line->ends[0], line->ends[1] };

  if (MAX (ends[0].x, ends[1].x) < low.x || MIN (ends[0].x, ends[1].x) > high.x
      || MAX (ends[0].y, ends[1].y) < low.y
      || MIN (ends[0].y, ends[1].y) > high.y
      || !clip_to_rectangle (low, high, ends))
    return 0;
  return hypot (ends[1].x - ends[0].x, ends[1].y - ends[0].y);
}

/* Returns: the ink that a box covers; something above @most when it is more. */
static double
ink_under (const LabelNear *near, const PixelBox *box, double most)
{
  double ink = 0;

  for (guint i = 0; i < near->lines->len && ink <= most; i++) {
    const FieldLine *line = &g_array_index (near->lines, FieldLine, i);

    ink += line->ink * length_under (line, box);
  }
  return ink;
}

bool
label_trial_is_led (const LabelTrial *trial, const Label *label)
{
  if (label->is_number || label->is_centred)
    return label->is_centred && trial->doubt > 0;
  return trial->doubt + trial->fault > 0 || trial->gap > LEADER_GAP;
}

/* What is a pity, though it stands well: a name right above or below another
 * one, and that of a facet close to a mark. */
static double
cost_of_company (const LabelNear *near,
                 const Label *label,
                 const LabelTrial *trial)
{
  const double height = trial->box.bottom - trial->box.top;
  double cost = 0;

  for (guint i = 0; i < near->names->len; i++) {
    const FieldName *name = &g_array_index (near->names, FieldName, i);
    const bool is_other = name->is_centred != label->is_centred;
    const float apart = (float)((is_other ? STACKED_OTHER : STACKED) * height);
    const PixelBox tall = { trial->box.left, trial->box.top - apart,
                            trial->box.right, trial->box.bottom + apart };

    if (name->is_fixed && boxes_meet (&name->box, &tall))
      cost += is_other ? COST_STACKED_OTHER : COST_STACKED;
  }
  for (guint i = 0; label->is_centred && i < near->marks->len; i++) {
    const FieldMark *mark = &g_array_index (near->marks, FieldMark, i);
    const double apart = mark->reach + UNDER_MARK * height;

    if (mark->is_named
        && label_square_to (&trial->box, mark->at) < apart * apart)
      cost += COST_UNDER;
  }
  return cost;
}

/* A leader that is all within its facet leads from beside it to its border. */
static bool
is_stub (const Label *label, const PixelBox *box)
{
  PixelBox end;
  Pixel ends[2];

  if (!label->is_of_facet || !label_leader (label, box, ends))
    return false;
  end = (PixelBox){ (float)ends[1].x, (float)ends[1].y, (float)ends[1].x,
                    (float)ends[1].y };
  return label_outside (&end, label->corners) < 0;
}

/* The middle of a name that reaches out of its facet may be within: then it is
 * better there than with a leader that is none. */
static void
lead (const LabelNear *near, const Label *label, LabelTrial *trial)
{
  const PixelBox *box = &trial->box;
  const float x = (box->left + box->right) / 2;
  const float y = (box->top + box->bottom) / 2;
  const bool is_only_out = label->is_of_facet && !(trial->doubt > COST_OUT);
  const double fault = label_leader_fault (near, label, trial)
                       + (is_stub (label, box) ? COST_STUB : 0);

  if (fault > 0 && is_only_out
      && label_outside (&(PixelBox){ x, y, x, y }, label->corners) < 0) {
    trial->doubt = 0;
    trial->cost += COST_UNLED;
  } else {
    trial->fault += fault;
  }
}

void
label_trial_judge (LabelTrial *trial,
                   const Label *label,
                   const LabelNear *near,
                   const PixelBox *frame,
                   LabelPatience patience)
{
  double ink;

  trial->fault = fault_of_frame (frame, &trial->box);
  if (is_borne (trial, patience))
    trial->fault += fault_of_names (near, label, trial);
  if (is_borne (trial, patience))
    find_marks (near, label, patience, trial);
  if (is_borne (trial, patience))
    find_lines (near, label, trial);
  if (is_borne (trial, patience))
    find_facet (label, trial);
  if (is_borne (trial, patience) && label_trial_is_led (trial, label))
    lead (near, label, trial);
  if (!is_borne (trial, patience)) {
    trial->cost = DBL_MAX;
    return;
  }
  trial->cost += trial->fault + trial->doubt;
  if (!trial->is_held && !label->is_number)
    trial->cost += cost_of_company (near, label, trial);
  ink = ink_under (near, &trial->box, trial->most - trial->cost);
  trial->cost += label_trial_is_led (trial, label) && !label->is_centred
                     ? LED_INK * ink
                     : ink;
}
