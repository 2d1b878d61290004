#include "window-private.h"

#include "action.h"
#include "document.h"
#include "file-dialogs.h"
#include "hull2vd-application.h"
#include "lesson-copy.h"
#include "point-import.h"
#include "progress-keeper.h"
#include "window-ask.h"
#include "window-recent.h"

#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <sys/stat.h>

/* A lesson is read again whenever its author saves it. */
static void
watch_lesson (Hull2vdWindow *window)
{
  lesson_watch_set_path (
      window->watch,
      session_get_lesson (window->session) != NULL ? window->path : NULL);
}

/* The file at @path is what is shown. Takes @path. */
static void
set_path (Hull2vdWindow *window, char *path)
{
  g_free (window->path);
  window->path = path;
}

/* Restored sites are in no file: they are saved where the person says. */
static void
show_restored (Hull2vdWindow *window, char *origin)
{
  set_path (window, origin);
  window->is_foreign = TRUE;
  g_clear_pointer (&window->saved, g_bytes_unref);
  hull2vd_window_update_title (window);
}

static void
show_loaded (Hull2vdWindow *window, const char *path, gboolean is_foreign)
{
  char *origin;

  if (window_recovery_take (window, path, &origin))
    show_restored (window, origin);
  else {
    set_path (window, g_strdup (path));
    window->is_foreign = is_foreign;
    window_files_remember_saved (window);
    window_recent_add (path);
  }
  watch_lesson (window);
  window_message_settle (window, "open");
  gtk_widget_grab_focus (GTK_WIDGET (window->plane_view));
}

/* What has been read of a file: one of the first two, or neither. */
typedef struct Content {
  SiteSet *set;
  Lesson *lesson;
  gboolean is_foreign;
} Content;

static void
content_clear (Content *content)
{
  g_clear_pointer (&content->set, site_set_free);
  g_clear_pointer (&content->lesson, lesson_unref);
}

/* Puts what is at @path into the session; what nobody has read yet is read. */
static gboolean
put_content (Session *session,
             const char *path,
             Content *content,
             GError **error)
{
  if (content->lesson != NULL) {
    session_set_lesson (session, content->lesson);
    return TRUE;
  }
  if (content->set != NULL)
    return point_import_put (session, g_steal_pointer (&content->set), error);
  return point_import_open (session, path, &content->is_foreign, error);
}

/* Shows what is at @path. */
static gboolean
load_now (Hull2vdWindow *window, const char *path, Content *content)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *kept = g_strdup (path);
  char *before = g_steal_pointer (&window->path);

  g_clear_pointer (&window->awaited, g_free);
  /* The title is made while the session tells of its change. */
  window->path = g_strdup (path);
  if (!put_content (window->session, path, content, &error)) {
    set_path (window, before);
    window_message_say (window, "open", error->message);
    return FALSE;
  }
  window->awaited_work = session_get_work (window->session);
  if (window->awaited_work != 0) {
    set_path (window, before);
    window->awaited = g_steal_pointer (&kept);
    window->is_awaited_foreign = content->is_foreign;
    return TRUE;
  }
  g_free (before);
  show_loaded (window, kept, content->is_foreign);
  return TRUE;
}

/* What a thread reads: many points, or of somebody who may let it wait; or
 * plays: a lesson of many sites. */
typedef struct Reading {
  Hull2vdWindow *window;
  char *path;
  Content content;
  guint stop; /* of the lesson, to begin with */
  ChoreTask *task;
} Reading;

static void
reading_free (gpointer data)
{
  Reading *reading = data;

  if (reading->window->reading == reading->task)
    reading->window->reading = NULL;
  g_object_unref (reading->window);
  content_clear (&reading->content);
  g_free (reading->path);
  g_free (reading);
}

static gboolean
read_points (ChoreTask *task, gpointer data, GError **error)
{
  Content *content = &((Reading *)data)->content;

  content->set
      = point_import_read (((Reading *)data)->path, &content->is_foreign,
                           chore_task_get_cancellable (task), error);
  return content->set != NULL;
}

static gboolean
play_lesson (ChoreTask *task, gpointer data, GError **error)
{
  const Reading *reading = data;

  (void)task;
  return lesson_play (reading->content.lesson, error);
}

static void
on_read (gpointer data, const GError *error)
{
  Reading *reading = data;
  Hull2vdWindow *window = reading->window;

  window->reading = NULL;
  if (error != NULL)
    window_message_say (window, "open", error->message);
  else if (load_now (window, reading->path, &reading->content)
           && reading->stop > 0)
    session_set_stop (window->session, reading->stop);
}

/* Takes what @content holds. */
static void
begin_reading (Hull2vdWindow *window,
               const char *path,
               const Content *content,
               guint stop)
{
  const gboolean is_lesson = content->lesson != NULL;
  Reading *reading = g_new0 (Reading, 1);

  session_cancel (window->session);
  reading->window = g_object_ref (window);
  reading->path = g_strdup (path);
  reading->content = *content;
  reading->stop = stop;
  window->reading = reading->task = chore_task_begin (
      window->session, _ ("The file is being read"),
      is_lesson ? play_lesson : read_points, on_read, reading, reading_free);
}

void
window_files_stop_reading (Hull2vdWindow *window)
{
  if (window->reading != NULL)
    chore_task_give_up (window->reading);
  window->reading = NULL;
}

/* Points by the thousand, in a file. */
#define LONG_BYTES 100000

static gboolean
takes_long (const char *path)
{
  GStatBuf status;

  return g_stat (path, &status) == 0
         && (!S_ISREG (status.st_mode) || status.st_size > LONG_BYTES);
}

/* Loads a lesson, and goes to @stop. */
static gboolean
load_lesson (Hull2vdWindow *window, const char *path, guint stop)
{
  g_autoptr (GError) error = NULL;
  Content content = { .lesson = point_import_read_lesson (path, &error) };
  const gboolean is_large
      = content.lesson != NULL && content.lesson->n_sites > SESSION_AT_ONCE;
  gboolean is_loaded = FALSE;

  window_files_stop_reading (window);
  if (is_large) {
    begin_reading (window, path, &content, stop);
    return TRUE;
  }
  g_clear_pointer (&window->awaited, g_free);
  if (content.lesson == NULL || !lesson_play (content.lesson, &error))
    window_message_say (window, "open", error->message);
  else
    is_loaded = load_now (window, path, &content);
  content_clear (&content);
  if (is_loaded && stop > 0)
    session_set_stop (window->session, stop);
  return is_loaded;
}

gboolean
window_files_load (Hull2vdWindow *window, const char *path)
{
  Content content = { NULL, NULL, FALSE };

  if (document_is_lesson (path))
    return load_lesson (window, path, 0);
  window_files_stop_reading (window);
  if (!takes_long (path))
    return load_now (window, path, &content);
  begin_reading (window, path, &content, 0);
  return TRUE;
}

void
window_files_follow_work (Hull2vdWindow *window)
{
  g_autofree char *path = NULL;

  if (window->awaited == NULL
      || session_get_work (window->session) == window->awaited_work)
    return;
  path = g_steal_pointer (&window->awaited);
  if (session_has_finished (window->session, window->awaited_work))
    show_loaded (window, path, window->is_awaited_foreign);
}

/* New */

static void
begin_anew (Hull2vdWindow *window, const char *path)
{
  (void)path;
  g_clear_pointer (&window->path, g_free);
  window->is_foreign = FALSE;
  action_run (window->session, "new", NULL, NULL);
  watch_lesson (window);
  window_files_remember_saved (window);
  window_message_settle (window, "new");
}

void
window_files_new (Hull2vdWindow *window)
{
  window_ask (window, ASK_NEW, begin_anew, NULL);
}

/* A lesson of one's own, in the folder of documents. */
void
window_files_adapt (Hull2vdWindow *window)
{
  const Lesson *lesson = session_get_lesson (window->session);
  g_autofree char *folder = lesson_copy_folder ();
  g_autofree char *path = NULL, *message = NULL;
  g_autoptr (GError) error = NULL;
  const guint stop = session_get_stop (window->session);

  if (lesson == NULL)
    return;
  path = lesson_copy (lesson, folder, &error);
  if (path == NULL) {
    hull2vd_window_say (window, error->message);
    return;
  }
  if (!load_lesson (window, path, stop))
    return;
  message = g_strdup_printf (
      _ ("This is your own copy, %s. Change it in any editor: what you save is "
         "shown at once."),
      path);
  hull2vd_window_say (window, message);
}

/* Open */

static void
load (Hull2vdWindow *window, const char *path)
{
  window_files_load (window, path);
}

void
window_files_open_path (Hull2vdWindow *window, const char *path)
{
  window_ask (window, ASK_OPEN, load, path);
}

static void
on_open_chosen (const char *path, gpointer user)
{
  window_files_open_path (user, path);
}

void
window_files_open (Hull2vdWindow *window)
{
  file_dialog_open (GTK_WINDOW (window), _ ("Open a Lesson or Points"),
                    on_open_chosen, window);
}

/* Drop */

/* In a window of its own. */
static void
open_alone (Hull2vdWindow *window, const char *path)
{
  g_autoptr (GFile) file = g_file_new_for_path (path);

  g_application_open (
      G_APPLICATION (gtk_window_get_application (GTK_WINDOW (window))), &file,
      1, HULL2VD_OPEN_ALONE);
}

static void
drop_uris (Hull2vdWindow *window, char **uris)
{
  for (guint i = 0; uris[i] != NULL; i++) {
    g_autofree char *path = g_filename_from_uri (uris[i], NULL, NULL);

    if (path == NULL)
      window_message_say (window, "open",
                          _ ("Only files on this computer can be opened"));
    else if (i == 0)
      window_files_open_path (window, path);
    else
      open_alone (window, path);
  }
}

static void
on_drop (GtkWidget *widget,
         GdkDragContext *context,
         int x,
         int y,
         GtkSelectionData *data,
         guint info,
         guint time,
         gpointer user)
{
  g_auto (GStrv) uris = gtk_selection_data_get_uris (data);
  g_autofree guchar *text = gtk_selection_data_get_text (data);

  (void)widget;
  (void)context;
  (void)x;
  (void)y;
  (void)info;
  (void)time;
  if (uris != NULL)
    drop_uris (user, uris);
  else if (text != NULL)
    window_paste_text (user, (const char *)text, _ ("dropped text"),
                       _ ("drop"));
}

void
window_files_take_drops (Hull2vdWindow *window, GtkWidget *widget)
{
  gtk_drag_dest_set (widget, GTK_DEST_DEFAULT_ALL, NULL, 0, GDK_ACTION_COPY);
  gtk_drag_dest_add_uri_targets (widget);
  gtk_drag_dest_add_text_targets (widget);
  g_signal_connect (widget, "drag-data-received", G_CALLBACK (on_drop), window);
}

/* Close */

static void
close_window (Hull2vdWindow *window, const char *path)
{
  (void)path;
  window_recovery_clear (window);
  window_layout_save (window);
  window_space_save (window);
  progress_keeper_flush ();
  gtk_widget_destroy (GTK_WIDGET (window));
}

static gboolean
on_delete (GtkWidget *widget, GdkEvent *event, gpointer user)
{
  (void)event;
  (void)user;
  window_ask (HULL2VD_WINDOW (widget), ASK_CLOSE, close_window, NULL);
  return TRUE;
}

static void
tell_faults (const LessonFaults *faults, gpointer user)
{
  lesson_panel_set_faults (user, faults);
}

void
window_files_init (Hull2vdWindow *window)
{
  GtkWidget *widget = GTK_WIDGET (window);

  window->watch
      = lesson_watch_new (window->session, tell_faults, window->lesson_panel);
  window_files_take_drops (window, widget);
  g_signal_connect (widget, "delete-event", G_CALLBACK (on_delete), NULL);
  window_files_remember_saved (window);
}
