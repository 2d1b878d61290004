/* Numbers of the look, and the site that is measured. */
#include "action-private.h"
#include "object-name.h"
#include "words.h"

#include <glib/gi18n.h>

static gboolean
check_range (double value, double most, GError **error)
{
  if (value >= 0 && value <= most)
    return TRUE;
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("%g is not a number from 0 to %g"), value, most);
  return FALSE;
}

ACTION_RUN (action_lift)
{
  const double lift = g_variant_get_double (parameter);

  if (!check_range (lift, 1, error))
    return FALSE;
  session_set_lift (session, lift);
  return TRUE;
}

ACTION_RUN (action_raise)
{
  const double raise = g_variant_get_double (parameter);

  if (!check_range (raise, RAISE_MOST, error))
    return FALSE;
  session_set_raise (session, raise);
  return TRUE;
}

static gboolean
refuse_name (const char *name, GError **error)
{
  const char *names[N_BODIES + N_ROLES + 1] = { NULL };
  g_autofree char *hint = NULL;

  for (Body body = 0; body < N_BODIES; body++)
    names[body] = body_name (body);
  for (Role role = 0; role < N_ROLES; role++)
    names[N_BODIES + role] = role_name (role);
  hint = words_hint (name, names);
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("nothing in the pictures is called “%s”%s; write "
                  "paraboloid, hull, plane or the name of a role"),
               name, hint);
  return FALSE;
}

ACTION_RUN (action_opacity)
{
  const char *name;
  double opacity;
  Body body;
  Role role;

  g_variant_get (parameter, "(&sd)", &name, &opacity);
  if (!check_range (opacity, 1, error))
    return FALSE;
  if (body_parse (name, &body))
    session_set_body_opacity (session, body, opacity);
  else if (role_parse (name, &role))
    session_set_role_opacity (session, role, opacity);
  else
    return refuse_name (name, error);
  return TRUE;
}

ACTION_RUN (action_body_opacity)
{
  const double opacity = g_variant_get_double (parameter);

  if (!check_range (opacity, 1, error))
    return FALSE;
  session_set_body_opacity (session, (Body)action->data, opacity);
  return TRUE;
}

ACTION_RUN (action_reset_look)
{
  session_reset_look (session);
  return TRUE;
}

ACTION_RUN (action_measure)
{
  const char *name = g_variant_get_string (parameter, NULL);
  Object object;

  if (object_name_parse (name, &object)
      && (object.kind == OBJECT_NONE
          || (object.kind == OBJECT_SITE
              && object.number < session_get_set (session)->n_sites))) {
    session_set_measured (session, object);
    return TRUE;
  }
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("cannot measure “%s”: write a site, such as s5, or none"),
               name);
  return FALSE;
}

/* The sites in turn, then none. */
ACTION_RUN (action_measure_next)
{
  const guint n_sites = session_get_set (session)->n_sites;
  const Object old = session_get_look (session)->measured;
  const guint next = old.kind == OBJECT_SITE ? old.number + 1 : 0;

  session_set_measured (session, next < n_sites ? (Object){ OBJECT_SITE, next }
                                                : (Object){ OBJECT_NONE, 0 });
  return TRUE;
}
