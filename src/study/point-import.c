#include "point-import.h"

#include "decimal-comma.h"
#include "document.h"
#include "lesson-source.h"
#include "lesson-words.h"
#include "site-file.h"
#include "words.h"

#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>

#define BYTE_ORDER_MARK "\xef\xbb\xbf"
/* Longer first lines are no headings. */
#define HEAD_MAX 200

/* What comes before the rows. */
typedef struct Head {
  gsize length;                     /* bytes of the text that are no rows */
  guint n_lines;                    /* that these bytes make */
  guint dimension_line, count_line; /* where dimension and number of rows are
                                       said, 0: nowhere */
  guint64 n_rows;
} Head;

/* A walk through the lines of a text. */
typedef struct Lines {
  const char *next, *end;
  guint n; /* lines so far */
} Lines;

/* Returns: (transfer full): the next line that says something, without blanks
 *          around it, or NULL when there is none or it is too long to be
 *          looked at. */
static char *
next_line (Lines *lines)
{
  while (lines->next < lines->end) {
    const char *start = lines->next;
    const char *feed = memchr (start, '\n', (gsize)(lines->end - start));
    const char *stop = feed == NULL ? lines->end : feed;
    g_autofree char *line = NULL;

    if (stop - start > HEAD_MAX)
      return NULL;
    lines->next = feed == NULL ? lines->end : feed + 1;
    lines->n += 1;
    line = g_strstrip (g_strndup (start, (gsize)(stop - start)));
    if (*line != '\0' && *line != '#')
      return g_steal_pointer (&line);
  }
  return NULL;
}

/* Whether @field may be what a column is called. */
static gboolean
is_heading (const char *field)
{
  static const char *const numbers[]
      = { "nan", "inf", "infinity", "nil", "null", "none", NULL };
  g_autofree char *name = g_strstrip (g_strdup (field));
  const gsize length = strlen (name);
  const gboolean is_quoted
      = length > 2 && name[0] == '"' && name[length - 1] == '"';
  g_autofree char *bare = is_quoted ? g_strndup (name + 1, length - 2) : NULL;
  g_autofree char *lower = g_ascii_strdown (is_quoted ? bare : name, -1);

  if (!g_utf8_validate (lower, -1, NULL)
      || !g_unichar_isalpha (g_utf8_get_char (lower)))
    return FALSE;
  for (const char *c = lower; *c != '\0'; c = g_utf8_next_char (c))
    if (g_unichar_iscntrl (g_utf8_get_char (c)) || *c == '"')
      return FALSE;
  /* No number was written there, but one was meant. */
  return !g_strv_contains (numbers, lower);
}

/* Headings are names with one separator between them.
 *
 * Returns: how many there are, 0 when they are none. */
static guint
count_headings (const char *line)
{
  const char *separators = strpbrk (line, ",;\t");
  g_autofree char *separator
      = g_strndup (separators != NULL ? separators : " ", 1);
  g_auto (GStrv) fields = g_strsplit (line, separator, -1);
  guint n = 0;

  for (; fields[n] != NULL; n++)
    if (!is_heading (fields[n]))
      return 0;
  return n;
}

static void
take_lines (Head *head, const char *text, const Lines *lines)
{
  head->length = (gsize)(lines->next - text);
  head->n_lines = lines->n;
}

/* Prose is no table: under more or less than two names a number stands.
 *
 * Returns: how many columns have one, 0: there is no heading. */
static guint
read_headings (const char *text, Lines lines, Head *head)
{
  g_autofree char *first = next_line (&lines);
  Lines rest = lines;
  g_autofree char *row = first == NULL ? NULL : next_line (&rest);
  const guint n = row == NULL ? 0 : count_headings (first);

  if (n == 0 || (n != 2 && strchr ("+-.0123456789", row[0]) == NULL))
    return 0;
  take_lines (head, text, &lines);
  return n;
}

/* "2" or "2 rbox 10 D2": a number that a name follows, if anything does. */
static gboolean
is_dimension (const char *line, guint64 *dimension)
{
  g_auto (GStrv) words = words_split (line);

  return words[0] != NULL && words_parse_number (words[0], 1000, dimension)
         && (words[1] == NULL || g_ascii_isalpha (words[1][0]));
}

/* The dimension, then the number of points. */
static gboolean
read_counts (const char *text, Lines lines, Head *head, guint64 *dimension)
{
  g_autofree char *first = next_line (&lines);
  const guint first_line = lines.n;
  g_autofree char *second = first == NULL ? NULL : next_line (&lines);

  if (second == NULL || !is_dimension (first, dimension)
      || !words_parse_number (second, G_MAXUINT32, &head->n_rows))
    return FALSE;
  take_lines (head, text, &lines);
  head->dimension_line = first_line;
  head->count_line = lines.n;
  return TRUE;
}

static SiteSet *
refuse (const char *name, guint line, const char *reason, GError **error)
{
  g_autofree char *shown = display_path (name);

  if (line == 0)
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_REFUSED, "%s: %s", shown,
                 reason);
  else
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_REFUSED, "%s:%u: %s",
                 shown, line, reason);
  return NULL;
}

static SiteSet *
refuse_columns (const char *name, guint line, guint n, GError **error)
{
  g_autofree char *reason = g_strdup_printf (
      ngettext ("expected exactly two columns, x and y, found %u",
                "expected exactly two columns, x and y, found %u", n),
      n);

  return refuse (name, line, reason, error);
}

static SiteSet *
parse_rows (const char *text,
            gsize length,
            const Head *head,
            const char *name,
            GError **error)
{
  SiteFileError fault;
  SiteSet *set
      = site_file_parse (text + head->length, length - head->length, &fault);
  g_autofree char *announced = NULL;
  g_autofree char *reason = NULL;

  if (set == NULL)
    return refuse (name, fault.line == 0 ? 0 : head->n_lines + fault.line,
                   _ (fault.reason), error);
  if (head->count_line == 0 || head->n_rows == set->n_sites)
    return set;
  announced = g_strdup_printf ("%" G_GUINT64_FORMAT, head->n_rows);
  reason = g_strdup_printf (
      _ ("the number of points is given as %s, but %u follow"), announced,
      set->n_sites);
  site_set_free (set);
  return refuse (name, head->count_line, reason, error);
}

/* The rows, though they have commas where points are meant; where that is not
 * sure, nobody guesses. */
static SiteSet *
parse_table (const char *text,
             gsize length,
             const Head *head,
             const char *name,
             gboolean *is_foreign,
             GError **error)
{
  const gsize n_bytes = length - head->length;
  Head rest = *head;
  g_autofree char *rows = NULL;

  if (!decimal_comma_is_sure (text + head->length, n_bytes))
    return parse_rows (text, length, head, name, error);
  if (is_foreign != NULL)
    *is_foreign = TRUE;
  rows = decimal_comma_replace (text + head->length, n_bytes);
  rest.length = 0;
  return parse_rows (rows, n_bytes, &rest, name, error);
}

SiteSet *
point_import_parse (const char *text,
                    gsize length,
                    const char *name,
                    gboolean *is_foreign,
                    GError **error)
{
  const gsize mark = strlen (BYTE_ORDER_MARK);
  const gboolean is_marked
      = length >= mark && memcmp (text, BYTE_ORDER_MARK, mark) == 0;
  const Lines lines = { text + (is_marked ? mark : 0), text + length, 0 };
  Head head = { .length = 0 };
  guint64 dimension = 2;
  const guint n_headings = read_headings (text, lines, &head);
  const gboolean has_counts
      = n_headings == 0 && read_counts (text, lines, &head, &dimension);

  if (is_foreign != NULL)
    *is_foreign = n_headings > 0 || has_counts;
  if (n_headings > 0 && n_headings != 2)
    return refuse_columns (name, head.n_lines, n_headings, error);
  if (has_counts && dimension != 2)
    return refuse_columns (name, head.dimension_line, (guint)dimension, error);
  return parse_table (text, length, &head, name, is_foreign, error);
}

/* Into a session */

typedef gboolean (*PutSites) (Session *session,
                              const Site *sites,
                              guint n_sites,
                              const char *edit,
                              GError **error);

/* Takes @set. */
static gboolean
put_set (Session *session,
         SiteSet *set,
         PutSites put,
         const char *edit,
         GError **error)
{
  g_autofree Site *sites = g_new (Site, set->n_sites + 1);
  const guint n_sites = set->n_sites;

  for (guint i = 0; i < n_sites; i++)
    sites[i] = site_set_given (set, i);
  site_set_free (set);
  return put (session, sites, n_sites, edit, error);
}

SiteSet *
point_import_read (const char *path,
                   gboolean *is_foreign,
                   GCancellable *cancellable,
                   GError **error)
{
  gsize length;
  g_autofree char *text = document_read (path, &length, cancellable, error);

  *is_foreign = FALSE;
  return text == NULL
             ? NULL
             : point_import_parse (text, length, path, is_foreign, error);
}

gboolean
point_import_put (Session *session, SiteSet *set, GError **error)
{
  return put_set (session, set, session_open_sites, _ ("opening a file"),
                  error);
}

/* A lesson is read again when its file changes, and nothing is waited for. */
static gboolean
check_regular (const char *path, GError **error)
{
  GStatBuf status;

  if (g_stat (path, &status) != 0 || S_ISREG (status.st_mode)
      || S_ISDIR (status.st_mode))
    return TRUE; /* or what cannot be opened, which says why */
  refuse (path, 0, _ ("this is not a regular file"), error);
  return FALSE;
}

Lesson *
point_import_read_lesson (const char *path, GError **error)
{
  Lesson *lesson
      = check_regular (path, error) ? lesson_load_unplayed (path, error) : NULL;

  if (lesson != NULL)
    lesson_words_translate (lesson);
  return lesson;
}

gboolean
point_import_open (Session *session,
                   const char *path,
                   gboolean *is_foreign,
                   GError **error)
{
  SiteSet *set;

  *is_foreign = FALSE;
  if (document_is_lesson (path))
    return check_regular (path, error) && document_open (session, path, error);
  set = point_import_read (path, is_foreign, NULL, error);
  return set != NULL && point_import_put (session, set, error);
}

SiteSet *
point_import_read_text (const char *text,
                        gsize length,
                        const char *origin,
                        GError **error)
{
  SiteSet *set = point_import_parse (text, length, origin, NULL, error);

  if (set == NULL || set->n_sites > 0)
    return set;
  /* Nobody means to delete all sites by that. */
  site_set_free (set);
  return refuse (origin, 0, _ ("there are no points in it"), error);
}

gboolean
point_import_replace (Session *session,
                      SiteSet *set,
                      const char *edit,
                      GError **error)
{
  return put_set (session, set, session_replace_sites, edit, error);
}

gboolean
point_import_text (Session *session,
                   const char *text,
                   const char *origin,
                   const char *edit,
                   GError **error)
{
  SiteSet *set = point_import_read_text (text, strlen (text), origin, error);

  return set != NULL && point_import_replace (session, set, edit, error);
}
