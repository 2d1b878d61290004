/* The inside of the window, for the files hull2vd-window.c and window-*.c
 * alone. */
#ifndef WINDOW_PRIVATE_H
#define WINDOW_PRIVATE_H

#include "chore-task.h"
#include "code-panel.h"
#include "columns.h"
#include "coordinate-entry.h"
#include "counters-panel.h"
#include "hull2vd-window.h"
#include "lecturer-window.h"
#include "legend-panel.h"
#include "lesson-panel.h"
#include "lesson-watch.h"
#include "narration-bar.h"
#include "plane-view.h"
#include "record-window.h"
#include "side-column.h"
#include "space-view.h"
#include "transport.h"
#include "window-message.h"
#include "window-recovery.h"
#include "work-bar.h"

G_BEGIN_DECLS

typedef enum WindowPanel {
  PANEL_LESSON,
  PANEL_CODE, /* from here on: in the right column, or in tabs */
  PANEL_COUNTERS,
  PANEL_LEGEND,
} WindowPanel;

#define N_PANELS (PANEL_LEGEND + 1)

struct _Hull2vdWindow {
  GtkApplicationWindow parent_instance;

  Session *session;
  GSettings *settings; /* NULL: not installed */
  char *path;          /* of the points or lesson, or NULL: new sites */
  GBytes *saved;       /* the points as they are in the file, or NULL */
  ChoreTask *saving;   /* NULL: none is under way */
  ChoreTask *reading;  /* the same */
  LessonWatch *watch;  /* of the lesson's file */
  WindowRecovery *recovery;
  gboolean is_foreign; /* the file is no point file: see point-import.h */
  char *awaited;       /* of points whose hull a thread makes, or NULL */
  guint awaited_work;  /* its number */
  gboolean is_awaited_foreign;

  GtkHeaderBar *header_bar;
  GtkMenuButton *lessons_button, *view_button, *main_button;
  GtkWidget *undo_button, *redo_button;
  GtkInfoBar *info_bar;
  GtkLabel *info_label;
  char *message_kind; /* what it is about; NULL: no command, or no message */
  gint64 message_read_at; /* until then it may not have been read */
  guint message_source;   /* that takes it away */
  const char *command;    /* that is being carried out, or NULL */
  GtkInfoBar *recovery_bar;
  GtkLabel *recovery_label;
  WorkBar *work_bar;
  Columns *columns;
  GtkPaned *lesson_paned, *view_paned;
  GtkWidget *left_column, *right_column, *tabs;
  GtkBox *right_box;
  GtkStack *stack;
  GtkWidget *space_buttons; /* cameras and looks */
  PlaneView *plane_view;
  SpaceView *space_view;
  GtkLabel *plane_hint, *space_hint, *plane_readout;
  CoordinateEntry *coordinate_entry;
  GtkWidget *generate_dialog;  /* NULL: not asked for yet */
  GtkWidget *keys_dialog;      /* the same */
  RecordWindow *record_window; /* NULL: not asked for yet */
  SessionRecord *record;       /* NULL: nothing is recorded */
  GtkWidget *space_window;     /* NULL: space is in this window */
  GtkLabel *plane_title, *space_title;
  Canvas *views[2 * N_PANES]; /* both kinds for each place */
  GtkLabel *reports[N_PANES];
  GtkWidget *plane_box, *space_box;
  LessonPanel *lesson_panel;
  CodePanel *code_panel;
  CountersPanel *counters_panel;
  LegendPanel *legend_panel;
  NarrationBar *narration_bar;
  Transport *transport;
  gboolean shows_panel[N_PANELS];
  LecturerWindow *lecturer; /* NULL: it is not open */
  gboolean is_blank;        /* the screen is black */
  gboolean is_frozen;       /* the screen stands still */
  char *frozen_place;       /* where the session was then, in words */
  gboolean is_placed;       /* the divider stands where it was left */
  Listing listing;          /* that is shown */
};

/* window-layout.c: columns, panels, and what is remembered of them. */
void window_layout_init (Hull2vdWindow *window);
void window_layout_save (Hull2vdWindow *window);
gboolean window_layout_shows (Hull2vdWindow *window, WindowPanel panel);
void window_layout_show (Hull2vdWindow *window, WindowPanel panel, gboolean on);
/* Gives a window larger letters while it is wide. */
void window_layout_follow_width (GtkWidget *window);

/* window-panes.c: what the two pictures show. */
void window_panes_init (Hull2vdWindow *window);

/* window-actions.c: the registry as GActions. */
void window_actions_init (Hull2vdWindow *window);

/* window-commands.c: the rows of the registry that need a window.
 *
 * Returns: FALSE: not one of them. */
gboolean window_command_run (Hull2vdWindow *window,
                             const char *name,
                             GVariant *parameter);
/* Returns: (transfer floating): its state, or NULL: none. */
GVariant *window_command_state (Hull2vdWindow *window, const char *name);

/* hull2vd-window.c */
void hull2vd_window_update_title (Hull2vdWindow *window);
/* Which button does what in the plane, and what the window says of it. */
void hull2vd_window_set_paper_bindings (Hull2vdWindow *window,
                                        gboolean has_them);
/* A key in @other, a window beside this one: what its focus does not want is
 * for the accelerators of @window.
 *
 * Returns: whether somebody wanted it. */
gboolean hull2vd_window_forward_key (Hull2vdWindow *window,
                                     GtkWindow *other,
                                     GdkEventKey *event);

/* window-files.c: open, save, export. What replaces unsaved sites asks first;
 * window_files_load() does not. */
void window_files_init (Hull2vdWindow *window);
/* What is dropped on @widget is opened in @window. */
void window_files_take_drops (Hull2vdWindow *window, GtkWidget *widget);
void window_files_new (Hull2vdWindow *window);
void window_files_open (Hull2vdWindow *window);
void window_files_open_path (Hull2vdWindow *window, const char *path);
void window_files_adapt (Hull2vdWindow *window);
void window_files_storyboard (Hull2vdWindow *window);
void window_files_handout (Hull2vdWindow *window);
/* Many points are read by a thread, and shown when they are there; FALSE: it
 * is known already that they cannot be. */
gboolean window_files_load (Hull2vdWindow *window, const char *path);
/* Replaces the sites by points in text, as the clipboard has it; @origin and
 * @edit, which stay, as point_import_text() has them. */
void window_paste (Hull2vdWindow *window);
void window_paste_text (Hull2vdWindow *window,
                        const char *text,
                        const char *origin,
                        const char *edit);
/* What was to be read takes the place of nothing any more. */
void window_files_stop_reading (Hull2vdWindow *window);

/* A thread is at work, or no longer: a file that was waited for is there now,
 * or will not come. */
void window_files_follow_work (Hull2vdWindow *window);

/* window-save.c: the sites as a file and as text; a thread writes many. */
void window_files_save (Hull2vdWindow *window);
void window_files_save_now (Hull2vdWindow *window); /* for window-ask.c */
void window_files_save_as (Hull2vdWindow *window);
void window_files_copy (Hull2vdWindow *window); /* to the clipboard */
/* The sites as they are now are those of the file. */
void window_files_remember_saved (Hull2vdWindow *window);
/* Whether there is work in the window that is in no file. */
gboolean window_files_is_modified (Hull2vdWindow *window);

/* window-picture.c: pictures of the views. */
void window_picture_export (Hull2vdWindow *window);
void window_picture_copy (Hull2vdWindow *window);

/* window-theme.c: the theme of pictures and chrome. */
void window_theme_init (Hull2vdWindow *window);
/* All that belongs to @window, in its theme. */
void window_theme_dress (Hull2vdWindow *window);

/* window-space.c: space in a window of its own. */
void window_space_init (Hull2vdWindow *window);
void window_space_detach (Hull2vdWindow *window, gboolean detached);
gboolean window_space_is_detached (Hull2vdWindow *window);
/* Remembers the size of its window. */
void window_space_save (Hull2vdWindow *window);

/* window-cover.c: what covers every window that was added: the black screen,
 * until a key, a click or a touch, or a picture of what it showed. */
void window_cover_add (Hull2vdWindow *window, GtkWidget *widget);
void window_cover_toggle_black (Hull2vdWindow *window);
gboolean window_cover_is_black (Hull2vdWindow *window);
/* Returns: whether the key was for the black screen. */
gboolean window_cover_key (Hull2vdWindow *window, const GdkEventKey *event);
void window_cover_toggle_frozen (Hull2vdWindow *window);
gboolean window_cover_is_frozen (Hull2vdWindow *window);

/* window-lecturer.c: the lecturer's window. */
void window_lecturer_toggle (Hull2vdWindow *window);
gboolean window_lecturer_is_open (Hull2vdWindow *window);
void window_lecturer_follow_cover (Hull2vdWindow *window);
void window_lecturer_toggle_freeze (Hull2vdWindow *window); /* opens it */
void window_lecturer_toggle_clock (Hull2vdWindow *window);  /* opens it */
gboolean window_lecturer_is_running (Hull2vdWindow *window);
void window_lecturer_reset_clock (Hull2vdWindow *window);
void window_lecturer_show_overview (Hull2vdWindow *window);
void window_lecturer_end (Hull2vdWindow *window); /* the window goes */

/* window-dialog.c
 *
 * Returns: whether there is a dialog to be answered first; then this has been
 *          said, with @path unless NULL, which was to be opened. */
gboolean window_dialog_refuse (Hull2vdWindow *window, const char *path);

/* window-progress.c: what the person has done in lessons. */
void window_progress_init (Hull2vdWindow *window);
void window_progress_export (Hull2vdWindow *window);
void window_progress_clear (Hull2vdWindow *window);
void window_progress_next_lesson (Hull2vdWindow *window);

/* window-record.c: what is done, as text of a lesson. */
void window_record_toggle (Hull2vdWindow *window);
gboolean window_record_is_on (Hull2vdWindow *window);
void window_record_cut (Hull2vdWindow *window);
void window_record_copy (Hull2vdWindow *window);
void window_record_end (Hull2vdWindow *window); /* the window goes */

/* window-menus.c */
void window_menus_init (Hull2vdWindow *window);

G_END_DECLS

#endif
