#include "session-private.h"

#include "narration.h"
#include "why.h"

#include <glib/gi18n.h>
#include <math.h>

enum { SIGNAL_CHANGED, N_SIGNALS };

static guint signals[N_SIGNALS];

G_DEFINE_TYPE (Session, session, G_TYPE_OBJECT)

G_DEFINE_QUARK (session - error - quark, session_error)

static const char *const step_size_names[N_STEP_SIZES] = {
  [STEP_BEAT] = "beat",
  [STEP_PHASE] = "phase",
  [STEP_EVENT] = "event",
};

const char *
step_size_name (StepSize size)
{
  return step_size_names[size];
}

gboolean
step_size_parse (const char *name, StepSize *size)
{
  for (StepSize i = 0; i < N_STEP_SIZES; i++)
    if (g_str_equal (name, step_size_names[i])) {
      *size = i;
      return TRUE;
    }
  return FALSE;
}

static void
session_init (Session *session)
{
  session->run = run_new (NULL, 0, &(Order){ ORDER_FURTHEST, 0 });
  session->step = session->run->trace->n_events;
  session->history = history_new ();
  session->answers = g_array_new (FALSE, FALSE, sizeof (SceneAnswer));
  session_chores_init (session);
  session->speed = 1;
  session->other_order = (Order){ ORDER_INPUT, 0 };
  session->turn.node[0] = session->turn.node[1] = SIGN_MAP_SIDE / 2;
  session->look.layers = LAYERS_DEFAULT;
  session->look.focus = FOCUS_ACTIVE;
  session->look.raise = RAISE_DEFAULT;
  session->look.lift = 1;
  session->look.extent = site_set_extent (session->run->set);
  camera_init (&session->camera, CAMERA_HOME);
  plane_camera_init (&session->plane_camera);
  appearance_init (&session->appearance);
  appearance_init (&session->own);
  session->told_theme = THEME_UNTOLD;
}

static void
session_finalize (GObject *object)
{
  Session *session = HULL2VD_SESSION (object);

  g_clear_pointer (&session->frame, kept_frame_unref);
  exhibit_free (session->exhibit);
  session_renew_other (session);
  g_clear_pointer (&session->run, run_unref);
  g_clear_pointer (&session->drag_run, run_unref);
  g_clear_pointer (&session->history, history_free);
  session_question_forget (session);
  session_progress_end (session);
  g_array_unref (session->answers);
  session_chores_clear (session);
  session_forget_lost_stop (session);
  g_clear_pointer (&session->lesson, lesson_unref);
  g_clear_pointer (&session->selected, g_array_unref);
  G_OBJECT_CLASS (session_parent_class)->finalize (object);
}

static void
session_class_init (SessionClass *class)
{
  G_OBJECT_CLASS (class)->finalize = session_finalize;
  signals[SIGNAL_CHANGED]
      = g_signal_new ("changed", G_TYPE_FROM_CLASS (class), G_SIGNAL_RUN_LAST,
                      0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_UINT);
}

Session *
session_new (void)
{
  return g_object_new (SESSION_TYPE, NULL);
}

void
session_tell (Session *session, guint changes)
{
  session->changes |= changes;
  if (session->n_held > 0 || session->changes == 0)
    return;
  changes = session->changes;
  session->changes = 0;
  g_signal_emit (session, signals[SIGNAL_CHANGED], 0, changes);
}

void
session_hold (Session *session)
{
  session->n_held += 1;
}

void
session_release (Session *session)
{
  g_assert (session->n_held > 0);
  session->n_held -= 1;
  session_tell (session, 0);
}

void
session_put_run (Session *session, Run *run, guint step)
{
  const int shift = session->run->set->exponent - run->set->exponent;
  Extent *extent = &session->look.extent;

  session->look.has_preview = FALSE;
  /* What a thread works on follows from what was there. */
  session_cancel (session);
  g_clear_pointer (&session->frame, kept_frame_unref);
  run_unref (session->run);
  session->run = run;
  session->look.hues = run->hues;
  session->look.n_hues = run->set->n_sites;
  session->step = MIN (step, run->trace->n_events);
  session_renew_exhibit (session);
  /* The extent is in units of SiteSet.sites: keep it where it was. */
  extent->centre.x = ldexp (extent->centre.x, shift);
  extent->centre.y = ldexp (extent->centre.y, shift);
  extent->radius = ldexp (extent->radius, shift);
  session_question_refresh (session);
  session_question_follow_run (session);
  session_tell (session, CHANGED_SITES | CHANGED_STEP);
}

void
session_put_step (Session *session, guint step)
{
  step = MIN (step, session_get_n_steps (session));
  if (step == session_get_step (session))
    return;
  if (session->exhibit_kind > EXHIBIT_COMPARE) {
    session->exhibit_step = step;
  } else {
    g_clear_pointer (&session->frame, kept_frame_unref);
    session->step = step;
    session_question_refresh (session);
  }
  session_tell (session, CHANGED_STEP);
}

const SiteSet *
session_get_set (Session *session)
{
  return session->run->set;
}

const Trace *
session_get_trace (Session *session)
{
  return session->run->trace;
}

void
session_set_step (Session *session, guint step)
{
  const guint old_step = session_get_step (session);

  session_hold (session);
  session_put_step (session, MIN (step, session_last_step_allowed (session)));
  session_follow_step (session, old_step);
  session_release (session);
}

/* Returns: (transfer full): what a thread has made, if it is for this. */
static KeptFrame *
take_ready_frame (Session *session)
{
  const KeptFrame *ready = session->ready_frame;

  return ready != NULL && ready->frame.trace == session->run->trace
                 && ready->frame.step == session->step
             ? g_steal_pointer (&session->ready_frame)
             : NULL;
}

KeptFrame *
session_keep_frame (Session *session)
{
  if (session->frame != NULL)
    return session->frame;
  session->frame = take_ready_frame (session);
  if (session->frame == NULL)
    session->frame = kept_frame_new (session->run->trace, session->step);
  kept_frame_share (session->frame, session->run);
  return session->frame;
}

const Frame *
session_get_frame (Session *session)
{
  return &session_keep_frame (session)->frame;
}

StepSize
session_get_step_size (Session *session)
{
  return session->step_size;
}

void
session_set_step_size (Session *session, StepSize size)
{
  if (size == session->step_size)
    return;
  session->step_size = size;
  session_tell (session, CHANGED_PLAY);
}

static Grain
grain_of (StepSize size)
{
  switch (size) {
  case STEP_BEAT:
    return GRAIN_ROUND;
  case STEP_PHASE:
    return GRAIN_PHASE;
  case STEP_EVENT:
    return GRAIN_EVENT;
  }
  return GRAIN_EVENT;
}

static gboolean
goes_by_stops (Session *session)
{
  return session->step_size == STEP_BEAT && session->lesson != NULL;
}

/* Forwards from before a stop leads to that stop first. */
static guint
stop_after (Session *session)
{
  guint step;

  return session_get_stop_step (session, session->stop, &step)
                 && session_get_step (session) < step
             ? session->stop
             : session->stop + 1;
}

/* Backwards from what was looked at beyond a stop leads to that stop first;
 * the number before 0 is larger than any. */
static guint
stop_before (Session *session)
{
  guint step;

  return session_get_stop_step (session, session->stop, &step)
                 && session_get_step (session) <= step
             ? session->stop - 1
             : session->stop;
}

gboolean
session_can_next (Session *session)
{
  if (session_perform_can_next (session))
    return TRUE;
  return goes_by_stops (session)
             ? session_question_is_open (session)
                   || stop_after (session) < session_get_n_stops (session)
             : session_get_step (session) < session_get_n_steps (session);
}

gboolean
session_can_back (Session *session)
{
  if (session->step_size == STEP_BEAT && session_can_browse (session, FALSE))
    return TRUE;
  return goes_by_stops (session)
             ? stop_before (session) < session_get_n_stops (session)
             : session_get_step (session) > 0;
}

gboolean
session_next (Session *session)
{
  if (session_perform_next (session))
    return TRUE;
  if (goes_by_stops (session))
    return session_answer_then_go (session)
           || session_set_stop (session, stop_after (session));
  if (!session_can_next (session))
    return FALSE;
  session_set_step (
      session, session_step_after (session, grain_of (session->step_size)));
  return TRUE;
}

gboolean
session_back (Session *session)
{
  if (session_perform_back (session))
    return TRUE;
  if (goes_by_stops (session))
    return session_set_stop (session, stop_before (session));
  if (!session_can_back (session))
    return FALSE;
  session_set_step (
      session, session_step_before (session, grain_of (session->step_size)));
  return TRUE;
}

void
session_first (Session *session)
{
  session_hold (session);
  if (session->lesson != NULL)
    session_set_stop (session, 0);
  session_put_step (session, 0);
  session_release (session);
}

void
session_last (Session *session)
{
  session_hold (session);
  if (session->lesson != NULL)
    session_set_stop (session, session_get_n_stops (session) - 1);
  session_put_step (session, MIN (session_get_n_steps (session),
                                  session_last_step_allowed (session)));
  session_release (session);
}

gboolean
session_get_playing (Session *session)
{
  return session->is_playing;
}

void
session_set_playing (Session *session, gboolean playing)
{
  if (playing == session->is_playing)
    return;
  session_hold (session);
  session->is_playing = playing;
  if (playing && !session_can_next (session))
    session_first (session);
  session_tell (session, CHANGED_PLAY);
  session_release (session);
}

double
session_get_speed (Session *session)
{
  return session->speed;
}

void
session_set_speed (Session *session, double speed)
{
  /* A speed that is not a number is not taken. */
  if (!(speed == speed))
    return;
  speed = CLAMP (speed, SPEED_LEAST, SPEED_MOST);
  if (speed == session->speed)
    return;
  session->speed = speed;
  session_tell (session, CHANGED_PLAY);
}

guint
session_get_tick_ms (Session *session)
{
  static const double milliseconds[N_STEP_SIZES] = {
    [STEP_BEAT] = 3000,
    [STEP_PHASE] = 1500,
    [STEP_EVENT] = 600,
  };

  return (guint)(milliseconds[session->step_size] / session->speed);
}

void
session_tick (Session *session)
{
  if (!session->is_playing)
    return;
  session_hold (session);
  if (!session_next (session) || !session_can_next (session)
      || session_question_is_open (session))
    session_set_playing (session, FALSE);
  session_release (session);
}

static const char *
translate (const char *english)
{
  return _ (english);
}

char *
session_explain (Session *session)
{
  const SceneLook *look = &session->look;
  const Frame *frame = session_get_frame (session);
  char text[NARRATION_ROOM];

  if ((look->layers & LAYER_WHY) == 0 || (look->mask & MASK_WHY) != 0)
    return NULL;
  why_write (frame,
             why_find (frame, look->selection, look->hover, look->measured),
             translate, text);
  return text[0] == '\0' ? NULL : g_strdup (text);
}
