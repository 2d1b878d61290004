#include "lesson-list.h"

#include "lesson-words.h"
#include "locate.h"

#include <glib/gi18n.h>

static void
free_entry (gpointer data)
{
  LessonEntry *entry = data;

  g_free (entry->path);
  g_free (entry->title);
  g_free (entry);
}

GPtrArray *
lesson_list_new (void)
{
  GPtrArray *entries = g_ptr_array_new_with_free_func (free_entry);
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  for (guint i = 0; i < paths->len; i++) {
    const char *path = g_ptr_array_index (paths, i);
    g_autoptr (Lesson) lesson = lesson_words_load (path, NULL);
    LessonEntry *entry;

    if (lesson == NULL)
      continue;
    entry = g_new0 (LessonEntry, 1);
    entry->path = g_strdup (path);
    entry->title = g_strdup (lesson->title);
    g_ptr_array_add (entries, entry);
  }
  return entries;
}

char *
lesson_list_progress (const Progress *progress, const char *path)
{
  g_autofree char *name = g_path_get_basename (path);
  const LessonRecord *record = progress_find (progress, name);

  if (record == NULL || (record->furthest == 0 && record->n_stops > 1))
    return NULL;
  if (lesson_record_is_done (record))
    return g_strdup ("✓");
  if (record->furthest + 1 >= record->n_stops) {
    const guint n = lesson_record_count (record, OUTCOME_OPEN);

    return g_strdup_printf (
        ngettext ("%u question open", "%u questions open", n), n);
  }
  return g_strdup_printf (_ ("%u of %u"), record->furthest + 1,
                          record->n_stops);
}

char *
lesson_list_next (const char *path)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();
  g_autofree char *here = g_canonicalize_filename (path, NULL);

  for (guint i = 0; i + 1 < paths->len; i++) {
    g_autofree char *other
        = g_canonicalize_filename (g_ptr_array_index (paths, i), NULL);

    if (g_str_equal (other, here))
      return g_strdup (g_ptr_array_index (paths, i + 1));
  }
  return NULL;
}

char *
lesson_list_title (const char *path)
{
  g_autoptr (Lesson) lesson = lesson_words_load (path, NULL);

  return lesson == NULL ? NULL : g_strdup (lesson->title);
}

char *
lesson_list_last (const Progress *progress)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();
  const char *best = NULL;
  gint64 last = 0;

  for (guint i = 0; i < paths->len; i++) {
    const char *path = g_ptr_array_index (paths, i);
    g_autofree char *name = g_path_get_basename (path);
    const LessonRecord *record = progress_find (progress, name);

    if (record != NULL && record->last > last) {
      best = path;
      last = record->last;
    }
  }
  return g_strdup (best);
}

guint
lesson_list_number (const char *path)
{
  g_autofree char *name = g_path_get_basename (path);

  return (guint)g_ascii_strtoull (name, NULL, 10);
}

char *
lesson_list_first (void)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  for (guint i = 0; i < paths->len; i++)
    if (lesson_list_number (g_ptr_array_index (paths, i)) > 0)
      return g_strdup (g_ptr_array_index (paths, i));
  return NULL;
}
