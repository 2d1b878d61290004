#include "recovery.h"

#include "document.h"
#include "input.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#define TEXT ".txt"
#define LOCK ".lock"
#define ORIGIN "# from "
#define UNLOCKED (-1)

struct Recovery {
  char *folder, *name;
  char *path, *lock_path;
  char *origin;
  int lock; /* its file, or UNLOCKED */
};

char *
recovery_default_folder (void)
{
  return g_build_filename (g_get_user_data_dir (), "hull2vd", "unsaved", NULL);
}

static Recovery *
recovery_new_named (const char *folder, const char *name)
{
  Recovery *recovery = g_new0 (Recovery, 1);
  g_autofree char *text = g_strconcat (name, TEXT, NULL);
  g_autofree char *lock = g_strconcat (name, LOCK, NULL);

  recovery->folder = g_strdup (folder);
  recovery->name = g_strdup (name);
  recovery->path = g_build_filename (folder, text, NULL);
  recovery->lock_path = g_build_filename (folder, lock, NULL);
  recovery->lock = UNLOCKED;
  return recovery;
}

Recovery *
recovery_new (const char *folder)
{
  g_autofree char *name = g_uuid_string_random ();

  return recovery_new_named (folder, name);
}

/* Lock */

static gboolean
is_at (int file, const char *path)
{
  struct stat here, there;

  return fstat (file, &here) == 0 && stat (path, &there) == 0
         && here.st_ino == there.st_ino && here.st_dev == there.st_dev;
}

/* A lock upon a file that another has meanwhile taken away holds nothing. */
static gboolean
take_lock (Recovery *recovery, int how)
{
  while (recovery->lock == UNLOCKED) {
    int file = g_open (recovery->lock_path, O_CREAT | O_RDWR | O_CLOEXEC, 0600);

    if (file < 0)
      return FALSE;
    if (flock (file, how) != 0) {
      close (file);
      return FALSE;
    }
    if (is_at (file, recovery->lock_path))
      recovery->lock = file;
    else
      close (file);
  }
  return TRUE;
}

static void
drop_lock (Recovery *recovery)
{
  if (recovery->lock == UNLOCKED)
    return;
  close (recovery->lock);
  recovery->lock = UNLOCKED;
}

/* A program that is killed while it writes leaves a text that it has begun
 * beside the one before. */
static void
remove_texts (Recovery *recovery)
{
  g_autoptr (GDir) dir = g_dir_open (recovery->folder, 0, NULL);
  g_autofree char *start = g_strconcat (recovery->name, TEXT, NULL);
  const char *name;

  while (dir != NULL && (name = g_dir_read_name (dir)) != NULL)
    if (g_str_has_prefix (name, start)) {
      g_autofree char *path = g_build_filename (recovery->folder, name, NULL);

      g_unlink (path);
    }
}

void
recovery_clear (Recovery *recovery)
{
  if (recovery->lock == UNLOCKED)
    return;
  remove_texts (recovery);
  g_unlink (recovery->lock_path);
  drop_lock (recovery);
}

void
recovery_free (Recovery *recovery)
{
  if (recovery == NULL)
    return;
  drop_lock (recovery);
  g_free (recovery->folder);
  g_free (recovery->name);
  g_free (recovery->path);
  g_free (recovery->lock_path);
  g_free (recovery->origin);
  g_free (recovery);
}

/* Text */

const char *
recovery_get_path (const Recovery *recovery)
{
  return recovery->path;
}

const char *
recovery_get_origin (const Recovery *recovery)
{
  return recovery->origin;
}

GDateTime *
recovery_get_time (const Recovery *recovery)
{
  GStatBuf status;

  if (g_stat (recovery->path, &status) != 0)
    return NULL;
  return g_date_time_new_from_unix_local (status.st_mtime);
}

/* A path may hold any byte but NUL, a comment no line end. */
static char *
origin_line (const char *origin)
{
  g_autofree char *whole = NULL, *uri = NULL;

  if (origin == NULL)
    return g_strdup ("");
  whole = g_canonicalize_filename (origin, NULL);
  uri = g_filename_to_uri (whole, NULL, NULL);
  return uri == NULL ? g_strdup ("") : g_strdup_printf (ORIGIN "%s\n", uri);
}

gboolean
recovery_write (Recovery *recovery,
                const char *origin,
                const char *text,
                GError **error)
{
  g_autofree char *line = origin_line (origin);
  g_autofree char *whole = g_strconcat (
      "# sites of Hull2VD that are in no file yet\n", line, text, NULL);

  if (g_mkdir_with_parents (recovery->folder, 0700) != 0
      || !take_lock (recovery, LOCK_EX)) {
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE, "%s: %s",
                 recovery->folder, g_strerror (errno));
    return FALSE;
  }
  return document_write (recovery->path, whole, strlen (whole), error);
}

/* What is left over */

static char *
read_origin (const char *path)
{
  gsize length;
  g_autofree char *text = input_read (path, &length, NULL);
  g_auto (GStrv) lines = text != NULL ? g_strsplit (text, "\n", 3) : NULL;

  if (lines == NULL || lines[0] == NULL || lines[1] == NULL
      || !g_str_has_prefix (lines[1], ORIGIN))
    return NULL;
  return g_filename_from_uri (lines[1] + strlen (ORIGIN), NULL, NULL);
}

/* The oldest first. */
static int
compare (gconstpointer a, gconstpointer b)
{
  GStatBuf status[2] = { 0 };
  const Recovery *recoveries[]
      = { *(Recovery *const *)a, *(Recovery *const *)b };

  for (int k = 0; k < 2; k++)
    g_stat (recoveries[k]->path, &status[k]);
  if (status[0].st_mtime != status[1].st_mtime)
    return status[0].st_mtime < status[1].st_mtime ? -1 : 1;
  return strcmp (recoveries[0]->name, recoveries[1]->name);
}

/* Whoever has written, or begun to write, has a lock there. */
static GPtrArray *
list_all (const char *folder)
{
  GPtrArray *all
      = g_ptr_array_new_with_free_func ((GDestroyNotify)recovery_free);
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  const char *file;

  while (dir != NULL && (file = g_dir_read_name (dir)) != NULL)
    if (g_str_has_suffix (file, LOCK)) {
      g_autofree char *name = g_strndup (file, strlen (file) - strlen (LOCK));

      g_ptr_array_add (all, recovery_new_named (folder, name));
    }
  g_ptr_array_sort (all, compare);
  return all;
}

/* Who was quicker may have dealt with it: then there is no text any more. */
static gboolean
claim (Recovery *recovery)
{
  if (!take_lock (recovery, LOCK_EX | LOCK_NB))
    return FALSE;
  if (!g_file_test (recovery->path, G_FILE_TEST_IS_REGULAR)) {
    recovery_clear (recovery);
    return FALSE;
  }
  recovery->origin = read_origin (recovery->path);
  return TRUE;
}

Recovery *
recovery_claim (const char *folder)
{
  g_autoptr (GPtrArray) all = list_all (folder);

  for (guint i = 0; i < all->len; i++)
    if (claim (g_ptr_array_index (all, i)))
      return g_ptr_array_steal_index (all, i);
  return NULL;
}
