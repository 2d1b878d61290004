#include "action.h"

#include <glib/gi18n.h>

G_DEFINE_QUARK (action - error - quark, action_error)

const Action *
action_find (const char *name)
{
  guint n_actions;
  const Action *table = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++)
    if (g_str_equal (table[i].name, name))
      return &table[i];
  return NULL;
}

GVariant *
action_get_state (const Action *action, Session *session)
{
  return action->get_state == NULL ? NULL : action->get_state (action, session);
}

gboolean
action_is_enabled (const Action *action, Session *session)
{
  return action->is_enabled == NULL || action->is_enabled (action, session);
}

static gboolean
check_parameter (const Action *action, GVariant *parameter, GError **error)
{
  if (action->parameter == NULL
          ? parameter == NULL
          : parameter != NULL
                && g_variant_is_of_type (parameter,
                                         G_VARIANT_TYPE (action->parameter)))
    return TRUE;
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               action->parameter == NULL
                   ? _ ("“%s” takes no parameter")
                   : _ ("“%s” takes a parameter of type %s"),
               action->name, action->parameter);
  return FALSE;
}

gboolean
action_run (Session *session,
            const char *name,
            GVariant *parameter,
            GError **error)
{
  const Action *action = action_find (name);
  g_autoptr (GVariant) owned
      = parameter == NULL ? NULL : g_variant_ref_sink (parameter);

  if (action == NULL || action->run == NULL) {
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_UNKNOWN,
                 action == NULL ? _ ("there is no action “%s”")
                                : _ ("“%s” can be done only in the window"),
                 name);
    return FALSE;
  }
  return check_parameter (action, owned, error)
         && action->run (action, session, owned, error);
}
