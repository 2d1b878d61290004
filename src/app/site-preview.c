#include "site-preview.h"

#include "site-edit.h"

#include <math.h>

/* Nearer to a site than this the pointer is on it. */
#define SITE_REACH_PX 12.0

gboolean
site_preview_is_on_site (Canvas *canvas, const double at_px[2])
{
  Session *session = canvas_get_session (canvas);
  const SceneLook *look = session_get_look (session);
  const SiteSet *set = session_get_set (session);
  const Projection projection = canvas_get_projection (canvas);

  for (guint i = 0; i < set->n_sites; i++) {
    const Point3 point = projection_apply (
        &projection, scene_point (look, &set->sites[i], false));

    if (hypot (point.x - at_px[0], point.y - at_px[1]) <= SITE_REACH_PX)
      return TRUE;
  }
  return FALSE;
}

/* Where a click would put a site, in units of SiteSet.sites. */
static Site
site_under (Canvas *canvas, const double at_px[2])
{
  Session *session = canvas_get_session (canvas);
  const Projection projection = canvas_get_projection (canvas);
  const Point3 point = projection_unapply (&projection, at_px[0], at_px[1]);
  const Site given = site_edit_at (session, point);
  const int exponent = session_get_set (session)->exponent;

  return (Site){ ldexp (given.x, -exponent), ldexp (given.y, -exponent) };
}

static gboolean
is_pressed (void)
{
  const GdkModifierType buttons
      = GDK_BUTTON1_MASK | GDK_BUTTON2_MASK | GDK_BUTTON3_MASK;
  GdkModifierType state = 0;

  return gtk_get_current_event_state (&state) && (state & buttons) != 0;
}

static void
on_motion (GtkEventController *controller, double x, double y, Canvas *canvas)
{
  Session *session = canvas_get_session (canvas);
  const double at_px[2] = { x, y };
  Site site;

  (void)controller;
  if (is_pressed () || site_preview_is_on_site (canvas, at_px)
      || (session_get_look (session)->layers & LAYER_PREVIEW) == 0) {
    session_set_preview (session, NULL);
    return;
  }
  site = site_under (canvas, at_px);
  session_set_preview (session, &site);
}

/* The controller of GTK 3 does not tell of every way out. */
static gboolean
on_leave (GtkWidget *widget, GdkEventCrossing *event, gpointer user)
{
  (void)event;
  (void)user;
  session_set_preview (canvas_get_session (HULL2VD_CANVAS (widget)), NULL);
  return GDK_EVENT_PROPAGATE;
}

/* What is pressed is no longer a matter of a preview. */
static gboolean
on_button_press (GtkWidget *widget, GdkEventButton *event, gpointer user)
{
  (void)event;
  (void)user;
  session_set_preview (canvas_get_session (HULL2VD_CANVAS (widget)), NULL);
  return GDK_EVENT_PROPAGATE;
}

void
site_preview_attach (Canvas *canvas)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  GtkEventController *motion = gtk_event_controller_motion_new (widget);

  g_signal_connect (motion, "motion", G_CALLBACK (on_motion), canvas);
  g_signal_connect (widget, "leave-notify-event", G_CALLBACK (on_leave), NULL);
  g_signal_connect (widget, "button-press-event", G_CALLBACK (on_button_press),
                    NULL);
  g_object_set_data_full (G_OBJECT (canvas), "site-preview", motion,
                          g_object_unref);
}
