#include "session-private.h"

const Appearance *
session_get_appearance (Session *session)
{
  return &session->appearance;
}

const Appearance *
session_get_own_appearance (Session *session)
{
  return &session->own;
}

/* Shows the person's appearance, in the theme that the lesson tells. */
static void
update (Session *session)
{
  Appearance shown = session->own;

  if (session->told_theme != THEME_UNTOLD)
    shown.theme = (ThemeKind)session->told_theme;
  if (appearance_equal (&shown, &session->appearance))
    return;
  session->appearance = shown;
  session_tell (session, CHANGED_APPEARANCE);
}

/* A scale that is not a number is 1. */
static double
clamp_scale (double scale)
{
  return scale == scale ? CLAMP (scale, SCALE_LEAST, SCALE_MOST) : 1;
}

void
session_set_own_appearance (Session *session, const Appearance *appearance)
{
  session->own
      = (Appearance){ appearance->theme, clamp_scale (appearance->line_scale),
                      clamp_scale (appearance->mark_scale),
                      clamp_scale (appearance->text_scale) };
  update (session);
}

void
session_tell_theme (Session *session, int theme)
{
  session->told_theme = theme;
  update (session);
}

void
session_set_theme (Session *session, ThemeKind theme)
{
  if (session->is_replaying) {
    session_tell_theme (session, (int)theme);
    return;
  }
  session->told_theme = THEME_UNTOLD;
  session->own.theme = theme;
  update (session);
}
