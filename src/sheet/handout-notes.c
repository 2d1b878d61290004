#include "handout-notes.h"

#include "block-prose.h"
#include "prose.h"
#include "timetable.h"

#include <glib/gi18n.h>

#define PADDING 6.0
#define TIME_COLUMN 66.0

/* Notes */

/* A labelled text in a frame. */
static void
add_labelled (const Handout *handout,
              Block *frame,
              const char *label,
              const char *commonmark)
{
  const double width = block_inner_width (frame);
  Block *words = handout_words (handout, TEXT_LABEL, width, label);

  words->keeps = TRUE;
  block_add_below (frame, words, PADDING);
  block_add_below (
      frame, block_prose (&handout->press, TEXT_SMALL, width, commonmark), 2);
}

static char *
hints_of (const Question *question)
{
  GString *hints = g_string_new (NULL);

  for (guint i = 0; i < question->hints->len; i++)
    g_string_append_printf (
        hints, "- %s\n", (const char *)g_ptr_array_index (question->hints, i));
  return g_string_free (hints, FALSE);
}

Block *
handout_note (const Handout *handout,
              const char *note,
              const Question *question)
{
  Block *frame = block_frame (handout->width, PADDING);

  if (note != NULL) {
    g_autofree char *words = prose_capitalize (note);

    add_labelled (handout, frame, _ ("For the lecturer"), words);
  }
  if (question != NULL && question->hints->len > 0) {
    g_autofree char *hints = hints_of (question);

    add_labelled (handout, frame, _ ("Hints"), hints);
  }
  if (frame->parts->len > 0)
    return frame;
  block_free (frame);
  return NULL;
}

static Block *
timetable_row (const Handout *handout, guint stop, double width)
{
  const LessonStop *row = lesson_stop (handout->lesson, stop);
  g_autofree char *time = timetable_text (handout->lesson, stop);
  g_autofree char *title = g_strdup_printf (
      "%u  %s%s", stop + 1, row->title, row->question != NULL ? " (?)" : "");
  Block *columns = block_columns (0);

  block_add (columns, handout_words (handout, TEXT_SMALL, TIME_COLUMN, time));
  block_add (columns,
             handout_words (handout, TEXT_SMALL, width - TIME_COLUMN, title));
  columns->link = handout_stop_name (stop);
  return columns;
}

/* Two columns, read downwards. */
static Block *
timetable (const Handout *handout, double width)
{
  const guint n = handout->lesson->stops->len;
  const guint half = (n + 1) / 2;
  const double column = (width - COLUMN_GAP) / 2;
  Block *columns = block_columns (COLUMN_GAP);

  for (guint side = 0; side < 2; side++) {
    Block *stack = block_stack (column);

    for (guint i = side * half; i < MIN ((side + 1) * half, n); i++)
      block_add_below (stack, timetable_row (handout, i, column), 2);
    block_add (columns, stack);
  }
  return columns;
}

void
handout_add_timetable (Handout *handout)
{
  const Lesson *lesson = handout->lesson;
  Block *note = handout_note (handout, lesson->note, NULL);

  if (note != NULL)
    pages_add (handout->pages, note, 10);
  if (lesson->minutes > 0) {
    Block *stack = block_stack (handout->width);

    block_add (stack, handout_words (handout, TEXT_LABEL, handout->width,
                                     _ ("Timetable; (?) asks a question")));
    block_add_below (stack, timetable (handout, handout->width), 4);
    pages_add (handout->pages, stack, 12);
  }
}
