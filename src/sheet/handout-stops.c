/* The stops of a lesson: pictures, line of the code and sentence on the left,
 * what is to be read and answered on the right. */
#include "handout-private.h"

#include "block-prose.h"
#include "form.h"
#include "handout-notes.h"
#include "stop-state.h"
#include "timetable.h"

#include <glib/gi18n.h>

/* Of the width, for the pictures. */
#define PICTURE_PART 0.56
#define WIDE_PART 0.84 /* of one to be marked */
#define TIME_WIDTH 70.0

/* Room for a sentence that a learner finds. */
#define SENTENCE_LINES 2

/* What answers earlier questions */

/* Whether it asks for what its round is about to find. */
static gboolean
asks_for_round (const LessonStop *stop)
{
  return stop->question != NULL && stop->ask_state != NULL
         && stop->question->kind != QUESTION_DRAG
         && stop->question->kind != QUESTION_ALWAYS
         && stop->occasion.reveal > stop->occasion.step
         && occasion_round (&stop->occasion) != NULL;
}

/* Whether @stop shows what @asked asks: the same round, once its event has
 * happened. */
static gboolean
answers (const LessonStop *stop, const LessonStop *asked)
{
  const StopState *state = stop->state;

  return asks_for_round (asked) && state->run == asked->ask_state->run
         && state->exhibit_kind == EXHIBIT_LIFTS
         && state->step > asked->occasion.step
         && state->step <= occasion_round (&asked->occasion)->end;
}

static gboolean
answers_one_before (const Handout *handout, guint stop)
{
  for (guint i = 0; i < stop; i++)
    if (answers (lesson_stop (handout->lesson, stop),
                 lesson_stop (handout->lesson, i)))
      return TRUE;
  return FALSE;
}

/* What of a stop is printed */

typedef struct Print {
  Handout *handout;
  guint stop;
  Moment moment;
} Print;

static void
choose_face (Print *print)
{
  const Handout *handout = print->handout;
  Moment *moment = &print->moment;

  *moment
      = (Moment){ handout->session, print->stop, MOMENT_SHOWN, MOMENT_NONE };
  if (!handout->options.has_blanks)
    return;
  if (handout_asks (handout, print->stop))
    moment->face = MOMENT_ASKED;
  else if (answers_one_before (handout, print->stop))
    moment->face = MOMENT_MASKED;
}

/* Left */

static char *
code_line (Session *session)
{
  guint n_lines;
  const PseudocodeLine *lines = session_get_lines (session, &n_lines);
  const guint line
      = session_is_asking (session) ? INDEX_NONE : session_get_line (session);

  return line >= n_lines
             ? NULL
             : g_strdup_printf ("%u  %s", line + 1, _ (lines[line].text));
}

/* What each pane shows, where that is not the plane and space. */
static Block *
pane_titles (const Handout *handout, double width)
{
  Session *session = handout->session;
  const double column = (width - COLUMN_GAP) / 2;
  Block *columns;

  if (session_get_exhibit_kind (session) == EXHIBIT_LIFTS)
    return NULL;
  columns = block_columns (COLUMN_GAP);
  for (guint pane = 0; pane < N_PANES; pane++) {
    g_autofree char *title = session_get_pane_title (session, pane);

    if (session_get_pane (session, pane) != PANE_NONE)
      block_add (columns, handout_words (handout, TEXT_SMALL, column, title));
  }
  return columns;
}

static gboolean
is_as_before (const Print *print)
{
  const LessonStop *before, *stop;

  if (print->stop == 0 || print->moment.face != MOMENT_SHOWN)
    return FALSE;
  stop = lesson_stop (print->handout->lesson, print->stop);
  before = lesson_stop (print->handout->lesson, print->stop - 1);
  return stop->question == NULL && before->state->run == stop->state->run
         && before->state->step == stop->state->step
         && before->state->exhibit_kind == stop->state->exhibit_kind
         && before->state->exhibit_step == stop->state->exhibit_step
         && before->state->listing == stop->state->listing;
}

/* The line of the code and the sentence: what has just happened. */
static void
add_event (const Print *print, Block *stack, double width)
{
  const Handout *handout = print->handout;
  g_autofree char *code = code_line (handout->session);
  g_autofree char *sentence = session_narrate (handout->session);
  g_autofree char *italic = g_markup_printf_escaped ("<i>%s</i>", sentence);

  if (print->moment.face == MOMENT_ASKED || is_as_before (print))
    return;
  if (code != NULL)
    block_add_below (stack, handout_words (handout, TEXT_CODE, width, code),
                     PART_GAP);
  if (print->moment.face == MOMENT_MASKED)
    block_add_below (stack, form_lines (width, SENTENCE_LINES), 0);
  else
    block_add_below (stack,
                     block_text (&handout->press, TEXT_SMALL, width, italic),
                     code != NULL ? 2 : PART_GAP);
}

/* A listing is printed where it comes up. */
static Block *
new_listing (Handout *handout, double width)
{
  const Listing listing = session_get_listing (handout->session);
  const gboolean is_new = listing != handout->listing;

  handout->listing = listing;
  return is_new ? handout_listing (handout, width) : NULL;
}

static Block *
left_column (const Print *print, double width)
{
  Handout *handout = print->handout;
  Block *stack = block_stack (width);
  Block *titles = pane_titles (handout, width);
  Block *listing = new_listing (handout, width);

  block_add (stack, moment_block (&print->moment, MOMENT_VIEWS,
                                  &handout->options.appearance, width,
                                  width / PICTURE_RATIO));
  if (titles != NULL)
    block_add_below (stack, titles, 3);
  add_event (print, stack, width);
  if (listing != NULL)
    block_add_below (stack, listing, PART_GAP);
  return stack;
}

/* Right */

static void
add_prose (const Handout *handout, guint stop, Block *stack)
{
  const char *prose = lesson_stop (handout->lesson, stop)->prose;
  Block *block;

  if (prose == NULL)
    return;
  block = block_prose (&handout->press, TEXT_BODY, stack->width, prose);
  if (block->parts->len > 0)
    block_add (stack, block);
  else
    block_free (block);
}

static Block *
right_column (const Print *print, double width)
{
  const Handout *handout = print->handout;
  Block *stack = block_stack (width);

  add_prose (handout, print->stop, stack);
  if (handout_asks (handout, print->stop))
    block_add_below (stack,
                     handout_question (handout, print->stop, width,
                                       print->moment.face != MOMENT_ASKED),
                     PART_GAP);
  return stack;
}

/* Whole */

static Block *
heading (const Handout *handout, guint stop)
{
  const char *title = lesson_stop (handout->lesson, stop)->title;
  g_autofree char *time = handout->options.has_notes
                              ? timetable_text (handout->lesson, stop)
                              : g_strdup ("");
  g_autofree char *numbered = g_strdup_printf ("%u  %s", stop + 1, title);
  Block *columns = block_columns (0);
  Block *words = handout_words (handout, TEXT_HEADING,
                                handout->width - TIME_WIDTH, numbered);
  Block *minutes = handout_words (handout, TEXT_SMALL, TIME_WIDTH, time);

  words->tag = "H2";
  if (handout->options.has_key && handout_asks (handout, stop))
    words->link = handout_key_name (stop);
  pango_layout_set_alignment (minutes->layout, PANGO_ALIGN_RIGHT);
  block_add (columns, words);
  block_add (columns, minutes);
  columns->keeps = TRUE;
  return columns;
}

/* A question whose answer is a mark has a larger picture, below its words. */
static void
add_wide (const Print *print, Block *stack)
{
  const Handout *handout = print->handout;
  const double width = WIDE_PART * handout->width;
  Block *words = right_column (print, handout->width);

  words->keeps = TRUE;
  block_add_below (stack, words, PART_GAP);
  block_add_below (stack,
                   handout_picture (handout, print->stop, MOMENT_ASKED, width),
                   PART_GAP);
}

static void
add_narrow (const Print *print, Block *stack)
{
  const double left = PICTURE_PART * print->handout->width;
  const double right = print->handout->width - COLUMN_GAP - left;
  Block *columns = block_columns (COLUMN_GAP);

  block_add (columns, left_column (print, left));
  block_add (columns, right_column (print, right));
  block_add_below (stack, columns, PART_GAP);
}

static void
add_stop (Handout *handout, guint stop)
{
  const LessonStop *row = lesson_stop (handout->lesson, stop);
  Print print = { .handout = handout, .stop = stop };
  Block *stack = block_stack (handout->width);
  Block *note = NULL;

  choose_face (&print);
  moment_enter (&print.moment);
  handout_tell_of (handout, handout->session, print.moment.face, MOMENT_VIEWS);
  stack->tag = "Sect";
  stack->title = g_strdup (row->title);
  stack->level = 2;
  stack->name = handout_stop_name (stop);
  block_add (stack, heading (handout, stop));
  if (print.moment.face == MOMENT_ASKED
      && handout_marks_picture (handout, stop))
    add_wide (&print, stack);
  else
    add_narrow (&print, stack);
  if (handout->options.has_notes)
    note = handout_note (handout, row->note, row->question);
  if (note != NULL)
    block_add_below (stack, note, PART_GAP);
  pages_add (handout->pages, stack, STOP_GAP);
}

void
handout_add_stops (Handout *handout)
{
  if (handout->options.has_notes)
    handout_add_timetable (handout);
  for (guint i = 0; i < handout->lesson->stops->len; i++)
    add_stop (handout, i);
  handout->has_part = TRUE;
}
