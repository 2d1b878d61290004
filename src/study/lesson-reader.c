/* Reads a lesson: libcmark finds the blocks, this file says what they mean,
 * lesson-fence.c what blocks of commands do, lesson-block.c reads their
 * lines. */
#include "lesson-reader.h"

#include "prose-words.h"
#include "stop-state.h"

#include <glib/gi18n.h>
#include <string.h>

/* Text that a person can read at a stop. Longer text has another purpose,
 * and libcmark needs the square of its length. */
#define MAX_BLOCK_BYTES (16 << 10)
#define MAX_PROSE_BYTES (256 << 10)
#define MAX_TITLE 200 /* characters */
#define MAX_WORD 1000

guint
lesson_node_line (cmark_node *node)
{
  return (guint)cmark_node_get_start_line (node);
}

static gboolean
blame (LessonReader *reader, guint line, GError **error, const char *reason)
{
  return lesson_source_blame (reader->source, line, 1, error, "%s", reason);
}

/* Hands the text gathered so far to the lesson or the stop it belongs to. */
static void
end_text (LessonReader *reader)
{
  char **prose
      = reader->stop != NULL ? &reader->stop->prose : &reader->lesson->prose;
  char **note
      = reader->stop != NULL ? &reader->stop->note : &reader->lesson->note;

  *prose = g_string_free (reader->prose, FALSE);
  *note = g_string_free (reader->note, reader->note->len == 0);
  reader->prose = g_string_new (NULL);
  reader->note = g_string_new (NULL);
}

static void
append_block (GString *text, cmark_node *node)
{
  char *block = cmark_render_commonmark (node, CMARK_OPT_DEFAULT, 0);

  if (text->len > 0)
    g_string_append_c (text, '\n');
  g_string_append (text, block);
  free (block);
}

/* Where a line can end without a blank: scripts that write words together. */
static gboolean
ends_word (gunichar c)
{
  return g_unichar_isspace (c) || g_unichar_iswide (c)
         || g_unichar_break_type (c) == G_UNICODE_BREAK_COMPLEX_CONTEXT;
}

/* Counts on from *@n letters of a word that begins before @literal. */
static gboolean
is_long_word (const char *literal, guint *n)
{
  for (const char *p = literal; *p != '\0' && *n <= MAX_WORD;
       p = g_utf8_next_char (p))
    *n = ends_word (g_utf8_get_char (p)) ? 0 : *n + 1;
  return *n > MAX_WORD;
}

/* Emphasis may begin and end within a word. */
static gboolean
has_long_word (cmark_node *block)
{
  cmark_iter *iter = cmark_iter_new (block);
  gboolean is_long = FALSE;
  guint n = 0;

  while (!is_long && cmark_iter_next (iter) != CMARK_EVENT_DONE) {
    cmark_node *node = cmark_iter_get_node (iter);
    const cmark_node_type type = cmark_node_get_type (node);

    if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE
        || type == CMARK_NODE_CODE_BLOCK)
      is_long = is_long_word (cmark_node_get_literal (node), &n);
    else if (type <= CMARK_NODE_LAST_BLOCK || type == CMARK_NODE_SOFTBREAK
             || type == CMARK_NODE_LINEBREAK)
      n = 0;
  }
  cmark_iter_free (iter);
  return is_long;
}

gboolean
lesson_read_prose (LessonReader *reader,
                   cmark_node *node,
                   GString *text,
                   GError **error)
{
  const gsize n = lesson_source_bytes (reader->source, lesson_node_line (node),
                                       (guint)cmark_node_get_end_line (node));

  if (n > MAX_BLOCK_BYTES)
    return blame (reader, lesson_node_line (node), error,
                  _ ("a text longer than 16 KB"));
  if (has_long_word (node))
    return blame (reader, lesson_node_line (node), error,
                  _ ("a word longer than 1000 characters"));
  reader->n_prose += n;
  if (reader->n_prose > MAX_PROSE_BYTES)
    return blame (reader, lesson_node_line (node), error,
                  _ ("the texts of this lesson are longer than 256 KB"));
  append_block (text, node);
  return TRUE;
}

/* Returns: the first words of a block quotation, or "". */
static const char *
quoted_words (cmark_node *quote)
{
  cmark_node *node = cmark_node_get_type (quote) == CMARK_NODE_BLOCK_QUOTE
                         ? cmark_node_first_child (quote)
                         : NULL;

  if (node == NULL || cmark_node_get_type (node) != CMARK_NODE_PARAGRAPH)
    return "";
  node = cmark_node_first_child (node);
  if (node == NULL || cmark_node_get_type (node) != CMARK_NODE_TEXT)
    return "";
  return cmark_node_get_literal (node);
}

#define NOTE_MARK "Note:"

gboolean
lesson_note_strip (cmark_node *node)
{
  const char *words = quoted_words (node);
  g_autofree char *rest = NULL;

  if (!g_str_has_prefix (words, NOTE_MARK))
    return FALSE;
  rest = g_strchug (g_strdup (words + strlen (NOTE_MARK)));
  cmark_node_set_literal (
      cmark_node_first_child (cmark_node_first_child (node)), rest);
  return TRUE;
}

void
lesson_note_mark (cmark_node *quote)
{
  cmark_node *mark = cmark_node_new (CMARK_NODE_TEXT);

  cmark_node_set_literal (mark, NOTE_MARK " ");
  cmark_node_prepend_child (cmark_node_first_child (quote), mark);
}

static gboolean
read_quote (LessonReader *reader, cmark_node *quote, GError **error)
{
  if (!lesson_note_strip (quote))
    return lesson_read_prose (reader, quote, reader->prose, error);

  for (cmark_node *node = cmark_node_first_child (quote); node != NULL;
       node = cmark_node_next (node))
    if (!lesson_read_prose (reader, node, reader->note, error))
      return FALSE;
  return TRUE;
}

static gboolean
check_title (LessonReader *reader,
             guint line,
             const char *title,
             GError **error)
{
  if (*title == '\0')
    return blame (reader, line, error, _ ("a heading without words"));
  if (g_utf8_strlen (title, -1) > MAX_TITLE)
    return blame (reader, line, error,
                  _ ("a heading longer than 200 characters"));
  return TRUE;
}

static gboolean
read_title (LessonReader *reader, cmark_node *heading, GError **error)
{
  if (reader->lesson->title != NULL)
    return blame (reader, lesson_node_line (heading), error,
                  _ ("a second title; stops are headings of level 2: ## STOP"));
  reader->lesson->title = prose_plain_words (heading);
  return check_title (reader, lesson_node_line (heading), reader->lesson->title,
                      error);
}

static void
stop_free (gpointer data)
{
  LessonStop *stop = data;

  g_free (stop->title);
  g_free (stop->prose);
  g_free (stop->note);
  g_ptr_array_unref (stop->commands);
  g_clear_pointer (&stop->state, stop_state_free);
  g_clear_pointer (&stop->ask_state, stop_state_free);
  g_clear_pointer (&stop->question, question_unref);
  g_free (stop);
}

/* A stop begins whatever is wrong with its heading, so that the blocks after
 * it have one to belong to. */
static gboolean
begin_stop (LessonReader *reader, cmark_node *heading, GError **error)
{
  const guint line = lesson_node_line (heading);
  const gboolean has_lesson = reader->lesson_line != 0;

  if (reader->lesson->stops->len == LESSON_MAX_STOPS)
    return blame (reader, line, error, _ ("more than 1000 stops"));
  end_text (reader);
  reader->stop = g_new0 (LessonStop, 1);
  reader->stop->line = line;
  reader->stop->title = prose_plain_words (heading);
  reader->stop->commands = g_ptr_array_new_with_free_func (lesson_command_free);
  reader->steps_line = reader->ask_line = 0;
  g_ptr_array_add (reader->lesson->stops, reader->stop);
  if (!has_lesson) {
    reader->lesson_line = line; /* said once */
    return blame (reader, line, error,
                  _ ("the lesson block must stand before the first stop"));
  }
  return check_title (reader, line, reader->stop->title, error);
}

static gboolean
read_heading (LessonReader *reader, cmark_node *heading, GError **error)
{
  switch (cmark_node_get_heading_level (heading)) {
  case 1:
    return read_title (reader, heading, error);
  case 2:
    return begin_stop (reader, heading, error);
  default:
    return lesson_read_prose (reader, heading, reader->prose, error);
  }
}

static void
note_html (LessonReader *reader, cmark_node *node)
{
  const guint line = lesson_node_line (node);

  if (reader->faults->html_lines->len < LESSON_MAX_FAULTS)
    g_array_append_val (reader->faults->html_lines, line);
}

static gboolean
read_node (LessonReader *reader, cmark_node *node, GError **error)
{
  const cmark_node_type type = cmark_node_get_type (node);

  if (reader->lesson->title == NULL
      && (type != CMARK_NODE_HEADING
          || cmark_node_get_heading_level (node) != 1)) {
    reader->lesson->title = g_strdup (""); /* said once */
    return blame (reader, lesson_node_line (node), error,
                  _ ("a lesson begins with its title: # TITLE"));
  }

  switch ((int)type) {
  case CMARK_NODE_HEADING:
    return read_heading (reader, node, error);
  case CMARK_NODE_CODE_BLOCK:
    return lesson_read_fence (reader, node, error);
  case CMARK_NODE_BLOCK_QUOTE:
    return lesson_check_inner_fences (reader, node, error)
           && read_quote (reader, node, error);
  case CMARK_NODE_HTML_BLOCK:
    note_html (reader, node);
    return TRUE;
  default:
    return lesson_check_inner_fences (reader, node, error)
           && lesson_read_prose (reader, node, reader->prose, error);
  }
}

/* What can be known missing only at the end. */
static gboolean
check_whole (LessonReader *reader, GError **error)
{
  const guint last = lesson_source_n_lines (reader->source);

  if (reader->lesson->title == NULL)
    return blame (reader, 1, error,
                  _ ("a lesson begins with its title: # TITLE"));
  if (reader->lesson_line == 0)
    return blame (reader, last, error, _ ("there is no lesson block"));
  if (reader->lesson->stops->len == 0)
    return blame (reader, last, error, _ ("there is no stop: write ## STOP"));
  return TRUE;
}

/* Reads on behind what is wrong, to find all of it. */
static void
read_document (LessonReader *reader, cmark_node *document)
{
  GError *error = NULL;

  for (cmark_node *node = cmark_node_first_child (document);
       node != NULL && !lesson_faults_is_full (reader->faults);
       node = cmark_node_next (node))
    if (!read_node (reader, node, &error))
      lesson_faults_take (reader->faults, g_steal_pointer (&error));
  if (!check_whole (reader, &error))
    lesson_faults_take (reader->faults, g_steal_pointer (&error));
  end_text (reader);
}

static Lesson *
lesson_new (const LessonSource *source)
{
  Lesson *lesson = g_new0 (Lesson, 1);

  lesson->reference_count = 1;
  lesson->path = g_strdup (source->name);
  lesson->step_size = lesson->theme = -1;
  lesson->stops = g_ptr_array_new_with_free_func (stop_free);
  return lesson;
}

static void
read_source (const LessonSource *source,
             const char *folder,
             Lesson *lesson,
             LessonFaults *faults)
{
  cmark_node *document = cmark_parse_document (
      source->text, strlen (source->text), CMARK_OPT_SOURCEPOS);
  LessonReader reader = { .source = source,
                          .folder = folder,
                          .lesson = lesson,
                          .prose = g_string_new (NULL),
                          .note = g_string_new (NULL),
                          .faults = faults };

  read_document (&reader, document);
  g_string_free (reader.prose, TRUE);
  g_string_free (reader.note, TRUE);
  cmark_node_free (document);
}

/* Returns: (transfer full): what has been read, whatever is wrong with it;
 * NULL: nothing. */
static Lesson *
read_unplayed (const char *text,
               gsize length,
               const char *path,
               LessonFaults *faults)
{
  g_autofree char *folder = g_path_get_dirname (path);
  g_autoptr (LessonSource) source = NULL;
  GError *error = NULL;
  Lesson *lesson;

  source = lesson_source_new (text, length, path, &error);
  if (source == NULL) {
    lesson_faults_take (faults, error);
    return NULL;
  }
  lesson = lesson_new (source);
  read_source (source, folder, lesson, faults);
  faults->site_file = g_strdup (lesson->site_file);
  return lesson;
}

Lesson *
lesson_parse_all (const char *text,
                  gsize length,
                  const char *path,
                  LessonFaults *faults)
{
  g_autoptr (Lesson) lesson = read_unplayed (text, length, path, faults);

  if (lesson == NULL)
    return NULL;
  if (lesson->sites != NULL && lesson->stops->len > 0)
    lesson_fill_states (lesson, faults);
  return faults->errors->len == 0 ? g_steal_pointer (&lesson) : NULL;
}

/* Returns: FALSE with the first of @faults in @error, if there are any. */
static gboolean
is_faultless (const LessonFaults *faults, GError **error)
{
  if (faults->errors->len == 0)
    return TRUE;
  g_propagate_error (error,
                     g_error_copy (g_ptr_array_index (faults->errors, 0)));
  return FALSE;
}

Lesson *
lesson_parse_unplayed (const char *text,
                       gsize length,
                       const char *path,
                       GError **error)
{
  g_autoptr (LessonFaults) faults = lesson_faults_new ();
  g_autoptr (Lesson) lesson = read_unplayed (text, length, path, faults);

  return is_faultless (faults, error) ? g_steal_pointer (&lesson) : NULL;
}

gboolean
lesson_play (Lesson *lesson, GError **error)
{
  g_autoptr (LessonFaults) faults = lesson_faults_new ();

  lesson_fill_states (lesson, faults);
  return is_faultless (faults, error);
}

Lesson *
lesson_parse (const char *text, gsize length, const char *path, GError **error)
{
  g_autoptr (Lesson) lesson = lesson_parse_unplayed (text, length, path, error);

  return lesson != NULL && lesson_play (lesson, error)
             ? g_steal_pointer (&lesson)
             : NULL;
}
