#include "handout-answer.h"

#include "form.h"
#include "handout-perform.h"
#include "number.h"
#include "question-bank.h"

#include <glib/gi18n.h>

#define ROW_GAP 4.0

/* Of very many objects a page gives the reason of some. */
#define MOST_REASONS 8

typedef struct Key {
  const Handout *handout;
  const LessonStop *stop;
  const Answer *answer;
  Block *stack;
} Key;

static gboolean
is_right (const Answer *answer, Object object)
{
  for (guint i = 0; i < answer->objects->len; i++)
    if (object_equal (g_array_index (answer->objects, Object, i), object))
      return TRUE;
  return FALSE;
}

static void
add_line (const Key *key, TextStyle style, const char *markup, double above)
{
  block_add_below (
      key->stack,
      block_text (&key->handout->press, style, key->stack->width, markup),
      above);
}

static void
add_told (const Key *key, const char *words)
{
  g_autofree char *markup
      /* Translators: before the answer to a question, on paper. */
      = g_markup_printf_escaped ("<b>%s</b> %s", _ ("Answer:"), words);

  add_line (key, TEXT_BODY, markup, ROW_GAP);
}

/* What is right */

static void
add_choices (const Key *key, guint n)
{
  for (guint i = 0; i < n; i++) {
    const Object item = { OBJECT_NONE, i };
    g_autofree char *text = question_item_text (key->stop->question, item);
    g_autofree char *markup = g_markup_escape_text (text, -1);

    block_add_below (
        key->stack,
        form_choice (&key->handout->press, key->stack->width, markup,
                     is_right (key->answer, item) ? FORM_CROSSED : FORM_EMPTY),
        ROW_GAP);
  }
}

static void
add_numbers (const Key *key)
{
  const GArray *quantities = key->stop->question->quantities;

  for (guint i = 0; i < quantities->len; i++) {
    const char *label
        = quantity_label (g_array_index (quantities, Quantity, i));
    g_autofree char *value = g_strdup_printf (
        "%" G_GINT64_FORMAT, g_array_index (key->answer->numbers, gint64, i));

    block_add_below (
        key->stack,
        form_number (&key->handout->press, key->stack->width, label, value),
        ROW_GAP);
  }
}

/* Objects by the sites that make them, what is put in order by its name. */
static char *
name_of (const Key *key, const Frame *frame, Object object)
{
  return key->stop->question->kind == QUESTION_CLICK
             ? question_object_text (key->stop->question, frame, object)
             : question_item_text (key->stop->question, object);
}

static void
add_objects (const Key *key, const char *between)
{
  const GArray *objects = key->answer->objects;
  g_autoptr (GString) names = g_string_new (NULL);
  Frame frame;

  frame_init (&frame, key->stop->occasion.trace, key->stop->occasion.step);
  for (guint i = 0; i < objects->len; i++) {
    g_autofree char *name
        = name_of (key, &frame, g_array_index (objects, Object, i));

    g_string_append_printf (names, "%s%s", i == 0 ? "" : between, name);
  }
  frame_clear (&frame);
  add_told (key, names->str);
}

/* Sites that show it: the picture has them. */
static void
add_sites (const Key *key)
{
  const guint site = key->stop->question->site;
  char x[NUMBER_ROOM], y[NUMBER_ROOM];
  g_autofree char *words = NULL;

  if (!key->answer->is_found)
    return;
  number_write (key->answer->sites[site].x, x);
  number_write (key->answer->sites[site].y, y);
  words = g_strdup_printf (_ ("for example s%u at (%s, %s), as shown"), site, x,
                           y);
  add_told (key, words);
}

static void
add_right (const Key *key)
{
  switch (key->stop->question->kind) {
  case QUESTION_CHOOSE:
    add_choices (key, key->stop->question->options->len);
    break;
  case QUESTION_NUMBERS:
    add_numbers (key);
    break;
  case QUESTION_CLICK:
    /* Translators: between objects of which each is a right answer. */
    add_objects (key, key->answer->is_any ? _ (" or ") : ", ");
    break;
  case QUESTION_ORDER:
    add_objects (key, " → ");
    break;
  case QUESTION_DRAG:
    add_sites (key);
    break;
  case QUESTION_ALWAYS:
    add_choices (key, 2);
    break;
  case QUESTION_PERFORM:
    handout_add_performance (key->handout, key->stop, key->stack);
    break;
  }
}

/* Why it is right */

/* An attempt whose grading says why: nothing answered, or the wrong word. */
static Attempt *
make_attempt (const Key *key)
{
  Attempt *attempt = attempt_new (key->stop->question);

  if (key->stop->question->kind == QUESTION_ALWAYS)
    attempt_toggle (attempt, key->stop->question,
                    (Object){ OBJECT_NONE, key->answer->is_found ? 0 : 1 });
  return attempt;
}

static void
add_reasons (const Key *key)
{
  const Question *question = key->stop->question;
  g_autoptr (Attempt) attempt = make_attempt (key);
  g_autoptr (Verdict) verdict
      = attempt_grade (attempt, question, &key->stop->occasion);
  const GPtrArray *reasons
      = question->kind == QUESTION_ALWAYS ? verdict->reasons : verdict->missed;
  const gboolean has_reasons = question->kind == QUESTION_CHOOSE
                               || question->kind == QUESTION_CLICK
                               || question->kind == QUESTION_ALWAYS;

  for (guint i = 0; has_reasons && i < MIN (reasons->len, MOST_REASONS); i++) {
    g_autofree char *markup
        = g_markup_escape_text (g_ptr_array_index (reasons, i), -1);

    add_line (key, TEXT_SMALL, markup, i == 0 ? ROW_GAP : 1);
  }
}

void
handout_add_answer (const Handout *handout, guint stop, Block *stack)
{
  const LessonStop *row = lesson_stop (handout->lesson, stop);
  g_autoptr (Answer) answer = answer_new (row->question, &row->occasion);
  const Key key = { handout, row, answer, stack };

  add_right (&key);
  add_reasons (&key);
}

/* The key */

static void
add_entry (Handout *handout, guint stop)
{
  const LessonStop *row = lesson_stop (handout->lesson, stop);
  const double left = (handout->width - COLUMN_GAP) / 2;
  g_autofree char *title = g_strdup_printf ("%u  %s", stop + 1, row->title);
  Block *stack = block_stack (handout->width);
  Block *heading = handout_words (handout, TEXT_HEADING, handout->width, title);
  Block *columns = block_columns (COLUMN_GAP);

  moment_enter (&(Moment){ handout->session, stop, MOMENT_SHOWN, MOMENT_NONE });
  handout_tell_of (handout, handout->session, MOMENT_SHOWN, MOMENT_VIEWS);
  stack->tag = "Sect";
  stack->title = g_strdup (row->title);
  stack->level = 2;
  stack->name = handout_key_name (stop);
  heading->tag = "H2";
  heading->keeps = TRUE;
  if (handout->options.has_stops)
    heading->link = handout_stop_name (stop);
  block_add (stack, heading);
  block_add (columns, handout_picture (handout, stop, MOMENT_SHOWN, left));
  block_add (columns, handout_question (handout, stop, left, TRUE));
  block_add_below (stack, columns, PART_GAP);
  pages_add (handout->pages, stack, STOP_GAP);
}

void
handout_add_key (Handout *handout)
{
  handout_add_part (handout, _ ("Answers"));
  for (guint i = 0; i < handout->lesson->stops->len; i++)
    if (handout_asks (handout, i))
      add_entry (handout, i);
}
