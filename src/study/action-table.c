#include "action-private.h"

static GArray *
join (void)
{
  const ActionRows *parts[]
      = { &action_rows_time, &action_rows_perform, &action_rows_look,
          &action_rows_edit, &action_rows_progress };
  GArray *table = g_array_new (FALSE, FALSE, sizeof (Action));

  for (guint i = 0; i < G_N_ELEMENTS (parts); i++)
    g_array_append_vals (table, parts[i]->rows, parts[i]->n_rows);
  return table;
}

const Action *
action_table (guint *n_actions)
{
  static gsize joined = 0;
  static const GArray *table;

  if (g_once_init_enter (&joined)) {
    table = join ();
    g_once_init_leave (&joined, 1);
  }
  *n_actions = table->len;
  return (const Action *)(gpointer)table->data;
}
