/* The lesson block: where the sites come from, and how to begin. */
#include "appearance.h"
#include "lesson-block.h"
#include "site-source.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

#define MAX_MINUTES 600
#define MAX_AUTHOR 200 /* characters */

/* What a lesson block has said so far. */
typedef struct Head {
  const LessonSource *source;
  const char *folder;
  Lesson *lesson;
  guint has; /* bit i: keys[i] */
} Head;

/* Returns: what follows the first word. */
static const char *
after_word (const char *text)
{
  text += strcspn (text, " \t");
  return text + strspn (text, " \t");
}

static gboolean
blame (Head *head,
       const LessonLine *line,
       const char *at,
       const char *reason,
       GError **error)
{
  return lesson_line_blame (line, head->source, at, reason, error);
}

static gboolean
read_format (Head *head,
             const LessonLine *line,
             const char *value,
             GError **error)
{
  guint64 format;

  if (!words_parse_number (value, G_MAXUINT32, &format) || format == 0)
    return blame (head, line, value,
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
                const LessonLine *line,
                const char *name,
                GError **error)
{
  g_autoptr (GError) reason = NULL;

  /* Also one that is missing: it may come. */
  g_free (head->lesson->site_file);
  head->lesson->site_file = g_strdup (name);
  if (lesson_read_site_file (head->folder, name, head->lesson, &reason))
    return TRUE;
  if (reason->code == LESSON_ERROR_SITES)
    g_propagate_error (error, g_steal_pointer (&reason));
  else
    blame (head, line, name, reason->message, error);
  return FALSE;
}

static gboolean
read_sites (Head *head,
            const LessonLine *line,
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
         || blame (head, line, value + fault, reason->message, error);
}

/* How to begin */

/* Returns: the place of @word in @names, or -1 with @error set. */
static int
find_word (Head *head,
           const LessonLine *line,
           const char *word,
           const char *const *names,
           GError **error)
{
  g_autofree char *bare = g_strndup (word, strcspn (word, " \t"));
  g_autofree char *hint = words_hint (bare, names);
  g_autofree char *list = g_strjoinv (", ", (char **)names);
  g_autofree char *reason = NULL;

  for (int i = 0; names[i] != NULL; i++)
    if (g_str_equal (bare, names[i]))
      return i;
  reason = g_strdup_printf (_ ("“%s” is not known here%s; write %s"), bare,
                            hint, list);
  blame (head, line, word, reason, error);
  return -1;
}

static gboolean
read_views (Head *head,
            const LessonLine *line,
            const char *value,
            GError **error)
{
  const char *names[N_VIEWS + 1] = { NULL };
  int views;

  for (guint i = 0; i < N_VIEWS; i++)
    names[i] = views_name ((Views)i);
  views = find_word (head, line, value, names, error);
  head->lesson->views = MAX (views, 0);
  return views >= 0;
}

static gboolean
read_step_size (Head *head,
                const LessonLine *line,
                const char *value,
                GError **error)
{
  static const char *const names[] = { "beat", "phase", "event", NULL };
  const int size = find_word (head, line, value, names, error);

  head->lesson->step_size = MAX (size, 0);
  return size >= 0;
}

static gboolean
read_theme (Head *head,
            const LessonLine *line,
            const char *value,
            GError **error)
{
  const char *names[N_THEMES + 1] = { NULL };
  int theme;

  for (guint i = 0; i < N_THEMES; i++)
    names[i] = theme_kind_name ((ThemeKind)i);
  theme = find_word (head, line, value, names, error);
  head->lesson->theme = theme;
  return theme >= 0;
}

static gboolean
read_levels (Head *head,
             const LessonLine *line,
             const char *value,
             GError **error)
{
  const char *names[N_LEVELS + 1] = { NULL };

  for (guint i = 0; i < N_LEVELS; i++)
    names[i] = level_name ((Level)i);
  if (*value == '\0')
    return find_word (head, line, value, names, error) >= 0;
  for (; *value != '\0'; value = after_word (value)) {
    const int level = find_word (head, line, value, names, error);

    if (level < 0)
      return FALSE;
    head->lesson->levels |= 1u << level;
  }
  return TRUE;
}

static gboolean
read_minutes (Head *head,
              const LessonLine *line,
              const char *value,
              GError **error)
{
  guint64 minutes;

  if (!words_parse_number (value, MAX_MINUTES, &minutes) || minutes == 0)
    return blame (head, line, value,
                  _ ("“minutes” takes a whole number from 1 to 600"), error);
  head->lesson->minutes = (guint)minutes;
  return TRUE;
}

static gboolean
read_author (Head *head,
             const LessonLine *line,
             const char *value,
             GError **error)
{
  const glong n = g_utf8_strlen (value, -1);

  if (n == 0 || n > MAX_AUTHOR)
    return blame (head, line, value,
                  _ ("“author” takes a name of at most 200 characters"), error);
  head->lesson->author = g_strdup (value);
  return TRUE;
}

/* Keys */

static const struct {
  const char *name;
  gboolean (*read) (Head *head,
                    const LessonLine *line,
                    const char *value,
                    GError **error);
} keys[] = {
  { "format", read_format },   { "sites", read_sites },
  { "views", read_views },     { "step-size", read_step_size },
  { "theme", read_theme },     { "levels", read_levels },
  { "minutes", read_minutes }, { "author", read_author },
};

static gboolean
refuse_key (const Head *head, const LessonLine *line, GError **error)
{
  const char *names[G_N_ELEMENTS (keys) + 1] = { NULL };
  g_autofree char *word = g_strndup (line->text, strcspn (line->text, " \t"));
  g_autofree char *hint = NULL, *list = NULL;

  for (guint i = 0; i < G_N_ELEMENTS (keys); i++)
    names[i] = keys[i].name;
  hint = words_hint (word, names);
  list = g_strjoinv (", ", (char **)names);
  return lesson_source_blame (head->source, line->line, line->column, error,
                              _ ("a lesson block has no “%s”%s; it has %s"),
                              word, hint, list);
}

static gboolean
read_key (Head *head, const LessonLine *line, GError **error)
{
  g_autofree char *word = g_strndup (line->text, strcspn (line->text, " \t"));

  for (guint i = 0; i < G_N_ELEMENTS (keys); i++) {
    if (!g_str_equal (word, keys[i].name))
      continue;
    if (head->has & 1u << i)
      return lesson_source_blame (head->source, line->line, line->column, error,
                                  _ ("a second %s line"), word);
    head->has |= 1u << i;
    return keys[i].read (head, line, after_word (line->text), error);
  }
  return refuse_key (head, line, error);
}

/* The first two keys must be there. */
static void
check_head (const Head *head, guint line, LessonFaults *faults)
{
  GError *error = NULL;

  if (!(head->has & 1))
    lesson_source_blame (head->source, line, 1, &error,
                         _ ("the lesson block needs a line: format 1"));
  else if (!(head->has & 2))
    lesson_source_blame (
        head->source, line, 1, &error,
        _ ("the lesson block needs a line: sites x y; x y; …"));
  if (error != NULL)
    lesson_faults_take (faults, error);
}

void
lesson_block_read_head (const LessonSource *source,
                        const LessonLines *lines,
                        const char *folder,
                        Lesson *lesson,
                        LessonFaults *faults)
{
  Head head = { source, folder, lesson, 0 };
  const guint n_faults = faults->errors->len;

  for (guint number = lines->first;
       number <= lines->last && !lesson_faults_is_full (faults); number++) {
    GError *error = NULL;
    LessonLine line;

    lesson_line_init (&line, source, number);
    if (line.text[0] != '\0' && !read_key (&head, &line, &error))
      lesson_faults_take (faults, error);
    lesson_line_clear (&line);
  }
  if (faults->errors->len == n_faults)
    check_head (&head, lines->first - 1, faults);
}
