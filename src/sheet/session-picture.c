#include "session-picture.h"

static void
fill (Scene *scene, int pane, const SceneLook *look, void *user)
{
  session_fill_scene (user, (guint)pane, scene, look);
}

PictureView
session_picture_view (Session *session)
{
  switch (session_get_views (session)) {
  case VIEWS_PLANE:
    return PICTURE_PLANE;
  case VIEWS_SPACE:
    return PICTURE_SPACE;
  case VIEWS_BOTH:
    break;
  }
  return PICTURE_BOTH;
}

void
session_picture_take (Picture *picture, Session *session)
{
  if (session_get_pane (session, 1) == PANE_NONE)
    picture->view = PICTURE_PLANE;
  picture->look = *session_get_look (session);
  picture->look.hover = (Object){ OBJECT_NONE, 0 };
  picture->look.has_preview = false;
  picture->camera = *session_get_camera (session);
  picture->plane_camera = *session_get_plane_camera (session);
  picture->fill = fill;
  picture->fill_user = session;
  for (guint pane = 0; pane < N_PANES; pane++)
    picture->is_space[pane] = session_get_pane (session, pane) == PANE_SPACE;
}

void
session_picture (Picture *picture, Session *session, PictureView view)
{
  if (session_get_pane (session, 1) == PANE_NONE)
    view = PICTURE_PLANE;
  picture_init (picture, view, session_get_frame (session));
  session_picture_take (picture, session);
}

/* Panes that belong to no session */

struct KeptPanes {
  Showing *showings[N_PANES]; /* NULL: there is no such pane */
  gint is_given_up;           /* atomic */
};

static void
fill_kept (Scene *scene, int pane, const SceneLook *look, void *user)
{
  KeptPanes *kept = user;
  Showing *showing = kept->showings[pane];

  if (showing == NULL || kept_panes_are_given_up (kept))
    return;
  showing->look.low = look->low;
  showing->look.high = look->high;
  showing_fill (showing, scene);
}

KeptPanes *
session_picture_keep (Picture *picture, Session *session)
{
  KeptPanes *kept = g_new0 (KeptPanes, 1);

  session_picture_take (picture, session);
  for (guint pane = 0; pane < N_PANES; pane++)
    if (session_get_pane (session, pane) != PANE_NONE)
      kept->showings[pane]
          = session_keep_showing (session, pane, &picture->look);
  picture->look = kept->showings[0]->look;
  picture->fill = fill_kept;
  picture->fill_user = kept;
  return kept;
}

void
kept_panes_give_up (KeptPanes *kept)
{
  g_atomic_int_set (&kept->is_given_up, 1);
}

gboolean
kept_panes_are_given_up (KeptPanes *kept)
{
  return g_atomic_int_get (&kept->is_given_up) != 0;
}

void
kept_panes_free (KeptPanes *kept)
{
  for (guint pane = 0; pane < N_PANES; pane++)
    showing_free (kept->showings[pane]);
  g_free (kept);
}
