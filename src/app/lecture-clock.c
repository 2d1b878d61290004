#include "lecture-clock.h"

gboolean
lecture_clock_is_running (const LectureClock *clock)
{
  return clock->started != 0;
}

static gint64
elapsed (const LectureClock *clock)
{
  return clock->before
         + (clock->started != 0 ? g_get_monotonic_time () - clock->started : 0);
}

void
lecture_clock_set_running (LectureClock *clock, gboolean is_running)
{
  if (is_running == lecture_clock_is_running (clock))
    return;
  clock->before = elapsed (clock);
  clock->started = is_running ? g_get_monotonic_time () : 0;
}

void
lecture_clock_reset (LectureClock *clock)
{
  clock->before = 0;
  if (clock->started != 0)
    clock->started = g_get_monotonic_time ();
}

guint
lecture_clock_get_seconds (const LectureClock *clock)
{
  return (guint)(elapsed (clock) / G_USEC_PER_SEC);
}
