#include "cli.h"
#include "document.h"
#include "trace-file.h"

#include <glib/gi18n.h>

static gboolean
parse_detail (const CliCommand *command, const char *detail, Grain *grain)
{
  static const char *const names[] = { "event", "phase", "round" };

  *grain = GRAIN_EVENT;
  for (guint i = 0; detail != NULL && i < G_N_ELEMENTS (names); i++)
    if (g_str_equal (detail, names[i])) {
      *grain = (Grain)i;
      return TRUE;
    }
  if (detail == NULL)
    return TRUE;
  cli_usage (command,
             _ ("there is no detail “%s”: write event, phase or round"),
             detail);
  return FALSE;
}

static CliStatus
write_trace (const SiteSet *set,
             const Order *order,
             Grain grain,
             const char *path)
{
  Trace *trace = trace_record (set, order);
  CliOutput output;

  cli_output_begin (&output);
  trace_file_write (trace, grain, output.file);
  trace_free (trace);
  return cli_output_end (&output, path);
}

CliStatus
cli_trace (const CliCommand *command, int argc, char **argv)
{
  g_autofree char *detail = NULL, *path = NULL;
  g_auto (CliOrder) order_options = { NULL, NULL };
  g_auto (GStrv) paths = NULL;
  const GOptionEntry options[]
      = { { "detail", 'd', 0, G_OPTION_ARG_STRING, &detail,
            N_ ("a line for each event, phase or round"), "event|phase|round" },
          CLI_ORDER_ENTRIES (&order_options),
          { "output", 'o', 0, G_OPTION_ARG_FILENAME, &path,
            N_ ("write to FILE instead of standard output"), "FILE" },
          G_OPTION_ENTRY_NULL };
  GError *error = NULL;
  CliStatus status;
  SiteSet *set;
  Grain grain;
  Order order;

  if (!cli_parse (command, options, (CliCount){ 1, 1 }, argc, argv, &paths)
      || !parse_detail (command, detail, &grain)
      || !cli_order (command, &order_options, &order))
    return CLI_USAGE;
  set = document_read_points (paths[0], &error);
  if (set == NULL)
    return cli_fail (error);
  status = write_trace (set, &order, grain, path);
  site_set_free (set);
  return status;
}
