#include "action-private.h"
#include "position.h"

#include <glib/gi18n.h>

static gboolean
refuse_position (const char *reason, GError **error)
{
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_POSITION, "%s", reason);
  return FALSE;
}

ACTION_RUN (action_next)
{
  const guint step = session_get_step (session);

  if (action->data == 0 ? !session_next (session)
                        : step == session_get_n_steps (session))
    return refuse_position (_ ("there is nothing after the end"), error);
  if (action->data != 0)
    session_set_step (session,
                      session_step_after (session, (Grain)(action->data - 1)));
  return TRUE;
}

ACTION_RUN (action_back)
{
  const guint step = session_get_step (session);

  if (action->data == 0 ? !session_back (session) : step == 0)
    return refuse_position (_ ("there is nothing before the start"), error);
  if (action->data != 0)
    session_set_step (session,
                      session_step_before (session, (Grain)(action->data - 1)));
  return TRUE;
}

ACTION_RUN (action_first)
{
  session_first (session);
  return TRUE;
}

ACTION_RUN (action_last)
{
  session_last (session);
  return TRUE;
}

ACTION_RUN (action_play)
{
  session_set_playing (session, !session_get_playing (session));
  return TRUE;
}

ACTION_RUN (action_step_size)
{
  const char *name = g_variant_get_string (parameter, NULL);
  StepSize size;

  if (!step_size_parse (name, &size)) {
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
                 _ ("“%s” is not a step size; write beat, phase or event"),
                 name);
    return FALSE;
  }
  session_set_step_size (session, size);
  return TRUE;
}

ACTION_RUN (action_speed)
{
  session_set_speed (session, g_variant_get_double (parameter));
  return TRUE;
}

static gboolean
find_in_exhibit (Session *session,
                 const char *text,
                 guint *step,
                 GError **error)
{
  gboolean is_before;
  Place place;

  if (!position_read (text, &place, &is_before, error))
    return FALSE;
  if (session_find_step (session, place, is_before, step))
    return TRUE;
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_POSITION,
               _ ("there is no “%s”: the last round is %u"), text,
               session_get_n_rounds (session));
  return FALSE;
}

ACTION_RUN (action_goto)
{
  const char *text = g_variant_get_string (parameter, NULL);
  guint step;

  if (session_get_exhibit (session) != NULL
          ? !find_in_exhibit (session, text, &step, error)
          : !position_find (session_get_trace (session), text, &step, error))
    return FALSE;
  session_set_step (session, step);
  return TRUE;
}

ACTION_RUN (action_goto_step)
{
  const guint step = g_variant_get_uint32 (parameter);
  const guint last = session_get_n_steps (session);

  if (step > last) {
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_POSITION,
                 _ ("there is no step %u: the last is %u"), step, last);
    return FALSE;
  }
  session_set_step (session, step);
  return TRUE;
}

ACTION_RUN (action_goto_stop)
{
  const guint stop = g_variant_get_uint32 (parameter);
  const guint n_stops = session_get_n_stops (session);

  if (stop >= 1 && session_set_stop (session, stop - 1))
    return TRUE;
  if (n_stops == 0)
    return refuse_position (_ ("there are no stops: no lesson is open"), error);
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_POSITION,
               _ ("there is no stop %u: they are numbered from 1 to %u"), stop,
               n_stops);
  return FALSE;
}

ACTION_RUN (action_next_stop)
{
  return session_set_stop (session, session_get_stop (session) + 1)
         || refuse_position (_ ("there is no next stop"), error);
}

ACTION_RUN (action_previous_stop)
{
  const guint stop = session_get_stop (session);

  return (stop > 0 && session_set_stop (session, stop - 1))
         || refuse_position (_ ("there is no previous stop"), error);
}
