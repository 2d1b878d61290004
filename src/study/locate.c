#include "locate.h"

#include "config.h"
#include "lesson-words.h"

#include <libintl.h>
#include <string.h>

/* Returns: whether the running program lies in its build folder. */
static gboolean
is_in_build_folder (void)
{
  g_autofree char *program = g_file_read_link ("/proc/self/exe", NULL);

  return program != NULL && g_str_has_prefix (program, BUILD_ROOT "/");
}

char *
locate_lessons (void)
{
  const char *chosen = g_getenv ("HULL2VD_LESSONS");

  if (chosen != NULL && *chosen != '\0')
    return g_strdup (chosen);
  if (is_in_build_folder ())
    return g_build_filename (SOURCE_ROOT, "lessons", NULL);
  return g_build_filename (DATADIR, "hull2vd", "lessons", NULL);
}

static int
compare_paths (const void *left, const void *right)
{
  return strcmp (*(char *const *)left, *(char *const *)right);
}

/* The names of lessons begin with their number. */
static gboolean
is_lesson (const char *name)
{
  return g_ascii_isdigit (name[0]) && g_str_has_suffix (name, ".md");
}

GPtrArray *
locate_lesson_files (void)
{
  GPtrArray *paths = g_ptr_array_new_with_free_func (g_free);
  g_autofree char *folder = locate_lessons ();
  g_autoptr (GDir) directory = g_dir_open (folder, 0, NULL);
  const char *name;

  while (directory != NULL && (name = g_dir_read_name (directory)) != NULL)
    if (is_lesson (name))
      g_ptr_array_add (paths, g_build_filename (folder, name, NULL));
  g_ptr_array_sort (paths, compare_paths);
  return paths;
}

/* Catalogs of one domain: in the folder that was chosen, in that of the build,
 * or where they were installed. */
static void
bind_domain (const char *domain, const char *build_folder)
{
  const char *chosen = g_getenv ("HULL2VD_LOCALE");

  if (chosen != NULL && *chosen != '\0')
    bindtextdomain (domain, chosen);
  else
    bindtextdomain (domain, is_in_build_folder () ? build_folder : LOCALEDIR);
  bind_textdomain_codeset (domain, "UTF-8");
}

void
locate_translations (void)
{
  bind_domain (GETTEXT_PACKAGE, BUILD_ROOT "/po");
  bind_domain (LESSON_WORDS_DOMAIN, BUILD_ROOT "/lessons/po");
  textdomain (GETTEXT_PACKAGE);
}
