#include "batch.h"
#include "cli.h"
#include "document.h"

#include <glib/gi18n.h>

/* How each order chooses and finds, as a reader of the numbers must know. */
static const char *
policy_of (OrderKind kind)
{
  switch (kind) {
  case ORDER_FURTHEST:
    return N_ ("the furthest site of the oldest facet that has an outside "
               "set; sites wait in outside sets");
  case ORDER_INPUT:
    return N_ ("the sites as they come; they wait in outside sets");
  case ORDER_RANDOM:
    return N_ ("the sites shuffled by the seed; they wait in outside sets");
  case ORDER_SEEDED:
    return N_ ("every sixteenth site along a Hilbert curve, found by walking; "
               "then the furthest site of the oldest facet that has an "
               "outside set");
  case ORDER_HILBERT:
    return N_ ("rounds of growing samples, each along a Hilbert curve; sites "
               "are found by walking");
  }
  return "";
}

static void
print_count (FILE *file, const char *name, guint64 count, guint n_sites)
{
  char per_site[G_ASCII_DTOSTR_BUF_SIZE];

  g_ascii_formatd (per_site, sizeof per_site, "%.3f",
                   n_sites > 0 ? (double)count / n_sites : 0);
  fprintf (file, "%-28s %12" G_GUINT64_FORMAT "  %s\n", name, count, per_site);
}

static CliStatus
print_counts (const SiteSet *set, const Order *order)
{
  Batch *batch = batch_build (set->sites, set->n_sites, order, BATCH_OLDEST);
  const HullCounts *counts = &batch->counts;
  const guint n = set->n_sites;
  CliOutput output;
  FILE *file;

  cli_output_begin (&output);
  file = output.file;
  fprintf (file, _ ("order %s: %s\n"), order_kind_name (order->kind),
           _ (policy_of (order->kind)));
  fprintf (file, "%s\n",
           _ ("counts for the whole hull, with lower, upper and vertical "
              "facets: in total, and per site"));
  print_count (file, _ ("sites"), n, n);
  print_count (file, _ ("facets at the end"), batch->n_facets, n);
  print_count (file, _ ("facets created"), counts->facets_created, n);
  print_count (file, _ ("visibility tests"), counts->visibility_tests, n);
  print_count (file, _ ("claims and redistributions"), counts->redistributions,
               n);
  print_count (file, _ ("walk steps"), counts->walk_steps, n);
  batch_free (batch);
  return cli_output_end (&output, NULL);
}

CliStatus
cli_count (const CliCommand *command, int argc, char **argv)
{
  g_auto (CliOrder) order_options = { NULL, NULL };
  g_auto (GStrv) paths = NULL;
  const GOptionEntry options[]
      = { CLI_ORDER_ENTRIES (&order_options), G_OPTION_ENTRY_NULL };
  GError *error = NULL;
  CliStatus status;
  SiteSet *set;
  Order order;

  if (!cli_parse (command, options, (CliCount){ 1, 1 }, argc, argv, &paths)
      || !cli_order (command, &order_options, &order))
    return CLI_USAGE;
  set = document_read_points (paths[0], &error);
  if (set == NULL)
    return cli_fail (error);
  status = print_counts (set, &order);
  site_set_free (set);
  return status;
}
