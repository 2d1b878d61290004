/* The parts of the action table, and the functions of their rows. What is in
 * Action.data is said at each. */
#ifndef ACTION_PRIVATE_H
#define ACTION_PRIVATE_H

#include "action.h"

G_BEGIN_DECLS

typedef struct ActionRows {
  const Action *rows;
  guint n_rows;
} ActionRows;

extern const ActionRows action_rows_time;     /* time, questions, states */
extern const ActionRows action_rows_perform;  /* You be QuickHull */
extern const ActionRows action_rows_look;     /* what is shown and how */
extern const ActionRows action_rows_edit;     /* sites, and the window's own */
extern const ActionRows action_rows_progress; /* progress, results, records */

#define ACTION_RUN(name)                                                       \
  gboolean name (const Action *action G_GNUC_UNUSED, Session *session,         \
                 GVariant *parameter G_GNUC_UNUSED,                            \
                 GError **error G_GNUC_UNUSED)

/* data: 0 by the step size, else a Grain + 1 */
ACTION_RUN (action_next);
ACTION_RUN (action_back);
ACTION_RUN (action_first);
ACTION_RUN (action_last);
ACTION_RUN (action_play);
ACTION_RUN (action_step_size);
ACTION_RUN (action_speed);
ACTION_RUN (action_goto);
ACTION_RUN (action_goto_step);
ACTION_RUN (action_goto_stop);
ACTION_RUN (action_next_stop);
ACTION_RUN (action_previous_stop);

ACTION_RUN (action_show);         /* data: whether to show */
ACTION_RUN (action_toggle_layer); /* data: Layer */
ACTION_RUN (action_lift);
ACTION_RUN (action_raise);
ACTION_RUN (action_opacity);
ACTION_RUN (action_body_opacity); /* data: Body */
ACTION_RUN (action_reset_look);
ACTION_RUN (action_measure);
ACTION_RUN (action_measure_next);
ACTION_RUN (action_focus);
ACTION_RUN (action_select);
ACTION_RUN (action_select_next); /* data: whether to go forwards */
ACTION_RUN (action_select_sites);
ACTION_RUN (action_toggle_site);
ACTION_RUN (action_select_all);
ACTION_RUN (action_select_none);
ACTION_RUN (action_camera);
ACTION_RUN (action_camera_preset); /* data: CameraPreset */
ACTION_RUN (action_zoom);          /* data: ActionZoom bits */
ACTION_RUN (action_fit);

ACTION_RUN (action_theme);
ACTION_RUN (action_scale); /* data: ActionScale */

ACTION_RUN (action_view);
ACTION_RUN (action_views);
ACTION_RUN (action_listing);
ACTION_RUN (action_compare);
ACTION_RUN (action_compare_view);
ACTION_RUN (action_rounding);
ACTION_RUN (action_turn);
ACTION_RUN (action_node);

ACTION_RUN (action_order);
ACTION_RUN (action_add_site);
ACTION_RUN (action_move_site);
ACTION_RUN (action_remove_site);
ACTION_RUN (action_delete_selection);
ACTION_RUN (action_nudge);
ACTION_RUN (action_snap);
ACTION_RUN (action_sites);
ACTION_RUN (action_new);
ACTION_RUN (action_undo);
ACTION_RUN (action_redo);
ACTION_RUN (action_cancel);

ACTION_RUN (action_answer_toggle);
ACTION_RUN (action_answer_number);
ACTION_RUN (action_answer_undo);
ACTION_RUN (action_check);
ACTION_RUN (action_hint);
ACTION_RUN (action_retry);
ACTION_RUN (action_show_answer);
ACTION_RUN (action_another);
ACTION_RUN (action_continue);

ACTION_RUN (action_resume);

#define ACTION_STATE(name)                                                     \
  GVariant *name (const Action *action G_GNUC_UNUSED,                          \
                  Session *session G_GNUC_UNUSED)

ACTION_STATE (action_state_step);
ACTION_STATE (action_state_n_steps);
ACTION_STATE (action_state_round);
ACTION_STATE (action_state_phase);
ACTION_STATE (action_state_stop); /* from 1; 0: no lesson */
ACTION_STATE (action_state_n_stops);
ACTION_STATE (action_state_n_sites);
ACTION_STATE (action_state_order);
ACTION_STATE (action_state_views);
ACTION_STATE (action_state_listing);
ACTION_STATE (action_state_view);
ACTION_STATE (action_state_compare);
ACTION_STATE (action_state_compare_view);
ACTION_STATE (action_state_play);
ACTION_STATE (action_state_step_size);
ACTION_STATE (action_state_speed);
ACTION_STATE (action_state_layer); /* data: Layer */
ACTION_STATE (action_state_focus);
ACTION_STATE (action_state_theme);
ACTION_STATE (action_state_scale); /* data: ActionScale */
ACTION_STATE (action_state_lift);
ACTION_STATE (action_state_raise);
ACTION_STATE (action_state_body_opacity); /* data: Body */
ACTION_STATE (action_state_measure);
ACTION_STATE (action_state_selection);
ACTION_STATE (action_state_selected_sites);
ACTION_STATE (action_state_snap);

ACTION_STATE (action_state_question);
ACTION_STATE (action_state_attempt);
ACTION_STATE (action_state_score);

#define ACTION_ENABLED(name)                                                   \
  gboolean name (const Action *action G_GNUC_UNUSED, Session *session)

ACTION_ENABLED (action_can_next); /* data as of action_next */
ACTION_ENABLED (action_can_back);
ACTION_ENABLED (action_can_play);
ACTION_ENABLED (action_can_next_stop);
ACTION_ENABLED (action_can_previous_stop);
ACTION_ENABLED (action_can_toggle_layer); /* data: Layer */
ACTION_ENABLED (action_has_sites);
ACTION_ENABLED (action_has_selection);
ACTION_ENABLED (action_has_selected_site);
ACTION_ENABLED (action_can_undo);
ACTION_ENABLED (action_can_redo);
ACTION_ENABLED (action_has_lesson);
ACTION_ENABLED (action_can_check);
ACTION_ENABLED (action_can_hint);
ACTION_ENABLED (action_can_undo_answer);
ACTION_ENABLED (action_has_question);
ACTION_ENABLED (action_has_open_question);
ACTION_ENABLED (action_can_another);
ACTION_ENABLED (action_can_continue);
ACTION_ENABLED (action_is_working);
ACTION_ENABLED (action_can_resume);
ACTION_ENABLED (action_has_progress);

typedef enum ActionZoom {
  ZOOM_PLANE = 1,
  ZOOM_SPACE = 2,
  ZOOM_IN = 4, /* else out */
} ActionZoom;

typedef enum ActionScale {
  SCALE_LINES,
  SCALE_MARKS,
  SCALE_TEXT,
} ActionScale;

#define ZOOM_LEAST 0.1
#define ZOOM_MOST 1e6

G_END_DECLS

#endif
