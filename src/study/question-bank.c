#include "question-bank.h"

#include "attempt.h"
#include "question-click.h"
#include "question-reason.h"
#include "question-search.h"

#include <glib/gi18n.h>
#include <stdarg.h>

static void
free_option (gpointer data)
{
  BankOption *option = data;

  g_free (option->text);
  g_free (option->reason);
  g_free (option);
}

static void
free_item (gpointer data)
{
  BankItem *item = data;

  g_free (item->name);
  g_free (item->lesson);
  g_free (item->title);
  g_free (item->prompt);
  g_free (item->reason);
  g_ptr_array_unref (item->given);
  g_ptr_array_unref (item->options);
  g_free (item);
}

QuestionBank *
question_bank_new (void)
{
  QuestionBank *bank = g_new0 (QuestionBank, 1);

  bank->items = g_ptr_array_new_with_free_func (free_item);
  bank->left_out = g_ptr_array_new_with_free_func (g_free);
  return bank;
}

void
question_bank_free (QuestionBank *bank)
{
  g_ptr_array_unref (bank->items);
  g_ptr_array_unref (bank->left_out);
  g_free (bank);
}

/* One question on its way into the bank. */
typedef struct Banking {
  QuestionBank *bank;
  const Lesson *lesson;
  guint stop;
  const Question *question;
  const Occasion *occasion;
  Answer *answer;
  guint n_items; /* made of it so far */
} Banking;

static void leave_out (Banking *banking, const char *format, ...)
    G_GNUC_PRINTF (2, 3);

static void
leave_out (Banking *banking, const char *format, ...)
{
  g_autofree char *reason = NULL;
  va_list arguments;

  va_start (arguments, format);
  reason = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  g_ptr_array_add (banking->bank->left_out,
                   g_strdup_printf (_ ("%s:%u: left out: %s"),
                                    banking->lesson->path,
                                    banking->question->line, reason));
}

static BankItem *
add_item (Banking *banking, BankForm form)
{
  BankItem *item = g_new0 (BankItem, 1);

  banking->n_items += 1;
  item->name = g_strdup_printf ("lesson%u-stop%u-%u", banking->bank->n_lessons,
                                banking->stop + 1, banking->n_items);
  item->lesson = g_strdup (banking->lesson->title);
  item->title = g_strdup (lesson_stop (banking->lesson, banking->stop)->title);
  item->line = banking->question->line;
  item->prompt = question_prompt (banking->question, banking->occasion);
  item->given = question_given (banking->question, banking->occasion);
  item->form = form;
  item->options = g_ptr_array_new_with_free_func (free_option);
  g_ptr_array_add (banking->bank->items, item);
  return item;
}

static gboolean
is_right (const Banking *banking, Object object)
{
  for (guint i = 0; i < banking->answer->objects->len; i++)
    if (object_equal (g_array_index (banking->answer->objects, Object, i),
                      object))
      return TRUE;
  return FALSE;
}

/* Takes @text. */
static void
add_option (Banking *banking, BankItem *item, Object object, char *text)
{
  BankOption *option = g_new0 (BankOption, 1);

  option->text = text;
  option->is_right = is_right (banking, object);
  option->reason = answer_reason (banking->question, banking->occasion, object,
                                  option->is_right);
  g_ptr_array_add (item->options, option);
}

/* Options that are written down */

static void
bank_choose (Banking *banking)
{
  const Question *question = banking->question;
  BankItem *item
      = add_item (banking, question->is_several ? BANK_SEVERAL : BANK_ONE);

  for (guint i = 0; i < question->options->len; i++) {
    const Object object = { OBJECT_NONE, i };

    add_option (banking, item, object, question_item_text (question, object));
  }
}

/* Numbers: an item for each */

static void
bank_numbers (Banking *banking)
{
  const Question *question = banking->question;

  for (guint i = 0; i < question->quantities->len; i++) {
    BankItem *item = add_item (banking, BANK_NUMBER);
    const char *label
        = quantity_label (g_array_index (question->quantities, Quantity, i));

    item->number = (guint)g_array_index (banking->answer->numbers, gint64, i);
    item->reason = g_strdup_printf (_ ("%s: %u."), label, item->number);
    g_ptr_array_add (item->given, g_strdup_printf (_ ("How many: %s?"), label));
  }
}

/* Clicks: all that could be clicked are options */

static void
add_candidate (GArray *candidates,
               const Question *question,
               const Frame *frame,
               Object object)
{
  if (!question_takes (question, frame, &object))
    return;
  for (guint i = 0; i < candidates->len; i++)
    if (object_equal (g_array_index (candidates, Object, i), object))
      return;
  g_array_append_val (candidates, object);
}

static GArray *
find_candidates (const Question *question, const Frame *frame)
{
  GArray *candidates = g_array_new (FALSE, FALSE, sizeof (Object));

  switch (question->click->target) {
  case OBJECT_SITE:
    for (guint i = 0; i < frame->n_sites; i++)
      add_candidate (candidates, question, frame, (Object){ OBJECT_SITE, i });
    break;
  case OBJECT_FACET:
    for (guint i = 0; i < frame->n_facets; i++)
      add_candidate (candidates, question, frame,
                     (Object){ OBJECT_FACET, frame->facets[i].facet });
    break;
  case OBJECT_VERTEX:
    for (guint i = 0; i < frame->delaunay.n_triangles; i++)
      add_candidate (
          candidates, question, frame,
          (Object){ OBJECT_VERTEX, frame->delaunay.triangles[i].facet });
    break;
  case OBJECT_RIDGE:
    for (guint i = 0; i < frame->n_ridges; i++)
      add_candidate (candidates, question, frame,
                     (Object){ OBJECT_RIDGE, frame->ridges[i].ridge });
    break;
  case OBJECT_NONE:
    break;
  }
  return candidates;
}

static void
bank_candidates (Banking *banking, const Frame *frame, const GArray *candidates)
{
  const gboolean is_any = banking->answer->is_any;
  BankItem *item = add_item (banking, is_any ? BANK_ONE : BANK_SEVERAL);

  for (guint i = 0; i < candidates->len; i++) {
    const Object object = g_array_index (candidates, Object, i);

    add_option (banking, item, object,
                question_object_text (banking->question, frame, object));
  }
}

static void
bank_click (Banking *banking)
{
  g_autoptr (GArray) candidates = NULL;
  Frame frame;

  frame_init (&frame, banking->occasion->trace, banking->occasion->step);
  candidates = find_candidates (banking->question, &frame);
  if (candidates->len > BANK_MAX_OPTIONS)
    leave_out (banking, _ ("%u things to choose from are too many"),
               candidates->len);
  else if (banking->answer->is_any
           && banking->answer->objects->len == candidates->len)
    leave_out (banking, _ ("all that could be chosen is right"));
  else
    bank_candidates (banking, &frame, candidates);
  frame_clear (&frame);
}

/* Orders: where only one is right */

static gboolean
can_follow (const Banking *banking, const GArray *order, guint n, Object object)
{
  g_autoptr (GArray) tried = g_array_new (FALSE, FALSE, sizeof (Object));
  guint better;

  g_array_append_vals (tried, order->data, n);
  g_array_append_val (tried, object);
  return question_legal_order (banking->occasion, tried, &better) > n;
}

/* Whether some other site could be inserted somewhere in the order. */
static gboolean
has_other_order (const Banking *banking)
{
  const GArray *order = banking->answer->objects;

  for (guint i = 0; i < order->len; i++)
    for (guint k = i + 1; k < order->len; k++)
      if (can_follow (banking, order, i, g_array_index (order, Object, k)))
        return TRUE;
  return FALSE;
}

static gboolean
has_tie (const Banking *banking)
{
  const GArray *order = banking->answer->objects;

  for (guint i = 1; i < order->len; i++)
    if (question_further (banking->occasion->trace,
                          banking->question->argument.number,
                          g_array_index (order, Object, i - 1).number,
                          g_array_index (order, Object, i).number)
        == 0)
      return TRUE;
  return FALSE;
}

static gboolean
is_ambiguous (const Banking *banking)
{
  switch (banking->question->order) {
  case ORDER_OF_SITES:
    return has_other_order (banking);
  case ORDER_OF_OUTSIDE_SET:
    return has_tie (banking);
  case ORDER_OF_PHASES:
    break;
  }
  return FALSE;
}

/* Of two things the orders themselves are chosen from. */
static void
bank_pair (Banking *banking)
{
  BankItem *item = add_item (banking, BANK_ONE);

  for (guint i = 0; i < 2; i++) {
    BankOption *option = g_new0 (BankOption, 1);
    g_autofree char *first = question_item_text (
        banking->question, g_array_index (banking->answer->objects, Object, i));
    g_autofree char *second = question_item_text (
        banking->question,
        g_array_index (banking->answer->objects, Object, 1 - i));

    option->text = g_strdup_printf (_ ("%s, then %s"), first, second);
    option->is_right = i == 0;
    g_ptr_array_add (item->options, option);
  }
}

static void
bank_order (Banking *banking)
{
  const GArray *order = banking->answer->objects;
  BankItem *item;

  if (order->len > BANK_MAX_OPTIONS) {
    leave_out (banking, _ ("%u things to choose from are too many"),
               order->len);
    return;
  }
  if (is_ambiguous (banking)) {
    leave_out (banking, _ ("more than one order is right"));
    return;
  }
  if (order->len == 2) {
    bank_pair (banking);
    return;
  }
  item = add_item (banking, BANK_ORDER);
  for (guint i = 0; i < order->len; i++) {
    BankOption *option = g_new0 (BankOption, 1);

    option->text = question_item_text (banking->question,
                                       g_array_index (order, Object, i));
    option->is_right = TRUE;
    g_ptr_array_add (item->options, option);
  }
}

/* Laws: yes or no */

static void
bank_always (Banking *banking)
{
  BankItem *item = add_item (banking, BANK_ONE);

  for (guint i = 0; i < 2; i++) {
    const Object object = { OBJECT_NONE, i };

    add_option (banking, item, object,
                question_item_text (banking->question, object));
  }
}

static void
bank_drag (Banking *banking)
{
  leave_out (banking, _ ("it is answered by dragging a site"));
}

static void
bank_perform (Banking *banking)
{
  leave_out (banking, _ ("it is performed in the pictures"));
}

static void
bank_question (Banking *banking)
{
  static void (*const bank[]) (Banking * banking) = {
    [QUESTION_CHOOSE] = bank_choose,   [QUESTION_NUMBERS] = bank_numbers,
    [QUESTION_CLICK] = bank_click,     [QUESTION_ORDER] = bank_order,
    [QUESTION_DRAG] = bank_drag,       [QUESTION_ALWAYS] = bank_always,
    [QUESTION_PERFORM] = bank_perform,
  };
  const guint n_sites = banking->occasion->trace->set->n_sites;

  if (banking->question->kind != QUESTION_DRAG && n_sites > BANK_MAX_SITES) {
    leave_out (banking, _ ("%u sites are too many to be read"), n_sites);
    return;
  }
  if (banking->question->kind != QUESTION_DRAG)
    banking->answer = answer_new (banking->question, banking->occasion);
  bank[banking->question->kind](banking);
  g_clear_pointer (&banking->answer, answer_free);
}

void
question_bank_add (QuestionBank *bank, const Lesson *lesson)
{
  bank->n_lessons += 1;
  for (guint i = 0; i < lesson->stops->len; i++) {
    const LessonStop *stop = lesson_stop (lesson, i);

    if (stop->question != NULL && stop->ask_state != NULL)
      bank_question (&(Banking){ .bank = bank,
                                 .lesson = lesson,
                                 .stop = i,
                                 .question = stop->question,
                                 .occasion = &stop->occasion });
  }
}
