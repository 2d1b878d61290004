#include "action-private.h"
#include "words.h"

#include <glib/gi18n.h>

ACTION_RUN (action_views)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const char *names[N_VIEWS + 1] = { NULL };
  g_autofree char *hint = NULL;
  Views views;

  if (views_parse (name, &views)) {
    session_set_views (session, views);
    return TRUE;
  }
  for (guint i = 0; i < N_VIEWS; i++)
    names[i] = views_name ((Views)i);
  hint = words_hint (name, names);
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("there are no views “%s”%s; write both, plane or space"),
               name, hint);
  return FALSE;
}

ACTION_STATE (action_state_views)
{
  return g_variant_new_string (views_name (session_get_views (session)));
}

ACTION_RUN (action_listing)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const char *names[N_LISTINGS + 1] = { NULL };
  g_autofree char *hint = NULL;
  g_autofree char *list = NULL;
  Listing listing;

  if (listing_parse (name, &listing)) {
    session_set_listing (session, listing);
    return TRUE;
  }
  for (guint i = 0; i < N_LISTINGS; i++)
    names[i] = listing_name ((Listing)i);
  hint = words_hint (name, names);
  list = g_strjoinv (", ", (char **)names);
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("there is no listing “%s”%s; write %s"), name, hint, list);
  return FALSE;
}

ACTION_STATE (action_state_listing)
{
  return g_variant_new_string (listing_name (session_get_listing (session)));
}
