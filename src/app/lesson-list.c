#include "lesson-list.h"

#include "lesson-words.h"
#include "locate.h"

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
