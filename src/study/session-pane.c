/* The two panes: what each of them shows. */
#include "session-private.h"

#include <glib/gi18n.h>

Pane
session_get_pane (Session *session, guint pane)
{
  switch (session->exhibit_kind) {
  case EXHIBIT_LIFTS:
    return pane == 0 ? PANE_PLANE : PANE_SPACE;
  case EXHIBIT_COMPARE:
    return session->compares_space ? PANE_SPACE : PANE_PLANE;
  case EXHIBIT_PLANAR:
    return pane == 0 ? PANE_PLANE : PANE_NONE;
  case EXHIBIT_SIGNS:
  case EXHIBIT_ROUNDED:
    return PANE_PLANE;
  }
  return PANE_NONE;
}

static char *
order_title (const Order *order)
{
  g_autofree char *seed = g_strdup_printf ("%" G_GUINT64_FORMAT, order->seed);

  switch (order->kind) {
  case ORDER_FURTHEST:
    return g_strdup (_ ("Order: furthest"));
  case ORDER_INPUT:
    return g_strdup (_ ("Order: input"));
  case ORDER_RANDOM:
    return g_strdup_printf (_ ("Order: random %s"), seed);
  case ORDER_SEEDED:
    return g_strdup (_ ("Order: seeded"));
  case ORDER_HILBERT:
    return g_strdup (_ ("Order: Hilbert curve"));
  }
  g_assert_not_reached ();
}

char *
session_get_pane_title (Session *session, guint pane)
{
  const Order orders[N_PANES]
      = { session->run->trace->order, session->other_order };

  switch (session->exhibit_kind) {
  case EXHIBIT_LIFTS:
    break;
  case EXHIBIT_COMPARE:
    return order_title (&orders[pane]);
  case EXHIBIT_PLANAR:
    return g_strdup (_ ("Hull in the plane"));
  case EXHIBIT_SIGNS:
    return g_strdup (pane == 0 ? _ ("Signs in plain doubles (demonstration)")
                               : _ ("True signs"));
  case EXHIBIT_ROUNDED:
    return g_strdup (pane == 0 ? _ ("Hull by plain doubles (demonstration)")
                               : _ ("True hull"));
  }
  return g_strdup (pane == 0 ? _ ("Plane") : _ ("Space"));
}

gboolean
session_pane_has_facets (Session *session, guint pane)
{
  return session_shows_lifts (session)
         && (pane == 0 || session->exhibit_kind == EXHIBIT_LIFTS);
}

/* Facets of the other run have other names: what is lit there are sites. */
static SceneLook
look_at_sites (const SceneLook *look)
{
  SceneLook result = *look;

  if (result.selection.kind != OBJECT_SITE)
    result.selection = (Object){ OBJECT_NONE, 0 };
  if (result.hover.kind != OBJECT_SITE)
    result.hover = (Object){ OBJECT_NONE, 0 };
  result.layers &= ~(guint)LAYER_WHY;
  result.has_preview = false;
  return result;
}

/* What a pane shows of the runs of the hull, and how. */
static KeptFrame *
frame_of_pane (Session *session, guint pane, SceneLook *look)
{
  if (session_pane_has_facets (session, pane))
    return session_keep_frame (session);
  *look = look_at_sites (look);
  return session_keep_other_frame (session);
}

Showing *
session_keep_showing (Session *session, guint pane, const SceneLook *look)
{
  SceneLook its_look = *look;
  KeptFrame *frame;

  if (!session_shows_lifts (session))
    return showing_new_exhibit (session_get_exhibit (session),
                                session->exhibit_step, pane, look);
  frame = frame_of_pane (session, pane, &its_look);
  return showing_new (frame, session->run,
                      session_get_pane (session, pane) == PANE_SPACE,
                      &its_look);
}

static void
fill_run (Session *session, guint pane, Scene *scene, const SceneLook *look)
{
  g_autoptr (Showing) showing = session_keep_showing (session, pane, look);

  showing_fill (showing, scene);
}

gboolean
session_relight_scene (Session *session,
                       guint pane,
                       Scene *scene,
                       const SceneLook *look)
{
  SceneLook its_look = *look;

  if ((session_get_pane (session, pane) == PANE_SPACE) != scene->is_space)
    return FALSE;
  if (!session_shows_lifts (session))
    return scene_relight (scene, NULL, look);
  return scene_relight (scene, &frame_of_pane (session, pane, &its_look)->frame,
                        &its_look);
}

void
session_fill_scene (Session *session,
                    guint pane,
                    Scene *scene,
                    const SceneLook *look)
{
  if (!session_shows_lifts (session))
    exhibit_scene (session_get_exhibit (session), session->exhibit_step, pane,
                   scene, look);
  else
    fill_run (session, pane, scene, look);
}

SiteState
session_get_site_state (Session *session, guint pane, guint site)
{
  const Frame *frame;

  if (session->exhibit_kind == EXHIBIT_PLANAR)
    return exhibit_planar_frame (session_get_exhibit (session),
                                 session->exhibit_step)
        ->sites[site]
        .state;
  frame = session_shows_lifts (session)
                  && !session_pane_has_facets (session, pane)
              ? session_get_other_frame (session)
              : session_get_frame (session);
  return site < frame->n_sites ? frame->sites[site].state : SITE_WAITING;
}

guint
session_get_apex (Session *session)
{
  const Frame *frame;
  const PlanarFrame *planar;

  if (session->exhibit_kind == EXHIBIT_PLANAR) {
    planar = exhibit_planar_frame (session_get_exhibit (session),
                                   session->exhibit_step);
    return planar->round == INDEX_NONE
               ? INDEX_NONE
               : planar->trace->rounds[planar->round].site;
  }
  if (session->exhibit_kind == EXHIBIT_ROUNDED) {
    const RoundedHull *hull = exhibit_rounded_hull (
        session_get_exhibit (session), session->exhibit_step);

    return hull->n_steps == 0 ? INDEX_NONE
                              : hull->steps[hull->n_steps - 1].site;
  }
  /* Two runs may have two current sites. */
  if (session->exhibit_kind != EXHIBIT_LIFTS)
    return INDEX_NONE;
  frame = session_get_frame (session);
  return frame->round == INDEX_NONE ? INDEX_NONE
                                    : frame->trace->rounds[frame->round].site;
}
