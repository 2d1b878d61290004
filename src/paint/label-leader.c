/* Leaders: where they go, and what speaks against them. */
#include "label-geometry.h"
#include "label-trial.h"

/* What it costs not to lead well. */
#define COST_LEADER 3000.0
#define COST_BESIDE 1500.0  /* its name stands beside another mark */
#define COST_ALONG 300.0    /* more than is borne but for a name that matters */
#define COST_LEADERS 5000.0 /* two that meet exchange their names */
#define COST_ACROSS 120.0   /* a leader across a heavy line */
#define COST_SHORT 40.0     /* a leader that is hardly seen */
#define COST_UPRIGHT 60.0   /* one like a lift, or a line of a hatch */

#define SHORT_GAP 8.0

/* A leader begins so far from its mark, is as long at least, and passes other
 * marks and leaders at such distances, px. */
#define OFF_MARK_PX 1.5
#define LEAST_PX 1.0
#define CLEAR_PX 3.0
#define LEADERS_APART_PX 7.0

/* From a name with a leader to other marks: px, and a part of its gap. */
#define LED_PX 6.0
#define LED_PART 0.5

/* A leader leaves lines with so much ink at an angle of which this is the sine,
 * and is no nearer to them than so many px. */
#define SEEN_INK 1.5
#define ALONG 0.25
#define ALONG_PX 2.5

/* A leader is upright when it goes to a side by no more than this part of its
 * way. */
#define UPRIGHT 0.1

bool
label_leader (const Label *label, const PixelBox *box, Pixel ends[2])
{
  const Pixel to = { CLAMP (label->at.x, box->left, box->right),
                     CLAMP (label->at.y, box->top, box->bottom) };
  const double dx = to.x - label->at.x, dy = to.y - label->at.y;
  const double length = hypot (dx, dy);
  const double radius = label->is_centred ? 0 : label->radius;
  const double off
      = radius > 0 ? radius + MIN (OFF_MARK_PX, (length - radius) / 2) : 0;

  ends[0] = ends[1] = to;
  if (length < radius + LEAST_PX)
    return false;
  ends[0] = (Pixel){ label->at.x + dx * off / length,
                     label->at.y + dy * off / length };
  return true;
}

/* Whether a leader lies all along a line that is seen: it would be taken for a
 * part of it. */
static bool
runs_along (const FieldLine *line, const Pixel leader[2])
{
  const double dx = leader[1].x - leader[0].x, dy = leader[1].y - leader[0].y;
  const double off = MAX (ALONG * hypot (dx, dy), ALONG_PX);
  const Pixel middle = { leader[0].x + dx / 2, leader[0].y + dy / 2 };

  return line->ink >= SEEN_INK
         && label_distance_from (leader[1], line->ends) < off
         && label_distance_from (middle, line->ends) < MAX (off / 2, ALONG_PX);
}

static bool
is_upright (const Pixel leader[2])
{
  return fabs (leader[1].x - leader[0].x)
         < UPRIGHT * fabs (leader[1].y - leader[0].y);
}

/* Whether a leader would seem to begin at this mark. */
static bool
is_passed (const FieldMark *mark, const Pixel leader[2])
{
  return label_distance_from (mark->at, leader)
         < (mark->is_named ? mark->reach + CLEAR_PX : mark->radius);
}

/* Whether the name at its end would seem to be of this mark. */
static bool
is_beside (const FieldMark *mark, const LabelTrial *trial)
{
  const double apart = mark->radius + MAX (LED_PX, LED_PART * trial->gap);

  return mark->is_named
         && label_square_to (&trial->box, mark->at) < apart * apart;
}

static double
fault_beside_marks (const LabelNear *near,
                    const Label *label,
                    const LabelTrial *trial,
                    const Pixel leader[2])
{
  double fault = 0;

  for (guint i = 0; i < near->marks->len; i++) {
    const FieldMark *mark = &g_array_index (near->marks, FieldMark, i);

    if (label_is_own (label, mark->at))
      continue;
    if (is_passed (mark, leader))
      return COST_LEADER;
    if (!label->is_centred && is_beside (mark, trial))
      fault = COST_BESIDE;
  }
  return fault;
}

/* Whether two segments meet, or come nearer to each other than @apart. */
static bool
are_near (const Pixel a[2], const Pixel b[2], double apart)
{
  return label_segments_cross (a[0], a[1], b[0], b[1])
         || label_distance_from (a[0], b) < apart
         || label_distance_from (a[1], b) < apart
         || label_distance_from (b[0], a) < apart
         || label_distance_from (b[1], a) < apart;
}

static double
fault_on_lines (const LabelNear *near,
                const Label *label,
                LabelTrial *trial,
                const Pixel leader[2])
{
  double fault = 0;

  for (guint i = 0; i < near->lines->len; i++) {
    const FieldLine *line = &g_array_index (near->lines, FieldLine, i);

    if (line->is_leader && are_near (leader, line->ends, LEADERS_APART_PX))
      fault += COST_LEADERS;
    else if (runs_along (line, leader))
      trial->doubt += COST_ALONG;
    else if (line->is_heavy && !label->is_centred
             && label_segments_cross (leader[0], leader[1], line->ends[0],
                                      line->ends[1]))
      trial->cost += COST_ACROSS;
  }
  return fault;
}

/* A leader passes clear of all other marks, names and leaders, and runs along
 * no line. */
double
label_leader_fault (const LabelNear *near,
                    const Label *label,
                    LabelTrial *trial)
{
  double fault = 0;
  Pixel ends[2];

  if (trial->gap < SHORT_GAP)
    trial->cost += COST_SHORT;
  if (!label_leader (label, &trial->box, ends))
    fault += COST_LEADER;
  if (is_upright (ends))
    trial->cost += COST_UPRIGHT;
  fault += fault_beside_marks (near, label, trial, ends);
  for (guint i = 0; i < near->names->len && !(fault > 0); i++)
    if (label_segment_meets (ends,
                             &g_array_index (near->names, FieldName, i).box))
      fault += COST_LEADER;
  return fault + fault_on_lines (near, label, trial, ends);
}
