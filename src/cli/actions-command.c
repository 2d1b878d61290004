#include "action.h"
#include "cli.h"

#include <glib/gi18n.h>

static const char *
where_of (const Action *action)
{
  if (action->where == (ACTION_IN_LESSON | ACTION_IN_WINDOW))
    return "lesson,window";
  return action->where == ACTION_IN_LESSON ? "lesson" : "window";
}

/* Five columns apart by tabs: name, parameter, state, where, sentence; "-"
 * for none. */
static void
write_actions (FILE *file)
{
  guint n_actions;
  const Action *table = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++)
    fprintf (file, "%s\t%s\t%s\t%s\t%s\n", table[i].name,
             table[i].parameter == NULL ? "-" : table[i].parameter,
             table[i].state == NULL ? "-" : table[i].state,
             where_of (&table[i]), _ (table[i].sentence));
}

CliStatus
cli_actions (const CliCommand *command, int argc, char **argv)
{
  g_auto (GStrv) paths = NULL;
  CliOutput output;

  if (!cli_parse (command, NULL, (CliCount){ 0, 0 }, argc, argv, &paths))
    return CLI_USAGE;
  cli_output_begin (&output);
  write_actions (output.file);
  return cli_output_end (&output, NULL);
}
