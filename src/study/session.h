/* The session: the only owner of mutable state. Views, panels and lessons
 * read it and ask it to change; it says what has changed in one signal.
 *
 *   g_signal_connect (session, "changed", G_CALLBACK (on_changed), widget);
 *   static void on_changed (Session *session, guint changes, gpointer user);
 *
 * An edit makes a new SiteSet and a new trace; the step stays at the same
 * place of the timeline where that place still exists.
 */
#ifndef SESSION_H
#define SESSION_H

#include "lesson.h"
#include "scene.h"

#include <gio/gio.h>

G_BEGIN_DECLS

typedef enum SessionChange {
  CHANGED_SITES = 1 << 0,   /* set and trace are new; frame too */
  CHANGED_STEP = 1 << 1,    /* frame is new */
  CHANGED_LOOK = 1 << 2,    /* layers, focus, selection, hover, extent */
  CHANGED_CAMERA = 1 << 3,  /* of either view */
  CHANGED_LESSON = 1 << 4,  /* another lesson, or another stop */
  CHANGED_HISTORY = 1 << 5, /* what can be undone */
  CHANGED_PLAY = 1 << 6,    /* playing, speed, step size */
} SessionChange;

/* What "next" means. */
typedef enum StepSize {
  STEP_BEAT, /* the next stop of the lesson; without one, a round */
  STEP_PHASE,
  STEP_EVENT,
} StepSize;

#define SESSION_TYPE (session_get_type ())
G_DECLARE_FINAL_TYPE (Session, session, HULL2VD, SESSION, GObject)

Session *session_new (void);

/* Sites. All edits can be undone and redone. */
const SiteSet *session_get_set (Session *session);
const Trace *session_get_trace (Session *session);
gboolean session_set_sites (Session *session,
                            const Site *sites,
                            guint n_sites,
                            GError **error); /* and fits the extent */
gboolean session_add_site (Session *session, Site site, GError **error);
gboolean
session_move_site (Session *session, guint site, Site to, GError **error);
gboolean session_remove_site (Session *session, guint site, GError **error);

/* Moves between begin and end are one edit for undo (a drag). */
void session_begin_edit (Session *session);
void session_end_edit (Session *session);

gboolean session_undo (Session *session);
gboolean session_redo (Session *session);
const char *session_get_undo_label (Session *session); /* NULL: nothing */
const char *session_get_redo_label (Session *session);

/* Returns: @site moved to the snap grid: coordinates with few digits, on one
 *          power-of-two grid that is fine enough for the extent. */
Site session_snap (Session *session, Site site);

/* Time. */
guint session_get_step (Session *session);
void session_set_step (Session *session, guint step);
const Frame *session_get_frame (Session *session);
Place session_get_place (Session *session);
StepSize session_get_step_size (Session *session);
void session_set_step_size (Session *session, StepSize size);

/* Steps by the step size.
 *
 * Returns: FALSE at the end (the start). */
gboolean session_next (Session *session);
gboolean session_back (Session *session);

/* Playing is next, again and again; the window's clock calls
 * session_tick(). */
gboolean session_get_playing (Session *session);
void session_set_playing (Session *session, gboolean playing);
double session_get_speed (Session *session); /* 1: one step in 1.5 s */
void session_set_speed (Session *session, double speed);
guint session_get_tick_ms (Session *session);
void session_tick (Session *session); /* stops playing at the end */

/* The look. */
const SceneLook *session_get_look (Session *session);
void session_set_layers (Session *session, guint layers);
void session_set_focus (Session *session, Focus focus);
void session_set_selection (Session *session, Object object);
void session_set_hover (Session *session, Object object);
const Camera *session_get_camera (Session *session);
void session_set_camera (Session *session, const Camera *camera);
const PlaneCamera *session_get_plane_camera (Session *session);
void session_set_plane_camera (Session *session, const PlaneCamera *camera);

/* The lesson. A stop's state is that of the lesson played from its start,
 * whichever way the stop was reached. */
void session_set_lesson (Session *session, Lesson *lesson);
Lesson *session_get_lesson (Session *session); /* NULL: none */
guint session_get_stop (Session *session);     /* index; 0 the first */
gboolean session_set_stop (Session *session, guint stop);

/* Carries out the commands of one stop and checks its expectations; replay
 * is this for every stop.
 *
 * Returns: FALSE with @error set when a position does not exist. */
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

G_END_DECLS

#endif
