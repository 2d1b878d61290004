#include "session-private.h"

#include <math.h>

const SceneLook *
session_get_look (Session *session)
{
  return &session->look;
}

void
session_set_layers (Session *session, guint layers)
{
  if (layers == session->look.layers)
    return;
  session->look.layers = layers;
  session_tell (session, CHANGED_LOOK);
}

void
session_set_focus (Session *session, Focus focus)
{
  if (focus == session->look.focus)
    return;
  session->look.focus = focus;
  session_tell (session, CHANGED_LOOK);
}

void
session_set_selection (Session *session, Object object)
{
  if (object_equal (object, session->look.selection))
    return;
  session->look.selection = object;
  session_tell (session, CHANGED_LOOK);
}

void
session_set_hover (Session *session, Object object)
{
  if (object_equal (object, session->look.hover))
    return;
  session->look.hover = object;
  session_tell (session, CHANGED_LOOK);
}

const Camera *
session_get_camera (Session *session)
{
  return &session->camera;
}

void
session_set_camera (Session *session, const Camera *camera)
{
  session->camera = *camera;
  session_tell (session, CHANGED_CAMERA);
}

const PlaneCamera *
session_get_plane_camera (Session *session)
{
  return &session->plane_camera;
}

void
session_set_plane_camera (Session *session, const PlaneCamera *camera)
{
  session->plane_camera = *camera;
  session_tell (session, CHANGED_CAMERA);
}

static gboolean
all_inside (const SiteSet *set, const Extent *extent)
{
  for (guint i = 0; i < set->n_sites; i++)
    if (fabs (set->sites[i].x - extent->centre.x) > extent->radius
        || fabs (set->sites[i].y - extent->centre.y) > extent->radius)
      return FALSE;
  return TRUE;
}

/* Lets the plane view show what it showed, now that scene coordinates have
 * become others: a site stays under the pointer that put it there. */
static void
keep_plane (Session *session, const Extent *before)
{
  const Extent *now = &session->look.extent;
  PlaneCamera camera = session->plane_camera;
  const double scale = before->radius / now->radius;

  camera.centre_x = (before->centre.x - now->centre.x) / now->radius
                    + camera.centre_x * scale;
  camera.centre_y = (before->centre.y - now->centre.y) / now->radius
                    + camera.centre_y * scale;
  camera.zoom /= scale;
  session_set_plane_camera (session, &camera);
}

void
session_fit_extent (Session *session, gboolean anyway)
{
  const Extent before = session->look.extent;

  if (!anyway && all_inside (session->run->set, &before))
    return;
  session->look.extent = site_set_extent (session->run->set);
  if (!anyway)
    keep_plane (session, &before);
  session_tell (session, CHANGED_LOOK);
}

void
session_fit (Session *session)
{
  const Quaternion turn = session->camera.turn;
  const gboolean is_parallel = session->camera.is_parallel;

  session_hold (session);
  session_fit_extent (session, TRUE);
  plane_camera_init (&session->plane_camera);
  camera_init (&session->camera, CAMERA_HOME);
  session->camera.turn = turn;
  session->camera.is_parallel = is_parallel;
  session_tell (session, CHANGED_CAMERA);
  session_release (session);
}
