/* The inside of a session, for the files session*.c alone. */
#ifndef SESSION_PRIVATE_H
#define SESSION_PRIVATE_H

#include "history.h"
#include "kept-frame.h"
#include "run.h"
#include "session-work.h"
#include "session.h"
#include "stop-state.h"

G_BEGIN_DECLS

struct _Session {
  GObject parent_instance;

  Run *run;
  guint step;
  KeptFrame *frame; /* of run and step; NULL: not made yet */

  ExhibitKind exhibit_kind;
  Exhibit *exhibit; /* of the run; NULL: the lifts, or not made yet */
  guint exhibit_step;
  ExhibitTurn turn;

  Order other_order;       /* of EXHIBIT_COMPARE */
  Run *other;              /* NULL: not made yet */
  KeptFrame *other_frame;  /* NULL: not made yet */
  gboolean compares_space; /* else the plane */

  Views views;
  Listing listing;

  SceneLook look;
  GArray *selected; /* guint32: what look.selected points to */
  gboolean is_free; /* the mouse does not snap */
  Camera camera;
  PlaneCamera plane_camera;

  Appearance appearance; /* as it is shown */
  Appearance own;        /* as the person wants it */
  int told_theme;        /* by the lesson: ThemeKind, or THEME_UNTOLD */

  StepSize step_size;
  double speed;
  gboolean is_playing;

  History *history;
  gboolean is_dragging; /* between begin and end of an edit */
  gboolean has_dragged; /* the history holds this drag already */
  Run *drag_run;        /* as the drag began, with its step: a place lost */
  guint drag_step;      /* on the way is found again */

  Lesson *lesson;
  guint stop;
  GPtrArray *exercises; /* of Exercise, one for each stop; NULL: not begun */
  Exercise *another;    /* on other sites, in place of the stop's */
  guint64 another_seed;
  gboolean another_is_own; /* it is on a person's sites */
  GArray *answers;         /* of SceneAnswer: what the look shows */
  Lesson *sought;          /* whose stop a renewed lesson had not; NULL: none */
  guint sought_stop;       /* that stop */
  guint stop_instead;      /* where the session went */
  gboolean is_replaying;   /* a lesson's commands are carried out: no history,
                              and the stop does not follow the step */

  Progress *progress;       /* NULL: none is kept */
  const Lesson *keyed;      /* whose keys these are; to compare */
  char *lesson_key;         /* of progress */
  GPtrArray *question_keys; /* one for each stop; NULL: no question */
  gboolean has_moved;       /* from the first stop of it */
  guint noted_stop;
  gint64 noted; /* when progress was noted last, µs; 0: not in this lesson */

  guint n_sites_made; /* by a lesson's commands, all sets together */

  gboolean is_patient;     /* large sets are worked on in a thread */
  SessionWork *work;       /* that goes on; its task owns it */
  guint n_works, finished; /* numbers of the last one begun and finished */
  Run *ready;              /* that a thread has just made … */
  KeptFrame *ready_frame;  /* … and where it will be looked at */
  Run *ready_other;        /* the same of a run beside it */
  KeptFrame *ready_other_frame;
  Exhibit *ready_exhibit; /* of the run */
  gboolean is_deferred;   /* the edit that was asked for last */
  gboolean ends_later;    /* a drag, when its last run is there */

  GArray *chores; /* oldest first; inside of session-chore.c */
  guint n_chores; /* begun so far */

  guint n_held;  /* session_hold() that are not released */
  guint changes; /* told when the last one is */
};

/* Tells of changes, or gathers them while they are held. */
void session_tell (Session *session, guint changes);
void session_hold (Session *session);
void session_release (Session *session);

/* Puts another run in place, at @step. Takes @run. */
void session_put_run (Session *session, Run *run, guint step);
void session_put_step (Session *session, guint step);

/* The frames of the session and of the run beside it, which can be kept. */
KeptFrame *session_keep_frame (Session *session);
KeptFrame *session_keep_other_frame (Session *session);

/* The run has become another: so does the exhibit of it, at the same place. */
void session_renew_exhibit (Session *session);

/* Inside of session-chore.c. */
void session_chores_init (Session *session);
void session_chores_clear (Session *session);

/* Inside of session-compare.c. */
void session_renew_other (Session *session);

/* Takes the run that a thread has just made to be compared, if it is wanted. */
void session_take_ready_other (Session *session);

/* Whether a comparison is put off until a thread has made its runs. */
gboolean session_defer_compare (Session *session, const Order orders[2]);

/* The step of @other where @run is at @step. */
guint session_other_step_of (const Run *run, guint step, const Run *other);
void session_put_other_order (Session *session, const Order *order);
gboolean session_count_run (Session *session, const char *key, guint *count);
GPtrArray *session_compare_laws (Session *session);
void session_narrate_compare (Session *session,
                              NarrationTranslate translator,
                              char text[NARRATION_ROOM]);

/* Another turn or node of the sign map. */
void session_put_turn (Session *session, const ExhibitTurn *turn);

/* Shows another exhibit, or the lifts, at @step. */
void session_put_exhibit (Session *session, ExhibitKind kind, guint step);

/* Fits the extent to the sites; without @anyway only when they are not all
 * inside it. */
void session_fit_extent (Session *session, gboolean anyway);

/* Fits the plane to the sites when some are outside of it: nobody holds one
 * that would have to stay under the pointer. */
void session_show_all_sites (Session *session);

#define THEME_UNTOLD (-1)

/* The theme that a lesson tells, or THEME_UNTOLD. */
void session_tell_theme (Session *session, int theme);

/* Returns: what is shown at a stop: while its question is open, what comes
 *          before the answer. */
const StopState *session_state_of (Session *session, guint stop);

/* Returns: whether time is that of the trace. */
gboolean session_shows_lifts (Session *session);

/* To be called when the run, the step or the stop has changed. */
void session_question_refresh (Session *session);

/* Appends to Session.answers what the pictures show of a question. */
void session_find_answers (Session *session, const Exercise *exercise);
void session_question_follow_run (Session *session);
void session_question_follow_step (Session *session);

/* To be called when a drag has come to its end. */
void session_question_settle (Session *session);

/* Forgets all exercises: the lesson is another. */
void session_question_forget (Session *session);

/* Inside of session-progress.c: an exercise that has just begun is put where
 * it was left. */
void session_recall (Session *session, guint stop, Exercise *exercise);
void session_progress_end (Session *session);

/* Returns: the exercise of a stop, if it has begun. */
const Exercise *session_begun_exercise (Session *session, guint stop);

/* Returns: whether a question is open, and it is asked here. */
gboolean session_question_is_open (Session *session);

/* Shows the answer to an open question.
 *
 * Returns: FALSE: there is none. */
gboolean session_answer_then_go (Session *session);

/* Returns: the question as a whole; session_get_exercise() is the task of a
 *          performance. NULL: none. */
Exercise *session_question_whole (Session *session);

/* Returns: whether the run is one that questions put in place, not a
 *          person's. */
gboolean session_question_owns_run (Session *session, const Run *run);

/* Inside of session-perform.c. */
void session_show_task (Session *session);

/* Does what was chosen in a task that is closed.
 *
 * Returns: FALSE: there is no performance. */
gboolean session_settle_task (Session *session);
gboolean session_can_next_task (Session *session);
gboolean session_next_task (Session *session);
gboolean session_perform_can_next (Session *session);
gboolean session_perform_next (Session *session);
gboolean session_perform_back (Session *session);
gboolean session_can_perform_another (Session *session);
gboolean session_perform_another (Session *session);

/* The last step that may be shown: what comes after it would answer a
 * task. */
guint session_last_step_allowed (Session *session);

/* Returns: (transfer full): the coordinates as given. */
Site *session_copy_sites (Session *session);

/* session_replace_sites(), for the next sites of a question too. */
gboolean session_put_sites (Session *session,
                            const Site *sites,
                            guint n_sites,
                            const char *edit,
                            GError **error);

/* Puts other sites in place as the edit @edit, a noun; the place in time and
 * what is selected stay as far as they still exist. */
gboolean session_edit_sites (Session *session,
                             const Site *sites,
                             guint n_sites,
                             const char *edit,
                             GError **error);

/* Keeps of the selection only sites below @n_sites: all else is numbered
 * anew. */
void session_trim_selection (Session *session, guint n_sites);

/* Before @site goes: those after it move up. */
void session_forget_site (Session *session, guint site);

/* Lets the stop follow the step from @old_step. */
void session_follow_step (Session *session, guint old_step);

/* A stop that a renewed lesson had not is sought no longer. */
void session_forget_lost_stop (Session *session);

/* Inside of session-own-sites.c. */

/* What is shown before other sites may take its place. */
typedef struct OwnSites {
  Run *run;
  gboolean are_own;
} OwnSites;

OwnSites session_keep_own_sites (Session *session);

/* What was a person's, and is shown no longer, can be had back by undoing
 * @edit. Frees what @kept holds. */
void session_remember_own_sites (Session *session,
                                 const OwnSites *kept,
                                 const char *edit);

/* Takes the state as it is; free with stop_state_free(). */
StopState *session_get_state (Session *session);

/* Puts the state of a stop in place; a camera that a person has turned since
 * @from is kept unless the lesson turns it on the way. */
void session_put_state (Session *session,
                        const StopState *from,
                        const StopState *state);

/* Puts the views and the listing of a stop in place, but those that a person
 * has chosen since @from; @from NULL: all of them. */
void session_put_staging (Session *session,
                          const StopState *from,
                          const StopState *state);

/* Shows of the sites what a new session shows: nothing stays hidden because a
 * lesson has hidden it. */
void session_clear_staging (Session *session);

/* Remembers that a lesson's own sites took the place of others. */
void session_remember (Session *session, const Run *before, char *edit);

G_END_DECLS

#endif
