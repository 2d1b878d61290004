/* What is right, computed from the trace; a model answer, and a wrong one. */
#include "attempt.h"

#include "question-click.h"
#include "question-reason.h"
#include "question-search.h"

static void
add (GArray *objects, ObjectKind kind, guint number)
{
  const Object object = { kind, number };

  g_array_append_val (objects, object);
}

static void
answer_choose (Answer *answer,
               const Question *question,
               const Occasion *occasion)
{
  Frame frame;

  frame_init (&frame, occasion->trace, occasion->reveal);
  for (guint i = 0; i < question->options->len; i++) {
    const QuestionOption *option = g_ptr_array_index (question->options, i);

    if (condition_holds (option->condition,
                         &(Situation){ &frame, NULL, INDEX_NONE }))
      add (answer->objects, OBJECT_NONE, i);
  }
  frame_clear (&frame);
  answer->is_any = !question->is_several;
}

static void
answer_numbers (Answer *answer,
                const Question *question,
                const Occasion *occasion)
{
  Frame frame;

  frame_init (&frame, occasion->trace, occasion->reveal);
  for (guint i = 0; i < question->quantities->len; i++) {
    const gint64 number = quantity_value (
        &frame, g_array_index (question->quantities, Quantity, i));

    g_array_append_val (answer->numbers, number);
  }
  frame_clear (&frame);
}

static void
answer_click (Answer *answer,
              const Question *question,
              const Occasion *occasion)
{
  Frame frame;

  frame_init (&frame, occasion->trace, occasion->step);
  question->click->collect (question, occasion, &frame, answer->objects);
  frame_clear (&frame);
  answer->is_any = question->click->is_any;
}

/* The furthest first: the engine's own sign, ties to the lower index. */
static void
sort_outside_set (GArray *items, const Trace *trace, guint facet)
{
  for (guint i = 1; i < items->len; i++)
    for (guint k = i; k > 0; k--) {
      Object *left = &g_array_index (items, Object, k - 1);
      Object *right = &g_array_index (items, Object, k);
      const Object swapped = *left;

      if (question_further (trace, facet, right->number, left->number) <= 0)
        break;
      *left = *right;
      *right = swapped;
    }
}

static void
answer_order (Answer *answer,
              const Question *question,
              const Occasion *occasion)
{
  const Trace *trace = occasion->trace;

  switch (question->order) {
  case ORDER_OF_SITES:
    for (guint i = occasion->round - 1; i < trace->n_rounds; i++)
      add (answer->objects, OBJECT_SITE, trace->rounds[i].site);
    break;
  case ORDER_OF_OUTSIDE_SET:
    g_array_unref (answer->objects);
    answer->objects = question_items (question, occasion);
    sort_outside_set (answer->objects, trace, question->argument.number);
    break;
  case ORDER_OF_PHASES:
    for (guint i = occasion->step; i < occasion->reveal; i++) {
      const Phase phase = timeline_place (trace, i + 1).phase;
      const guint n = answer->objects->len;

      if (n == 0
          || g_array_index (answer->objects, Object, n - 1).number != phase)
        add (answer->objects, OBJECT_NONE, phase);
    }
    break;
  }
}

static void
answer_drag (Answer *answer, const Question *question, const Occasion *occasion)
{
  const SiteSet *set = occasion->trace->set;
  Site to;

  answer->is_found = question_find_drag (question, occasion->trace, &to);
  if (!answer->is_found)
    return;
  answer->n_sites = set->n_sites;
  answer->sites = g_new0 (Site, set->n_sites);
  for (guint i = 0; i < set->n_sites; i++)
    answer->sites[i] = site_set_given (set, i);
  answer->sites[question->site] = to;
}

static void
answer_always (Answer *answer,
               const Question *question,
               const Occasion *occasion)
{
  answer->sites = question_find_failure (question->condition, occasion->trace,
                                         &answer->n_sites);
  answer->is_found = answer->sites != NULL;
  answer->is_any = TRUE;
  add (answer->objects, OBJECT_NONE, answer->is_found ? 1 : 0);
}

/* What is right is up to its tasks. */
static void
answer_nothing (Answer *answer,
                const Question *question,
                const Occasion *occasion)
{
  (void)answer;
  (void)question;
  (void)occasion;
}

Answer *
answer_new (const Question *question, const Occasion *occasion)
{
  static void (*const find[]) (Answer * answer, const Question *question,
                               const Occasion *occasion)
      = {
          [QUESTION_CHOOSE] = answer_choose,
          [QUESTION_NUMBERS] = answer_numbers,
          [QUESTION_CLICK] = answer_click,
          [QUESTION_ORDER] = answer_order,
          [QUESTION_DRAG] = answer_drag,
          [QUESTION_ALWAYS] = answer_always,
          [QUESTION_PERFORM] = answer_nothing,
        };
  Answer *answer = g_new0 (Answer, 1);

  answer->objects = g_array_new (FALSE, FALSE, sizeof (Object));
  answer->numbers = g_array_new (FALSE, FALSE, sizeof (gint64));
  find[question->kind](answer, question, occasion);
  return answer;
}

void
answer_free (Answer *answer)
{
  g_array_unref (answer->objects);
  g_array_unref (answer->numbers);
  g_free (answer->sites);
  g_free (answer);
}

Attempt *
answer_model (const Question *question, const Occasion *occasion)
{
  g_autoptr (Answer) answer = answer_new (question, occasion);
  Attempt *attempt = attempt_new (question);

  for (guint i = 0; i < answer->objects->len; i++)
    if (i == 0 || !answer->is_any)
      g_array_append_val (attempt->objects,
                          g_array_index (answer->objects, Object, i));
  for (guint i = 0; i < answer->numbers->len; i++)
    g_array_index (attempt->numbers, gint64, i)
        = g_array_index (answer->numbers, gint64, i);
  if (answer->sites != NULL)
    attempt->run
        = run_new (answer->sites, answer->n_sites, &occasion->trace->order);
  return attempt;
}

/* Of a model answer. */
static void
spoil (Attempt *attempt, const Question *question)
{
  GArray *objects = attempt->objects;

  for (guint i = 0; i < attempt->numbers->len; i++)
    g_array_index (attempt->numbers, gint64, i) += 1;
  g_clear_pointer (&attempt->run, run_unref);
  if (question->kind == QUESTION_ALWAYS)
    g_array_index (objects, Object, 0).number ^= 1;
  else if (question->kind == QUESTION_ORDER) {
    /* All but the first: it may be the last in all legal orders. */
    const Object first = g_array_index (objects, Object, 0);

    g_array_remove_index (objects, 0);
    g_array_append_val (objects, first);
  } else if (objects->len > 0)
    g_array_remove_index (objects, objects->len - 1);
}

/* Where everything tied, nothing at all is still wrong. */
Attempt *
answer_wrong (const Question *question, const Occasion *occasion)
{
  g_autoptr (Attempt) attempt = answer_model (question, occasion);
  g_autoptr (Verdict) verdict = NULL;

  spoil (attempt, question);
  verdict = attempt_grade (attempt, question, occasion);
  return verdict->is_right ? attempt_new (question)
                           : g_steal_pointer (&attempt);
}
