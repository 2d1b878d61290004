/* A lesson as a file in another language. What is between fences is copied
 * line by line, all else is written anew. */
#include "lesson-reader.h"
#include "lesson-words.h"
#include "prose-words.h"

#include <stdlib.h>
#include <string.h>

typedef struct Writer {
  const LessonSource *source;
  ProseTranslate translate;
  GString *text;
} Writer;

/* A paragraph is one line: where libcmark breaks lines it looks not at what
 * a line begins with then. */
static void
write_rendered (Writer *writer, cmark_node *node)
{
  char *rendered = cmark_render_commonmark (node, CMARK_OPT_NOBREAKS, 0);

  g_string_append (writer->text, rendered);
  free (rendered);
}

/* Returns: where in @text its words are; sets *@length. NULL: it has none. */
static const char *
find_words (const char *text, gsize *length)
{
  const char *rest = text + strcspn (text, " \t");
  g_autofree char *option = NULL;

  rest += strspn (rest, " \t");
  *length = strlen (rest);
  if (g_str_has_prefix (text, "prompt ") || g_str_has_prefix (text, "hint "))
    return rest;
  if (!g_str_has_prefix (text, "option "))
    return NULL;
  option = question_option_words (rest);
  if (option == NULL)
    return NULL;
  *length = strlen (option);
  return rest;
}

/* A line of a question: its words, when it has some, and all around them. */
static void
write_asking (Writer *writer, const char *line, gsize length)
{
  g_autofree char *text = g_strndup (line, length);
  const char *indented = text + strspn (text, " \t");
  gsize n;
  const char *at = find_words (indented, &n);
  g_autofree char *words = at != NULL ? g_strndup (at, n) : NULL;
  const char *translation = words != NULL ? writer->translate (words) : NULL;

  if (translation == NULL)
    g_string_append (writer->text, text);
  else {
    g_string_append_len (writer->text, text, at - text);
    g_string_append (writer->text, translation);
    g_string_append (writer->text, at + n);
  }
}

static void
write_fenced (Writer *writer, cmark_node *block)
{
  const gboolean is_asking
      = g_str_equal (cmark_node_get_fence_info (block), "ask");
  const guint last = (guint)cmark_node_get_end_line (block);

  for (guint number = lesson_node_line (block); number <= last; number++) {
    gsize length;
    const char *line = lesson_source_line (writer->source, number, &length);

    if (is_asking)
      write_asking (writer, line, length);
    else
      g_string_append_len (writer->text, line, (gssize)length);
    g_string_append_c (writer->text, '\n');
  }
}

static void
write_heading (Writer *writer, cmark_node *heading)
{
  g_autofree char *words = prose_plain_words (heading);
  const char *translation = writer->translate (words);

  if (translation != NULL)
    prose_set_words (heading, translation);
  write_rendered (writer, heading);
}

static void
write_prose (Writer *writer, cmark_node *node)
{
  const gboolean is_note = lesson_note_strip (node);

  prose_translate_block (node, writer->translate);
  if (is_note)
    lesson_note_mark (node);
  write_rendered (writer, node);
}

static void
write_node (Writer *writer, cmark_node *node)
{
  const cmark_node_type type = cmark_node_get_type (node);

  if (writer->text->len > 0)
    g_string_append_c (writer->text, '\n');
  if (type == CMARK_NODE_CODE_BLOCK)
    write_fenced (writer, node);
  else if (type == CMARK_NODE_HEADING
           && cmark_node_get_heading_level (node) <= 2)
    write_heading (writer, node);
  else
    write_prose (writer, node);
}

static char *
write_source (const LessonSource *source, ProseTranslate translate)
{
  Writer writer = { source, translate, g_string_new (NULL) };
  cmark_node *document = cmark_parse_document (
      source->text, strlen (source->text), CMARK_OPT_SOURCEPOS);

  for (cmark_node *node = cmark_node_first_child (document); node != NULL;
       node = cmark_node_next (node))
    write_node (&writer, node);
  cmark_node_free (document);
  return g_string_free (writer.text, FALSE);
}

static gboolean
is_lesson (const char *text, const char *path)
{
  g_autoptr (Lesson) lesson = lesson_parse (text, strlen (text), path, NULL);

  return lesson != NULL;
}

char *
lesson_words_write (const char *text,
                    gsize length,
                    const char *path,
                    ProseTranslate translate)
{
  g_autoptr (LessonSource) source = NULL;
  g_autoptr (Lesson) lesson = lesson_parse (text, length, path, NULL);
  g_autofree char *written = NULL;

  if (lesson == NULL || translate (lesson->title) == NULL)
    return NULL;
  source = lesson_source_new (text, length, path, NULL);
  if (source != NULL)
    written = write_source (source, translate);
  return written != NULL && is_lesson (written, path)
             ? g_steal_pointer (&written)
             : NULL;
}
