#include "lesson-block.h"

#include "command.h"
#include "site-source.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

/* One line of a block, without the blanks around it. */
typedef struct BlockLine {
  guint line, column;
  char *text;
} BlockLine;

static guint
column_of (const char *line, gsize offset)
{
  return 1 + (guint)g_utf8_strlen (line, (gssize)offset);
}

/* Takes a line; empty lines and those that begin with # have no text. */
static void
block_line_init (BlockLine *line, const LessonSource *source, guint number)
{
  gsize length;
  const char *start = lesson_source_line (source, number, &length);
  const gsize blanks = strspn (start, " \t");

  line->line = number;
  line->column = column_of (start, blanks);
  line->text = g_strchomp (g_strndup (start + blanks, length - blanks));
  if (line->text[0] == '#')
    line->text[0] = '\0';
}

static gboolean
blame (const LessonSource *source,
       const BlockLine *line,
       gsize offset,
       const char *reason,
       GError **error)
{
  const guint column = line->column + column_of (line->text, offset) - 1;

  return lesson_source_blame (source, line->line, column, error, "%s", reason);
}

void
lesson_command_free (gpointer data)
{
  LessonCommand *command = data;

  g_free (command->text);
  g_free (command->verb);
  g_clear_pointer (&command->parameter, g_variant_unref);
  g_free (command);
}

/* Takes the text of @line. */
static gboolean
read_command (const LessonSource *source,
              BlockLine *line,
              GPtrArray *commands,
              GError **error)
{
  LessonCommand *command = g_new0 (LessonCommand, 1);
  g_autoptr (GError) reason = NULL;

  g_ptr_array_add (commands, command);
  command->line = line->line;
  command->column = line->column;
  command->text = g_strdup (line->text);
  return command_parse (line->text, &command->verb, &command->parameter,
                        &reason)
         || blame (source, line, 0, reason->message, error);
}

gboolean
lesson_block_read_steps (const LessonSource *source,
                         const LessonLines *lines,
                         guint *n_commands,
                         GPtrArray *commands,
                         GError **error)
{
  gboolean is_good = TRUE;

  for (guint number = lines->first; is_good && number <= lines->last;
       number++) {
    BlockLine line;

    block_line_init (&line, source, number);
    if (line.text[0] != '\0') {
      *n_commands += 1;
      is_good = *n_commands <= LESSON_MAX_COMMANDS
                    ? read_command (source, &line, commands, error)
                    : blame (source, &line, 0, _ ("more than 100000 commands"),
                             error);
    }
    g_free (line.text);
  }
  return is_good;
}

/* What a lesson block has said so far. */
typedef struct Head {
  const LessonSource *source;
  const char *folder;
  Lesson *lesson;
  gboolean has_format, has_sites;
} Head;

/* Returns: what follows the first word. */
static const char *
after_word (const char *text)
{
  text += strcspn (text, " \t");
  return text + strspn (text, " \t");
}

static gboolean
read_format (Head *head,
             const BlockLine *line,
             const char *value,
             GError **error)
{
  guint64 format;

  if (!words_parse_number (value, G_MAXUINT32, &format) || format == 0)
    return blame (head->source, line, (gsize)(value - line->text),
                  _ ("the format is a whole number: format 1"), error);
  if (format > LESSON_FORMAT)
    return lesson_source_blame (
        head->source, line->line, line->column, error,
        _ ("format %u is newer than this program knows; open this lesson with "
           "a Hull2VD that knows lesson format %u (this one knows %d)"),
        (guint)format, (guint)format, LESSON_FORMAT);
  return TRUE;
}

static gboolean
read_site_file (Head *head,
                const BlockLine *line,
                const char *name,
                GError **error)
{
  g_autoptr (GError) reason = NULL;

  if (lesson_read_site_file (head->folder, name, head->lesson, &reason))
    return TRUE;
  if (reason->code == LESSON_ERROR_SITES)
    g_propagate_error (error, g_steal_pointer (&reason));
  else
    blame (head->source, line, (gsize)(name - line->text), reason->message,
           error);
  return FALSE;
}

static gboolean
read_sites (Head *head,
            const BlockLine *line,
            const char *value,
            GError **error)
{
  g_autoptr (GError) reason = NULL;
  gsize fault;

  if (g_str_has_prefix (value, "file") && strcspn (value, " \t") == 4)
    return read_site_file (head, line, after_word (value), error);
  head->lesson->sites
      = site_source_make (value, &head->lesson->n_sites, &fault, &reason);
  return head->lesson->sites != NULL
         || blame (head->source, line, (gsize)(value - line->text) + fault,
                   reason->message, error);
}

static gboolean
refuse_key (const Head *head, const BlockLine *line, GError **error)
{
  static const char *const names[] = { "format", "sites", NULL };
  g_autofree char *word = g_strndup (line->text, strcspn (line->text, " \t"));
  g_autofree char *hint = words_hint (word, names);

  return lesson_source_blame (head->source, line->line, line->column, error,
                              _ ("a lesson block has no “%s”%s; it has format "
                                 "and sites"),
                              word, hint);
}

static gboolean
read_key (Head *head, const BlockLine *line, GError **error)
{
  const gsize length = strcspn (line->text, " \t");
  const gboolean is_format
      = length == 6 && strncmp (line->text, "format", length) == 0;
  const gboolean is_sites
      = length == 5 && strncmp (line->text, "sites", length) == 0;
  gboolean *has_key = is_format ? &head->has_format : &head->has_sites;

  if (!is_format && !is_sites)
    return refuse_key (head, line, error);
  if (*has_key)
    return blame (head->source, line, 0,
                  is_format ? _ ("a second format") : _ ("a second sites line"),
                  error);
  *has_key = TRUE;
  return is_format ? read_format (head, line, after_word (line->text), error)
                   : read_sites (head, line, after_word (line->text), error);
}

static gboolean
check_head (const Head *head, guint line, GError **error)
{
  if (!head->has_format)
    return lesson_source_blame (head->source, line, 1, error,
                                _ ("the lesson block needs a line: format 1"));
  if (!head->has_sites)
    return lesson_source_blame (
        head->source, line, 1, error,
        _ ("the lesson block needs a line: sites x y; x y; …"));
  return TRUE;
}

gboolean
lesson_block_read_head (const LessonSource *source,
                        const LessonLines *lines,
                        const char *folder,
                        Lesson *lesson,
                        GError **error)
{
  Head head = { source, folder, lesson, FALSE, FALSE };
  gboolean is_good = TRUE;

  for (guint number = lines->first; is_good && number <= lines->last;
       number++) {
    BlockLine line;

    block_line_init (&line, source, number);
    if (line.text[0] != '\0')
      is_good = read_key (&head, &line, error);
    g_free (line.text);
  }
  return is_good && check_head (&head, lines->first - 1, error);
}
