#include "step-motion.h"

#include "motion.h"

struct StepMotion {
  Canvas *canvas;
  const Trace *trace; /* that was shown last, to compare alone */
  guint step, since;
  double part; /* of the way; 1: there */
  gint64 start_us;
  guint n_skips;
  guint tick;
};

StepMotion *
step_motion_new (Canvas *canvas)
{
  StepMotion *motion = g_new0 (StepMotion, 1);

  motion->canvas = canvas;
  motion->part = 1;
  return motion;
}

static void
stop (StepMotion *motion)
{
  motion->part = 1;
  if (motion->tick != 0)
    gtk_widget_remove_tick_callback (GTK_WIDGET (motion->canvas), motion->tick);
  motion->tick = 0;
}

void
step_motion_free (StepMotion *motion)
{
  stop (motion);
  g_free (motion);
}

static gboolean
on_tick (GtkWidget *widget, GdkFrameClock *clock, gpointer user)
{
  StepMotion *motion = user;
  const gint64 now_us = gdk_frame_clock_get_frame_time (clock);

  (void)widget;
  if (motion->start_us == 0)
    motion->start_us = now_us;
  motion->part = motion_part (now_us - motion->start_us);
  if (motion->n_skips != motion_n_skips ())
    motion->part = 1;
  canvas_invalidate (motion->canvas);
  if (motion->part < 1)
    return G_SOURCE_CONTINUE;
  motion->tick = 0;
  return G_SOURCE_REMOVE;
}

/* Something grows only where a step leads on into horizon or cone; and not
 * when the next step comes before it could be seen. */
static gboolean
is_worth_it (StepMotion *motion, Session *session)
{
  const Phase phase = session_get_place (session).phase;

  return motion->trace == session_get_trace (session)
         && session_get_step (session) > motion->step
         && (phase == PHASE_HORIZON || phase == PHASE_CONE)
         && !(session_get_playing (session)
              && session_get_tick_ms (session) < MOTION_MS)
         && motion_is_wanted (GTK_WIDGET (motion->canvas));
}

static void
follow (StepMotion *motion, Session *session)
{
  const guint step = session_get_step (session);

  if (step == motion->step && session_get_trace (session) == motion->trace)
    return;
  stop (motion);
  if (is_worth_it (motion, session)) {
    motion->since = motion->step;
    motion->part = 0;
    motion->start_us = 0;
    motion->n_skips = motion_n_skips ();
    motion->tick = gtk_widget_add_tick_callback (GTK_WIDGET (motion->canvas),
                                                 on_tick, motion, NULL);
  }
  motion->step = step;
  motion->trace = session_get_trace (session);
}

void
step_motion_apply (StepMotion *motion, SceneLook *look)
{
  follow (motion, canvas_get_session (motion->canvas));
  look->moving = 1 - motion->part;
  look->since = motion->since;
}
