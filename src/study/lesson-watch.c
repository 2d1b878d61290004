#include "lesson-watch.h"

#include "lesson-words.h"

#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <stdlib.h>

/* Editors save in several steps; the last one counts. */
#define SETTLE_MS 150
/* What is being written, or away because another takes its place, is waited
 * for. */
#define PATIENCE_MS 600

struct LessonWatch {
  Session *session;
  LessonWatchTell tell;
  gpointer user;
  char *path;
  char *shown;          /* digest of what is shown; NULL: not known */
  GHashTable *monitors; /* of GFileMonitor by path */
  guint source;
};

static void
free_monitor (gpointer monitor)
{
  g_file_monitor_cancel (monitor);
  g_object_unref (monitor);
}

LessonWatch *
lesson_watch_new (Session *session, LessonWatchTell tell, gpointer user)
{
  LessonWatch *watch = g_new0 (LessonWatch, 1);

  watch->session = session;
  watch->tell = tell;
  watch->user = user;
  watch->monitors
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, free_monitor);
  return watch;
}

static void
stop (LessonWatch *watch)
{
  g_clear_handle_id (&watch->source, g_source_remove);
  g_hash_table_remove_all (watch->monitors);
  g_clear_pointer (&watch->path, g_free);
  g_clear_pointer (&watch->shown, g_free);
}

void
lesson_watch_free (LessonWatch *watch)
{
  stop (watch);
  g_hash_table_unref (watch->monitors);
  g_free (watch);
}

/* Returns: (transfer full): where a file of sites is, or NULL: none. */
static char *
site_path (const LessonWatch *watch, const char *site_file)
{
  g_autofree char *folder = g_path_get_dirname (watch->path);

  return site_file == NULL ? NULL : g_build_filename (folder, site_file, NULL);
}

/* What is shown */

static gboolean
add_digest (GChecksum *digest, const char *path)
{
  g_autofree char *text = NULL;
  gsize length;
  GStatBuf status;

  if (g_stat (path, &status) != 0 || !S_ISREG (status.st_mode)
      || status.st_size > LESSON_MAX_BYTES
      || !g_file_get_contents (path, &text, &length, NULL))
    return FALSE;
  g_checksum_update (digest, (const guchar *)text, (gssize)length);
  g_checksum_update (digest, (const guchar *)"", 1);
  return TRUE;
}

/* Returns: (transfer full): a digest of the lesson and its sites as the files
 *          are now; NULL: they cannot be read. */
static char *
make_digest (LessonWatch *watch)
{
  const Lesson *lesson = session_get_lesson (watch->session);
  g_autoptr (GChecksum) digest = g_checksum_new (G_CHECKSUM_SHA256);
  g_autofree char *sites
      = site_path (watch, lesson == NULL ? NULL : lesson->site_file);

  if (!add_digest (digest, watch->path)
      || (sites != NULL && !add_digest (digest, sites)))
    return NULL;
  return g_strdup (g_checksum_get_string (digest));
}

static void watch_files (LessonWatch *watch, const char *site_file);

/* To read from a pipe might wait for ever. */
static Lesson *
load (LessonWatch *watch, LessonFaults *faults)
{
  GStatBuf status;
  GError *error = NULL;
  g_autofree char *name = display_path (watch->path);

  if (g_stat (watch->path, &status) != 0 || S_ISREG (status.st_mode)
      || S_ISDIR (status.st_mode))
    return lesson_load_all (watch->path, faults);
  g_set_error (&error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN, "%s: %s", name,
               _ ("this is not a regular file"));
  lesson_faults_take (faults, error);
  return NULL;
}

static gboolean
on_settled (gpointer user)
{
  LessonWatch *watch = user;
  g_autofree char *digest = make_digest (watch);
  g_autoptr (LessonFaults) faults = lesson_faults_new ();
  g_autoptr (Lesson) lesson = NULL;

  watch->source = 0;
  if (digest != NULL && g_strcmp0 (digest, watch->shown) == 0) {
    watch->tell (NULL, watch->user);
    watch_files (watch, session_get_lesson (watch->session)->site_file);
    return G_SOURCE_REMOVE;
  }
  lesson = load (watch, faults);
  watch->tell (faults, watch->user);
  watch_files (watch, lesson == NULL ? faults->site_file : lesson->site_file);
  if (lesson == NULL)
    return G_SOURCE_REMOVE;
  lesson_words_translate (lesson);
  session_renew_lesson (watch->session, lesson);
  g_free (watch->shown);
  watch->shown = make_digest (watch);
  return G_SOURCE_REMOVE;
}

/* Files */

/* Returns: whether a file is whole now; else it is being written, or away for
 *          a moment, or for good. */
static gboolean
is_whole (GFileMonitorEvent event)
{
  return event == G_FILE_MONITOR_EVENT_CHANGES_DONE_HINT
         || event == G_FILE_MONITOR_EVENT_RENAMED
         || event == G_FILE_MONITOR_EVENT_MOVED_IN
         || event == G_FILE_MONITOR_EVENT_ATTRIBUTE_CHANGED;
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
  g_clear_handle_id (&watch->source, g_source_remove);
  watch->source = g_timeout_add (is_whole (event) ? SETTLE_MS : PATIENCE_MS,
                                 on_settled, watch);
}

/* Takes @path; keeps the monitor that there is for it. */
static void
watch_file (LessonWatch *watch, GHashTable *before, char *path)
{
  g_autoptr (GFile) file = g_file_new_for_path (path);
  gpointer known_path, monitor;

  if (g_hash_table_contains (watch->monitors, path)) {
    g_free (path);
    return;
  }
  if (g_hash_table_steal_extended (before, path, &known_path, &monitor)) {
    g_free (known_path);
  } else {
    monitor
        = g_file_monitor_file (file, G_FILE_MONITOR_WATCH_MOVES, NULL, NULL);
    if (monitor != NULL)
      g_signal_connect (monitor, "changed", G_CALLBACK (on_file), watch);
  }
  if (monitor != NULL)
    g_hash_table_insert (watch->monitors, path, monitor);
  else
    g_free (path);
}

/* A link, and what it leads to. */
static void
watch_link (LessonWatch *watch, GHashTable *before, const char *path)
{
  char *true_path = realpath (path, NULL);

  watch_file (watch, before, g_canonicalize_filename (path, NULL));
  if (true_path != NULL)
    watch_file (watch, before, g_strdup (true_path));
  free (true_path);
}

static void
watch_files (LessonWatch *watch, const char *site_file)
{
  g_autofree char *sites = site_path (watch, site_file);
  g_autoptr (GHashTable) before = watch->monitors;

  watch->monitors
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, free_monitor);
  watch_link (watch, before, watch->path);
  if (sites != NULL)
    watch_link (watch, before, sites);
}

void
lesson_watch_set_path (LessonWatch *watch, const char *path)
{
  g_autofree char *kept = g_strdup (path);
  const Lesson *lesson = session_get_lesson (watch->session);

  stop (watch);
  watch->tell (NULL, watch->user);
  if (kept == NULL || lesson == NULL)
    return;
  watch->path = g_steal_pointer (&kept);
  watch_files (watch, lesson->site_file);
  watch->shown = make_digest (watch);
}
