/* How long a lecture has been going on: a watch that can be stopped. */
#ifndef LECTURE_CLOCK_H
#define LECTURE_CLOCK_H

#include <glib.h>

G_BEGIN_DECLS

typedef struct LectureClock {
  gint64 started; /* monotonic µs; 0: it stands */
  gint64 before;  /* µs that it went before that */
} LectureClock;

gboolean lecture_clock_is_running (const LectureClock *clock);
void lecture_clock_set_running (LectureClock *clock, gboolean is_running);
void lecture_clock_reset (LectureClock *clock); /* and goes on, if it went */

/* Returns: whole seconds. */
guint lecture_clock_get_seconds (const LectureClock *clock);

G_END_DECLS

#endif
