/* The session: the only owner of mutable state. Views, panels and lessons
 * read it and ask it to change; it says what has changed in one signal.
 *
 *   g_signal_connect (session, "changed", G_CALLBACK (on_changed), widget);
 *   static void on_changed (Session *session, guint changes, gpointer user);
 *
 * An edit makes a new SiteSet and a new trace; the step stays at the same
 * place of the timeline where that place still exists.
 *
 * What a getter returns is borrowed, and good until the next change.
 */
#ifndef SESSION_H
#define SESSION_H

#include "appearance.h"
#include "exercise.h"
#include "exhibit.h"
#include "insertion-cost.h"
#include "lesson.h"
#include "listing.h"
#include "performance.h"
#include "progress.h"
#include "scene.h"
#include "showing.h"

#include <gio/gio.h>

G_BEGIN_DECLS

typedef enum SessionChange {
  CHANGED_SITES = 1 << 0,      /* set and trace are new; frame too */
  CHANGED_STEP = 1 << 1,       /* frame is new */
  CHANGED_LOOK = 1 << 2,       /* layers, focus, selection, hover, extent */
  CHANGED_CAMERA = 1 << 3,     /* of either view */
  CHANGED_LESSON = 1 << 4,     /* another lesson, or another stop */
  CHANGED_HISTORY = 1 << 5,    /* what can be undone */
  CHANGED_PLAY = 1 << 6,       /* playing, speed, step size */
  CHANGED_APPEARANCE = 1 << 7, /* theme and sizes */
  CHANGED_QUESTION = 1 << 8,   /* what is answered, and how right it is; another
                                  question is CHANGED_LESSON */
  CHANGED_EXHIBIT = 1 << 9,  /* what is shown of the sites; then sites and step
                                are said to have changed as well */
  CHANGED_WORK = 1 << 10,    /* a thread is at work, or no longer */
  CHANGED_STAGING = 1 << 11, /* which pictures, which listing */
} SessionChange;

/* What "next" means. */
typedef enum StepSize {
  STEP_BEAT, /* the next stop of the lesson; without one, a round */
  STEP_PHASE,
  STEP_EVENT,
} StepSize;

#define N_STEP_SIZES (STEP_EVENT + 1)

const char *step_size_name (StepSize size); /* "beat", "phase", "event" */
gboolean step_size_parse (const char *name, StepSize *size);

#define SESSION_TYPE (session_get_type ())
G_DECLARE_FINAL_TYPE (Session, session, HULL2VD, SESSION, GObject)

Session *session_new (void);

#define SESSION_ERROR (session_error_quark ())
GQuark session_error_quark (void);
typedef enum SessionError {
  SESSION_ERROR_SITE,  /* there is no such site */
  SESSION_ERROR_RANGE, /* no exact scaling fits the coordinates */
  SESSION_ERROR_ASKED, /* a question is asked about the sites as they are */
} SessionError;

/* Sites. All edits can be undone and redone. Coordinates are those that are
 * given, not SiteSet.sites, which may be scaled by a power of two. */
const SiteSet *session_get_set (Session *session);
const Trace *session_get_trace (Session *session);

/* Which site comes next: QuickHull's furthest to begin with. Edits keep the
 * order. */
Order session_get_order (Session *session);
void session_set_order (Session *session, const Order *order);

/* All that follow but session_open_sites() are refused while a question is
 * asked about the sites; a performance ends by them.
 *
 * Returns: FALSE with @error set while that is so. */
gboolean session_can_edit (Session *session, GError **error);

/* Replaces all sites, fits the views and goes to the last step. */
gboolean session_set_sites (Session *session,
                            const Site *sites,
                            guint n_sites,
                            GError **error);
/* The same, with a name of its own for undo: "paste", translated. */
gboolean session_replace_sites (Session *session,
                                const Site *sites,
                                guint n_sites,
                                const char *edit,
                                GError **error);

/* The same, and no lesson any more: a file of points. */
gboolean session_open_sites (Session *session,
                             const Site *sites,
                             guint n_sites,
                             const char *edit,
                             GError **error);
gboolean session_add_site (Session *session, Site site, GError **error);
gboolean
session_move_site (Session *session, guint site, Site to, GError **error);
gboolean session_remove_site (Session *session, guint site, GError **error);

/* Moves the selected site @lead there, and the other selected ones by as
 * much. */
gboolean
session_move_selected (Session *session, guint lead, Site to, GError **error);
gboolean session_remove_selected (Session *session, GError **error);

/* Moves between begin and end are one edit for undo (a drag). */
void session_begin_edit (Session *session);
void session_end_edit (Session *session);
/* Ends it as if it had not been; it cannot be redone. */
void session_cancel_edit (Session *session);

gboolean session_undo (Session *session);
gboolean session_redo (Session *session);

/* Returns: "Undo move of s3", translated, or NULL: nothing to undo. */
const char *session_get_undo_label (Session *session);
const char *session_get_redo_label (Session *session);

/* Whether the mouse puts sites on a grid that can be seen; else on one finer
 * than pixels. */
gboolean session_get_snaps (Session *session);
void session_set_snaps (Session *session, gboolean snaps);

/* Sets of more sites than this take longer than a person wants to wait. In a
 * session that is patient a thread makes their hull: an edit returns TRUE at
 * once, the session stays as it was, and the edit follows when the hull is
 * there. It needs a main loop. Another edit gives the work up, and so does
 * session_cancel(); a drag goes on to the last place that was asked for. */
#define SESSION_AT_ONCE 2000

void session_set_patient (Session *session, gboolean patient);
void session_cancel (Session *session);

/* Returns: whether a thread is at work, and in *@part how much is done, 0 … 1.
 */
gboolean session_is_working (Session *session, double *part);
guint session_get_work (Session *session); /* its number; 0: none */
gboolean session_has_finished (Session *session, guint work);
guint session_get_n_awaited (Session *session); /* sites that it works on */

/* Gives up all that threads work on, chores and the hull.
 *
 * Returns: FALSE: nothing is worked on. */
gboolean session_give_up (Session *session);

/* Puts a point of the plane, as scene_site() gives it, on the snap grid:
 * coordinates with few digits, on a power-of-two grid that is fine enough for
 * the extent and the zoom.
 *
 * Returns: the grid point, as a coordinate for session_add_site() and
 *          session_move_site(). */
Site session_snap (Session *session, Site point);

/* Returns: the distance of neighbours on the snap grid, as given. */
double session_get_grid (Session *session);

/* Time. */
guint session_get_step (Session *session);
guint session_get_n_steps (Session *session); /* the last step */
void session_set_step (Session *session, guint step);
const Frame *session_get_frame (Session *session);
Place session_get_place (Session *session);
Place session_get_place_at (Session *session, guint step);
guint session_get_n_rounds (Session *session);
gboolean session_is_retiring (Session *session); /* begins a hand over */
StepSize session_get_step_size (Session *session);
void session_set_step_size (Session *session, StepSize size);

/* Steps by @grain; the last step (step 0) when there is none. */
guint session_step_after (Session *session, Grain grain);
guint session_step_before (Session *session, Grain grain);

/* As timeline_find(), of what is shown. */
gboolean
session_find_step (Session *session, Place place, gboolean before, guint *step);

/* Steps by the step size.
 *
 * Returns: FALSE at the end (the start). */
gboolean session_next (Session *session);
gboolean session_back (Session *session);
gboolean session_can_next (Session *session);
gboolean session_can_back (Session *session);

/* The very start and end; in a lesson, with its first and last stop. */
void session_first (Session *session);
void session_last (Session *session);

/* Playing is next, again and again; the window's clock calls
 * session_tick(). Starting at the end begins anew. */
gboolean session_get_playing (Session *session);
void session_set_playing (Session *session, gboolean playing);
double session_get_speed (Session *session); /* 1: a phase in 1.5 s */
void session_set_speed (Session *session, double speed);
guint session_get_tick_ms (Session *session); /* until the next tick */
void session_tick (Session *session);         /* stops playing at the end */

#define SPEED_LEAST 0.25
#define SPEED_MOST 8.0

/* What is shown: the hull of the lifts, or another exhibit of the same sites.
 * Time, sentence and place are those of what is shown; the trace and the
 * frame stay those of the lifts, at the step where they were left. Another
 * exhibit begins at its end. */
ExhibitKind session_get_exhibit_kind (Session *session);
void session_set_exhibit_kind (Session *session, ExhibitKind kind);
Exhibit *session_get_exhibit (Session *session); /* NULL: the lifts */

/* Which pictures there are, and which listing the code panel shows. */
Views session_get_views (Session *session);
void session_set_views (Session *session, Views views);
Listing session_get_listing (Session *session);
void session_set_listing (Session *session, Listing listing);

/* Returns: the layers that what is shown has, whether they are on or off; those
 *          of planes alone, for one, have no hull in space. */
guint session_get_usable_layers (Session *session);

/* Two runs of the same sites in two orders, in step by round: the session's
 * own, on the left, and another one. */
void session_compare (Session *session, const Order orders[2]);
Order session_get_other_order (Session *session);
const Trace *session_get_other_trace (Session *session);
guint session_get_other_step (Session *session);
const Frame *session_get_other_frame (Session *session);
InsertionCost session_get_cost (Session *session, guint pane);

/* Whether space is compared, not the plane. */
gboolean session_get_compares_space (Session *session);
void session_set_compares_space (Session *session, gboolean space);

/* Returns: (transfer full): the sentence of one of the two runs. */
char *session_narrate_pane (Session *session, guint pane);

/* Returns: the current site of one of the two runs, or INDEX_NONE. */
guint session_get_pane_apex (Session *session, guint pane);

/* Returns: (transfer full): "random 7", as lessons write it. */
char *session_order_name (const Order *order);

/* The turn whose signs are shown. */
const ExhibitTurn *session_get_turn (Session *session);
void session_set_turn (Session *session, const ExhibitTurn *turn);

/* The two pictures, 0 on the left and 1 on the right. */
typedef enum Pane {
  PANE_NONE,
  PANE_PLANE,
  PANE_SPACE,
} Pane;

#define N_PANES 2

Pane session_get_pane (Session *session, guint pane);

/* Returns: (transfer full): what it shows: "Plane". */
char *session_get_pane_title (Session *session, guint pane);

/* Fills @scene with what a picture shows, for @look, which is the session's
 * with the rectangle that the picture shows. */
void session_fill_scene (Session *session,
                         guint pane,
                         Scene *scene,
                         const SceneLook *look);

/* The same for later: what a picture shows now.
 *
 * Returns: (transfer full): it belongs to no session. */
Showing *
session_keep_showing (Session *session, guint pane, const SceneLook *look);

/* Whether what is shown can be kept, and there are so many sites that pictures
 * of it take longer than the main loop of a patient session should wait.
 *
 * @is_heavy: it has much else to do for them. */
gboolean session_is_large (Session *session, gboolean is_heavy);

/* Brings a scene that the session has filled to another look: scene_relight().
 * Nothing but the look has changed since then.
 *
 * Returns: FALSE, and nothing has changed, when it has to be filled anew. */
gboolean session_relight_scene (Session *session,
                                guint pane,
                                Scene *scene,
                                const SceneLook *look);

/* Returns: what a site is at the step of what a picture shows. */
SiteState session_get_site_state (Session *session, guint pane, guint site);

/* Returns: whether a picture shows facets by the names of the trace. */
gboolean session_pane_has_facets (Session *session, guint pane);

/* Returns: the site of the current round or of the last one, or INDEX_NONE. */
guint session_get_apex (Session *session);

/* The listing, its heading, and its line at the step: INDEX_NONE for none. */
const PseudocodeLine *session_get_lines (Session *session, guint *n_lines);
const char *session_get_listing_title (Session *session);
guint session_get_line (Session *session);

/* The number that expect calls @key: of what is shown; else of the lifts.
 *
 * Returns: FALSE: there is no such number now. */
gboolean session_count (Session *session, const char *key, guint *count);

/* The look. Its extent is kept while sites are moved, and while they are
 * added inside it; session_fit() and new sites fit it. */
const SceneLook *session_get_look (Session *session);
void session_set_layers (Session *session, guint layers);
void session_set_focus (Session *session, Focus focus);
void session_set_selection (Session *session, Object object);

/* Several sites may be selected; SceneLook.selection is one of them.
 *
 * Shape: by number, each once. */
const guint32 *session_get_selected_sites (Session *session, guint *n_sites);
gboolean session_is_selected (Session *session, guint site);
void session_select_sites (Session *session, const guint32 *sites, guint n);
void session_toggle_site (Session *session, guint site);
void session_set_hover (Session *session, Object object);
/* Values beyond their range are brought into it. */
void session_set_lift (Session *session, double lift);   /* 0 … 1 */
void session_set_raise (Session *session, double raise); /* 0 … RAISE_MOST */
void session_set_body_opacity (Session *session, Body body, double opacity);
void session_set_role_opacity (Session *session, Role role, double opacity);
/* Sites on the paraboloid, the paraboloid where it was, all opaque. */
void session_reset_look (Session *session);
void session_set_measured (Session *session, Object site);
/* Where a site would be added, in units of SiteSet.sites; NULL: nowhere. */
void session_set_preview (Session *session, const Site *preview);
const Camera *session_get_camera (Session *session);
void session_set_camera (Session *session, const Camera *camera);
const PlaneCamera *session_get_plane_camera (Session *session);
void session_set_plane_camera (Session *session, const PlaneCamera *camera);

/* The theme and the sizes. Those of the person are kept from lesson to lesson;
 * a theme that a lesson asks for is shown in its stead until the lesson asks
 * for another or ends, or the person chooses one. */
const Appearance *session_get_appearance (Session *session);
const Appearance *session_get_own_appearance (Session *session);
void session_set_own_appearance (Session *session,
                                 const Appearance *appearance);

/* Chooses a theme: the lesson does while its commands are carried out, else
 * the person. */
void session_set_theme (Session *session, ThemeKind theme);

/* Fits both views to the sites; the turn of the space view is kept. */
void session_fit (Session *session);

/* The lesson. A stop's sites, step, layers, focus and selection are those of
 * the lesson played from its start, whichever way the stop was reached; a
 * camera that a person has turned is kept until the lesson turns it.
 *
 * While the sites are the lesson's, the stop follows the step: stepping or
 * scrubbing past a stop enters it. Who leaves it for no lesson finds all that
 * a new session shows. */
void session_set_lesson (Session *session, Lesson *lesson); /* or NULL */
Lesson *session_get_lesson (Session *session);              /* NULL: none */

/* Puts a lesson in place of another form of it, which its author has just
 * changed: the stop and both cameras are kept, the stop by its title where
 * that still exists. */
void session_renew_lesson (Session *session, Lesson *lesson);
guint session_get_n_stops (Session *session); /* 0: no lesson */
guint session_get_stop (Session *session);    /* index; 0 the first */
gboolean session_set_stop (Session *session, guint stop);

/* Returns: FALSE when @stop stands on other sites than those shown; else
 *          TRUE with its step, for a mark on the timeline. */
gboolean session_get_stop_step (Session *session, guint stop, guint *step);

/* The question of the stop. It is asked before its event; whoever has not
 * answered it is shown the answer by the next "next", and goes on with the one
 * after that, so that no question holds a class up. Stepping past the event
 * shows the answer too. */
const Exercise *session_get_exercise (Session *session); /* NULL: none */

/* That of any stop: NULL when it asks nothing. */
const Exercise *session_get_exercise_of (Session *session, guint stop);

/* Returns: whether the answer must not be told: a question is open, and the
 *          pictures show what it asks about. */
gboolean session_is_asking (Session *session);

/* Returns: whether a click on an object means an answer now. */
gboolean session_is_answering (Session *session);

/* Each returns: FALSE: nothing to do. */
gboolean session_answer_toggle (Session *session, Object object);
gboolean session_answer_number (Session *session, guint index, gint64 number);
gboolean session_answer_undo (Session *session);
gboolean session_hint (Session *session);
gboolean session_can_check (Session *session); /* something is answered */
gboolean session_check (Session *session);
gboolean session_reveal (Session *session); /* shows the answer */
gboolean session_retry (Session *session);  /* asks it anew */
gboolean session_can_continue (Session *session);
gboolean session_continue (Session *session); /* to the next stop */

/* The same question about other sites, that a seed gives. */
gboolean session_can_another (Session *session);
gboolean session_another (Session *session);

/* You be QuickHull: performance.h. While it lasts the exercise is its current
 * task, and nothing beyond that can be shown; when it is over, the task that
 * is looked at. */
const Performance *session_get_performance (Session *session); /* or NULL */

/* Performs on the sites as they are, @source "", or on those of a source with
 * a seed; a lesson waits until that is left. An edit ends it.
 *
 * Errors: ACTION_ERROR_PARAMETER, SESSION_ERROR_SITE. */
gboolean session_perform (Session *session, const char *source, GError **error);

/* Each returns: FALSE: nothing to do. */
gboolean session_can_grade (Session *session);
gboolean session_grade (Session *session); /* gives up what is left to do */
gboolean session_can_browse (Session *session, gboolean forwards);
gboolean session_browse (Session *session, gboolean forwards);
gboolean session_can_end_performance (Session *session); /* not a stop's */
gboolean session_end_performance (Session *session);

/* Returns: (transfer full): the source of the sites that a seed has given, to
 *          have them again; "": the sites are others. */
char *session_performance_sites (Session *session);

/* What the person has done in lessons, if it is to be kept: from then on the
 * session writes down what happens, and questions that were answered another
 * time are answered. Whoever owns the file writes it. */
void session_set_progress (Session *session, Progress *progress);
Progress *session_get_progress (Session *session); /* NULL: none is kept */

/* That of the lesson, and of the question of a stop; NULL: there is none. */
const LessonRecord *session_get_record (Session *session);
const QuestionRecord *session_get_record_of (Session *session, guint stop);

/* Whether the person was further on another time, and has not gone anywhere
 * yet; then session_resume() goes there. */
gboolean session_can_resume (Session *session, guint *stop);
gboolean session_resume (Session *session);

/* Forgets all progress; its questions are open again.
 *
 * Returns: (transfer full): where the file of it is kept, or NULL. */
char *session_clear_progress (Session *session);

/* Carries out the commands of one stop, from the state of the stop before
 * it, and checks its expectations; replay is this for every stop.
 *
 * Returns: FALSE with @error set (FILE:LINE: reason) when a command cannot
 *          be carried out. */
typedef void (*SessionExpect) (const LessonCommand *command,
                               gboolean holds,
                               const char *actual,
                               gpointer user);
gboolean session_play_stop (Session *session,
                            guint stop,
                            SessionExpect on_expect,
                            gpointer user,
                            GError **error);

/* The sentence for the step, translated; free with g_free(). */
char *session_narrate (Session *session);
char *session_narrate_in_english (Session *session);

/* Returns: (transfer full) (element-type Law): the counters of the step. */
GPtrArray *session_get_laws (Session *session);

/* The sentence of LAYER_WHY on the facet and the site that a person asks
 * about, translated; free with g_free().
 *
 * Returns: NULL when the layer is hidden or nothing is asked. */
char *session_explain (Session *session);

G_END_DECLS

#endif
