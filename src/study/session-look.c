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
session_set_hover (Session *session, Object object)
{
  if (object_equal (object, session->look.hover))
    return;
  session->look.hover = object;
  session_tell (session, CHANGED_LOOK);
}

/* Sets a number of the look; what is no number is not taken. */
static void
set_number (Session *session, double *number, double value, double most)
{
  if (!(value == value))
    return;
  value = CLAMP (value, 0, most);
  if (value == *number)
    return;
  *number = value;
  session_tell (session, CHANGED_LOOK);
}

void
session_set_lift (Session *session, double lift)
{
  set_number (session, &session->look.lift, lift, 1);
}

void
session_set_raise (Session *session, double raise)
{
  set_number (session, &session->look.raise, raise, RAISE_MOST);
}

void
session_set_body_opacity (Session *session, Body body, double opacity)
{
  set_number (session, &session->look.body_fade[body], 1 - opacity, 1);
}

void
session_set_role_opacity (Session *session, Role role, double opacity)
{
  set_number (session, &session->look.role_fade[role], 1 - opacity, 1);
}

void
session_reset_look (Session *session)
{
  session_hold (session);
  session_set_lift (session, 1);
  session_set_raise (session, RAISE_DEFAULT);
  for (Body body = 0; body < N_BODIES; body++)
    session_set_body_opacity (session, body, 1);
  for (Role role = 0; role < N_ROLES; role++)
    session_set_role_opacity (session, role, 1);
  session_release (session);
}

void
session_set_measured (Session *session, Object site)
{
  if (object_equal (site, session->look.measured))
    return;
  session->look.measured = site;
  session_tell (session, CHANGED_LOOK);
}

void
session_set_preview (Session *session, const Site *preview)
{
  SceneLook *look = &session->look;
  const Site none = { 0, 0 };
  /* A view may reach farther than sites can lie. */
  const gboolean has_preview = preview != NULL && site_is_in_range (preview);

  if (!has_preview)
    preview = &none;
  if (has_preview == look->has_preview && preview->x == look->preview.x
      && preview->y == look->preview.y)
    return;
  look->has_preview = has_preview;
  look->preview = *preview;
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
  /* A stop is shown with the whole plane in view. */
  if (!anyway && !session->is_replaying)
    keep_plane (session, &before);
  session_tell (session, CHANGED_LOOK);
}

void
session_show_all_sites (Session *session)
{
  if (all_inside (session->run->set, &session->look.extent))
    return;
  session_fit_extent (session, TRUE);
  plane_camera_init (&session->plane_camera);
  session_tell (session, CHANGED_CAMERA);
}

void
session_fit (Session *session)
{
  const Quaternion turn = session->camera.turn;
  const gboolean is_parallel = session->camera.is_parallel;
  const gboolean is_mirrored = session->camera.is_mirrored;

  session_hold (session);
  session_fit_extent (session, TRUE);
  plane_camera_init (&session->plane_camera);
  camera_init (&session->camera, CAMERA_HOME);
  session->camera.turn = turn;
  session->camera.is_parallel = is_parallel;
  session->camera.is_mirrored = is_mirrored;
  session_tell (session, CHANGED_CAMERA);
  session_release (session);
}
