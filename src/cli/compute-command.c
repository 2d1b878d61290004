#include "certify.h"
#include "cli.h"
#include "document.h"
#include "result-json.h"

#include <glib/gi18n.h>

typedef struct Options {
  char *round, *output;
  CliOrder order_options;
  gboolean verify, merged;
  char **paths;
  guint round_number;
  Order order;
} Options;

static void
options_clear (Options *options)
{
  g_free (options->round);
  cli_order_clear (&options->order_options);
  g_free (options->output);
  g_strfreev (options->paths);
}

static gboolean
options_parse (Options *options,
               const CliCommand *command,
               int argc,
               char **argv)
{
  const GOptionEntry entries[]
      = { { "round", 'r', 0, G_OPTION_ARG_STRING, &options->round,
            N_ ("stop after R insertions beyond the first simplex"), "R" },
          { "verify", 0, 0, G_OPTION_ARG_NONE, &options->verify,
            N_ ("check the result independently before it is written"), NULL },
          { "merged", 0, 0, G_OPTION_ARG_NONE, &options->merged,
            N_ ("write facets that lie in one plane as one polygon"), NULL },
          CLI_ORDER_ENTRIES (&options->order_options),
          { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options->output,
            N_ ("write to FILE instead of standard output"), "FILE" },
          G_OPTION_ENTRY_NULL };

  return cli_parse (command, entries, (CliCount){ 1, 1 }, argc, argv,
                    &options->paths)
         && (options->round == NULL
             || cli_number (command, "--round", options->round,
                            &options->round_number))
         && cli_order (command, &options->order_options, &options->order);
}

/* Finds the step at the end of the round asked for. */
static gboolean
find_step (const Options *options, const Trace *trace, guint *step)
{
  const char *path = options->paths[0];

  if (trace->is_flat) {
    cli_say (_ ("%s: there is no round %u: all lifts lie in one plane, so "
                "there is no first simplex"),
             path, options->round_number);
    return FALSE;
  }
  if (options->round_number > trace->n_rounds) {
    cli_say (_ ("%s: there is no round %u: the last is %u"), path,
             options->round_number, trace->n_rounds);
    return FALSE;
  }
  *step = options->round_number == 0
              ? trace->start_end
              : trace->rounds[options->round_number - 1].end;
  return TRUE;
}

static gboolean
is_well_merged (const Result *result, char why[CERTIFY_ROOM])
{
  gboolean is_good;
  Merged merged;

  merged_init (&merged, result);
  is_good = certify_merged (&merged, result, why);
  merged_clear (&merged);
  return is_good;
}

static gboolean
verify (const Options *options, const Result *result)
{
  char why[CERTIFY_ROOM];

  if (!options->verify
      || (certify_result (result, why)
          && (!options->merged || is_well_merged (result, why))))
    return TRUE;
  cli_say (_ ("%s: the result is wrong: %s"), options->paths[0], why);
  return FALSE;
}

static CliStatus
write_result (const Options *options, const Result *result)
{
  CliOutput output;

  if (!verify (options, result))
    return CLI_REFUSED;
  cli_output_begin (&output);
  result_json_write (result,
                     (ResultForm){ options->round == NULL, options->merged },
                     output.file);
  return cli_output_end (&output, options->output);
}

/* Only a round needs the trace. */
static CliStatus
compute (const Options *options, const SiteSet *set)
{
  CliStatus status = CLI_REFUSED;
  Trace *trace = NULL;
  Result result;
  guint step;

  if (options->round == NULL) {
    result_init_batch (&result, set, &options->order);
  } else {
    trace = trace_record (set, &options->order);
    if (!find_step (options, trace, &step)) {
      trace_free (trace);
      return CLI_REFUSED;
    }
    result_init (&result, trace, step);
  }
  status = write_result (options, &result);
  result_clear (&result);
  trace_free (trace);
  return status;
}

CliStatus
cli_compute (const CliCommand *command, int argc, char **argv)
{
  Options options = { .round = NULL };
  CliStatus status = CLI_USAGE;
  GError *error = NULL;
  SiteSet *set;

  if (options_parse (&options, command, argc, argv)) {
    set = document_read_points (options.paths[0], &error);
    status = set == NULL ? cli_fail (error) : compute (&options, set);
    if (set != NULL)
      site_set_free (set);
  }
  options_clear (&options);
  return status;
}
