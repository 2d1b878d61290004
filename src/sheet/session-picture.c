#include "session-picture.h"

static void
fill (Scene *scene, int pane, const SceneLook *look, void *user)
{
  session_fill_scene (user, (guint)pane, scene, look);
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
