#include "cli.h"
#include "lint.h"

static void
say_all (const GPtrArray *lines)
{
  for (guint i = 0; i < lines->len; i++)
    cli_say ("%s", (const char *)g_ptr_array_index (lines, i));
}

CliStatus
cli_lint (const CliCommand *command, int argc, char **argv)
{
  g_autoptr (Lint) lint = lint_new ();
  g_auto (GStrv) paths = NULL;

  if (!cli_parse (command, NULL, (CliCount){ 1, G_MAXUINT }, argc, argv,
                  &paths))
    return CLI_USAGE;
  for (guint i = 0; paths[i] != NULL; i++)
    lint_add (lint, paths[i]);
  lint_end (lint);
  say_all (lint->errors);
  say_all (lint->warnings);
  if (lint->is_missing)
    return CLI_CANNOT_OPEN;
  return lint->errors->len > 0 ? CLI_BROKEN : CLI_DONE;
}
