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
