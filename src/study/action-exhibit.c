#include "action-private.h"
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
