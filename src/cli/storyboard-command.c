#include "cli.h"
#include "document.h"
#include "storyboard.h"

#include <glib/gi18n.h>

static CliStatus
write_storyboard (Session *session, const char *path)
{
  GError *error = NULL;
  CliOutput output;

  cli_output_begin (&output);
  if (storyboard_write (session, output.file, &error))
    return cli_output_end (&output, path);
  cli_output_drop (&output);
  cli_say ("%s: %s", path, error->message);
  g_error_free (error);
  return CLI_CANNOT_WRITE;
}

CliStatus
cli_storyboard (const CliCommand *command, int argc, char **argv)
{
  g_autoptr (Session) session = session_new ();
  g_autofree char *path = NULL;
  g_auto (GStrv) paths = NULL;
  GError *error = NULL;
  const GOptionEntry options[] = { { "output", 'o', 0, G_OPTION_ARG_FILENAME,
                                     &path, N_ ("the PDF file"), "FILE.pdf" },
                                   G_OPTION_ENTRY_NULL };

  if (!cli_parse (command, options, (CliCount){ 1, 1 }, argc, argv, &paths))
    return CLI_USAGE;
  if (path == NULL)
    return cli_usage (command, _ ("which file to write? -o FILE.pdf"));
  if (!document_open (session, paths[0], &error))
    return cli_fail (error);
  return write_storyboard (session, path);
}
