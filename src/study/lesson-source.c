#include "lesson-source.h"

#include "lesson.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

/* No lesson needs more; beyond, the time that libcmark takes grows with the
 * square, and its memory beyond measure. */
#define MAX_NESTING_BYTES 100
#define MAX_LINES 200000
#define MAX_BRACKETS 10000
#define MAX_MARKS 100000

char *
display_path (const char *path)
{
  g_autofree char *name = g_filename_display_name (path);
  GString *shown = g_string_new (NULL);

  for (const char *p = name; *p != '\0'; p = g_utf8_next_char (p)) {
    const gunichar c = g_utf8_get_char (p);

    g_string_append_unichar (shown, g_unichar_isprint (c) ? c : 0xFFFD);
  }
  return g_string_free (shown, FALSE);
}

gboolean
lesson_source_blame (const LessonSource *source,
                     guint line,
                     guint column,
                     GError **error,
                     const char *format,
                     ...)
{
  g_autofree char *reason = NULL, *short_reason = NULL;
  va_list arguments;

  va_start (arguments, format);
  reason = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  short_reason = words_shorten (reason);
  g_set_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN, "%s:%u:%u: %s",
               source->name, line, column, short_reason);
  return FALSE;
}

/* Where the check stands. */
typedef struct Cursor {
  const LessonSource *source;
  const char *line; /* begin of the line */
  guint number;     /* of the line, from 1 */
  guint n_brackets, n_marks;
} Cursor;

static gboolean
blame_at (const Cursor *cursor,
          const char *at,
          GError **error,
          const char *reason)
{
  const guint column = 1 + (guint)g_utf8_pointer_to_offset (cursor->line, at);

  return lesson_source_blame (cursor->source, cursor->number, column, error,
                              "%s", reason);
}

/* Marks that reorder text or cannot be seen could make a lesson read
 * otherwise than it runs. */
static gboolean
is_invisible (gunichar c)
{
  return (c >= 0x7F && c <= 0x9F) || c == 0x200B || c == 0x2028 || c == 0x2029
         || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069)
         || c == 0xFEFF;
}

/* Returns: why the character at @at is refused, or NULL. */
static const char *
character_fault (const char *at, const char *end)
{
  const gunichar c = g_utf8_get_char_validated (at, end - at);

  if (*at == '\0')
    return _ ("a zero byte");
  if ((gint32)c < 0)
    return _ ("this is not UTF-8");
  if (c == '\r')
    return _ ("a carriage return that does not end a line");
  if (c < ' ' && c != '\t')
    return _ ("a control character");
  if (is_invisible (c))
    return _ ("an invisible character");
  return NULL;
}

/* Returns: how many blanks begin a line, which may be the last of a text that
 * nothing ends. */
static gsize
count_blanks (const char *line, gsize length)
{
  gsize n = 0;

  while (n < length && (line[n] == ' ' || line[n] == '\t'))
    n += 1;
  return n;
}

/* Returns: whether the line is blank, or a rule or underline of one mark
 *          alone, which nests nothing. */
static gboolean
is_rule (const char *line, gsize length)
{
  const gsize blanks = count_blanks (line, length);
  char mark = ' ';

  if (blanks < length)
    mark = line[blanks];
  for (gsize i = blanks; i < length; i++)
    if (line[i] != mark && line[i] != ' ' && line[i] != '\t')
      return FALSE;
  return blanks >= length || mark == '-' || mark == '*';
}

/* Returns: how many bytes of blanks and of marks of lists and quotations
 *          begin the line: they bound the depth of nesting. */
static gsize
nesting_bytes (const char *line, gsize length)
{
  gsize n = 0;

  if (is_rule (line, length))
    return 0;
  while (n < length && strchr (" \t>-+*.)0123456789", line[n]) != NULL)
    n += 1;
  return n;
}

/* Returns: FALSE when there are too many characters that mean something in
 * CommonMark. */
static gboolean
count_mark (Cursor *cursor, char character)
{
  cursor->n_brackets += character == '[' ? 1 : 0;
  cursor->n_marks += strchr ("[]!*_`<&\\", character) != NULL ? 1 : 0;
  return cursor->n_brackets <= MAX_BRACKETS && cursor->n_marks <= MAX_MARKS;
}

/* Checks a line of @length bytes without its line end. */
static gboolean
check_line (Cursor *cursor, gsize length, GError **error)
{
  const char *end = cursor->line + length;
  const char *fault;

  if (cursor->number > MAX_LINES)
    return blame_at (cursor, cursor->line, error, _ ("more than 200000 lines"));
  if (length > LESSON_MAX_LINE)
    return blame_at (cursor, cursor->line, error,
                     _ ("a line longer than 64 KB"));
  for (const char *at = cursor->line; at < end; at = g_utf8_next_char (at)) {
    fault = character_fault (at, end);
    if (fault != NULL)
      return blame_at (cursor, at, error, fault);
    if (!count_mark (cursor, *at))
      return blame_at (cursor, at, error,
                       _ ("too many marks: 10000 opening brackets, 100000 of "
                          "all marks at most"));
  }
  if (nesting_bytes (cursor->line, length) > MAX_NESTING_BYTES)
    return blame_at (cursor, cursor->line, error, _ ("nested too deeply"));
  return TRUE;
}

/* Checks all lines and copies them with LF as their end. */
static gboolean
check_lines (LessonSource *source,
             const char *text,
             gsize length,
             GError **error)
{
  Cursor cursor = { source, text, 0, 0, 0 };
  const char *end = text + length;
  char *copy = source->text;

  for (; cursor.line < end;) {
    const char *line_end
        = memchr (cursor.line, '\n', (gsize)(end - cursor.line));
    const char *next = line_end == NULL ? end : line_end + 1;
    gsize n = (gsize)((line_end == NULL ? end : line_end) - cursor.line);
    const gsize at = (gsize)(copy - source->text);

    n -= n > 0 && line_end != NULL && cursor.line[n - 1] == '\r' ? 1 : 0;
    cursor.number += 1;
    if (!check_line (&cursor, n, error))
      return FALSE;
    g_array_append_val (source->lines, at);
    memcpy (copy, cursor.line, n);
    copy += n;
    *copy++ = '\n';
    cursor.line = next;
  }
  *copy = '\0';
  return TRUE;
}

static guint
count_lines (const char *text, gsize length)
{
  guint n = 1;

  for (gsize i = 0; i < length; i++)
    n += text[i] == '\n' ? 1 : 0;
  return n;
}

/* The limits that need no reading. */
static gboolean
check_size (const LessonSource *source,
            const char *text,
            gsize length,
            GError **error)
{
  if (length == 0)
    return lesson_source_blame (source, 1, 1, error, _ ("the file is empty"));
  if (length > LESSON_MAX_BYTES)
    return lesson_source_blame (source, count_lines (text, LESSON_MAX_BYTES), 1,
                                error, _ ("the file is larger than 4 MB"));
  return TRUE;
}

LessonSource *
lesson_source_new (const char *text,
                   gsize length,
                   const char *path,
                   GError **error)
{
  static const char mark[] = "\xEF\xBB\xBF";
  g_autoptr (LessonSource) source = g_new0 (LessonSource, 1);

  source->name = display_path (path);
  source->lines = g_array_new (FALSE, FALSE, sizeof (gsize));
  if (!check_size (source, text, length, error))
    return NULL;
  if (length >= strlen (mark) && memcmp (text, mark, strlen (mark)) == 0) {
    text += strlen (mark);
    length -= strlen (mark);
  }
  source->text = g_malloc (length + 2);
  if (!check_lines (source, text, length, error))
    return NULL;
  return g_steal_pointer (&source);
}

void
lesson_source_free (LessonSource *source)
{
  g_free (source->name);
  g_free (source->text);
  g_array_unref (source->lines);
  g_free (source);
}

guint
lesson_source_n_lines (const LessonSource *source)
{
  return source->lines->len;
}

const char *
lesson_source_line (const LessonSource *source, guint line, gsize *length)
{
  const char *start
      = source->text + g_array_index (source->lines, gsize, line - 1);

  *length = strcspn (start, "\n");
  return start;
}

gsize
lesson_source_bytes (const LessonSource *source, guint first, guint last)
{
  gsize length;
  const char *start = lesson_source_line (source, first, &length);
  const char *end = lesson_source_line (source, last, &length) + length;

  return (gsize)(end - start);
}

static guint
column_of (const char *text, const char *at)
{
  return 1 + (guint)g_utf8_pointer_to_offset (text, at);
}

void
lesson_line_init (LessonLine *line, const LessonSource *source, guint number)
{
  gsize length;
  const char *start = lesson_source_line (source, number, &length);
  const gsize blanks = count_blanks (start, length);

  line->line = number;
  line->column = column_of (start, start + blanks);
  line->text = g_strchomp (g_strndup (start + blanks, length - blanks));
  if (line->text[0] == '#')
    line->text[0] = '\0';
}

void
lesson_line_clear (LessonLine *line)
{
  g_clear_pointer (&line->text, g_free);
}

gboolean
lesson_line_blame (const LessonLine *line,
                   const LessonSource *source,
                   const char *at,
                   const char *reason,
                   GError **error)
{
  return lesson_source_blame (source, line->line,
                              line->column + column_of (line->text, at) - 1,
                              error, "%s", reason);
}

LessonFaults *
lesson_faults_new (void)
{
  LessonFaults *faults = g_new0 (LessonFaults, 1);

  faults->errors
      = g_ptr_array_new_with_free_func ((GDestroyNotify)g_error_free);
  faults->html_lines = g_array_new (FALSE, FALSE, sizeof (guint));
  return faults;
}

void
lesson_faults_free (LessonFaults *faults)
{
  g_ptr_array_unref (faults->errors);
  g_array_unref (faults->html_lines);
  g_free (faults->site_file);
  g_free (faults);
}

void
lesson_faults_take (LessonFaults *faults, GError *error)
{
  if (lesson_faults_is_full (faults))
    g_error_free (error);
  else
    g_ptr_array_add (faults->errors, error);
}

gboolean
lesson_faults_is_full (const LessonFaults *faults)
{
  return faults->errors->len == LESSON_MAX_FAULTS;
}
