#include "attempt.h"

#include "number.h"
#include "question-click.h"
#include "question-reason.h"
#include "question-search.h"

#include <glib/gi18n.h>

Attempt *
attempt_new (const Question *question)
{
  Attempt *attempt = g_new0 (Attempt, 1);
  const gint64 none = NUMBER_NONE;

  attempt->objects = g_array_new (FALSE, FALSE, sizeof (Object));
  attempt->numbers = g_array_new (FALSE, FALSE, sizeof (gint64));
  for (guint i = 0; i < question->quantities->len; i++)
    g_array_append_val (attempt->numbers, none);
  return attempt;
}

Attempt *
attempt_copy (const Attempt *attempt)
{
  Attempt *copy = g_new0 (Attempt, 1);

  copy->objects = g_array_copy (attempt->objects);
  copy->numbers = g_array_copy (attempt->numbers);
  if (attempt->run != NULL)
    copy->run = run_ref (attempt->run);
  return copy;
}

void
attempt_free (Attempt *attempt)
{
  g_array_unref (attempt->objects);
  g_array_unref (attempt->numbers);
  g_clear_pointer (&attempt->run, run_unref);
  g_free (attempt);
}

gboolean
attempt_is_empty (const Attempt *attempt)
{
  for (guint i = 0; i < attempt->numbers->len; i++)
    if (g_array_index (attempt->numbers, gint64, i) != NUMBER_NONE)
      return FALSE;
  return attempt->objects->len == 0 && attempt->run == NULL;
}

static int
index_of (const GArray *objects, Object object)
{
  for (guint i = 0; i < objects->len; i++)
    if (object_equal (g_array_index (objects, Object, i), object))
      return (int)i;
  return -1;
}

gboolean
attempt_has (const Attempt *attempt, Object object)
{
  return index_of (attempt->objects, object) >= 0;
}

gboolean
attempt_is_single (const Question *question)
{
  return (question->kind == QUESTION_CHOOSE && !question->is_several)
         || (question->kind == QUESTION_CLICK && question->click->is_any)
         || question->kind == QUESTION_ALWAYS;
}

void
attempt_toggle (Attempt *attempt, const Question *question, Object object)
{
  const int i = index_of (attempt->objects, object);

  if (i >= 0) {
    g_array_remove_index (attempt->objects, (guint)i);
    return;
  }
  if (attempt_is_single (question))
    g_array_set_size (attempt->objects, 0);
  g_array_append_val (attempt->objects, object);
}

/* Grading */

Verdict *
verdict_new (void)
{
  Verdict *verdict = g_new0 (Verdict, 1);

  verdict->reasons = g_ptr_array_new_with_free_func (g_free);
  verdict->missed = g_ptr_array_new_with_free_func (g_free);
  return verdict;
}

void
verdict_free (Verdict *verdict)
{
  g_ptr_array_unref (verdict->reasons);
  g_ptr_array_unref (verdict->missed);
  g_free (verdict);
}

typedef struct Grading {
  Verdict *verdict;
  const Attempt *attempt;
  const Question *question;
  const Occasion *occasion;
} Grading;

static void
tell (GPtrArray *reasons, char *reason)
{
  if (reason != NULL)
    g_ptr_array_add (reasons, reason);
}

/* The numbers as they are when the answer is shown. */
static char *
reason_numbers (const Condition *condition,
                const Occasion *occasion,
                const char *text,
                gboolean is_right)
{
  g_autofree char *facts = NULL;
  Frame frame;

  frame_init (&frame, occasion->trace, occasion->reveal);
  facts = condition_facts (condition, &frame);
  frame_clear (&frame);
  return g_strdup_printf (is_right ? _ ("“%s” is right (%s).")
                                   : _ ("“%s” is wrong (%s)."),
                          text, facts);
}

/* Returns: (transfer full): why the condition holds or does not, as a sentence;
 *          NULL: its word says all there is to say. */
static char *
reason_word (const Condition *condition, const Occasion *occasion)
{
  Frame frame;
  char *reason;

  frame_init (&frame, occasion->trace, occasion->reveal);
  reason = reason_condition (condition, occasion, &frame);
  frame_clear (&frame);
  return reason;
}

/* Why an option is right, or is not: what it says, seen at the end. */
static char *
reason_option (const Grading *grading, guint index, gboolean is_right)
{
  const QuestionOption *option
      = g_ptr_array_index (grading->question->options, index);
  const Condition *condition = option->condition;
  g_autofree char *text
      = question_item_text (grading->question, (Object){ OBJECT_NONE, index });
  g_autofree char *statement = condition_statement (condition);
  g_autofree char *reason = reason_word (condition, grading->occasion);
  const char *form;

  if (statement == NULL)
    return reason_numbers (condition, grading->occasion, text, is_right);
  if (reason != NULL)
    return g_strdup_printf (is_right ? _ ("“%s” is right. %s")
                                     : _ ("“%s” is wrong. %s"),
                            text, reason);
  if (condition_is_negated (condition))
    form = is_right ? _ ("“%s” is right: it is not the case that %s.")
                    : _ ("“%s” is wrong: %s.");
  else
    form = is_right ? _ ("“%s” is right: %s.")
                    : _ ("“%s” is wrong: it is not the case that %s.");
  return g_strdup_printf (form, text, statement);
}

static char *
why (const Grading *grading,
     const Frame *frame,
     Object object,
     gboolean is_right)
{
  const Question *question = grading->question;

  if (question->kind == QUESTION_CHOOSE)
    return reason_option (grading, object.number, is_right);
  return question->click->why (question, grading->occasion, frame, object);
}

/* What was found for a law, or was not. */
static char *
reason_always (const Question *question, const Occasion *occasion)
{
  g_autoptr (Answer) answer = answer_new (question, occasion);
  g_autoptr (GString) sites = g_string_new (NULL);

  if (!answer->is_found)
    return g_strdup (_ ("None of the sets that were tried makes it fail: "
                        "random ones, grids, circles, lines."));
  for (guint i = 0; i < answer->n_sites; i++) {
    char x[NUMBER_ROOM], y[NUMBER_ROOM];

    number_write (answer->sites[i].x, x);
    number_write (answer->sites[i].y, y);
    g_string_append_printf (sites, "%s(%s, %s)", i == 0 ? "" : ", ", x, y);
  }
  return g_strdup_printf (_ ("For these sites it fails: %s."), sites->str);
}

char *
answer_reason (const Question *question,
               const Occasion *occasion,
               Object object,
               gboolean is_right)
{
  const Grading grading = { NULL, NULL, question, occasion };
  char *reason;
  Frame frame;

  if (question->kind == QUESTION_ALWAYS)
    return reason_always (question, occasion);
  if (question->kind != QUESTION_CHOOSE && question->kind != QUESTION_CLICK)
    return NULL;
  frame_init (&frame, occasion->trace, occasion->step);
  reason = why (&grading, &frame, object, is_right);
  frame_clear (&frame);
  return reason;
}

/* A set of objects, or one of them where they tie. */
static void
grade_objects (Grading *grading)
{
  Verdict *verdict = grading->verdict;
  const GArray *chosen = grading->attempt->objects;
  g_autoptr (Answer) answer = answer_new (grading->question, grading->occasion);
  Frame frame;

  frame_init (&frame, grading->occasion->trace, grading->occasion->step);
  verdict->total = answer->is_any ? 1 : answer->objects->len;
  for (guint i = 0; i < chosen->len; i++) {
    const Object object = g_array_index (chosen, Object, i);

    if (index_of (answer->objects, object) >= 0) {
      verdict->right += 1;
      continue;
    }
    verdict->wrong += 1;
    tell (verdict->reasons, why (grading, &frame, object, FALSE));
  }
  for (guint i = 0; i < answer->objects->len; i++) {
    const Object object = g_array_index (answer->objects, Object, i);

    if (index_of (chosen, object) < 0
        && !(answer->is_any && verdict->right > 0))
      tell (verdict->missed, why (grading, &frame, object, TRUE));
  }
  frame_clear (&frame);
  verdict->missing = verdict->total - MIN (verdict->right, verdict->total);
}

static void
grade_numbers (Grading *grading)
{
  Verdict *verdict = grading->verdict;
  const Question *question = grading->question;
  g_autoptr (Answer) answer = answer_new (question, grading->occasion);

  verdict->total = answer->numbers->len;
  for (guint i = 0; i < answer->numbers->len; i++) {
    const gint64 given = g_array_index (grading->attempt->numbers, gint64, i);
    const guint right = (guint)g_array_index (answer->numbers, gint64, i);
    const char *label
        = quantity_label (g_array_index (question->quantities, Quantity, i));

    if (given == right) {
      verdict->right += 1;
    } else if (given == NUMBER_NONE) {
      verdict->missing += 1;
      tell (verdict->missed, g_strdup_printf (_ ("%s: %u."), label, right));
    } else {
      g_autofree char *wrong = g_strdup_printf ("%" G_GINT64_FORMAT, given);

      verdict->wrong += 1;
      tell (verdict->reasons,
            g_strdup_printf (_ ("%s: not %s."), label, wrong));
      tell (verdict->missed, g_strdup_printf (_ ("%s: %u."), label, right));
    }
  }
}

/* Orders */

/* How many of the chosen stand rightly from the front on. */
static guint
count_legal (const Grading *grading, const Answer *answer)
{
  const GArray *chosen = grading->attempt->objects;
  const Question *question = grading->question;
  guint n = 0, better;

  if (question->order == ORDER_OF_SITES) {
    n = question_legal_order (grading->occasion, chosen, &better);
    if (better != INDEX_NONE)
      tell (grading->verdict->reasons,
            g_strdup_printf (
                _ ("s%u is not the furthest of its outside set: s%u lies "
                   "further in front of the facet."),
                g_array_index (chosen, Object, n).number, better));
    return n;
  }
  for (; n < MIN (chosen->len, answer->objects->len); n++) {
    const Object given = g_array_index (chosen, Object, n);
    const Object right = g_array_index (answer->objects, Object, n);

    if (object_equal (given, right))
      continue;
    if (question->order == ORDER_OF_PHASES
        || question_further (grading->occasion->trace,
                             question->argument.number, right.number,
                             given.number)
               != 0)
      break;
  }
  return n;
}

static void
tell_order (Grading *grading, const Answer *answer, guint n_legal)
{
  const Question *question = grading->question;
  const GArray *chosen = grading->attempt->objects;
  g_autoptr (GString) order = g_string_new (NULL);
  g_autofree char *here = NULL;

  for (guint i = 0; i < answer->objects->len; i++) {
    g_autofree char *text = question_item_text (
        question, g_array_index (answer->objects, Object, i));

    g_string_append_printf (order, "%s%s", i == 0 ? "" : ", ", text);
  }
  tell (grading->verdict->missed,
        g_strdup_printf (_ ("A right order: %s."), order->str));
  if (n_legal >= chosen->len || grading->verdict->reasons->len > 0)
    return;
  here = question_item_text (question, g_array_index (chosen, Object, n_legal));
  tell (
      grading->verdict->reasons,
      g_strdup_printf (_ ("“%s” cannot come at place %u."), here, n_legal + 1));
}

static void
grade_order (Grading *grading)
{
  Verdict *verdict = grading->verdict;
  g_autoptr (Answer) answer = answer_new (grading->question, grading->occasion);
  const guint n_chosen = grading->attempt->objects->len;

  verdict->total = answer->objects->len;
  verdict->right = count_legal (grading, answer);
  verdict->wrong = n_chosen - verdict->right;
  verdict->missing = verdict->total - MIN (n_chosen, verdict->total);
  if (verdict->right < verdict->total)
    tell_order (grading, answer, verdict->right);
}

/* Drags */

/* What does not hold yet, or still does, in words where there are any. */
static char *
reason_drag (const Condition *condition)
{
  g_autofree char *statement = condition_statement (condition);
  g_autofree char *sentence = condition_sentence (condition);

  return statement != NULL && condition_is_negated (condition)
             ? g_strdup_printf (_ ("It is still the case that %s."), statement)
             : g_strdup_printf (_ ("It is not yet the case that %s."),
                                sentence);
}

static void
grade_drag (Grading *grading)
{
  Verdict *verdict = grading->verdict;
  const Question *question = grading->question;
  const Run *run = grading->attempt->run;

  verdict->total = 1;
  verdict->right
      = run != NULL
        && question_drag_holds (question, grading->occasion->trace, run->trace);
  verdict->missing = 1 - verdict->right;
  if (verdict->right == 0)
    tell (verdict->reasons, reason_drag (question->condition));
}

static gboolean
fails_as_dragged (const Grading *grading)
{
  return grading->attempt->run != NULL
         && question_fails (grading->question->condition,
                            grading->attempt->run->trace);
}

static void
grade_always (Grading *grading)
{
  Verdict *verdict = grading->verdict;
  const GArray *chosen = grading->attempt->objects;
  const gboolean says_no
      = chosen->len > 0 && g_array_index (chosen, Object, 0).number == 1;
  g_autoptr (Answer) answer = NULL;

  verdict->total = 1;
  verdict->missing = 1;
  if (chosen->len == 0)
    return;
  if (says_no && fails_as_dragged (grading)) {
    verdict->right = 1;
    verdict->missing = 0;
    return;
  }
  answer = answer_new (grading->question, grading->occasion);
  if (says_no == answer->is_found && !says_no) {
    verdict->right = 1;
    verdict->missing = 0;
  } else if (says_no && answer->is_found) {
    tell (verdict->reasons, g_strdup (_ ("For these sites it holds: drag a "
                                         "site until it fails.")));
  } else {
    verdict->wrong = 1;
    tell (verdict->reasons,
          g_strdup (says_no
                        ? _ ("None of the sets that were tried makes it fail: "
                             "random ones, grids, circles, lines.")
                        : _ ("There are sites for which it fails.")));
  }
}

/* A performance is graded by its tasks. */
static void
grade_nothing (Grading *grading)
{
  grading->verdict->total = 1;
  grading->verdict->missing = 1;
}

Verdict *
attempt_grade (const Attempt *attempt,
               const Question *question,
               const Occasion *occasion)
{
  static void (*const grade[]) (Grading * grading) = {
    [QUESTION_CHOOSE] = grade_objects,  [QUESTION_NUMBERS] = grade_numbers,
    [QUESTION_CLICK] = grade_objects,   [QUESTION_ORDER] = grade_order,
    [QUESTION_DRAG] = grade_drag,       [QUESTION_ALWAYS] = grade_always,
    [QUESTION_PERFORM] = grade_nothing,
  };
  Verdict *verdict = verdict_new ();
  Grading grading = { verdict, attempt, question, occasion };

  grade[question->kind](&grading);
  verdict->is_right = verdict->right == verdict->total && verdict->wrong == 0
                      && verdict->missing == 0;
  return verdict;
}
