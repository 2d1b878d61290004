#include "action-private.h"
#include "rounding-case.h"
#include "words.h"

#include <glib/gi18n.h>

ACTION_RUN (action_view)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const char *names[N_EXHIBITS + 1] = { NULL };
  g_autofree char *hint = NULL;
  g_autofree char *list = NULL;
  ExhibitKind kind;

  if (exhibit_kind_parse (name, &kind)) {
    session_set_exhibit_kind (session, kind);
    return TRUE;
  }
  for (guint i = 0; i < N_EXHIBITS; i++)
    names[i] = exhibit_kind_name ((ExhibitKind)i);
  hint = words_hint (name, names);
  list = g_strjoinv (", ", (char **)names);
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("there is no view “%s”%s; write %s"), name, hint, list);
  return FALSE;
}

ACTION_STATE (action_state_view)
{
  return g_variant_new_string (
      exhibit_kind_name (session_get_exhibit_kind (session)));
}

/* Two runs */

/* An order of one word, or "random S"; moves on past its words. */
static gboolean
take_order (char ***words, Order *order)
{
  guint64 seed = 0;

  if (**words == NULL || !order_kind_parse (**words, &order->kind))
    return FALSE;
  *words += 1;
  order->seed = 0;
  if (order->kind != ORDER_RANDOM)
    return TRUE;
  if (**words == NULL || !words_parse_number (**words, G_MAXUINT64, &seed))
    return FALSE;
  order->seed = seed;
  *words += 1;
  return TRUE;
}

ACTION_RUN (action_compare)
{
  const char *text = g_variant_get_string (parameter, NULL);
  g_auto (GStrv) words = words_split (text);
  char **rest = words;
  Order orders[2];

  if (g_str_equal (text, "none")) {
    if (session_get_exhibit_kind (session) == EXHIBIT_COMPARE)
      session_set_exhibit_kind (session, EXHIBIT_LIFTS);
    return TRUE;
  }
  if (take_order (&rest, &orders[0]) && take_order (&rest, &orders[1])
      && *rest == NULL) {
    session_compare (session, orders);
    return TRUE;
  }
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("“%s” does not name two orders; write two of furthest, "
                  "input, random S, seeded and hilbert, or none"),
               text);
  return FALSE;
}

ACTION_RUN (action_compare_view)
{
  const char *name = g_variant_get_string (parameter, NULL);

  if (g_str_equal (name, "plane") || g_str_equal (name, "space")) {
    session_set_compares_space (session, g_str_equal (name, "space"));
    return TRUE;
  }
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("runs are compared in the plane or in space, not “%s”"),
               name);
  return FALSE;
}

ACTION_STATE (action_state_compare)
{
  const Order order = session_get_order (session);
  const Order other = session_get_other_order (session);
  g_autofree char *first = session_order_name (&order);
  g_autofree char *second = session_order_name (&other);

  if (session_get_exhibit_kind (session) != EXHIBIT_COMPARE)
    return g_variant_new_string ("none");
  return g_variant_new_take_string (g_strdup_printf ("%s %s", first, second));
}

ACTION_STATE (action_state_compare_view)
{
  return g_variant_new_string (session_get_compares_space (session) ? "space"
                                                                    : "plane");
}

/* Rounding */

ACTION_RUN (action_rounding)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const RoundingCase *what = rounding_case_find (name);
  const ExhibitTurn turn = { .node = { SIGN_MAP_SIDE / 2, SIGN_MAP_SIDE / 2 } };
  g_autoptr (GPtrArray) names = g_ptr_array_new ();
  g_autofree char *list = NULL;
  guint n_cases;
  const RoundingCase *cases = rounding_cases (&n_cases);

  if (what != NULL) {
    if (!session_set_sites (session, what->sites, what->n_sites, error))
      return FALSE;
    session_set_turn (session, &turn);
    session_set_exhibit_kind (session, EXHIBIT_SIGNS);
    return TRUE;
  }
  for (guint i = 0; i < n_cases; i++)
    g_ptr_array_add (names, (gpointer)cases[i].name);
  g_ptr_array_add (names, NULL);
  list = g_strjoinv (", ", (char **)names->pdata);
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("there is no case “%s” of rounding; write %s"), name, list);
  return FALSE;
}

ACTION_RUN (action_turn)
{
  ExhibitTurn turn = *session_get_turn (session);
  const guint n_sites = session_get_set (session)->n_sites;

  turn.is_named = TRUE;
  g_variant_get (parameter, "(uuu)", &turn.sites[0], &turn.sites[1],
                 &turn.sites[2]);
  for (guint i = 0; i < 3; i++)
    if (turn.sites[i] >= n_sites) {
      g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
                   _ ("there is no such site: s%u"), turn.sites[i]);
      return FALSE;
    }
  session_set_turn (session, &turn);
  session_set_exhibit_kind (session, EXHIBIT_SIGNS);
  return TRUE;
}

ACTION_RUN (action_node)
{
  ExhibitTurn turn = *session_get_turn (session);

  g_variant_get (parameter, "(uu)", &turn.node[0], &turn.node[1]);
  if (turn.node[0] >= SIGN_MAP_SIDE || turn.node[1] >= SIGN_MAP_SIDE) {
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
                 _ ("columns and rows of a sign map go from 0 to %d"),
                 SIGN_MAP_SIDE - 1);
    return FALSE;
  }
  session_set_turn (session, &turn);
  return TRUE;
}
