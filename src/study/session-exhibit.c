/* What of the sites is shown, and the time in it. */
#include "session-private.h"

#include "laws.h"
#include "quantity.h"

#include <glib/gi18n.h>

static gboolean
shows_lifts (Session *session)
{
  return session->exhibit_kind == EXHIBIT_LIFTS;
}

ExhibitKind
session_get_exhibit_kind (Session *session)
{
  return session->exhibit_kind;
}

Exhibit *
session_get_exhibit (Session *session)
{
  if (session->exhibit == NULL && !shows_lifts (session))
    session->exhibit = exhibit_new (session->exhibit_kind, session->run);
  return session->exhibit;
}

static const Course *
get_course (Session *session)
{
  return exhibit_course (session_get_exhibit (session));
}

void
session_renew_exhibit (Session *session)
{
  Exhibit *before = session->exhibit;

  if (before == NULL)
    return;
  session->exhibit = NULL;
  session->exhibit_step = course_same_place (
      exhibit_course (before), session->exhibit_step, get_course (session));
  exhibit_free (before);
}

void
session_put_exhibit (Session *session, ExhibitKind kind, guint step)
{
  if (kind != session->exhibit_kind) {
    exhibit_free (session->exhibit);
    session->exhibit = NULL;
    session->exhibit_kind = kind;
    session_tell (session, CHANGED_EXHIBIT | CHANGED_SITES | CHANGED_STEP);
  }
  session_put_step (session, step);
}

void
session_set_exhibit_kind (Session *session, ExhibitKind kind)
{
  if (kind == session->exhibit_kind)
    return;
  session_hold (session);
  session_put_exhibit (session, kind,
                       kind == EXHIBIT_LIFTS ? session->step : G_MAXUINT);
  session_release (session);
}

/* Time */

guint
session_get_step (Session *session)
{
  return shows_lifts (session) ? session->step : session->exhibit_step;
}

guint
session_get_n_steps (Session *session)
{
  return shows_lifts (session) ? session->run->trace->n_events
                               : get_course (session)->n_steps;
}

Place
session_get_place (Session *session)
{
  return session_get_place_at (session, session_get_step (session));
}

Place
session_get_place_at (Session *session, guint step)
{
  return shows_lifts (session) ? timeline_place (session->run->trace, step)
                               : course_place (get_course (session), step);
}

guint
session_get_n_rounds (Session *session)
{
  const Course *course;

  if (shows_lifts (session))
    return session->run->trace->n_rounds;
  course = get_course (session);
  return course_place (course, course->n_steps).round;
}

guint
session_step_after (Session *session, Grain grain)
{
  return shows_lifts (session)
             ? timeline_next (session->run->trace, session->step, grain)
             : course_next (get_course (session), session->exhibit_step, grain);
}

guint
session_step_before (Session *session, Grain grain)
{
  return shows_lifts (session)
             ? timeline_back (session->run->trace, session->step, grain)
             : course_back (get_course (session), session->exhibit_step, grain);
}

gboolean
session_find_step (Session *session, Place place, gboolean before, guint *step)
{
  return shows_lifts (session)
             ? timeline_find (session->run->trace, place, before, step)
             : course_find (get_course (session), place, before, step);
}

/* Pictures */

Pane
session_get_pane (Session *session, guint pane)
{
  if (shows_lifts (session))
    return pane == 0 ? PANE_PLANE : PANE_SPACE;
  return pane == 0 ? PANE_PLANE : PANE_NONE;
}

char *
session_get_pane_title (Session *session, guint pane)
{
  if (session->exhibit_kind == EXHIBIT_PLANAR)
    return g_strdup (_ ("Hull in the plane"));
  return g_strdup (pane == 0 ? _ ("Plane") : _ ("Space"));
}

void
session_fill_scene (Session *session,
                    guint pane,
                    Scene *scene,
                    const SceneLook *look)
{
  if (!shows_lifts (session))
    exhibit_scene (session_get_exhibit (session), session->exhibit_step, scene,
                   look);
  else if (session_get_pane (session, pane) == PANE_SPACE)
    scene_space (scene, session_get_frame (session), look);
  else
    scene_plane (scene, session_get_frame (session), look);
}

SiteState
session_get_site_state (Session *session, guint site)
{
  const Frame *frame;

  if (session->exhibit_kind == EXHIBIT_PLANAR)
    return exhibit_planar_frame (session_get_exhibit (session),
                                 session->exhibit_step)
        ->sites[site]
        .state;
  frame = session_get_frame (session);
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
  frame = session_get_frame (session);
  return frame->round == INDEX_NONE ? INDEX_NONE
                                    : frame->trace->rounds[frame->round].site;
}

/* Words and numbers */

const PseudocodeLine *
session_get_lines (Session *session, guint *n_lines)
{
  return shows_lifts (session)
             ? listing_lines (session->listing, n_lines)
             : exhibit_lines (session_get_exhibit (session), n_lines);
}

const char *
session_get_listing_title (Session *session)
{
  return listing_title (shows_lifts (session) ? session->listing
                                              : LISTING_QUICKHULL);
}

guint
session_get_line (Session *session)
{
  return shows_lifts (session) ? listing_line (
             session->listing, session->run->trace, session->step)
                               : exhibit_line (session_get_exhibit (session),
                                               session->exhibit_step);
}

gboolean
session_count (Session *session, const char *key, guint *count)
{
  Quantity quantity;

  if (g_str_equal (key, "round"))
    *count = session_get_place (session).round;
  else if (g_str_equal (key, "step"))
    *count = session_get_step (session);
  else if (!shows_lifts (session)
           && exhibit_count (session_get_exhibit (session),
                             session->exhibit_step, key, count))
    return TRUE;
  else if (quantity_parse (key, &quantity))
    *count = quantity_value (session_get_frame (session), quantity);
  else
    return FALSE;
  return TRUE;
}

static char *
narrate (Session *session, NarrationTranslate translate)
{
  char text[NARRATION_ROOM];

  if (shows_lifts (session))
    narration_write (session->run->trace, session->step, translate, text);
  else
    exhibit_narrate (session_get_exhibit (session), session->exhibit_step,
                     translate, text);
  return g_strdup (text);
}

static const char *
translate (const char *english)
{
  return _ (english);
}

char *
session_narrate (Session *session)
{
  if (session_is_asking (session))
    return g_strdup (_ ("What happens here? Answer the question, or go on to "
                        "see."));
  return narrate (session, translate);
}

char *
session_narrate_in_english (Session *session)
{
  return narrate (session, NULL);
}

GPtrArray *
session_get_laws (Session *session)
{
  return shows_lifts (session) ? laws_of (session_get_frame (session))
                               : exhibit_laws (session_get_exhibit (session),
                                               session->exhibit_step);
}
