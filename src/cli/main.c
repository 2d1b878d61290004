/* hull2vd-cli COMMAND …: the program without a screen. */
#include "cli.h"
#include "config.h"
#include "locate.h"
#include "words.h"

#include <glib/gi18n.h>
#include <locale.h>
#include <signal.h>

static const CliCommand commands[] = {
  { "compute", "POINTS",
    N_ ("Write the hull, Delaunay triangulation and Voronoi diagram as JSON"),
    cli_compute },
  { "count", "POINTS", N_ ("Count what an order of insertion costs"),
    cli_count },
  { "trace", "POINTS", N_ ("Write what happens, one event per line"),
    cli_trace },
  { "replay", "LESSON…", N_ ("Play lessons and check what they expect"),
    cli_replay },
  { "lint", "LESSON…", N_ ("Report everything that is wrong with lessons"),
    cli_lint },
  { "export", "POINTS|LESSON", N_ ("Write a picture: SVG, PDF or PNG"),
    cli_export },
  { "storyboard", "POINTS|LESSON", N_ ("Write the stops of a lesson as PDF"),
    cli_storyboard },
  { "handout", "LESSON", N_ ("Write a handout of a lesson as PDF"),
    cli_handout },
  { "words", "LESSON…", N_ ("Write the translatable text of lessons"),
    cli_words },
  { "questions", "LESSON…",
    N_ ("Write the questions of lessons for Moodle (GIFT) or as QTI"),
    cli_questions },
  { "results", "[FILE]", N_ ("Write what a person has answered in lessons"),
    cli_results },
  { "actions", "", N_ ("List all actions by name"), cli_actions },
};

static void
print_usage (FILE *file)
{
  fprintf (file, "%s\n", _ ("usage: hull2vd-cli COMMAND [OPTION…] [FILE…]"));
}

static CliStatus
print_help (void)
{
  CliOutput output;

  cli_output_begin (&output);
  print_usage (output.file);
  fprintf (output.file, "\n");
  for (guint i = 0; i < G_N_ELEMENTS (commands); i++)
    fprintf (output.file, "  %-10s  %s\n", commands[i].name,
             _ (commands[i].sentence));
  fprintf (output.file, "\n%s\n%s\n",
           _ ("FILE “-” is standard input. hull2vd-cli COMMAND --help lists "
              "the options of a\ncommand."),
           _ ("Exit status: 0 done, 1 input refused or an expectation failed, "
              "2 broken lesson,\n64 usage error, 66 cannot open a file, 73 "
              "cannot write."));
  return cli_output_end (&output, NULL);
}

static CliStatus
print_version (void)
{
  CliOutput output;

  cli_output_begin (&output);
  fprintf (output.file, "hull2vd-cli %s\n", VERSION);
  return cli_output_end (&output, NULL);
}

static CliStatus
refuse_command (const char *name)
{
  const char *names[G_N_ELEMENTS (commands) + 1] = { NULL };
  g_autofree char *reason = NULL, *hint = NULL;

  if (name == NULL) {
    cli_say ("%s", _ ("hull2vd-cli: no command is given"));
  } else {
    for (guint i = 0; i < G_N_ELEMENTS (commands); i++)
      names[i] = commands[i].name;
    reason
        = g_strdup_printf (_ ("hull2vd-cli: there is no command “%s”"), name);
    hint = words_hint (name, names);
    cli_say ("%s%s", reason, hint);
  }
  print_usage (stderr);
  return CLI_USAGE;
}

int
main (int argc, char **argv)
{
  const char *name = argc > 1 ? argv[1] : NULL;

  signal (SIGXFSZ, SIG_IGN); /* what cannot be written is told */
  setlocale (LC_ALL, "");
  setlocale (LC_NUMERIC, "C"); /* numbers are told as they are read */
  locate_translations ();
  g_set_prgname ("hull2vd-cli");

  if (name == NULL)
    return refuse_command (NULL);
  if (g_str_equal (name, "--help") || g_str_equal (name, "-h")
      || g_str_equal (name, "help"))
    return print_help ();
  if (g_str_equal (name, "--version"))
    return print_version ();
  for (guint i = 0; i < G_N_ELEMENTS (commands); i++)
    if (g_str_equal (name, commands[i].name))
      return commands[i].run (&commands[i], argc - 1, argv + 1);
  return refuse_command (name);
}
