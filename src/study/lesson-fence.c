/* Fenced blocks: which of them stand where. */
#include "lesson-reader.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

static gboolean
blame (LessonReader *reader, guint line, GError **error, const char *reason)
{
  return lesson_source_blame (reader->source, line, 1, error, "%s", reason);
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
check_closed (LessonReader *reader, cmark_node *block, GError **error)
{
  const guint first = lesson_node_line (block);
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
  return (LessonLines){ lesson_node_line (block) + 1,
                        (guint)cmark_node_get_end_line (block) - 1 };
}

static gboolean
read_lesson_block (LessonReader *reader, cmark_node *block, GError **error)
{
  const LessonLines lines = lines_of (block);
  const guint line = lesson_node_line (block);

  if (reader->stop != NULL)
    return blame (reader, line, error,
                  _ ("the lesson block must stand before the first stop"));
  if (reader->lesson_line != 0)
    return lesson_source_blame (
        reader->source, line, 1, error,
        _ ("a second lesson block; the first is on line %u"),
        reader->lesson_line);
  reader->lesson_line = line;
  lesson_block_read_head (reader->source, &lines, reader->folder,
                          reader->lesson, reader->faults);
  return TRUE;
}

/* One block of steps, or two round the question: those before it set the
 * scene, those after it answer. */
static gboolean
read_steps_block (LessonReader *reader, cmark_node *block, GError **error)
{
  const LessonLines lines = lines_of (block);
  const guint line = lesson_node_line (block);

  if (reader->stop == NULL)
    return blame (reader, line, error,
                  _ ("a steps block belongs to a stop: put ## STOP before it"));
  if (reader->steps_line > reader->ask_line)
    return lesson_source_blame (
        reader->source, line, 1, error,
        _ ("a second steps block in this stop; the first is on line %u"),
        reader->steps_line);
  reader->steps_line = line;
  lesson_block_read_steps (reader->source, &lines, &reader->n_commands,
                           reader->stop->commands, reader->faults);
  return TRUE;
}

static gboolean
read_ask_block (LessonReader *reader, cmark_node *block, GError **error)
{
  const LessonLines lines = lines_of (block);
  const guint line = lesson_node_line (block);

  if (reader->stop == NULL)
    return blame (reader, line, error,
                  _ ("an ask block belongs to a stop: put ## STOP before it"));
  if (reader->ask_line != 0)
    return lesson_source_blame (
        reader->source, line, 1, error,
        _ ("a second question in this stop; the first is on line %u"),
        reader->ask_line);
  reader->ask_line = line;
  reader->stop->n_setup = reader->stop->commands->len;
  reader->stop->question
      = question_parse (reader->source, &lines, reader->faults);
  return TRUE;
}

static gboolean
refuse_block (LessonReader *reader,
              guint line,
              const char *info,
              GError **error)
{
  static const char *const names[] = { "lesson", "steps", "ask", "text", NULL };
  g_autofree char *hint = words_hint (info, names);

  return lesson_source_blame (reader->source, line, 1, error,
                              _ ("this program knows no “%s” blocks%s"), info,
                              hint);
}

gboolean
lesson_read_fence (LessonReader *reader, cmark_node *block, GError **error)
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
    return lesson_read_prose (reader, block, reader->prose, error);
  return refuse_block (reader, lesson_node_line (block), info, error);
}

gboolean
lesson_check_inner_fences (LessonReader *reader,
                           cmark_node *node,
                           GError **error)
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
      is_good = lesson_source_blame (reader->source, lesson_node_line (inner),
                                     1, error,
                                     _ ("a %s block stands by itself, not in a "
                                        "list or quotation"),
                                     info);
    else if (!g_str_equal (info, "") && !g_str_equal (info, "text"))
      is_good = refuse_block (reader, lesson_node_line (inner), info, error);
  }
  cmark_iter_free (iter);
  return is_good;
}
