/* What a session is at a stop of its lesson, found by playing the lesson
 * once: whichever way a stop is reached, this is put in place. */
#ifndef STOP_STATE_H
#define STOP_STATE_H

#include "run.h"
#include "session.h"

G_BEGIN_DECLS

struct StopState {
  Run *run;
  guint step; /* of the lifts' trace */
  ExhibitKind exhibit_kind;
  guint exhibit_step; /* of another exhibit */
  Order other_order;  /* of two runs */
  gboolean compares_space;
  ExhibitTurn turn;
  SceneLook look;   /* without what the pointer makes of it */
  GArray *selected; /* what look.selected points to, or NULL */
  Views views;
  Listing listing;
  Camera camera;
  int told_theme; /* ThemeKind, or -1: the lesson tells none */
};

void stop_state_free (StopState *state);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (StopState, stop_state_free)

/* Plays @lesson once in a session of its own, fills the states and steps of
 * its stops, and finds the places of its questions. A command that cannot be
 * carried out, and a question that cannot be asked, is told to @faults. */
void lesson_fill_states (Lesson *lesson, LessonFaults *faults);

G_END_DECLS

#endif
