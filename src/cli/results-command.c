#include "cli.h"
#include "results.h"

#include <glib/gi18n.h>
#include <stdio.h>

static CliStatus
status_of (const GError *error)
{
  return error->code == PROGRESS_ERROR_MISSING
                 || error->code == PROGRESS_ERROR_CANNOT_OPEN
             ? CLI_CANNOT_OPEN
             : CLI_REFUSED;
}

static CliStatus
write_results (const Progress *progress,
               gboolean is_csv,
               const char *name,
               const char *path)
{
  g_autofree char *text
      = (is_csv ? results_csv : results_xapi) (progress, name);
  CliOutput output;

  cli_output_begin (&output);
  fputs (text, output.file);
  return cli_output_end (&output, path);
}

CliStatus
cli_results (const CliCommand *command, int argc, char **argv)
{
  g_autofree char *path = NULL, *format = NULL, *name = NULL;
  g_autofree char *usual = progress_default_path ();
  g_auto (GStrv) paths = NULL;
  g_autoptr (Progress) progress = NULL;
  g_autoptr (GError) error = NULL;
  const GOptionEntry options[]
      = { { "format", 'f', 0, G_OPTION_ARG_STRING, &format,
            N_ ("csv: a table (the default); xapi: statements"), "csv|xapi" },
          { "name", 'n', 0, G_OPTION_ARG_STRING, &name,
            N_ ("name of the person in the output; random by default"),
            "NAME" },
          { "output", 'o', 0, G_OPTION_ARG_FILENAME, &path,
            N_ ("write to FILE instead of standard output"), "FILE" },
          G_OPTION_ENTRY_NULL };

  if (!cli_parse (command, options, (CliCount){ 0, 1 }, argc, argv, &paths))
    return CLI_USAGE;
  if (format != NULL && !g_str_equal (format, "csv")
      && !g_str_equal (format, "xapi"))
    return cli_usage (command, _ ("--format must be csv or xapi"));
  progress = progress_new (paths[0] != NULL ? paths[0] : usual);
  if (!progress_read (progress, &error)) {
    cli_say ("%s", error->message);
    return status_of (error);
  }
  return write_results (progress, g_strcmp0 (format, "xapi") != 0, name, path);
}
