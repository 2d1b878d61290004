/* What a stop asks, with room for the answer; the listing it may be about. */
#include "handout-private.h"

#include "block-prose.h"
#include "form.h"
#include "handout-answer.h"
#include "handout-perform.h"

#include <glib/gi18n.h>

#define FIELD_HEIGHT 90.0
#define CODE_BLANKS 2 /* for each level of a listing */
#define ROW_GAP 4.0

static const LessonStop *
get_stop (const Handout *handout, guint stop)
{
  return lesson_stop (handout->lesson, stop);
}

gboolean
handout_asks (const Handout *handout, guint stop)
{
  const LessonStop *row = get_stop (handout, stop);

  return row->question != NULL && row->ask_state != NULL;
}

gboolean
handout_marks_picture (const Handout *handout, guint stop)
{
  const LessonStop *row = get_stop (handout, stop);

  return handout_asks (handout, stop)
         && (row->question->kind == QUESTION_CLICK
             || row->question->kind == QUESTION_DRAG);
}

/* Room for answers */

typedef struct Room {
  const Handout *handout;
  const LessonStop *stop;
  Block *stack;
} Room;

static void
add_small (const Room *room, const char *words)
{
  g_autofree char *italic = g_markup_printf_escaped ("<i>%s</i>", words);

  block_add_below (room->stack,
                   block_text (&room->handout->press, TEXT_SMALL,
                               room->stack->width, italic),
                   ROW_GAP);
}

static void
add_choice (const Room *room, Object item, FormMark mark)
{
  g_autofree char *text = question_item_text (room->stop->question, item);
  g_autofree char *markup = g_markup_escape_text (text, -1);

  block_add_below (
      room->stack,
      form_choice (&room->handout->press, room->stack->width, markup, mark),
      mark == FORM_ROOMY ? 2 * ROW_GAP : ROW_GAP);
}

static void
add_options (const Room *room)
{
  const Question *question = room->stop->question;

  add_small (room, question->is_several ? _ ("Tick all that are right.")
                                        : _ ("Tick one."));
  for (guint i = 0; i < question->options->len; i++)
    add_choice (room, (Object){ OBJECT_NONE, i }, FORM_EMPTY);
  block_add_below (
      room->stack,
      form_entry (&room->handout->press, room->stack->width, _ ("Why?")),
      PART_GAP);
  block_add (room->stack, form_lines (room->stack->width, 1));
}

static void
add_numbers (const Room *room)
{
  const GArray *quantities = room->stop->question->quantities;

  for (guint i = 0; i < quantities->len; i++) {
    const char *label
        = quantity_label (g_array_index (quantities, Quantity, i));

    block_add_below (
        room->stack,
        form_number (&room->handout->press, room->stack->width, label, NULL),
        2 * ROW_GAP);
  }
}

static void
add_marks (const Room *room)
{
  add_small (room, _ ("Mark them in the picture, and write their names."));
  block_add (room->stack, form_lines (room->stack->width, 1));
}

static void
add_order (const Room *room)
{
  g_autoptr (GArray) items
      = question_items (room->stop->question, &room->stop->occasion);

  add_small (room, _ ("Number them."));
  for (guint i = 0; i < items->len; i++)
    add_choice (room, g_array_index (items, Object, i), FORM_ROOMY);
}

static void
add_drag (const Room *room)
{
  g_autofree char *words
      = g_strdup_printf (_ ("Mark in the picture where s%u has to go."),
                         room->stop->question->site);

  add_small (room, words);
}

static void
add_always (const Room *room)
{
  for (guint i = 0; i < 2; i++)
    add_choice (room, (Object){ OBJECT_NONE, i }, FORM_EMPTY);
  add_small (room, _ ("If it is not true: draw sites for which it fails."));
  block_add_below (room->stack, form_field (room->stack->width, FIELD_HEIGHT),
                   ROW_GAP);
}

static void
add_room (const Room *room)
{
  switch (room->stop->question->kind) {
  case QUESTION_CHOOSE:
    add_options (room);
    break;
  case QUESTION_NUMBERS:
    add_numbers (room);
    break;
  case QUESTION_CLICK:
    add_marks (room);
    break;
  case QUESTION_ORDER:
    add_order (room);
    break;
  case QUESTION_DRAG:
    add_drag (room);
    break;
  case QUESTION_ALWAYS:
    add_always (room);
    break;
  case QUESTION_PERFORM:
    handout_add_tasks (room->handout, room->stop, room->stack);
    break;
  }
}

/* Options are printed with the answer, which crosses some of them. */
Block *
handout_question (const Handout *handout,
                  guint stop,
                  double width,
                  gboolean is_answered)
{
  const LessonStop *row = get_stop (handout, stop);
  const Room room = { handout, row, block_stack (width) };
  g_autofree char *prompt = question_prompt (row->question, &row->occasion);

  block_add (room.stack,
             block_prose (&handout->press, TEXT_BODY, width, prompt));
  if (is_answered)
    handout_add_answer (handout, stop, room.stack);
  else
    add_room (&room);
  return room.stack;
}

/* Listings */

/* Lines as one text, so that all are of one size; blanks stand for levels. */
static char *
listing_markup (Session *session)
{
  guint n_lines;
  const PseudocodeLine *lines = session_get_lines (session, &n_lines);
  GString *text = g_string_new (NULL);

  for (guint i = 0; i < n_lines; i++) {
    g_autofree char *words = g_markup_escape_text (_ (lines[i].text), -1);

    g_string_append_printf (text, "%s%*s%s", i == 0 ? "" : "\n",
                            CODE_BLANKS * lines[i].indent, "", words);
  }
  return g_string_free (text, FALSE);
}

Block *
handout_listing (const Handout *handout, double width)
{
  Session *session = handout->session;
  g_autofree char *markup = NULL;
  Block *frame;

  if (session_get_listing (session) == LISTING_QUICKHULL
      || session_get_exhibit_kind (session) != EXHIBIT_LIFTS)
    return NULL;
  markup = listing_markup (session);
  frame = block_frame (width, PART_GAP);
  block_add (frame,
             handout_words (handout, TEXT_LABEL, block_inner_width (frame),
                            _ (session_get_listing_title (session))));
  block_add_below (
      frame, block_code (&handout->press, block_inner_width (frame), markup),
      3);
  return frame;
}
