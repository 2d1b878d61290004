#include "cli.h"
#include "document.h"
#include "storyboard.h"

#include <glib/gi18n.h>

typedef struct Options {
  char *output;
  CliLook look;
  Appearance appearance;
  char **paths;
} Options;

static void
options_clear (Options *options)
{
  g_free (options->output);
  cli_look_clear (&options->look);
  g_strfreev (options->paths);
}

static gboolean
options_parse (Options *options,
               const CliCommand *command,
               int argc,
               char **argv)
{
  Camera camera;
  guint layers = 0;
  const GOptionEntry entries[]
      = { { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options->output,
            N_ ("write to this PDF file"), "FILE.pdf" },
          CLI_APPEARANCE_ENTRIES (&options->look),
          G_OPTION_ENTRY_NULL };

  if (!cli_parse (command, entries, (CliCount){ 1, 1 }, argc, argv,
                  &options->paths))
    return FALSE;
  if (!cli_pdf (command, options->output))
    return FALSE;
  appearance_init (&options->appearance);
  return cli_look (command, &options->look, &options->appearance, &layers,
                   &camera);
}

static CliStatus
write_storyboard (Session *session, const Options *options)
{
  GError *error = NULL;
  CliOutput output;

  cli_output_begin (&output);
  return storyboard_write (session, &options->appearance, output.file, NULL,
                           &error)
             ? cli_output_end (&output, options->output)
             : cli_output_fail (&output, options->output, error);
}

CliStatus
cli_storyboard (const CliCommand *command, int argc, char **argv)
{
  g_autoptr (Session) session = session_new ();
  Options options = { .output = NULL };
  CliStatus status = CLI_USAGE;
  GError *error = NULL;

  if (options_parse (&options, command, argc, argv))
    status = document_open (session, options.paths[0], &error)
                 ? write_storyboard (session, &options)
                 : cli_fail (error);
  options_clear (&options);
  return status;
}
