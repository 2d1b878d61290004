/* Rows of the action table: progress in lessons, results, and records. */
#include "action-private.h"

#include <glib/gi18n.h>

static const Action rows[] = {
  { .name = "resume",
    .sentence = N_ ("Resume the lesson where you left it"),
    .keys = "<Alt>Home",
    .where = ACTION_IN_WINDOW,
    .run = action_resume,
    .is_enabled = action_can_resume },
  { .name = "next-lesson",
    .sentence = N_ ("Open the next lesson"),
    .keys = "<Alt>Page_Down",
    .where = ACTION_IN_WINDOW,
    .is_enabled = action_has_lesson },
  { .name = "export-results",
    .sentence = N_ ("Save what you have answered"),
    .where = ACTION_IN_WINDOW,
    .is_enabled = action_has_progress },
  { .name = "clear-progress",
    .sentence = N_ ("Forget your progress in all lessons"),
    .where = ACTION_IN_WINDOW,
    .is_enabled = action_has_progress },
  { .name = "record",
    .state = "b",
    .sentence = N_ ("Record what you do as lesson text"),
    .keys = "<Primary>r",
    .where = ACTION_IN_WINDOW },
  { .name = "record-stop",
    .sentence = N_ ("Start a new stop in the recording"),
    .keys = "<Primary><Shift>r",
    .where = ACTION_IN_WINDOW },
  { .name = "record-copy",
    .sentence = N_ ("Copy the recording"),
    .where = ACTION_IN_WINDOW },
};

const ActionRows action_rows_progress = { rows, G_N_ELEMENTS (rows) };
