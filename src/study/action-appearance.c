#include "action-private.h"
#include "words.h"

#include <glib/gi18n.h>

ACTION_RUN (action_theme)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const char *names[N_THEMES + 1] = { NULL };
  g_autofree char *hint = NULL, *list = NULL;
  ThemeKind theme;

  if (theme_kind_parse (name, &theme)) {
    session_set_theme (session, theme);
    return TRUE;
  }
  for (guint i = 0; i < N_THEMES; i++)
    names[i] = theme_kind_name ((ThemeKind)i);
  hint = words_hint (name, names);
  list = g_strjoinv (", ", (char **)names);
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("there is no theme “%s”%s; the themes are %s"), name, hint,
               list);
  return FALSE;
}

static double *
scale_of (Appearance *appearance, guint which)
{
  switch ((ActionScale)which) {
  case SCALE_LINES:
    return &appearance->line_scale;
  case SCALE_MARKS:
    return &appearance->mark_scale;
  case SCALE_TEXT:
    return &appearance->text_scale;
  }
  g_assert_not_reached ();
}

ACTION_RUN (action_scale)
{
  const double scale = g_variant_get_double (parameter);
  Appearance own = *session_get_own_appearance (session);

  if (scale >= SCALE_LEAST && scale <= SCALE_MOST) {
    *scale_of (&own, action->data) = scale;
    session_set_own_appearance (session, &own);
    return TRUE;
  }
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("“%s” takes a number from %g to %g"), action->name,
               SCALE_LEAST, SCALE_MOST);
  return FALSE;
}

ACTION_STATE (action_state_theme)
{
  return g_variant_new_string (
      theme_kind_name (session_get_appearance (session)->theme));
}

ACTION_STATE (action_state_scale)
{
  Appearance appearance = *session_get_appearance (session);

  return g_variant_new_double (*scale_of (&appearance, action->data));
}
