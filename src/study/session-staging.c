/* What a lesson puts on the stage beside its sites: which pictures there are,
 * and which listing. A person may change either; a stop's are put back when
 * the lesson changes them on the way. */
#include "session-private.h"

Views
session_get_views (Session *session)
{
  return session->views;
}

void
session_set_views (Session *session, Views views)
{
  if (views == session->views)
    return;
  session->views = views;
  session_tell (session, CHANGED_STAGING);
}

Listing
session_get_listing (Session *session)
{
  return session->listing;
}

void
session_set_listing (Session *session, Listing listing)
{
  if (listing == session->listing)
    return;
  session->listing = listing;
  session_tell (session, CHANGED_STAGING);
}

void
session_put_staging (Session *session,
                     const StopState *from,
                     const StopState *state)
{
  if (from == NULL || from->views != state->views)
    session_set_views (session, state->views);
  if (from == NULL || from->listing != state->listing)
    session_set_listing (session, state->listing);
}

void
session_clear_staging (Session *session)
{
  Camera home;

  camera_init (&home, CAMERA_HOME);
  session_hold (session);
  session_set_exhibit_kind (session, EXHIBIT_LIFTS);
  session_set_views (session, VIEWS_BOTH);
  session_set_listing (session, LISTING_QUICKHULL);
  session_set_layers (session, LAYERS_DEFAULT);
  session_set_focus (session, FOCUS_ACTIVE);
  session_set_measured (session, (Object){ OBJECT_NONE, 0 });
  session_reset_look (session);
  session_set_camera (session, &home);
  session_release (session);
}
