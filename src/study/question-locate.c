/* Where a question is asked, and whether it can be asked there. */
#include "attempt.h"
#include "lesson.h"
#include "object-name.h"
#include "position.h"
#include "question-click.h"

#include <glib/gi18n.h>

/* What is being found out. */
typedef struct Locating {
  const Question *question;
  Occasion *occasion;
  gboolean is_before; /* the position is before a place */
  Place place;
  GError **error;
  gboolean is_good;
  gboolean may_be_shown; /* of what is compared one part may be known */
  gboolean was_shown;
} Locating;

/* The round that a position is about: the current one, after its end the
 * next. */
static guint
round_about (const Trace *trace, Place place, gboolean is_before)
{
  if (place.phase == PHASE_COMPLETE)
    return trace->n_rounds + 1;
  if (place.round == 0)
    return is_before ? 0 : 1;
  return place.round + (!is_before && place.phase == PHASE_HAND_OVER ? 1 : 0);
}

/* Checks that the events of @phase are not shown yet, and shows them when the
 * answer is. */
static gboolean
need_phase (Locating *locating, Phase phase)
{
  Occasion *occasion = locating->occasion;
  const Place place = { occasion->round, phase };
  guint before, end;

  if (occasion_round (occasion) == NULL)
    return lesson_refuse (
        locating->error,
        _ ("there is no round here to ask about: the last round is "
           "%u"),
        occasion->trace->n_rounds);
  timeline_find (occasion->trace, place, true, &before);
  timeline_find (occasion->trace, place, false, &end);
  if (occasion->step > before && locating->may_be_shown) {
    locating->was_shown = TRUE;
    return TRUE;
  }
  if (occasion->step > before)
    return lesson_refuse (
        locating->error,
        _ ("this gives the answer away: it is shown already; ask "
           "before round %u %s"),
        occasion->round, phase_name (phase));
  occasion->reveal = MAX (occasion->reveal, end);
  return TRUE;
}

/* Of the state of things: that after the round, when the question is asked
 * before it. */
static void
need_state (Locating *locating)
{
  Occasion *occasion = locating->occasion;
  const RoundRow *round = occasion_round (occasion);

  if (!locating->is_before)
    return;
  if (locating->place.phase == PHASE_COMPLETE)
    occasion->reveal = occasion->trace->n_events;
  else if (round != NULL)
    occasion->reveal = MAX (occasion->reveal, round->end);
  else
    occasion->reveal = MAX (occasion->reveal, occasion->trace->start_end);
}

static void
need_quantity (Quantity quantity, gpointer user)
{
  Locating *locating = user;

  if (!locating->is_good)
    return;
  switch ((int)quantity) {
  case QUANTITY_VISIBLE:
  case QUANTITY_DYING_TRIANGLES:
  case QUANTITY_VISIBLE_UPPER:
  case QUANTITY_VISIBLE_VERTICAL:
    locating->is_good = need_phase (locating, PHASE_SEE);
    break;
  case QUANTITY_HORIZON:
    locating->is_good = need_phase (locating, PHASE_HORIZON);
    break;
  case QUANTITY_CONE:
  case QUANTITY_NEW_TRIANGLES:
    locating->is_good = need_phase (locating, PHASE_CONE);
    break;
  case QUANTITY_RETIRED:
    locating->is_good = need_phase (locating, PHASE_HAND_OVER);
    break;
  default:
    need_state (locating);
    break;
  }
}

static gboolean
locate_numbers (Locating *locating)
{
  const GArray *quantities = locating->question->quantities;

  for (guint i = 0; i < quantities->len; i++)
    need_quantity (g_array_index (quantities, Quantity, i), locating);
  return locating->is_good;
}

static gboolean
check_conditions (Locating *locating)
{
  const Question *question = locating->question;
  gboolean is_good = TRUE;
  Frame frame;

  frame_init (&frame, locating->occasion->trace, locating->occasion->reveal);
  for (guint i = 0; is_good && i < question->options->len; i++) {
    const QuestionOption *option = g_ptr_array_index (question->options, i);
    const char *fault = condition_fault (
        option->condition, &(Situation){ &frame, NULL, INDEX_NONE });

    if (fault != NULL)
      is_good = lesson_refuse (locating->error, "“%s”: %s",
                               condition_text (option->condition), fault);
  }
  frame_clear (&frame);
  return is_good;
}

static gboolean
locate_choose (Locating *locating)
{
  const Question *question = locating->question;
  g_autoptr (Answer) answer = NULL;
  guint step;

  locating->may_be_shown = TRUE;
  for (guint i = 0; i < question->options->len; i++) {
    const QuestionOption *option = g_ptr_array_index (question->options, i);

    condition_for_each_quantity (option->condition, need_quantity, locating);
  }
  if (!locating->is_good)
    return FALSE;
  if (locating->was_shown
      && locating->occasion->reveal == locating->occasion->step)
    return lesson_refuse (locating->error,
                          _ ("this gives the answer away: it is "
                             "shown already at this place"));
  /* Words are about the phase before which they stand. */
  if (locating->occasion->reveal == locating->occasion->step
      && locating->is_before
      && timeline_find (locating->occasion->trace, locating->place, false,
                        &step))
    locating->occasion->reveal = step;
  if (!check_conditions (locating))
    return FALSE;
  answer = answer_new (question, locating->occasion);
  return answer->objects->len > 0
         || lesson_refuse (locating->error, _ ("none of the options is right"));
}

/* Clicks */

static gboolean
check_argument (Locating *locating)
{
  const Object argument = locating->question->argument;
  const Trace *trace = locating->occasion->trace;
  char name[OBJECT_NAME_ROOM];

  object_name_write (argument, name);
  if (argument.kind == OBJECT_SITE && argument.number >= trace->set->n_sites)
    return lesson_refuse (locating->error, _ ("there is no site %s"), name);
  if (argument.kind != OBJECT_FACET)
    return TRUE;
  if (argument.number >= trace->n_facets)
    return lesson_refuse (locating->error, _ ("there is no facet %s"), name);
  return span_has (trace->facets[argument.number].span,
                   locating->occasion->step)
         || lesson_refuse (locating->error,
                           _ ("%s is not a facet of the hull at this place"),
                           name);
}

static gboolean
is_shown (const Frame *frame, Object object)
{
  switch (object.kind) {
  case OBJECT_FACET:
    return frame_facet_roles (frame, object.number) != 0
           || (frame->trace->is_flat
               && object.number < frame->delaunay.n_triangles);
  case OBJECT_RIDGE:
    for (guint i = 0; i < frame->n_ridges; i++)
      if (frame->ridges[i].ridge == object.number)
        return TRUE;
    return FALSE;
  case OBJECT_NONE:
  case OBJECT_SITE:
  case OBJECT_VERTEX:
    break;
  }
  return TRUE;
}

static gboolean
check_objects (Locating *locating, const Frame *frame)
{
  const Question *question = locating->question;
  g_autoptr (GArray) objects = g_array_new (FALSE, FALSE, sizeof (Object));

  question->click->collect (question, locating->occasion, frame, objects);
  if (objects->len == 0)
    return lesson_refuse (locating->error,
                          _ ("the answer is empty: there is nothing to click"));
  for (guint i = 0; i < objects->len; i++)
    if (!is_shown (frame, g_array_index (objects, Object, i)))
      return lesson_refuse (
          locating->error,
          _ ("the answer is not in the pictures at this place"));
  return TRUE;
}

static gboolean
locate_click (Locating *locating)
{
  const ClickKind *click = locating->question->click;
  gboolean is_good;
  Frame frame;

  if (click->event != PHASE_START && !need_phase (locating, click->event))
    return FALSE;
  if (!check_argument (locating))
    return FALSE;
  frame_init (&frame, locating->occasion->trace, locating->occasion->step);
  is_good = check_objects (locating, &frame);
  frame_clear (&frame);
  return is_good;
}

/* Orders, drags */

static gboolean
check_few_sites (Locating *locating)
{
  return locating->occasion->trace->set->n_sites <= QUESTION_MAX_SITES
         || lesson_refuse (locating->error,
                           _ ("this question is for at most %d sites"),
                           QUESTION_MAX_SITES);
}

static gboolean
locate_order (Locating *locating)
{
  g_autoptr (GArray) items = NULL;

  if (locating->question->order != ORDER_OF_OUTSIDE_SET
      && !need_phase (locating, PHASE_CHOOSE))
    return FALSE;
  if (!check_argument (locating) || !check_few_sites (locating))
    return FALSE;
  if (locating->question->order == ORDER_OF_SITES)
    locating->occasion->reveal = locating->occasion->trace->n_events;
  if (locating->question->order == ORDER_OF_PHASES)
    locating->occasion->reveal = occasion_round (locating->occasion)->end;
  if (locating->question->order == ORDER_OF_SITES
      && locating->occasion->trace->order.kind != ORDER_FURTHEST)
    return lesson_refuse (
        locating->error,
        _ ("this question is about QuickHull: write order furthest "
           "before it"));
  items = question_items (locating->question, locating->occasion);
  return items->len >= 2
         || lesson_refuse (locating->error,
                           _ ("there is nothing to put in order here"));
}

static gboolean
locate_drag (Locating *locating)
{
  const Question *question = locating->question;
  const Trace *trace = locating->occasion->trace;
  Situation situation = { NULL, trace, question->site };
  const char *fault;
  gboolean holds;
  Frame frame;

  if (!check_few_sites (locating))
    return FALSE;
  if (question->site >= trace->set->n_sites)
    return lesson_refuse (locating->error, _ ("there is no site s%u"),
                          question->site);
  frame_init (&frame, trace, trace->n_events);
  situation.frame = &frame;
  fault = condition_fault (question->condition, &situation);
  holds = fault == NULL && condition_holds (question->condition, &situation);
  frame_clear (&frame);
  if (fault != NULL)
    return lesson_refuse (locating->error, "“%s”: %s",
                          condition_text (question->condition), fault);
  return !holds
         || lesson_refuse (locating->error,
                           _ ("“%s” holds before anything is moved"),
                           condition_text (question->condition));
}

static gboolean
locate_always (Locating *locating)
{
  return check_few_sites (locating);
}

/* Performances */

/* A performance begins where a round, or the first partition, does. */
static gboolean
find_begin (Locating *locating)
{
  Occasion *occasion = locating->occasion;
  const Trace *trace = occasion->trace;

  if (occasion->step == 0)
    occasion->step = trace->simplex_end;
  return occasion->step == trace->simplex_end
         || occasion->step == trace->start_end
         || (occasion->round > 1 && occasion->round <= trace->n_rounds
             && occasion->step == trace->rounds[occasion->round - 2].end)
         || lesson_refuse (
             locating->error,
             _ ("a performance begins before a round: write start, "
                "simplex or round R"));
}

static gboolean
locate_perform (Locating *locating)
{
  Occasion *occasion = locating->occasion;
  const Trace *trace = occasion->trace;
  const guint wanted = (guint)locating->question->n_insertions;
  guint there;

  if (!check_few_sites (locating))
    return FALSE;
  if (trace->is_flat)
    return lesson_refuse (
        locating->error,
        _ ("these sites have no first simplex: nothing is inserted"));
  if (trace->order.kind != ORDER_FURTHEST)
    return lesson_refuse (
        locating->error,
        _ ("this question is about QuickHull: write order furthest "
           "before it"));
  there = trace->n_rounds + 1 - occasion->round;
  if (wanted > there)
    return lesson_refuse (
        locating->error,
        ngettext ("there is only %u insertion to perform here",
                  "there are only %u insertions to perform here", there),
        there);
  if (!find_begin (locating))
    return FALSE;
  occasion->reveal = trace->rounds[occasion->round + wanted - 2].end;
  return TRUE;
}

gboolean
question_locate (const Question *question,
                 const Trace *trace,
                 Occasion *occasion,
                 GError **error)
{
  static gboolean (*const locate[]) (Locating * locating) = {
    [QUESTION_CHOOSE] = locate_choose,   [QUESTION_NUMBERS] = locate_numbers,
    [QUESTION_CLICK] = locate_click,     [QUESTION_ORDER] = locate_order,
    [QUESTION_DRAG] = locate_drag,       [QUESTION_ALWAYS] = locate_always,
    [QUESTION_PERFORM] = locate_perform,
  };
  Locating locating = {
    .question = question, .occasion = occasion, .error = error, .is_good = TRUE
  };

  occasion->trace = trace;
  if (!position_find (trace, question->position, &occasion->step, error)
      || !position_read (question->position, &locating.place,
                         &locating.is_before, error))
    return FALSE;
  occasion->reveal = occasion->step;
  occasion->round = round_about (trace, locating.place, locating.is_before);
  return locate[question->kind](&locating);
}
