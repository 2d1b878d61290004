#include "step-motion.h"

#include "motion.h"

struct StepMotion {
  Motion motion;
  const Trace *trace; /* that was shown last, to compare alone */
  guint step, since;
};

StepMotion *
step_motion_new (Canvas *canvas)
{
  StepMotion *way = g_new0 (StepMotion, 1);

  motion_init (&way->motion, canvas);
  return way;
}

void
step_motion_free (StepMotion *way)
{
  motion_end (&way->motion);
  g_free (way);
}

/* Something grows only where a step leads on into horizon or cone; and not
 * when the next step comes before it could be seen. */
static gboolean
is_worth_it (StepMotion *way, Session *session)
{
  const Phase phase = session_get_place (session).phase;

  return way->trace == session_get_trace (session)
         && session_get_step (session) > way->step
         && (phase == PHASE_HORIZON || phase == PHASE_CONE)
         && !(session_get_playing (session)
              && session_get_tick_ms (session) < MOTION_MS)
         && motion_is_wanted (&way->motion);
}

static void
follow (StepMotion *way, Session *session)
{
  const guint step = session_get_step (session);

  if (step == way->step && session_get_trace (session) == way->trace)
    return;
  if (is_worth_it (way, session)) {
    way->since = way->step;
    motion_begin (&way->motion);
  } else {
    motion_end (&way->motion);
  }
  way->step = step;
  way->trace = session_get_trace (session);
}

void
step_motion_apply (StepMotion *way, SceneLook *look)
{
  follow (way, canvas_get_session (way->motion.canvas));
  look->moving = 1 - way->motion.part;
  look->since = way->since;
}
