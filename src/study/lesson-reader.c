/* Reads a lesson: libcmark finds the blocks, this file says what they mean,
 * lesson-block.c reads the lines in them. */
#include "lesson-block.h"
#include "lesson-source.h"
#include "stop-state.h"
#include "words.h"

#include <cmark.h>
#include <glib/gi18n.h>
#include <string.h>

/* Text that a person can read at a stop. Longer text has another purpose,
 * and libcmark needs the square of its length. */
#define MAX_BLOCK_BYTES (16 << 10)
#define MAX_PROSE_BYTES (256 << 10)
#define MAX_TITLE 200 /* characters */

typedef struct Reader {
  const LessonSource *source;
  const char *folder; /* of the lesson, for files of sites */
  Lesson *lesson;
  LessonStop *stop;  /* the one being read; NULL before the first */
  guint lesson_line; /* of the lesson block; 0: not yet */
  guint steps_line;  /* of the stop's last steps block; 0: not yet */
  guint ask_line;    /* of the stop's ask block; 0: not yet */
  guint n_commands;
  gsize n_prose;
  GString *prose, *note;
  LessonFaults *faults;
} Reader;

static guint
line_of (cmark_node *node)
{
  return (guint)cmark_node_get_start_line (node);
}

static gboolean
blame (Reader *reader, guint line, GError **error, const char *reason)
{
  return lesson_source_blame (reader->source, line, 1, error, "%s", reason);
}

/* Hands the text gathered so far to the lesson or the stop it belongs to. */
static void
end_text (Reader *reader)
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

static gboolean
read_prose (Reader *reader, cmark_node *node, GString *text, GError **error)
{
  const gsize n = lesson_source_bytes (reader->source, line_of (node),
                                       (guint)cmark_node_get_end_line (node));

  if (n > MAX_BLOCK_BYTES)
    return blame (reader, line_of (node), error,
                  _ ("a text longer than 16 KB"));
  reader->n_prose += n;
  if (reader->n_prose > MAX_PROSE_BYTES)
    return blame (reader, line_of (node), error,
                  _ ("the texts of this lesson are longer than 256 KB"));
  append_block (text, node);
  return TRUE;
}

/* Returns: the first words of a block quotation, or "". */
static const char *
quoted_words (cmark_node *quote)
{
  cmark_node *node = cmark_node_first_child (quote);

  if (node == NULL || cmark_node_get_type (node) != CMARK_NODE_PARAGRAPH)
    return "";
  node = cmark_node_first_child (node);
  if (node == NULL || cmark_node_get_type (node) != CMARK_NODE_TEXT)
    return "";
  return cmark_node_get_literal (node);
}

#define NOTE_MARK "Note:"

/* A quotation that begins with "Note:" is for the lecturer. */
static gboolean
read_quote (Reader *reader, cmark_node *quote, GError **error)
{
  const char *words = quoted_words (quote);
  g_autofree char *rest = NULL;

  if (!g_str_has_prefix (words, NOTE_MARK))
    return read_prose (reader, quote, reader->prose, error);

  rest = g_strchug (g_strdup (words + strlen (NOTE_MARK)));
  cmark_node_set_literal (
      cmark_node_first_child (cmark_node_first_child (quote)), rest);
  for (cmark_node *node = cmark_node_first_child (quote); node != NULL;
       node = cmark_node_next (node))
    if (!read_prose (reader, node, reader->note, error))
      return FALSE;
  return TRUE;
}

/* Returns: (transfer full): the words of a heading, without markup. */
static char *
heading_words (cmark_node *heading)
{
  GString *words = g_string_new (NULL);
  cmark_iter *iter = cmark_iter_new (heading);
  cmark_event_type event;

  while ((event = cmark_iter_next (iter)) != CMARK_EVENT_DONE) {
    cmark_node *node = cmark_iter_get_node (iter);
    const cmark_node_type type = cmark_node_get_type (node);

    if (event != CMARK_EVENT_ENTER)
      continue;
    if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE)
      g_string_append (words, cmark_node_get_literal (node));
    else if (type == CMARK_NODE_SOFTBREAK || type == CMARK_NODE_LINEBREAK)
      g_string_append_c (words, ' ');
  }
  cmark_iter_free (iter);
  return g_string_free (words, FALSE);
}

static gboolean
check_title (Reader *reader, guint line, const char *title, GError **error)
{
  if (*title == '\0')
    return blame (reader, line, error, _ ("a heading without words"));
  if (g_utf8_strlen (title, -1) > MAX_TITLE)
    return blame (reader, line, error,
                  _ ("a heading longer than 200 characters"));
  return TRUE;
}

static gboolean
read_title (Reader *reader, cmark_node *heading, GError **error)
{
  if (reader->lesson->title != NULL)
    return blame (reader, line_of (heading), error,
                  _ ("a second title; stops are headings of level 2: ## STOP"));
  reader->lesson->title = heading_words (heading);
  return check_title (reader, line_of (heading), reader->lesson->title, error);
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
begin_stop (Reader *reader, cmark_node *heading, GError **error)
{
  const guint line = line_of (heading);
  const gboolean has_lesson = reader->lesson_line != 0;

  if (reader->lesson->stops->len == LESSON_MAX_STOPS)
    return blame (reader, line, error, _ ("more than 1000 stops"));
  end_text (reader);
  reader->stop = g_new0 (LessonStop, 1);
  reader->stop->line = line;
  reader->stop->title = heading_words (heading);
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
read_heading (Reader *reader, cmark_node *heading, GError **error)
{
  switch (cmark_node_get_heading_level (heading)) {
  case 1:
    return read_title (reader, heading, error);
  case 2:
    return begin_stop (reader, heading, error);
  default:
    return read_prose (reader, heading, reader->prose, error);
  }
}

/* Returns: whether the line begins like a fence of a code block. */
static gboolean
is_fence (const LessonSource *source, guint line)
{
  gsize length;
  const char *start = lesson_source_line (source, line, &length);

  start += strspn (start, " ");
  return g_str_has_prefix (start, "```") || g_str_has_prefix (start, "~~~");
}

/* A block that is not closed would swallow the rest of the lesson. */
static gboolean
check_closed (Reader *reader, cmark_node *block, GError **error)
{
  const guint first = line_of (block);
  const guint last = MIN ((guint)cmark_node_get_end_line (block),
                          lesson_source_n_lines (reader->source));

  if (!is_fence (reader->source, first)
      || (last > first && is_fence (reader->source, last)))
    return TRUE;
  return blame (reader, first, error,
                _ ("this block is not closed: its last line must be ```"));
}

/* The lines inside a fenced block. */
static LessonLines
lines_of (cmark_node *block)
{
  return (LessonLines){ line_of (block) + 1,
                        (guint)cmark_node_get_end_line (block) - 1 };
}

static gboolean
read_lesson_block (Reader *reader, cmark_node *block, GError **error)
{
  const LessonLines lines = lines_of (block);
  const guint line = line_of (block);

  if (reader->stop != NULL)
    return blame (reader, line, error,
                  _ ("the lesson block must stand before the first stop"));
  if (reader->lesson_line != 0)
    return lesson_source_blame (reader->source, line, 1, error,
                                _ ("a second lesson block; the first is in "
                                   "line %u"),
                                reader->lesson_line);
  reader->lesson_line = line;
  lesson_block_read_head (reader->source, &lines, reader->folder,
                          reader->lesson, reader->faults);
  return TRUE;
}

/* One block of steps, or two round the question: those before it set the
 * scene, those after it answer. */
static gboolean
read_steps_block (Reader *reader, cmark_node *block, GError **error)
{
  const LessonLines lines = lines_of (block);
  const guint line = line_of (block);

  if (reader->stop == NULL)
    return blame (reader, line, error,
                  _ ("a steps block belongs to a stop: put ## STOP before it"));
  if (reader->steps_line > reader->ask_line)
    return lesson_source_blame (reader->source, line, 1, error,
                                _ ("a second steps block in this stop; the "
                                   "first is in line %u"),
                                reader->steps_line);
  reader->steps_line = line;
  lesson_block_read_steps (reader->source, &lines, &reader->n_commands,
                           reader->stop->commands, reader->faults);
  return TRUE;
}

static gboolean
read_ask_block (Reader *reader, cmark_node *block, GError **error)
{
  const LessonLines lines = lines_of (block);
  const guint line = line_of (block);

  if (reader->stop == NULL)
    return blame (reader, line, error,
                  _ ("an ask block belongs to a stop: put ## STOP before it"));
  if (reader->ask_line != 0)
    return lesson_source_blame (reader->source, line, 1, error,
                                _ ("a second question in this stop; the first "
                                   "is in line %u"),
                                reader->ask_line);
  reader->ask_line = line;
  reader->stop->n_setup = reader->stop->commands->len;
  reader->stop->question
      = question_parse (reader->source, &lines, reader->faults);
  return TRUE;
}

static gboolean
refuse_block (Reader *reader, guint line, const char *info, GError **error)
{
  static const char *const names[] = { "lesson", "steps", "ask", "text", NULL };
  g_autofree char *hint = words_hint (info, names);

  return lesson_source_blame (reader->source, line, 1, error,
                              _ ("this program knows no “%s” blocks%s"), info,
                              hint);
}

static gboolean
read_block (Reader *reader, cmark_node *block, GError **error)
{
  const char *info = cmark_node_get_fence_info (block);

  if (!check_closed (reader, block, error))
    return FALSE;
  if (g_str_equal (info, "lesson"))
    return read_lesson_block (reader, block, error);
  if (g_str_equal (info, "steps"))
    return read_steps_block (reader, block, error);
  if (g_str_equal (info, "ask"))
    return read_ask_block (reader, block, error);
  if (g_str_equal (info, "") || g_str_equal (info, "text"))
    return read_prose (reader, block, reader->prose, error);
  return refuse_block (reader, line_of (block), info, error);
}

/* Inside lists and quotations code is prose; what looks like commands there
 * would be silently left out, so it is refused. */
static gboolean
check_inner_blocks (Reader *reader, cmark_node *node, GError **error)
{
  cmark_iter *iter = cmark_iter_new (node);
  gboolean is_good = TRUE;

  while (is_good && cmark_iter_next (iter) != CMARK_EVENT_DONE) {
    cmark_node *inner = cmark_iter_get_node (iter);
    const char *info = cmark_node_get_type (inner) == CMARK_NODE_CODE_BLOCK
                           ? cmark_node_get_fence_info (inner)
                           : "";

    if (g_str_equal (info, "lesson") || g_str_equal (info, "steps")
        || g_str_equal (info, "ask"))
      is_good = lesson_source_blame (reader->source, line_of (inner), 1, error,
                                     _ ("a %s block stands by itself, not in a "
                                        "list or quotation"),
                                     info);
    else if (!g_str_equal (info, "") && !g_str_equal (info, "text"))
      is_good = refuse_block (reader, line_of (inner), info, error);
  }
  cmark_iter_free (iter);
  return is_good;
}

static gboolean
read_node (Reader *reader, cmark_node *node, GError **error)
{
  const cmark_node_type type = cmark_node_get_type (node);

  if (reader->lesson->title == NULL
      && (type != CMARK_NODE_HEADING
          || cmark_node_get_heading_level (node) != 1)) {
    reader->lesson->title = g_strdup (""); /* said once */
    return blame (reader, line_of (node), error,
                  _ ("a lesson begins with its title: # TITLE"));
  }

  switch ((int)type) {
  case CMARK_NODE_HEADING:
    return read_heading (reader, node, error);
  case CMARK_NODE_CODE_BLOCK:
    return read_block (reader, node, error);
  case CMARK_NODE_BLOCK_QUOTE:
    return check_inner_blocks (reader, node, error)
           && read_quote (reader, node, error);
  case CMARK_NODE_HTML_BLOCK:
    return TRUE;
  default:
    return check_inner_blocks (reader, node, error)
           && read_prose (reader, node, reader->prose, error);
  }
}

/* What can be known missing only at the end. */
static gboolean
check_whole (Reader *reader, GError **error)
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
read_document (Reader *reader, cmark_node *document)
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
  Reader reader = { .source = source,
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

Lesson *
lesson_parse_all (const char *text,
                  gsize length,
                  const char *path,
                  LessonFaults *faults)
{
  g_autofree char *folder = g_path_get_dirname (path);
  g_autoptr (LessonSource) source = NULL;
  g_autoptr (Lesson) lesson = NULL;
  GError *error = NULL;

  source = lesson_source_new (text, length, path, &error);
  if (source == NULL) {
    lesson_faults_take (faults, error);
    return NULL;
  }
  lesson = lesson_new (source);
  read_source (source, folder, lesson, faults);
  if (lesson->sites != NULL && lesson->stops->len > 0)
    lesson_fill_states (lesson, faults);
  return faults->errors->len == 0 ? g_steal_pointer (&lesson) : NULL;
}

Lesson *
lesson_parse (const char *text, gsize length, const char *path, GError **error)
{
  g_autoptr (LessonFaults) faults = lesson_faults_new ();
  Lesson *lesson = lesson_parse_all (text, length, path, faults);

  if (lesson == NULL)
    g_propagate_error (error,
                       g_error_copy (g_ptr_array_index (faults->errors, 0)));
  return lesson;
}
