/* The files of a lesson: its own, and those of sites below its folder. */
#include "document.h"
#include "input.h"
#include "lesson-block.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void
set_errno_error (int code, GError **error)
{
  g_set_error (error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN, "%s",
               g_strerror (code));
}

/* Reads all there is, up to one byte more than a lesson may have. */
static char *
read_descriptor (int descriptor, gsize *length, GError **error)
{
  g_autofree char *text = g_malloc (LESSON_MAX_BYTES + 1);
  gssize n;

  *length = 0;
  while (*length <= LESSON_MAX_BYTES) {
    n = read (descriptor, text + *length, LESSON_MAX_BYTES + 1 - *length);
    if (n < 0 && errno == EINTR)
      continue;
    if (n < 0) {
      set_errno_error (errno, error);
      return NULL;
    }
    if (n == 0)
      break;
    *length += (gsize)n;
  }
  return g_steal_pointer (&text);
}

char *
lesson_read (const char *path, gsize *length, GError **error)
{
  const int descriptor = input_open (path);
  g_autofree char *name = display_path (path);
  g_autoptr (GError) reason = NULL;
  char *text = NULL;

  if (descriptor >= 0) {
    text = read_descriptor (descriptor, length, &reason);
    close (descriptor);
  } else {
    set_errno_error (errno, &reason);
  }
  if (text == NULL)
    g_set_error (error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN, "%s: %s", name,
                 reason->message);
  return text;
}

Lesson *
lesson_load (const char *path, GError **error)
{
  gsize length;
  g_autofree char *text = lesson_read (path, &length, error);

  return text == NULL ? NULL : lesson_parse (text, length, path, error);
}

Lesson *
lesson_load_unplayed (const char *path, GError **error)
{
  gsize length;
  g_autofree char *text = lesson_read (path, &length, error);

  return text == NULL ? NULL
                      : lesson_parse_unplayed (text, length, path, error);
}

Lesson *
lesson_load_all (const char *path, LessonFaults *faults)
{
  GError *error = NULL;
  gsize length;
  g_autofree char *text = lesson_read (path, &length, &error);

  if (text != NULL)
    return lesson_parse_all (text, length, path, faults);
  lesson_faults_take (faults, error);
  return NULL;
}

static gboolean
refuse (const char *reason, GError **error)
{
  g_set_error (error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN, "%s", reason);
  return FALSE;
}

static gboolean
check_name (const char *name, GError **error)
{
  g_auto (GStrv) parts = g_strsplit (name, "/", -1);

  if (*name == '\0')
    return refuse (_ ("which file? write: sites file NAME"), error);
  if (g_path_is_absolute (name) || g_strv_contains ((const char **)parts, ".."))
    return refuse (
        _ ("a file of sites must lie in the lesson’s folder or below it"),
        error);
  return TRUE;
}

/* Returns: (transfer full): the true path of @name, links followed, when it
 *          lies below @folder. */
static char *
find_below (const char *folder, const char *name, GError **error)
{
  g_autofree char *joined = g_build_filename (folder, name, NULL);
  char *true_folder = realpath (folder, NULL);
  char *true_path = realpath (joined, NULL);
  char *found = NULL;

  if (true_folder == NULL || true_path == NULL) {
    set_errno_error (errno, error);
  } else {
    const gsize length = strlen (true_folder);

    if (strncmp (true_path, true_folder, length) == 0
        && (true_path[length] == '/' || g_str_equal (true_folder, "/")))
      found = g_strdup (true_path);
    else
      refuse (_ ("a file of sites must lie in the lesson’s folder or below it"),
              error);
  }
  free (true_folder);
  free (true_path);
  return found;
}

/* Opens a regular file alone; no link, device or pipe, which could block. */
static char *
read_regular (const char *path, gsize *length, GError **error)
{
  const int descriptor
      = g_open (path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0);
  char *text = NULL;
  struct stat status;

  if (descriptor < 0) {
    set_errno_error (errno, error);
    return NULL;
  }
  if (fstat (descriptor, &status) != 0 || !S_ISREG (status.st_mode))
    refuse (_ ("this is not a regular file"), error);
  else if (status.st_size > LESSON_MAX_BYTES)
    refuse (_ ("the file is larger than 4 MB"), error);
  else
    text = read_descriptor (descriptor, length, error);
  close (descriptor);
  return text;
}

static gboolean
take_sites (const SiteSet *set, Lesson *lesson, GError **error)
{
  if (set->n_sites > LESSON_MAX_SITES)
    return refuse (_ ("there are more than 20000 sites"), error);
  lesson->n_sites = set->n_sites;
  lesson->sites = g_new (Site, set->n_sites + 1);
  for (guint i = 0; i < set->n_sites; i++)
    lesson->sites[i] = site_set_given (set, i);
  return TRUE;
}

gboolean
lesson_read_site_file (const char *folder,
                       const char *name,
                       Lesson *lesson,
                       GError **error)
{
  g_autofree char *path = NULL, *shown = NULL, *text = NULL;
  g_autoptr (GError) reason = NULL;
  gboolean is_taken;
  gsize length;
  SiteSet *set;

  if (!check_name (name, error)
      || (path = find_below (folder, name, error)) == NULL
      || (text = read_regular (path, &length, error)) == NULL)
    return FALSE;

  shown = g_build_filename (folder, name, NULL);
  set = document_parse_points (text, length, shown, &reason);
  if (set == NULL) {
    g_set_error (error, LESSON_ERROR, LESSON_ERROR_SITES, "%s",
                 reason->message);
    return FALSE;
  }
  is_taken = take_sites (set, lesson, error);
  site_set_free (set);
  return is_taken;
}
