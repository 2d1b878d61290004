/* The options --order and --seed, which several commands take. */
#include "cli.h"

#include <glib/gi18n.h>

void
cli_order_clear (CliOrder *options)
{
  g_free (options->kind);
  g_free (options->seed);
}

gboolean
cli_order (const CliCommand *command, const CliOrder *options, Order *order)
{
  guint seed = 0;

  *order = (Order){ ORDER_FURTHEST, 0 };
  if (options->kind != NULL
      && !order_kind_parse (options->kind, &order->kind)) {
    cli_usage (command,
               _ ("there is no order “%s”: write furthest, input, random, "
                  "seeded or hilbert"),
               options->kind);
    return FALSE;
  }
  if (options->seed == NULL)
    return TRUE;
  if (order->kind != ORDER_RANDOM) {
    cli_usage (command, _ ("--seed needs --order random: no other order has a "
                           "seed"));
    return FALSE;
  }
  if (!cli_number (command, "--seed", options->seed, &seed))
    return FALSE;
  order->seed = seed;
  return TRUE;
}
