#include "document.h"

#include "input.h"
#include "lesson-source.h"
#include "lesson-words.h"
#include "site-file.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

/* As many reasons as Linux has. */
#define ERRNO_MAX 133

G_DEFINE_QUARK (document - error - quark, document_error)

gboolean
document_is_lesson (const char *path)
{
  return g_str_has_suffix (path, ".md");
}

SiteSet *
document_parse_points (const char *text,
                       gsize length,
                       const char *name,
                       GError **error)
{
  g_autofree char *shown = NULL;
  SiteFileError fault;
  SiteSet *set = site_file_parse (text, length, &fault);

  if (set != NULL)
    return set;
  shown = display_path (name);
  if (fault.line == 0)
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_REFUSED, "%s: %s", shown,
                 _ (fault.reason));
  else
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_REFUSED, "%s:%u: %s",
                 shown, fault.line, _ (fault.reason));
  return NULL;
}

static gboolean
refuse_file (DocumentError code, const char *path, int reason, GError **error)
{
  g_autofree char *shown = display_path (path);

  g_set_error (error, DOCUMENT_ERROR, (gint)code, "%s: %s", shown,
               code == DOCUMENT_ERROR_CANNOT_OPEN && reason == EPIPE
                   ? _ ("it is a pipe to which nobody writes")
                   : g_strerror (reason));
  return FALSE;
}

char *
document_read (const char *path,
               gsize *length,
               GCancellable *cancellable,
               GError **error)
{
  char *text = input_read (path, length, cancellable);

  if (text == NULL)
    refuse_file (DOCUMENT_ERROR_CANNOT_OPEN, path, errno, error);
  return text;
}

SiteSet *
document_read_points (const char *path, GError **error)
{
  gsize length;
  g_autofree char *text = document_read (path, &length, NULL, error);

  return text == NULL ? NULL
                      : document_parse_points (text, length, path, error);
}

static Site *
given_sites (const SiteSet *set)
{
  Site *sites = g_new (Site, set->n_sites + 1);

  for (guint i = 0; i < set->n_sites; i++)
    sites[i] = site_set_given (set, i);
  return sites;
}

/* Takes @set. */
static gboolean
open_set (Session *session, SiteSet *set, GError **error)
{
  g_autofree Site *sites = given_sites (set);
  const guint n_sites = set->n_sites;

  site_set_free (set);
  return session_open_sites (session, sites, n_sites, _ ("opening a file"),
                             error);
}

gboolean
document_open_lesson (Session *session, const char *path, GError **error)
{
  g_autoptr (Lesson) lesson = lesson_words_load (path, error);

  if (lesson == NULL)
    return FALSE;
  session_set_lesson (session, lesson);
  return TRUE;
}

/* No points have such a line. */
static gboolean
has_lesson_block (const char *text, gsize length)
{
  g_autoptr (GRegex) fence
      = g_regex_new ("^ {0,3}(`{3,}|~{3,}) *lesson *\r?$",
                     G_REGEX_RAW | G_REGEX_MULTILINE, 0, NULL);

  return g_regex_match_full (
      fence, text, (gssize)MIN (length, LESSON_MAX_BYTES), 0, 0, NULL, NULL);
}

static gboolean
open_text (Session *session,
           const char *text,
           gsize length,
           const char *path,
           GError **error)
{
  g_autoptr (Lesson) lesson = NULL;
  SiteSet *set;

  if (!input_is_standard (path) || !has_lesson_block (text, length)) {
    set = document_parse_points (text, length, path, error);
    return set != NULL && open_set (session, set, error);
  }
  lesson = lesson_parse (text, length, path, error);
  if (lesson != NULL)
    session_set_lesson (session, lesson);
  return lesson != NULL;
}

gboolean
document_open (Session *session, const char *path, GError **error)
{
  g_autofree char *text = NULL;
  gsize length;

  if (document_is_lesson (path))
    return document_open_lesson (session, path, error);
  text = document_read (path, &length, NULL, error);
  return text != NULL && open_text (session, text, length, path, error);
}

GBytes *
document_sites (Session *session)
{
  const SiteSet *set = session_get_set (session);

  return g_bytes_new_take (given_sites (set),
                           set->n_sites * sizeof *set->sites);
}

char *
document_sites_text (GBytes *sites)
{
  gsize length;
  const Site *each = g_bytes_get_data (sites, &length);
  GString *text = g_string_sized_new (length);

  for (gsize i = 0; i < length / sizeof *each; i++) {
    char line[SITE_LINE_ROOM];

    site_file_write_line (&each[i], line);
    g_string_append (text, line);
  }
  return g_string_free (text, FALSE);
}

char *
document_copy (Session *session)
{
  g_autoptr (GBytes) sites = document_sites (session);

  return document_sites_text (sites);
}

/* GLib has no code for some reasons, as for quotas, but their words. */
static gboolean
is_reason (const GError *error, int reason)
{
  return error->code == G_FILE_ERROR_FAILED
             ? g_str_has_suffix (error->message, g_strerror (reason))
             : (int)g_file_error_from_errno (reason) == error->code;
}

/* Returns: why, without the name that GLib has put into the message: it may be
 *          that of a temporary file. */
static const char *
reason_text (const GError *error)
{
  if (error->domain == G_FILE_ERROR)
    for (int reason = 1; reason <= ERRNO_MAX; reason++)
      if (is_reason (error, reason))
        return g_strerror (reason);
  return error->message;
}

/* Writes to what is not a file: a device or a pipe. */
static gboolean
write_through (const char *path,
               const char *bytes,
               gsize length,
               GError **error)
{
  FILE *file = g_fopen (path, "wbe");
  gboolean is_written;
  int reason;

  if (file == NULL)
    return refuse_file (DOCUMENT_ERROR_CANNOT_WRITE, path, errno, error);
  errno = 0;
  is_written = fwrite (bytes, 1, length, file) == length && fflush (file) == 0;
  reason = errno;
  if (fclose (file) != 0 && is_written) {
    is_written = FALSE;
    reason = errno;
  }
  return is_written
         || refuse_file (DOCUMENT_ERROR_CANNOT_WRITE, path, reason, error);
}

gboolean
document_write (const char *path,
                const char *bytes,
                gsize length,
                GError **error)
{
  char *resolved = realpath (path, NULL);
  g_autofree char *target = g_strdup (resolved == NULL ? path : resolved);
  g_autofree char *shown = NULL;
  g_autoptr (GError) reason = NULL;
  int mode = 0666;
  struct stat status;

  free (resolved);
  if (stat (target, &status) == 0) {
    if (!S_ISREG (status.st_mode))
      return write_through (path, bytes, length, error);
    mode = (int)(status.st_mode & 07777);
  }
  if (g_file_set_contents_full (target, bytes, (gssize)length,
                                G_FILE_SET_CONTENTS_CONSISTENT
                                    | G_FILE_SET_CONTENTS_DURABLE,
                                mode, &reason))
    return TRUE;
  shown = display_path (path);
  g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE, "%s: %s",
               shown, reason_text (reason));
  return FALSE;
}
