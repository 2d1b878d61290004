#include "action-private.h"

#include <glib/gi18n.h>

ACTION_RUN (action_resume)
{
  if (session_resume (session))
    return TRUE;
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_DISABLED, "%s",
               _ ("there is no place to resume from"));
  return FALSE;
}

ACTION_ENABLED (action_can_resume)
{
  return session_can_resume (session, NULL);
}

ACTION_ENABLED (action_has_progress)
{
  const Progress *progress = session_get_progress (session);

  return progress != NULL && progress->lessons->len > 0;
}
