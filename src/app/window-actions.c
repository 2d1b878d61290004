#include "window-private.h"

#include "action.h"

#include <glib/gi18n.h>

static GVariant *
get_state (Hull2vdWindow *window, const Action *action)
{
  if (action->state == NULL)
    return NULL;
  if (action->get_state != NULL)
    return action_get_state (action, window->session);
  return window_command_state (window, action->name);
}

static void
run (Hull2vdWindow *window, const char *name, GVariant *parameter)
{
  const char *before = window->command;
  g_autoptr (GError) error = NULL;

  window->command = action_find (name)->name;
  /* What the window does itself may take its time, and says when it is done. */
  if (!window_command_run (window, name, parameter)) {
    if (action_run (window->session, name, parameter, &error))
      window_message_settle (window, name);
    else
      hull2vd_window_say (window, error->message);
  }
  window->command = before;
}

/* States that the window keeps change by what it does, not by the session. */
static void
update (Hull2vdWindow *window)
{
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++) {
    GAction *action
        = g_action_map_lookup_action (G_ACTION_MAP (window), actions[i].name);
    GVariant *state;

    if (action == NULL)
      continue;
    g_simple_action_set_enabled (
        G_SIMPLE_ACTION (action),
        action_is_enabled (&actions[i], window->session));
    state = get_state (window, &actions[i]);
    if (state != NULL)
      g_simple_action_set_state (G_SIMPLE_ACTION (action), state);
  }
}

static void
on_activate (GSimpleAction *action, GVariant *parameter, gpointer user)
{
  Hull2vdWindow *window = g_object_ref (user);

  run (window, g_action_get_name (G_ACTION (action)), parameter);
  if (window->session != NULL)
    update (window);
  g_object_unref (window);
}

/* Setting a state is the action with that parameter; of a switch, the action
 * if it is not so already. States without either can only be read. */
static void
on_change_state (GSimpleAction *simple, GVariant *value, gpointer user)
{
  const char *name = g_action_get_name (G_ACTION (simple));
  const Action *action = action_find (name);
  g_autoptr (GVariant) state = g_action_get_state (G_ACTION (simple));

  if (action->parameter != NULL)
    on_activate (simple, value, user);
  else if (g_variant_is_of_type (state, G_VARIANT_TYPE_BOOLEAN)
           && !g_variant_equal (state, value))
    on_activate (simple, NULL, user);
}

static GSimpleAction *
make_action (Hull2vdWindow *window, const Action *action)
{
  const GVariantType *type
      = action->parameter == NULL ? NULL : G_VARIANT_TYPE (action->parameter);
  GVariant *state = get_state (window, action);
  GSimpleAction *simple
      = state == NULL
            ? g_simple_action_new (action->name, type)
            : g_simple_action_new_stateful (action->name, type, state);

  g_signal_connect (simple, "activate", G_CALLBACK (on_activate), window);
  if (state != NULL)
    g_signal_connect (simple, "change-state", G_CALLBACK (on_change_state),
                      window);
  return simple;
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  (void)session;
  (void)changes;
  update (window);
}

void
window_actions_init (Hull2vdWindow *window)
{
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++) {
    g_autoptr (GSimpleAction) action = NULL;

    if ((actions[i].where & ACTION_IN_WINDOW) == 0)
      continue;
    action = make_action (window, &actions[i]);
    g_action_map_add_action (G_ACTION_MAP (window), G_ACTION (action));
  }
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  update (window);
}
