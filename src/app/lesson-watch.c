#include "lesson-watch.h"

#include "lesson-words.h"

/* Editors save in several steps; the last one counts. */
#define SETTLE_MS 150

struct LessonWatch {
  Session *session;
  LessonPanel *panel;
  char *path;
  GFileMonitor *monitor;
  guint source;
};

LessonWatch *
lesson_watch_new (Session *session, LessonPanel *panel)
{
  LessonWatch *watch = g_new0 (LessonWatch, 1);

  watch->session = session;
  watch->panel = panel;
  return watch;
}

static void
stop (LessonWatch *watch)
{
  if (watch->source != 0)
    g_source_remove (watch->source);
  watch->source = 0;
  if (watch->monitor != NULL)
    g_file_monitor_cancel (watch->monitor);
  g_clear_object (&watch->monitor);
  g_clear_pointer (&watch->path, g_free);
}

void
lesson_watch_free (LessonWatch *watch)
{
  stop (watch);
  g_free (watch);
}

static gboolean
on_settled (gpointer user)
{
  LessonWatch *watch = user;
  g_autoptr (LessonFaults) faults = lesson_faults_new ();
  g_autoptr (Lesson) lesson = lesson_load_all (watch->path, faults);

  watch->source = 0;
  lesson_panel_set_faults (watch->panel, faults);
  if (lesson == NULL)
    return G_SOURCE_REMOVE;
  lesson_words_translate (lesson);
  session_renew_lesson (watch->session, lesson);
  return G_SOURCE_REMOVE;
}

static void
on_file (GFileMonitor *monitor,
         GFile *file,
         GFile *other,
         GFileMonitorEvent event,
         LessonWatch *watch)
{
  (void)monitor;
  (void)file;
  (void)other;
  /* A file that is put in place of another is away for a moment. */
  if (event == G_FILE_MONITOR_EVENT_DELETED
      || event == G_FILE_MONITOR_EVENT_MOVED_OUT
      || event == G_FILE_MONITOR_EVENT_ATTRIBUTE_CHANGED
      || event == G_FILE_MONITOR_EVENT_PRE_UNMOUNT
      || event == G_FILE_MONITOR_EVENT_UNMOUNTED)
    return;
  if (watch->source != 0)
    g_source_remove (watch->source);
  watch->source = g_timeout_add (SETTLE_MS, on_settled, watch);
}

void
lesson_watch_set_path (LessonWatch *watch, const char *path)
{
  g_autofree char *kept = g_strdup (path);
  g_autoptr (GFile) file = NULL;

  stop (watch);
  lesson_panel_set_faults (watch->panel, NULL);
  if (kept == NULL)
    return;
  watch->path = g_steal_pointer (&kept);
  file = g_file_new_for_path (watch->path);
  watch->monitor
      = g_file_monitor_file (file, G_FILE_MONITOR_WATCH_MOVES, NULL, NULL);
  if (watch->monitor != NULL)
    g_signal_connect (watch->monitor, "changed", G_CALLBACK (on_file), watch);
}
