#include "site-edit.h"

#include <math.h>

/* In scene units: the sites fill -1 … 1. */
#define NUDGE 0.01
#define NUDGE_FAR 0.1

Site
site_edit_at (Session *session, Point3 point)
{
  return session_snap (session, scene_site (session_get_look (session), point));
}

gboolean
site_edit_refuse (Canvas *canvas)
{
  g_autoptr (GError) error = NULL;

  if (session_can_edit (canvas_get_session (canvas), &error))
    return FALSE;
  canvas_fail (canvas, error);
  return TRUE;
}

/* In a performance all that is pressed is an answer. */
static gboolean
can_edit (Canvas *canvas)
{
  return !site_edit_refuse (canvas)
         && !session_is_asking (canvas_get_session (canvas));
}

void
site_edit_add (Canvas *canvas, Point3 point)
{
  Session *session = canvas_get_session (canvas);
  g_autoptr (GError) error = NULL;

  if (!can_edit (canvas))
    return;
  if (!session_add_site (session, site_edit_at (session, point), &error)) {
    canvas_fail (canvas, error);
    return;
  }
  if (session_is_working (session, NULL))
    return;
  site_edit_go_to_last (canvas);
}

void
site_edit_go_to_last (Canvas *canvas)
{
  Session *session = canvas_get_session (canvas);
  guint n_selected;

  session_get_selected_sites (session, &n_selected);
  if (n_selected > 0)
    session_set_selection (session, (Object){ OBJECT_NONE, 0 });
  canvas_set_cursor (
      canvas, (Object){ OBJECT_SITE, session_get_set (session)->n_sites - 1 });
}

void
site_edit_move (Canvas *canvas, guint site, Point3 point)
{
  Session *session = canvas_get_session (canvas);
  const Site to = site_edit_at (session, point);
  g_autoptr (GError) error = NULL;
  const gboolean is_moved
      = session_is_selected (session, site)
            ? session_move_selected (session, site, to, &error)
            : session_move_site (session, site, to, &error);

  if (!is_moved)
    canvas_fail (canvas, error);
}

gboolean
site_edit_joins (const CanvasPress *press)
{
  return press->button == GDK_BUTTON_PRIMARY
         && (press->modifiers & (GDK_SHIFT_MASK | GDK_CONTROL_MASK)) != 0;
}

gboolean
site_edit_toggle (Canvas *canvas, Object object)
{
  if (object.kind != OBJECT_SITE)
    return FALSE;
  canvas_set_cursor (canvas, object);
  session_toggle_site (canvas_get_session (canvas), object.number);
  return TRUE;
}

static gboolean
is_nudging (Canvas *canvas)
{
  return g_object_get_data (G_OBJECT (canvas), "nudging") != NULL;
}

static void
set_nudging (Canvas *canvas, gboolean nudging)
{
  g_object_set_data (G_OBJECT (canvas), "nudging",
                     GINT_TO_POINTER (nudging ? 1 : 0));
}

/* A shorter way would lead back to the same grid point. */
static double
grid_in_scene (Session *session)
{
  const double radius = session_get_look (session)->extent.radius;
  const int exponent = session_get_set (session)->exponent;

  return session_get_grid (session) / ldexp (radius, exponent);
}

gboolean
site_edit_nudge (Canvas *canvas, const double by[2], gboolean is_far)
{
  Session *session = canvas_get_session (canvas);
  const SiteSet *set = session_get_set (session);
  const Object cursor = canvas_get_cursor (canvas);
  Point3 point;
  double length;

  if (cursor.kind != OBJECT_SITE || cursor.number >= set->n_sites
      || !can_edit (canvas))
    return FALSE;
  if (!is_nudging (canvas))
    session_begin_edit (session);
  set_nudging (canvas, TRUE);
  point = scene_point (session_get_look (session), &set->sites[cursor.number],
                       false);
  length = MAX (is_far ? NUDGE_FAR : NUDGE, grid_in_scene (session));
  point.x += length * by[0];
  point.y -= length * by[1];
  site_edit_move (canvas, cursor.number, point);
  return TRUE;
}

void
site_edit_settle (Canvas *canvas)
{
  if (is_nudging (canvas))
    session_end_edit (canvas_get_session (canvas));
  set_nudging (canvas, FALSE);
}

gboolean
site_edit_remove (Canvas *canvas)
{
  Session *session = canvas_get_session (canvas);
  const Object cursor = canvas_get_cursor (canvas);
  g_autoptr (GError) error = NULL;
  gboolean is_removed;

  if (cursor.kind != OBJECT_SITE || !can_edit (canvas))
    return FALSE;
  is_removed = session_is_selected (session, cursor.number)
                   ? session_remove_selected (session, &error)
                   : session_remove_site (session, cursor.number, &error);
  if (!is_removed)
    canvas_fail (canvas, error);
  return TRUE;
}
