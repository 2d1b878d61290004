/* Replay: a lesson played without a screen, as a test of itself. */
#ifndef REPLAY_H
#define REPLAY_H

#include "lesson.h"

G_BEGIN_DECLS

typedef struct Replay {
  GString *report; /* TAP: one line for each expect */
  guint n_expects, n_failed;
} Replay;

/* How many failures are explained; the others are counted. */
#define REPLAY_MAX_EXPLAINED 20

Replay *replay_new (void);
void replay_free (Replay *replay);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Replay, replay_free)

/* Plays all stops of @lesson and adds a line for each expect, named
 * "lesson: stop: text".
 *
 * Returns: FALSE with @error set when a command cannot be carried out. */
gboolean replay_add (Replay *replay, Lesson *lesson, GError **error);

/* Adds the plan. */
void replay_end (Replay *replay);

G_END_DECLS

#endif
