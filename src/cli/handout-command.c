#include "cli.h"
#include "handout.h"

#include <glib/gi18n.h>

typedef struct Options {
  gboolean is_full;
  HandoutOptions handout;
  char *paper, *output;
  CliLook look;
  char **paths;
} Options;

static void
options_clear (Options *options)
{
  g_free (options->paper);
  g_free (options->output);
  cli_look_clear (&options->look);
  g_strfreev (options->paths);
}

static gboolean
parse_paper (const CliCommand *command, Options *options)
{
  g_autofree char *list = g_strjoinv (", ", (char **)paper_names ());

  if (options->paper == NULL)
    return TRUE;
  options->handout.paper = paper_find (options->paper);
  if (options->handout.paper == NULL)
    cli_usage (command, _ ("there is no paper “%s”; the papers are %s"),
               options->paper, list);
  return options->handout.paper != NULL;
}

/* Layers and camera are the lesson's. */
static gboolean
parse_look (const CliCommand *command, Options *options)
{
  Camera camera;
  guint layers = 0;

  return cli_look (command, &options->look, &options->handout.appearance,
                   &layers, &camera);
}

static gboolean
options_parse (Options *options,
               const CliCommand *command,
               int argc,
               char **argv)
{
#define FLAG(name, field, sentence)                                            \
  {                                                                            \
    name, 0, 0, G_OPTION_ARG_NONE, &options->field, sentence, NULL             \
  }
  const GOptionEntry entries[] = {
    FLAG ("full", is_full, N_ ("every stop, instead of one page")),
    FLAG ("steps", handout.has_steps, N_ ("four panels for each insertion")),
    FLAG ("notes", handout.has_notes,
          N_ ("every stop, with notes and timetable for the lecturer")),
    FLAG ("blanks", handout.has_blanks,
          N_ ("every stop, with room to answer its question")),
    FLAG ("key", handout.has_key, N_ ("the answers, and why they are right")),
    { "paper", 0, 0, G_OPTION_ARG_STRING, &options->paper, N_ ("a4 or letter"),
      "PAPER" },
    CLI_APPEARANCE_ENTRIES (&options->look),
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options->output,
      N_ ("write to this PDF file"), "FILE.pdf" },
    G_OPTION_ENTRY_NULL
  };
#undef FLAG

  handout_options_init (&options->handout);
  if (!cli_parse (command, entries, (CliCount){ 1, 1 }, argc, argv,
                  &options->paths))
    return FALSE;
  options->handout.has_stops = options->is_full || options->handout.has_notes
                               || options->handout.has_blanks;
  return cli_pdf (command, options->output) && parse_paper (command, options)
         && parse_look (command, options);
}

static CliStatus
write_handout (Session *session, const Options *options)
{
  g_autoptr (Handout) handout = handout_new (session, &options->handout);
  GError *error = NULL;
  CliOutput output;

  cli_output_begin (&output);
  return handout_write (handout, output.file, NULL, &error)
             ? cli_output_end (&output, options->output)
             : cli_output_fail (&output, options->output, error);
}

CliStatus
cli_handout (const CliCommand *command, int argc, char **argv)
{
  g_autoptr (Session) session = session_new ();
  Options options = { .is_full = FALSE };
  CliStatus status = CLI_USAGE;
  GError *error = NULL;

  if (options_parse (&options, command, argc, argv)) {
    if (!cli_open_lesson (session, options.paths[0], &error)) {
      status = cli_fail (error);
    } else if (session_get_lesson (session) == NULL) {
      cli_say (_ ("%s: a handout needs a lesson, not points"),
               options.paths[0]);
      status = CLI_REFUSED;
    } else {
      status = write_handout (session, &options);
    }
  }
  options_clear (&options);
  return status;
}
