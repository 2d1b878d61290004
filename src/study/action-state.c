#include "action-private.h"
#include "object-name.h"
#include "session-chore.h"

ACTION_STATE (action_state_step)
{
  return g_variant_new_uint32 (session_get_step (session));
}

ACTION_STATE (action_state_n_steps)
{
  return g_variant_new_uint32 (session_get_n_steps (session));
}

ACTION_STATE (action_state_round)
{
  return g_variant_new_uint32 (session_get_place (session).round);
}

ACTION_STATE (action_state_phase)
{
  return g_variant_new_string (phase_name (session_get_place (session).phase));
}

ACTION_STATE (action_state_stop)
{
  return g_variant_new_uint32 (session_get_lesson (session) == NULL
                                   ? 0
                                   : session_get_stop (session) + 1);
}

ACTION_STATE (action_state_n_stops)
{
  return g_variant_new_uint32 (session_get_n_stops (session));
}

ACTION_STATE (action_state_n_sites)
{
  return g_variant_new_uint32 (session_get_set (session)->n_sites);
}

ACTION_STATE (action_state_play)
{
  return g_variant_new_boolean (session_get_playing (session));
}

ACTION_STATE (action_state_step_size)
{
  return g_variant_new_string (
      step_size_name (session_get_step_size (session)));
}

ACTION_STATE (action_state_speed)
{
  return g_variant_new_double (session_get_speed (session));
}

ACTION_STATE (action_state_layer)
{
  return g_variant_new_boolean (
      (session_get_look (session)->layers & action->data) != 0);
}

ACTION_STATE (action_state_order)
{
  const Order order = session_get_order (session);
  const char *name = order_kind_name (order.kind);

  if (order.kind != ORDER_RANDOM)
    return g_variant_new_string (name);
  return g_variant_new_take_string (
      g_strdup_printf ("%s %" G_GUINT64_FORMAT, name, order.seed));
}

ACTION_STATE (action_state_focus)
{
  return g_variant_new_string (focus_name (session_get_look (session)->focus));
}

ACTION_STATE (action_state_selection)
{
  char name[OBJECT_NAME_ROOM];

  object_name_write (session_get_look (session)->selection, name);
  return g_variant_new_string (name);
}

ACTION_STATE (action_state_lift)
{
  return g_variant_new_double (session_get_look (session)->lift);
}

ACTION_STATE (action_state_raise)
{
  return g_variant_new_double (session_get_look (session)->raise);
}

ACTION_STATE (action_state_body_opacity)
{
  return g_variant_new_double (
      1 - session_get_look (session)->body_fade[action->data]);
}

ACTION_STATE (action_state_measure)
{
  char name[OBJECT_NAME_ROOM];

  object_name_write (session_get_look (session)->measured, name);
  return g_variant_new_string (name);
}

ACTION_STATE (action_state_selected_sites)
{
  guint n;
  const guint32 *sites = session_get_selected_sites (session, &n);
  GVariant *state = g_variant_new_fixed_array (G_VARIANT_TYPE_UINT32, sites, n,
                                               sizeof *sites);

  /* From now on it knows that it is, and is compared byte by byte: else it is
   * printed for that, which takes 100 ms for many sites. */
  g_variant_is_normal_form (state);
  return state;
}

ACTION_STATE (action_state_snap)
{
  return g_variant_new_boolean (session_get_snaps (session));
}

ACTION_ENABLED (action_can_next)
{
  return action->data == 0
             ? session_can_next (session)
             : session_get_step (session) < session_get_n_steps (session);
}

ACTION_ENABLED (action_can_back)
{
  return action->data == 0 ? session_can_back (session)
                           : session_get_step (session) > 0;
}

ACTION_ENABLED (action_can_play) { return session_get_n_steps (session) > 0; }

ACTION_ENABLED (action_can_next_stop)
{
  return session_get_stop (session) + 1 < session_get_n_stops (session);
}

ACTION_ENABLED (action_can_previous_stop)
{
  return session_get_stop (session) > 0;
}

ACTION_ENABLED (action_has_sites)
{
  return session_get_set (session)->n_sites > 0;
}

ACTION_ENABLED (action_has_selection)
{
  return session_get_look (session)->selection.kind != OBJECT_NONE;
}

ACTION_ENABLED (action_has_selected_site)
{
  return session_get_look (session)->selection.kind == OBJECT_SITE;
}

ACTION_ENABLED (action_can_undo)
{
  return session_get_undo_label (session) != NULL;
}

ACTION_ENABLED (action_can_redo)
{
  return session_get_redo_label (session) != NULL;
}

ACTION_ENABLED (action_is_working)
{
  return session_is_working (session, NULL)
         || session_get_chore (session) != NULL;
}
