#include "lesson-copy.h"

#include "document.h"
#include "lesson-words.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <string.h>

#define MOST_COPIES 1000

char *
lesson_copy_folder (void)
{
  const char *documents = g_get_user_special_dir (G_USER_DIRECTORY_DOCUMENTS);

  return g_build_filename (documents != NULL ? documents : g_get_home_dir (),
                           "Hull2VD", NULL);
}

/* Returns: (transfer full): NAME.md, NAME-2.md, … : the first that is free. */
static char *
find_free (const char *folder, const char *path)
{
  g_autofree char *name = g_path_get_basename (path);

  if (g_str_has_suffix (name, ".md"))
    name[strlen (name) - strlen (".md")] = '\0';
  for (guint i = 1; i <= MOST_COPIES; i++) {
    g_autofree char *numbered = i == 1 ? g_strdup_printf ("%s.md", name)
                                       : g_strdup_printf ("%s-%u.md", name, i);
    g_autofree char *free_path = g_build_filename (folder, numbered, NULL);

    if (!g_file_test (free_path, G_FILE_TEST_EXISTS))
      return g_steal_pointer (&free_path);
  }
  return NULL;
}

static gboolean
make_folder (const char *folder, GError **error)
{
  g_autofree char *shown = display_path (folder);

  if (g_mkdir_with_parents (folder, 0755) == 0)
    return TRUE;
  g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE, "%s: %s",
               shown, g_strerror (errno));
  return FALSE;
}

static gboolean
copy_file (const char *from, const char *to, GError **error)
{
  g_autofree char *text = NULL;
  gsize length;

  return g_file_get_contents (from, &text, &length, error)
         && document_write (to, text, length, error);
}

/* Who changes a lesson reads it in the language in which it is shown. */
static gboolean
copy_words (const char *from, const char *to, GError **error)
{
  g_autofree char *text = NULL, *translated = NULL;
  gsize length;

  if (!g_file_get_contents (from, &text, &length, error))
    return FALSE;
  translated = lesson_words_write (text, length, from, lesson_words_look_up);
  if (translated == NULL)
    return document_write (to, text, length, error);
  return document_write (to, translated, strlen (translated), error);
}

/* The file of sites keeps its name, for the lesson says it; one that is there
 * already belongs to another copy and may have been changed. */
static gboolean
copy_sites (const Lesson *lesson, const char *folder, GError **error)
{
  g_autofree char *from_folder = g_path_get_dirname (lesson->path);
  g_autofree char *from
      = g_build_filename (from_folder, lesson->site_file, NULL);
  g_autofree char *to = g_build_filename (folder, lesson->site_file, NULL);
  g_autofree char *to_folder = g_path_get_dirname (to);

  return g_file_test (to, G_FILE_TEST_EXISTS)
         || (make_folder (to_folder, error) && copy_file (from, to, error));
}

char *
lesson_copy (const Lesson *lesson, const char *folder, GError **error)
{
  g_autofree char *path = NULL;

  if (!make_folder (folder, error))
    return NULL;
  path = find_free (folder, lesson->path);
  if (path == NULL) {
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE,
                 _ ("there are too many copies of this lesson"));
    return NULL;
  }
  if (!copy_words (lesson->path, path, error)
      || (lesson->site_file != NULL && !copy_sites (lesson, folder, error)))
    return NULL;
  return g_steal_pointer (&path);
}
