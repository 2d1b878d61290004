/* What of the sites is shown, and the time in it. */
#include "session-private.h"

#include "laws.h"
#include "quantity.h"

#include <glib/gi18n.h>

gboolean
session_shows_lifts (Session *session)
{
  return session->exhibit_kind <= EXHIBIT_COMPARE;
}

ExhibitKind
session_get_exhibit_kind (Session *session)
{
  return session->exhibit_kind;
}

/* Returns: (transfer full): what a thread has made, if it is for this. */
static Exhibit *
take_ready_exhibit (Session *session)
{
  const Exhibit *ready = session->ready_exhibit;

  return ready != NULL && exhibit_kind (ready) == session->exhibit_kind
                 && exhibit_run (ready) == session->run
             ? g_steal_pointer (&session->ready_exhibit)
             : NULL;
}

Exhibit *
session_get_exhibit (Session *session)
{
  if (session->exhibit == NULL && !session_shows_lifts (session))
    session->exhibit = take_ready_exhibit (session);
  if (session->exhibit == NULL && !session_shows_lifts (session))
    session->exhibit
        = exhibit_new (session->exhibit_kind, session->run, &session->turn);
  return session->exhibit;
}

#define LAYERS_OF_SPACE (LAYER_HULL | LAYER_PARABOLOID | LAYER_LIFTS)

guint
session_get_usable_layers (Session *session)
{
  switch (session->exhibit_kind) {
  case EXHIBIT_LIFTS:
    return (guint)LAYERS_ALL;
  case EXHIBIT_COMPARE:
    return session->compares_space ? (guint)LAYERS_ALL
                                   : (guint)(LAYERS_ALL & ~LAYERS_OF_SPACE);
  case EXHIBIT_PLANAR:
  case EXHIBIT_ROUNDED:
    return LAYER_LABELS;
  case EXHIBIT_SIGNS:
    return 0;
  }
  return 0;
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

  session_renew_other (session);
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

/* The record of many sites in the plane is a thread's work. */
static gboolean
defer_planar (Session *session)
{
  g_autofree Site *sites = NULL;
  Edit edit = { .kind = EDIT_PLANAR,
                .n_sites = session->run->set->n_sites,
                .order = session->run->trace->order };

  if (session->ready_exhibit != NULL)
    return FALSE;
  sites = run_given (session->run);
  edit.sites = sites;
  return session_defer (session, &edit);
}

void
session_set_exhibit_kind (Session *session, ExhibitKind kind)
{
  const Order orders[2] = { session->run->trace->order, session->other_order };

  if (kind == session->exhibit_kind)
    return;
  if (kind == EXHIBIT_COMPARE && session_defer_compare (session, orders))
    return;
  if (kind == EXHIBIT_PLANAR && defer_planar (session))
    return;
  session_hold (session);
  session_put_exhibit (session, kind,
                       kind <= EXHIBIT_COMPARE ? session->step : G_MAXUINT);
  session_release (session);
}

const ExhibitTurn *
session_get_turn (Session *session)
{
  return &session->turn;
}

static gboolean
is_same_turn (const ExhibitTurn *a, const ExhibitTurn *b)
{
  return a->is_named == b->is_named
         && (!a->is_named
             || (a->sites[0] == b->sites[0] && a->sites[1] == b->sites[1]
                 && a->sites[2] == b->sites[2]));
}

void
session_put_turn (Session *session, const ExhibitTurn *turn)
{
  const gboolean is_same = is_same_turn (&session->turn, turn);

  session->turn = *turn;
  if (session->exhibit_kind != EXHIBIT_SIGNS)
    return;
  if (!is_same) {
    exhibit_free (session->exhibit);
    session->exhibit = NULL;
  } else if (session->exhibit != NULL) {
    exhibit_set_node (session->exhibit, turn->node);
  }
  session_tell (session, CHANGED_STEP);
}

void
session_set_turn (Session *session, const ExhibitTurn *turn)
{
  session_put_turn (session, turn);
}

/* Time */

guint
session_get_step (Session *session)
{
  return session_shows_lifts (session) ? session->step : session->exhibit_step;
}

guint
session_get_n_steps (Session *session)
{
  return session_shows_lifts (session) ? session->run->trace->n_events
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
  return session_shows_lifts (session)
             ? timeline_place (session->run->trace, step)
             : course_place (get_course (session), step);
}

guint
session_get_n_rounds (Session *session)
{
  const Course *course;

  if (session_shows_lifts (session))
    return session->run->trace->n_rounds;
  course = get_course (session);
  return course_place (course, course->n_steps).round;
}

static gboolean
retires (const Trace *trace, guint step)
{
  return step > 0 && trace_event (trace, step - 1).kind == EVENT_RETIRE;
}

gboolean
session_is_retiring (Session *session)
{
  const guint step = session_get_step (session);
  const PlanarFrame *planar;

  if (session_get_exhibit_kind (session) == EXHIBIT_PLANAR && step > 0) {
    planar = exhibit_planar_frame (session_get_exhibit (session), step);
    return planar->trace->events[step - 1].kind == PLANAR_RETIRE;
  }
  return session_shows_lifts (session) && retires (session->run->trace, step)
         && (session->exhibit_kind != EXHIBIT_COMPARE
             || retires (session_get_other_trace (session),
                         session_get_other_step (session)));
}

guint
session_step_after (Session *session, Grain grain)
{
  return session_shows_lifts (session)
             ? timeline_next (session->run->trace, session->step, grain)
             : course_next (get_course (session), session->exhibit_step, grain);
}

guint
session_step_before (Session *session, Grain grain)
{
  return session_shows_lifts (session)
             ? timeline_back (session->run->trace, session->step, grain)
             : course_back (get_course (session), session->exhibit_step, grain);
}

gboolean
session_find_step (Session *session, Place place, gboolean before, guint *step)
{
  return session_shows_lifts (session)
             ? timeline_find (session->run->trace, place, before, step)
             : course_find (get_course (session), place, before, step);
}

/* Words and numbers */

const PseudocodeLine *
session_get_lines (Session *session, guint *n_lines)
{
  return session_shows_lifts (session)
             ? listing_lines (session->listing, n_lines)
             : exhibit_lines (session_get_exhibit (session), n_lines);
}

const char *
session_get_listing_title (Session *session)
{
  return session_shows_lifts (session)
             ? listing_title (session->listing)
             : exhibit_listing_title (session_get_exhibit (session));
}

static guint
run_line (Session *session, const Trace *trace, guint step)
{
  return listing_line (session->listing, trace, step);
}

/* A phase may have two lines. Of two runs in one phase the one that is further
 * says where both have come to. */
static guint
compared_line (Session *session)
{
  const Trace *trace = session->run->trace;
  const Trace *other = session_get_other_trace (session);
  const guint step = session->step;
  const guint other_step = session_get_other_step (session);
  const guint line = run_line (session, trace, step);
  const guint other_line = run_line (session, other, other_step);

  return timeline_place (trace, step).phase
                     == timeline_place (other, other_step).phase
                 && line != INDEX_NONE && other_line != INDEX_NONE
             ? MAX (line, other_line)
             : line;
}

guint
session_get_line (Session *session)
{
  if (session->exhibit_kind == EXHIBIT_COMPARE)
    return compared_line (session);
  return session_shows_lifts (session)
             ? run_line (session, session->run->trace, session->step)
             : exhibit_line (session_get_exhibit (session),
                             session->exhibit_step);
}

gboolean
session_count (Session *session, const char *key, guint *count)
{
  Quantity quantity;

  if (session_shows_lifts (session) && session_count_run (session, key, count))
    return TRUE;
  if (g_str_equal (key, "round"))
    *count = session_get_place (session).round;
  else if (g_str_equal (key, "step"))
    *count = session_get_step (session);
  else if (!session_shows_lifts (session)
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

  if (session->exhibit_kind == EXHIBIT_COMPARE)
    session_narrate_compare (session, translate, text);
  else if (session_shows_lifts (session))
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
  if (session->exhibit_kind == EXHIBIT_COMPARE)
    return session_compare_laws (session);
  return session_shows_lifts (session)
             ? laws_of (session_get_frame (session))
             : exhibit_laws (session_get_exhibit (session),
                             session->exhibit_step);
}
