#include "lesson-block.h"

#include "command.h"

#include <glib/gi18n.h>

void
lesson_command_free (gpointer data)
{
  LessonCommand *command = data;

  g_free (command->text);
  g_free (command->verb);
  g_clear_pointer (&command->parameter, g_variant_unref);
  g_free (command);
}

static gboolean
read_command (const LessonSource *source,
              const LessonLine *line,
              GPtrArray *commands,
              GError **error)
{
  LessonCommand *command = g_new0 (LessonCommand, 1);
  g_autoptr (GError) reason = NULL;

  command->line = line->line;
  command->column = line->column;
  command->text = g_strdup (line->text);
  if (command_parse (line->text, &command->verb, &command->parameter,
                     &reason)) {
    g_ptr_array_add (commands, command);
    return TRUE;
  }
  lesson_command_free (command);
  return lesson_line_blame (line, source, line->text, reason->message, error);
}

void
lesson_block_read_steps (const LessonSource *source,
                         const LessonLines *lines,
                         guint *n_commands,
                         GPtrArray *commands,
                         LessonFaults *faults)
{
  for (guint number = lines->first;
       number <= lines->last && !lesson_faults_is_full (faults); number++) {
    GError *error = NULL;
    LessonLine line;

    lesson_line_init (&line, source, number);
    if (line.text[0] != '\0') {
      *n_commands += 1;
      if (*n_commands <= LESSON_MAX_COMMANDS)
        read_command (source, &line, commands, &error);
      else if (*n_commands == LESSON_MAX_COMMANDS + 1)
        lesson_line_blame (&line, source, line.text,
                           _ ("more than 100000 commands"), &error);
    }
    if (error != NULL)
      lesson_faults_take (faults, error);
    lesson_line_clear (&line);
  }
}
